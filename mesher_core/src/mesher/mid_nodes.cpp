#include "mesher/mid_nodes.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "base/side_by_side.h"
#include "mesher/patch_mids.h"

namespace advlayers {
namespace {

constexpr int kUnused = -1;

class MidNodes {
 public:
  MidNodes(const RunContext& context, const PatchJobs& jobs, const Discretization& boundary,
           const Settings& settings, unsigned threads, const Model& model)
      : boundary_(mids_on_borders(model, boundary)), threads_(threads), context_(context) {
    for (const auto& job : jobs) {
      if (!job->meshed()) continue;
      patches_.push_back(std::make_unique<PatchMids>(*job, model, settings, boundary_));
    }
  }
  void place();
  void number(MeshResult& result) const;
  void report(MeshResult& result) const;

 private:
  struct Side {
    std::size_t patch;
    HalfedgeH h;
  };
  static BoundaryMids mids_on_borders(const Model& model, const Discretization& boundary) {
    Evaluator evaluator(model);
    return BoundaryMids(evaluator, boundary);
  }
  void ease(std::vector<std::vector<FaceH>> overbent);
  void find_sides();
  template <class Visit>
  void for_each_mid(const Visit& visit) const;

  BoundaryMids boundary_;
  unsigned threads_;
  const RunContext& context_;
  std::vector<std::unique_ptr<PatchMids>> patches_;
  std::vector<std::vector<Side>> sides_;  // of each of the border's mid nodes
};

void MidNodes::place() {
  std::vector<std::vector<FaceH>> overbent(patches_.size());
  side_by_side(patches_.size(), threads_, [&](std::size_t i) {
    patches_[i]->place(context_);
    overbent[i] = patches_[i]->overbent(context_);
  });
  ease(std::move(overbent));
}

void MidNodes::find_sides() {
  sides_.resize(boundary_.all().size());
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const SurfaceMesh& mesh = patches_[p]->job().mesh();
    for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
      const HalfedgeH h(i);
      if (!mesh.alive(h) || mesh.is_border(h) || patches_[p]->shared(h) < 0) continue;
      sides_[static_cast<std::size_t>(patches_[p]->shared(h))].push_back({p, h});
    }
  }
}

// One step at a time, in the order of the patches and their faces; each step has its neighbours
// looked at again. Steps are finite in number, so that it ends.
void MidNodes::ease(std::vector<std::vector<FaceH>> overbent) {
  std::deque<std::pair<std::size_t, FaceH>> waiting;
  for (std::size_t p = 0; p < overbent.size(); ++p) {
    for (const FaceH face : overbent[p]) waiting.emplace_back(p, face);
  }
  if (!waiting.empty()) find_sides();
  while (!waiting.empty()) {
    context_.check();
    const auto [p, face] = waiting.front();
    waiting.pop_front();
    if (!patches_[p]->overbent(face)) continue;
    const HalfedgeH h = patches_[p]->best_to_ease(face);
    if (!h.valid()) continue;
    waiting.emplace_back(p, face);
    const int shared = patches_[p]->shared(h);
    if (shared < 0) {
      patches_[p]->ease(h);
      const HalfedgeH other = SurfaceMesh::twin(h);
      const SurfaceMesh& mesh = patches_[p]->job().mesh();
      if (!mesh.is_border(other)) waiting.emplace_back(p, mesh.face(other));
      continue;
    }
    ++boundary_[shared].eased;
    for (const Side& side : sides_[static_cast<std::size_t>(shared)]) {
      waiting.emplace_back(side.patch, patches_[side.patch]->job().mesh().face(side.h));
    }
  }
}

// Calls visit(patch, half-edge) once for every mid node that an element has.
template <class Visit>
void MidNodes::for_each_mid(const Visit& visit) const {
  std::vector<char> seen(boundary_.all().size(), 0);
  for (const auto& patch : patches_) {
    const SurfaceMesh& mesh = patch->job().mesh();
    for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      if (!mesh.alive(h)) continue;
      const int shared = patch->shared(h);
      if (shared >= 0 && std::exchange(seen[static_cast<std::size_t>(shared)], 1)) continue;
      visit(*patch, h);
    }
  }
}

// Elements come in the order in which merge() lists them.
void MidNodes::number(MeshResult& result) const {
  const auto first = static_cast<int>(result.nodes.size());
  std::vector<int> of_border(boundary_.all().size(), kUnused);
  for_each_mid([&](const PatchMids& patch, HalfedgeH h) {
    if (patch.shared(h) >= 0) of_border[static_cast<std::size_t>(patch.shared(h))] = 0;
  });
  for (std::size_t i = 0; i < of_border.size(); ++i) {
    if (of_border[i] == kUnused) continue;
    of_border[i] = first + static_cast<int>(result.mid_nodes.size());
    result.mid_nodes.push_back(boundary_.all()[i].at());
  }
  for (const auto& patch : patches_) {
    const SurfaceMesh& mesh = patch->job().mesh();
    std::vector<int> of_edge(mesh.halfedge_capacity() / 2, kUnused);
    for (std::size_t e = 0; e < of_edge.size(); ++e) {
      const HalfedgeH h(2 * e);
      if (!mesh.alive(h)) continue;
      const int shared = patch->shared(h);
      if (shared >= 0) {
        of_edge[e] = of_border[static_cast<std::size_t>(shared)];
        continue;
      }
      of_edge[e] = first + static_cast<int>(result.mid_nodes.size());
      result.mid_nodes.push_back(patch->at(h));
    }
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      if (!mesh.alive(FaceH(i))) continue;
      std::array<int, 4> mids{};
      std::size_t count = 0;
      for (const HalfedgeH h : mesh.sides(FaceH(i))) mids[count++] = of_edge[h.index() >> 1];
      if (count == 4) {
        result.quad_mids.push_back(mids);
      } else {
        result.triangle_mids.push_back({mids[0], mids[1], mids[2]});
      }
    }
  }
}

void MidNodes::report(MeshResult& result) const {
  int off = 0, eased = 0;
  double furthest = 0.0;
  Vec3 where = Vec3::Zero();
  for_each_mid([&](const PatchMids& patch, HalfedgeH h) {
    const double distance = patch.off_cad(h);
    off += distance > 0.0;
    eased += patch.eased(h);
    if (distance <= furthest) return;
    furthest = distance;
    where = patch.at(h);
  });
  Diagnostic note;
  note.point = where;
  if (off > 0) {
    note.severity = Severity::kWarning;
    note.code = "mid-nodes-off-cad";
    note.sentence = Sentence(
        "{} mid nodes lie off the shape, by up to {} mm: on it, curved elements would be turned "
        "over",
        off, furthest);
    result.diagnostics.push_back(note);
  } else if (eased > 0) {
    note.severity = Severity::kInfo;
    note.code = "mid-nodes-drawn-back";
    note.sentence = Sentence(
        "{} mid nodes follow the curved edges beside them less than in "
        "proportion: curved elements would be turned over",
        eased);
    result.diagnostics.push_back(note);
  }
}

}  // namespace

void add_mid_nodes(const RunContext& context, const PatchJobs& jobs, const Discretization& boundary,
                   const Settings& settings, unsigned threads, const Model& model,
                   MeshResult& result) {
  MidNodes mids(context, jobs, boundary, settings, threads, model);
  mids.place();
  mids.number(result);
  mids.report(result);
}

void find_segment_mids(MeshResult& result) {
  result.segment_mids.assign(result.edge_segments.size(), {});
  if (result.mid_nodes.empty()) return;
  std::map<std::pair<int, int>, int> mid_of;  // of the segments' ends alone
  for (const auto& segments : result.edge_segments) {
    for (const auto& segment : segments) mid_of[std::minmax(segment[0], segment[1])] = kUnused;
  }
  const auto note_sides = [&mid_of](const auto& elements, const auto& mids) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      for (std::size_t k = 0; k < elements[i].size(); ++k) {
        const int a = elements[i][k], b = elements[i][k + 1 < elements[i].size() ? k + 1 : 0];
        const auto found = mid_of.find(std::minmax(a, b));
        if (found != mid_of.end()) found->second = mids[i][k];
      }
    }
  };
  note_sides(result.quads, result.quad_mids);
  note_sides(result.triangles, result.triangle_mids);
  for (std::size_t e = 0; e < result.edge_segments.size(); ++e) {
    for (const auto& segment : result.edge_segments[e]) {
      result.segment_mids[e].push_back(mid_of[std::minmax(segment[0], segment[1])]);
    }
  }
}

}  // namespace advlayers
