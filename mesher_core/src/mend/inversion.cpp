#include "mend/inversion.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "measure/bend_middle.h"
#include "measure/element_measures.h"
#include "mend/cheapest_triangles.h"
#include "mend/element_faults.h"
#include "quads/pentagon.h"

namespace advlayers {
namespace {

constexpr int kPasses = 7;               // over all faulty elements: mending one may free another
constexpr int kMostThoroughly = 200;     // faulty elements whose vertices are moved about
constexpr double kSplitBend = 0.5;       // cosine between the normals at an edge's ends
constexpr double kFaultCost = 100.0;     // of a fault, against the shape of a triangle
constexpr std::size_t kMostInRing = 12;  // corners of a cavity
// How far a vertex is moved towards a neighbour or their mean.
constexpr std::array<double, 5> kShares{0.05, 0.15, 0.3, 0.5, 0.75};

class Mender {
 public:
  Mender(SurfaceMesh& mesh, PatchSurface& surface, LayerCells cells)
      : mesh_(mesh), surface_(surface), cells_(cells) {}
  bool is_faulty(FaceH face) { return faults(face) > 0; }
  // True where the faults about the element weigh less than before. Moving vertices takes long.
  // Layers that are to stay are spared, if that suffices or the element is a valid one.
  bool mend(FaceH face, bool thoroughly) {
    sparing_ = cells_ == LayerCells::kStay;
    if (mend_about(face, thoroughly)) return true;
    if (!sparing_ || faults(face) < kInvalid) return false;
    sparing_ = false;
    return mend_about(face, thoroughly);
  }
  int of_layers() const { return of_layers_; }

 private:
  int faults(const FaceCorners& corners) { return faults_of(mesh_, corners, surface_); }
  int faults(FaceH face) { return faults(corners_around(mesh_, face)); }

  int faults_about(VertexH v);
  bool mend_about(FaceH face, bool thoroughly);

  bool may_change(FaceH f) const { return !sparing_ || !is_layer_cell(mesh_, f); }
  void note_change(FaceH f) {
    if (cells_ == LayerCells::kStay && is_layer_cell(mesh_, f)) ++of_layers_;
  }
  std::vector<FaceH> faces_about(VertexH v) const;
  bool may_move(VertexH v) const;

  bool is_loose(VertexH v) const;
  bool divide_quad(FaceH face, int most);
  bool flip_side(HalfedgeH h);
  bool recut_beside(HalfedgeH h);
  bool mend_by_edges(FaceH face);
  bool relocate(VertexH v);
  bool remove(VertexH v);
  bool split_bend(HalfedgeH h);
  bool recut_about(FaceH face);
  bool recut_cavity(const std::vector<FaceH>& cavity, const std::vector<VertexH>& ring);

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  LayerCells cells_;
  bool sparing_ = false;
  int of_layers_ = 0;
};

using Triangle = std::array<VertexH, 3>;

bool Mender::divide_quad(FaceH face, int most) {
  if (!may_change(face)) return false;
  const auto v = corners_around(mesh_, face);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const VertexH a = v[k], b = v[k + 1], c = v[(k + 2) % 4], d = v[(k + 3) % 4];
    if (faults(Triangle{a, b, c}) + faults(Triangle{a, c, d}) > most) continue;
    if (mesh_.find_halfedge(a, c).valid()) continue;
    note_change(face);
    mesh_.divide(face, a);
    return true;
  }
  return false;
}

bool Mender::flip_side(HalfedgeH h) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  const VertexH a = mesh_.from(h), b = mesh_.to(h);
  const VertexH c = mesh_.to(mesh_.next(h)), d = mesh_.to(mesh_.next(t));
  const int before = faults(mesh_.face(h)) + faults(mesh_.face(t));
  if (faults(Triangle{a, d, c}) + faults(Triangle{d, b, c}) >= before) return false;
  if (mesh_.curve(h).valid() || !may_change(mesh_.face(h)) || !may_change(mesh_.face(t))) {
    return false;
  }
  const bool frozen = mesh_.frozen(h);
  mesh_.set_frozen(h, false);
  if (mesh_.flip_veto(h) == Veto::kNone) {
    for (const HalfedgeH side : {h, t}) note_change(mesh_.face(side));
    mesh_.flip(h);
    return true;
  }
  mesh_.set_frozen(h, frozen);
  return false;
}

// `h` lies between a triangle, on its left, and a quad.
bool Mender::recut_beside(HalfedgeH h) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  if (mesh_.curve(h).valid() || !may_change(mesh_.face(h)) || !may_change(mesh_.face(t))) {
    return false;
  }
  const Pentagon pentagon = pentagon_at(mesh_, h, mesh_.to(mesh_.next(h)));
  const int before = faults(mesh_.face(h)) + faults(mesh_.face(t));
  for (const auto cut : {PentagonCut::kA, PentagonCut::kB, PentagonCut::kC, PentagonCut::kD}) {
    const PentagonHalves halves = halves_of(pentagon, cut);
    if (faults(halves.triangle) + faults(halves.quad) >= before) continue;
    const bool frozen = mesh_.frozen(h);
    mesh_.set_frozen(h, false);
    const int before_cut = of_layers_;
    for (const HalfedgeH side : {h, t}) note_change(mesh_.face(side));
    if (recut(mesh_, h, cut)) return true;
    of_layers_ = before_cut;
    mesh_.set_frozen(h, frozen);
  }
  return false;
}

// Inside the patch, and on none of the model's edges; points on a fold of the surface are loose.
bool Mender::is_loose(VertexH v) const {
  const VertexData& data = mesh_.data(v);
  if (mesh_.is_border(v) || data.node.valid() || data.support == Support::kVertex) return false;
  if (data.support == Support::kPatch) return true;
  for (const HalfedgeH h : mesh_.around(v)) {
    if (mesh_.curve(h).valid()) return false;
  }
  return true;
}

std::vector<FaceH> Mender::faces_about(VertexH v) const {
  std::vector<FaceH> faces;
  for (const HalfedgeH h : mesh_.around(v)) {
    if (!mesh_.is_border(h)) faces.push_back(mesh_.face(h));
  }
  return faces;
}

bool Mender::may_move(VertexH v) const {
  if (!sparing_) return true;
  const std::vector<FaceH> faces = faces_about(v);
  return std::all_of(faces.begin(), faces.end(), [this](FaceH f) { return may_change(f); });
}

int Mender::faults_about(VertexH v) {
  int faulty = 0;
  for (const HalfedgeH h : mesh_.around(v)) {
    if (!mesh_.is_border(h)) faulty += faults(mesh_.face(h));
  }
  return faulty;
}

// Moves a vertex inside the patch to the nearest of some places about it that leave fewest faulty.
bool Mender::relocate(VertexH v) {
  const VertexData before = mesh_.data(v);
  if (!is_loose(v) || !may_move(v)) return false;
  std::vector<Vec3> beside;
  for (const HalfedgeH h : mesh_.around(v)) {
    beside.push_back(mesh_.position(mesh_.to(h)));
  }
  Vec3 mean = Vec3::Zero();
  for (const Vec3& xyz : beside) mean += xyz / static_cast<double>(beside.size());
  beside.push_back(mean);

  int fewest = faults_about(v);
  VertexData best = before;
  for (const double share : kShares) {
    for (const Vec3& goal : beside) {
      if (fewest == 0) break;
      VertexData& data = mesh_.data(v);
      const Vec3 target = before.point.xyz + share * (goal - before.point.xyz);
      SurfacePoint foot;
      if (!surface_.project(target, before.point, foot)) continue;
      data.point = foot;
      data.normal = surface_.normal(foot);
      const int faulty = faults_about(v);
      if (faulty >= fewest) continue;
      fewest = faulty;
      best = data;
    }
  }
  mesh_.data(v) = best;
  if (best.point.xyz == before.point.xyz) return false;
  for (const FaceH f : faces_about(v)) note_change(f);
  return true;
}

// Cuts the faces within the ring into the triangles with the fewest faults.
bool Mender::recut_cavity(const std::vector<FaceH>& cavity, const std::vector<VertexH>& ring) {
  if (ring.size() < 3 || ring.size() > kMostInRing) return false;
  if (std::set<VertexH>(ring.begin(), ring.end()).size() < ring.size()) return false;  // no disc
  int before = 0, after = 0;
  for (const FaceH f : cavity) {
    if (!may_change(f)) return false;
    before += faults(f);
  }
  const auto made = cheapest_triangles(ring, [this](const Triangle& t) {
    const Vec3 normal = mesh_.data(t[0]).normal + mesh_.data(t[1]).normal + mesh_.data(t[2]).normal;
    const double sine =
        min_angle_sine(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]), normal);
    return kFaultCost * faults(t) + 1.0 - sine;
  });
  for (const auto& t : made) after += faults(Triangle{t[0], t[1], t[2]});
  if (after >= before || mesh_.replace_veto(cavity, made) != Veto::kNone) return false;
  for (const FaceH f : cavity) note_change(f);
  mesh_.replace(cavity, made);
  return true;
}

// Lets a vertex of the core vanish.
bool Mender::remove(VertexH v) {
  if (!is_loose(v) || mesh_.data(v).layer != 0) return false;
  std::vector<FaceH> star;
  std::vector<VertexH> ring;
  for (const HalfedgeH h : mesh_.around_ccw(v)) {
    star.push_back(mesh_.face(h));
    for (HalfedgeH side = mesh_.next(h); mesh_.to(side) != v; side = mesh_.next(side)) {
      ring.push_back(mesh_.from(side));
    }
  }
  return recut_cavity(star, ring);
}

// Cuts a triangle together with the triangles beside it anew.
bool Mender::recut_about(FaceH face) {
  std::vector<FaceH> cavity{face};
  std::vector<VertexH> ring;
  for (const HalfedgeH h : mesh_.sides(face)) {
    const HalfedgeH t = SurfaceMesh::twin(h);
    ring.push_back(mesh_.from(h));
    const bool joins = !mesh_.is_border(t) && mesh_.is_triangle(t) && !mesh_.curve(h).valid();
    if (joins && may_change(mesh_.face(t))) {
      cavity.push_back(mesh_.face(t));
      ring.push_back(mesh_.to(mesh_.next(t)));
    }
  }
  return recut_cavity(cavity, ring);
}

// Splits the edge between two triangles half-way around the surface's bend.
bool Mender::split_bend(HalfedgeH h) {
  if (mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::twin(h))) return false;
  if (mesh_.curve(h).valid() || bend_cosine(mesh_, h) > kSplitBend) return false;
  VertexData middle;
  if (mesh_.split_edge_veto(h) != Veto::kNone || !find_bend_middle(mesh_, surface_, h, middle)) {
    return false;
  }
  const FaceH left = mesh_.face(h), right = mesh_.face(SurfaceMesh::twin(h));
  if (!may_change(left) || !may_change(right)) return false;
  const int before = faults(left) + faults(right);
  const VertexH back = mesh_.to(h);
  const VertexH v = mesh_.split_edge(h, middle);
  if (faults_about(v) < before) {
    for (const FaceH f : faces_about(v)) note_change(f);
    return true;
  }
  mesh_.collapse(mesh_.find_halfedge(v, back));
  return false;
}

bool Mender::mend_about(FaceH face, bool thoroughly) {
  if (mend_by_edges(face)) return true;
  for (const VertexH v : corners_around(mesh_, face)) {
    if (thoroughly && relocate(v)) return true;
  }
  for (const VertexH v : corners_around(mesh_, face)) {
    if (remove(v)) return true;
  }
  const HalfedgeH first = mesh_.halfedge(face);
  if (mesh_.is_triangle(first)) {
    const HalfedgeH second = mesh_.next(first);
    for (const HalfedgeH h : {first, second, mesh_.next(second)}) {
      if (split_bend(h)) return true;
    }
    return recut_about(face);
  }
  // No better, but the next pass has more to choose from.
  return divide_quad(face, faults(face));
}

bool Mender::mend_by_edges(FaceH face) {
  const HalfedgeH first = mesh_.halfedge(face);
  if (!mesh_.is_triangle(first) && divide_quad(face, faults(face) - 1)) return true;
  for (const HalfedgeH h : mesh_.sides(face)) {
    const HalfedgeH t = SurfaceMesh::twin(h);
    if (!mesh_.is_border(t)) {
      const bool left = mesh_.is_triangle(h), right = mesh_.is_triangle(t);
      if (left && right && flip_side(h)) return true;
      if (left && !right && recut_beside(h)) return true;
      if (!left && right && recut_beside(t)) return true;
    }
  }
  return false;
}

}  // namespace

bool is_inverted(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface) {
  return uprightness(mesh, corners_around(mesh, face), surface) < 0.0;
}

bool is_steep(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface) {
  return uprightness(mesh, corners_around(mesh, face), surface) < kSteep;
}

Mended mend_inverted(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                     LayerCells cells) {
  Mender mender(mesh, surface, cells);
  int left = 0;
  bool thoroughly = false;
  for (int pass = 0; pass < kPasses; ++pass) {
    left = 0;
    bool mended = false;
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      context.check();
      const FaceH f(i);
      if (!mesh.alive(f) || !mender.is_faulty(f)) continue;
      ++left;
      mended = mender.mend(f, thoroughly) || mended;
    }
    const bool few = left > 0 && left <= kMostThoroughly;
    if (!mended && (thoroughly || !few)) break;
    thoroughly = few;
  }
  return {left, mender.of_layers()};
}

}  // namespace advlayers
