#include "quads/triangle_pairs.h"

#include <algorithm>
#include <vector>

#include "base/ties.h"
#include "measure/core_region.h"
#include "quads/dissection.h"

namespace advlayers {
namespace {

constexpr int kKeptLayers = 1;                             // their quads stay
constexpr std::size_t kSearchLimit = 120, kMostGoals = 8;  // faces looked at, and triangles found
constexpr std::size_t kLongestPath = 7;                    // faces, with both triangles
constexpr double kLeastQuad = 0.06;   // corners of 20 to 160 degrees, before smoothing
constexpr double kGoodQuad = 0.4;     // as the worst of a dissection: no other is sought
constexpr double kLostQuad = 0.02;    // what a quad of a layer is worth
constexpr double kLongestSide = 1.3;  // of new quads, in longest sides of the disc

using Faces = std::vector<FaceH>;

bool contains(const Faces& faces, FaceH f) {
  return std::find(faces.begin(), faces.end(), f) != faces.end();
}

struct Remedy {
  double score = 0.0;
  Faces disc;
  std::vector<std::vector<VertexH>> quads;
};

class PairCloser {
 public:
  PairCloser(SurfaceMesh& mesh, LayerCells cells, bool through_layers)
      : mesh_(mesh),
        cells_(cells),
        through_layers_(through_layers),
        parent_(mesh.face_capacity()) {}

  bool may_go(FaceH f) const {
    if (cells_ == LayerCells::kStay) return !is_layer_cell(mesh_, f);
    const int layer = mesh_.data(f).layer;
    return layer == 0 || (through_layers_ && layer > kKeptLayers);
  }
  bool close(FaceH start);

 private:
  void find_goals(FaceH start);
  void try_path(FaceH start, FaceH goal);
  void consider(const Faces& disc);
  bool consider_loop(const Faces& disc, const std::vector<VertexH>& loop, double lost);
  template <class Visit>
  void for_each_spoke(const Faces& disc, const Visit& visit) const;
  std::vector<Faces> runs_beside(const Faces& disc) const;
  Faces neighbours(const Faces& disc) const;
  bool find_loop(const Faces& disc);
  void carry_out();

  SurfaceMesh& mesh_;
  LayerCells cells_;
  bool through_layers_;
  std::vector<FaceH> parent_;  // by face, in the search
  Faces touched_, goals_;
  std::vector<VertexH> loop_;
  double longest_ = 0.0;  // side of the loop [mm]
  Remedy best_;
};

void PairCloser::find_goals(FaceH start) {
  goals_.clear();
  touched_.assign(1, start);
  parent_[start.index()] = start;
  for (std::size_t i = 0; i < touched_.size() && i < kSearchLimit; ++i) {
    if (i > 0 && mesh_.is_triangle(mesh_.halfedge(touched_[i]))) continue;
    for (const HalfedgeH h : mesh_.sides(touched_[i])) {
      const HalfedgeH t = SurfaceMesh::twin(h);
      if (mesh_.is_border(t) || mesh_.curve(h).valid()) continue;
      const FaceH next = mesh_.face(t);
      if (parent_[next.index()].valid() || !may_go(next)) continue;
      parent_[next.index()] = touched_[i];
      touched_.push_back(next);
      if (mesh_.is_triangle(t)) goals_.push_back(next);
    }
    if (goals_.size() >= kMostGoals) break;
  }
}

// The disc's corners in order; false where they are no simple loop, too many, or odd.
bool PairCloser::find_loop(const Faces& disc) {
  std::vector<HalfedgeH> sides;
  bool over_edge = false;  // of the model
  for (const FaceH f : disc) {
    for (const HalfedgeH h : mesh_.sides(f)) {
      const HalfedgeH t = SurfaceMesh::twin(h);
      const bool outer = mesh_.is_border(t) || !contains(disc, mesh_.face(t));
      if (outer) sides.push_back(h);
      over_edge = over_edge || (!outer && mesh_.curve(h).valid());
    }
  }
  if (over_edge || sides.size() < 4 || sides.size() > kMostCorners || sides.size() % 2 != 0)
    return false;
  loop_.clear();
  longest_ = 0.0;
  for (HalfedgeH h = sides.front(); loop_.size() < sides.size();) {
    const VertexH v = mesh_.from(h);
    if (std::find(loop_.begin(), loop_.end(), v) != loop_.end()) return false;
    loop_.push_back(v);
    longest_ = std::max(longest_, (mesh_.position(v) - mesh_.position(mesh_.to(h))).norm());
    const auto next = std::find_if(sides.begin(), sides.end(), [&](HalfedgeH other) {
      return mesh_.from(other) == mesh_.to(h);
    });
    h = *next;
  }
  return true;
}

void PairCloser::consider(const Faces& disc) {
  if (!find_loop(disc)) return;
  double lost = 0.0;
  for (const FaceH f : disc) lost += mesh_.data(f).layer > 0 ? kLostQuad : 0.0;
  if (consider_loop(disc, loop_, lost)) return;
  for_each_spoke(disc, [&](std::size_t rim, VertexH hub) {
    std::vector<VertexH> slit = loop_;
    const auto at = slit.begin() + static_cast<std::ptrdiff_t>(rim);
    slit.insert(at + 1, {hub, *at});
    consider_loop(disc, slit, lost);
  });
}

bool PairCloser::consider_loop(const Faces& disc, const std::vector<VertexH>& loop, double lost) {
  if (loop.size() > kMostCorners) return false;
  const double least = std::max(kLeastQuad, best_.score + lost);
  Dissection found = dissect(mesh_, loop, kLongestSide * longest_, least);
  found.worst = settled(found.worst);
  if (found.worst - lost <= best_.score || found.quads.empty()) return false;
  if (mesh_.replace_veto(disc, found.quads) != Veto::kNone) return false;
  best_ = {found.worst - lost, disc, std::move(found.quads)};
  return true;
}

// The edges of the disc from its loop to a vertex inside it: cut open along one, the disc keeps
// that vertex.
template <class Visit>
void PairCloser::for_each_spoke(const Faces& disc, const Visit& visit) const {
  for (const FaceH f : disc) {
    for (const HalfedgeH h : mesh_.sides(f)) {
      const auto rim = std::find(loop_.begin(), loop_.end(), mesh_.from(h));
      const VertexH hub = mesh_.to(h);
      if (rim == loop_.end() || std::find(loop_.begin(), loop_.end(), hub) != loop_.end()) continue;
      visit(static_cast<std::size_t>(rim - loop_.begin()), hub);
    }
  }
}

Faces PairCloser::neighbours(const Faces& disc) const {
  Faces found;
  for (const FaceH f : disc) {
    for (const HalfedgeH h : mesh_.sides(f)) {
      const HalfedgeH t = SurfaceMesh::twin(h);
      if (mesh_.is_border(t) || mesh_.is_triangle(t) || mesh_.curve(h).valid()) continue;
      const FaceH g = mesh_.face(t);
      if (may_go(g) && !contains(disc, g) && !contains(found, g)) found.push_back(g);
    }
  }
  return found;
}

// Quads of layers beside the disc, those that touch each other together.
std::vector<Faces> PairCloser::runs_beside(const Faces& disc) const {
  Faces rest;
  for (const FaceH f : neighbours(disc)) {
    if (mesh_.data(f).layer > 0) rest.push_back(f);
  }
  std::vector<Faces> runs;
  while (!rest.empty()) {
    Faces run{rest.back()};
    rest.pop_back();
    for (std::size_t i = 0; i < run.size(); ++i) {
      for (const HalfedgeH h : mesh_.sides(run[i])) {
        const auto found = std::find(rest.begin(), rest.end(), mesh_.face(SurfaceMesh::twin(h)));
        if (found == rest.end()) continue;
        run.push_back(*found);
        rest.erase(found);
      }
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

void PairCloser::try_path(FaceH start, FaceH goal) {
  Faces path{goal};
  while (path.back() != start) path.push_back(parent_[path.back().index()]);
  if (path.size() > kLongestPath) return;
  const auto with = [&](const Faces& more) {
    Faces disc = path;
    disc.insert(disc.end(), more.begin(), more.end());
    consider(disc);
  };
  consider(path);
  if (best_.score > kGoodQuad) return;
  for (const FaceH f : neighbours(path)) with({f});
  if (!through_layers_ || best_.score > kGoodQuad) return;
  Faces all;
  for (const Faces& run : runs_beside(path)) {
    with(run);
    all.insert(all.end(), run.begin(), run.end());
  }
  with(all);
}

void PairCloser::carry_out() {
  const std::vector<FaceH> made = mesh_.replace(best_.disc, best_.quads);
  for (const FaceH f : made) {
    int extrusions = 0, layer = 0;
    for (const HalfedgeH h : mesh_.sides(f)) {
      extrusions += is_extrusion(mesh_, h);
      layer = std::max(layer, mesh_.data(mesh_.to(h)).layer);
    }
    if (extrusions == 2) mesh_.data(f).layer = layer;
  }
}

bool PairCloser::close(FaceH start) {
  best_ = Remedy();
  if (parent_.size() < mesh_.face_capacity()) parent_.resize(mesh_.face_capacity());
  find_goals(start);
  for (const FaceH goal : goals_) try_path(start, goal);
  for (const FaceH f : touched_) parent_[f.index()] = FaceH();
  if (best_.disc.empty()) return false;
  carry_out();
  return true;
}

}  // namespace

int close_triangle_pairs(const RunContext& context, SurfaceMesh& mesh, LayerCells cells) {
  int pairs = 0;
  for (const bool through_layers : {false, true}) {
    if (through_layers && cells == LayerCells::kStay) break;
    PairCloser closer(mesh, cells, through_layers);
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      const FaceH f(i);
      if (!mesh.alive(f) || !mesh.is_triangle(mesh.halfedge(f)) || !closer.may_go(f)) continue;
      context.check();
      pairs += closer.close(f);
    }
  }
  return pairs;
}

}  // namespace advlayers
