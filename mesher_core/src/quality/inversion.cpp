#include "quality/inversion.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <vector>

#include "quality/cheapest_triangles.h"
#include "quality/element_measures.h"
#include "quality/pentagon.h"

namespace advlayers {
namespace {

constexpr int kPasses = 7;
constexpr int kMostThoroughly = 200;  // faulty elements whose vertices are moved about
// The corners' normals decide where all agree with the element by this cosine; the projection of
// the centroid is spared then.
constexpr double kClearlyUpright = 0.3;
// An element that leans more than 75 degrees from the surface makes a fold with its neighbours.
constexpr double kSteep = 0.26;
constexpr int kTurnedOver = 4, kFolded = 2;
constexpr double kFaultCost = 100.0;     // of a fault, against the shape of a triangle
constexpr std::size_t kMostInRing = 12;  // corners of a cavity
// How far a vertex is moved towards a neighbour or their mean.
constexpr std::array<double, 5> kShares{0.05, 0.15, 0.3, 0.5, 0.75};

struct FaceCorners {
  std::array<VertexH, 4> vertex;
  std::size_t count = 0;

  std::size_t size() const { return count; }
  VertexH operator[](std::size_t k) const { return vertex[k]; }
  const VertexH* begin() const { return vertex.data(); }
  const VertexH* end() const { return vertex.data() + count; }
};

FaceCorners corners_around(const SurfaceMesh& mesh, FaceH face) {
  FaceCorners corners;
  const HalfedgeH first = mesh.halfedge(face);
  HalfedgeH h = first;
  do {
    corners.vertex[corners.count++] = mesh.from(h);
    h = mesh.next(h);
  } while (h != first && corners.count < 4);
  return corners;
}

template <class Corners>
Vec3 area_of(const SurfaceMesh& mesh, const Corners& v) {
  const Vec3 &a = mesh.position(v[0]), &b = mesh.position(v[1]), &c = mesh.position(v[2]);
  if (v.size() == 3) return (b - a).cross(c - a);
  return (c - a).cross(mesh.position(v[v.size() - 1]) - b);
}

// The cosine between the element's normal and the surface's at the foot of its centroid, or 1 where
// the corners' normals tell that it is upright; -1 where it has no area.
template <class Corners>
double uprightness(const SurfaceMesh& mesh, const Corners& corners, PatchSurface& surface) {
  const Vec3 area = area_of(mesh, corners);
  const double size = area.norm();
  if (!(size > 0.0)) return -1.0;
  bool upright = true;
  Vec3 center = Vec3::Zero();
  for (const VertexH v : corners) {
    upright = upright && mesh.data(v).normal.dot(area) > kClearlyUpright * size;
    center += mesh.position(v) / static_cast<double>(corners.size());
  }
  if (upright) return 1.0;
  // Two sheets of the surface may lie close together: the nearest foot counts.
  double nearest = std::numeric_limits<double>::infinity();
  double side = 0.0;
  for (const VertexH v : corners) {
    SurfacePoint foot;
    if (!surface.project(center, mesh.data(v).point, foot)) continue;
    const double distance = (foot.xyz - center).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    side = surface.normal(foot).dot(area);
  }
  return side / size;
}

// True where a corner of a quad turns back, against the surface at its corners or against the
// quad's own normal: over a bend the one says nothing of the other.
template <class Corners>
bool has_folded_corner(const SurfaceMesh& mesh, const Corners& v) {
  Vec3 normal = Vec3::Zero();
  for (const VertexH corner : v) normal += mesh.data(corner).normal;
  for (const Vec3& against : {normal, area_of(mesh, v)}) {
    if (right_angle_quality(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                            mesh.position(v[v.size() - 1]), against) < 0.0) {
      return true;
    }
  }
  return false;
}

// What mending is to remove, by weight: an element turned over, a folded corner, a steep element.
template <class Corners>
int faults_of(const SurfaceMesh& mesh, const Corners& v, PatchSurface& surface) {
  const double upright = uprightness(mesh, v, surface);
  if (upright < 0.0) return kTurnedOver;
  if (v.size() == 4 && has_folded_corner(mesh, v)) return kFolded;
  return upright < kSteep ? 1 : 0;
}

class Mender {
 public:
  Mender(SurfaceMesh& mesh, PatchSurface& surface) : mesh_(mesh), surface_(surface) {}
  bool is_faulty(FaceH face) { return faults(face) > 0; }
  // True where the faults about the element weigh less than before. Moving vertices takes long.
  bool mend(FaceH face, bool thoroughly);

 private:
  template <class Corners>
  int faults(const Corners& corners) {
    return faults_of(mesh_, corners, surface_);
  }
  int faults(FaceH face) { return faults(corners_around(mesh_, face)); }

  int faults_about(VertexH v);
  int faults_after_collapse(HalfedgeH h);

  bool is_loose(VertexH v) const;
  bool divide_quad(FaceH face, int most);
  bool flip_side(HalfedgeH h);
  bool recut_beside(HalfedgeH h);
  bool mend_by_edges(FaceH face);
  bool relocate(VertexH v);
  bool remove(VertexH v);
  bool recut_about(FaceH face);
  bool recut_cavity(const std::vector<FaceH>& cavity, const std::vector<VertexH>& ring);

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
};

using Triangle = std::array<VertexH, 3>;

bool Mender::divide_quad(FaceH face, int most) {
  const auto v = corners_around(mesh_, face);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const VertexH a = v[k], b = v[k + 1], c = v[(k + 2) % 4], d = v[(k + 3) % 4];
    if (faults(Triangle{a, b, c}) + faults(Triangle{a, c, d}) > most) continue;
    if (mesh_.find_halfedge(a, c).valid()) continue;
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
  if (mesh_.curve(h).valid()) return false;
  const bool frozen = mesh_.frozen(h);
  mesh_.set_frozen(h, false);
  if (mesh_.flip_veto(h) == Veto::kNone) {
    mesh_.flip(h);
    return true;
  }
  mesh_.set_frozen(h, frozen);
  return false;
}

// `h` lies between a triangle, on its left, and a quad.
bool Mender::recut_beside(HalfedgeH h) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  if (mesh_.curve(h).valid()) return false;
  const Pentagon pentagon = pentagon_at(mesh_, h, mesh_.to(mesh_.next(h)));
  const int before = faults(mesh_.face(h)) + faults(mesh_.face(t));
  for (const auto cut : {PentagonCut::kA, PentagonCut::kB, PentagonCut::kC, PentagonCut::kD}) {
    const PentagonHalves halves = halves_of(pentagon, cut);
    if (faults(halves.triangle) + faults(halves.quad) >= before) continue;
    const bool frozen = mesh_.frozen(h);
    mesh_.set_frozen(h, false);
    if (recut(mesh_, h, cut)) return true;
    mesh_.set_frozen(h, frozen);
  }
  return false;
}

// Inside the patch, and on none of the model's edges; points on a fold of the surface are loose.
bool Mender::is_loose(VertexH v) const {
  const VertexData& data = mesh_.data(v);
  if (mesh_.is_border(v) || data.node.valid() || data.support == Support::kVertex) return false;
  if (data.support == Support::kPatch) return true;
  const HalfedgeH first = mesh_.outgoing(v);
  HalfedgeH h = first;
  do {
    if (mesh_.curve(h).valid()) return false;
    h = mesh_.rotate_cw(h);
  } while (h != first);
  return true;
}

int Mender::faults_about(VertexH v) {
  int faulty = 0;
  const HalfedgeH first = mesh_.outgoing(v);
  HalfedgeH h = first;
  do {
    if (!mesh_.is_border(h)) faulty += faults(mesh_.face(h));
    h = mesh_.rotate_cw(h);
  } while (h != first);
  return faulty;
}

// Moves a vertex inside the patch to the nearest of some places about it that leave fewest faulty.
bool Mender::relocate(VertexH v) {
  const VertexData before = mesh_.data(v);
  if (!is_loose(v)) return false;
  std::vector<Vec3> beside;
  const HalfedgeH first = mesh_.outgoing(v);
  HalfedgeH h = first;
  do {
    beside.push_back(mesh_.position(mesh_.to(h)));
    h = mesh_.rotate_cw(h);
  } while (h != first);
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
  return best.point.xyz != before.point.xyz;
}

// Cuts the faces within the ring into the triangles with the fewest faults.
bool Mender::recut_cavity(const std::vector<FaceH>& cavity, const std::vector<VertexH>& ring) {
  if (ring.size() < 3 || ring.size() > kMostInRing) return false;
  if (std::set<VertexH>(ring.begin(), ring.end()).size() < ring.size()) return false;  // no disc
  int before = 0, after = 0;
  for (const FaceH f : cavity) before += faults(f);
  const auto made = cheapest_triangles(ring, [this](const Triangle& t) {
    const Vec3 normal = mesh_.data(t[0]).normal + mesh_.data(t[1]).normal + mesh_.data(t[2]).normal;
    const double sine =
        min_angle_sine(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]), normal);
    return kFaultCost * faults(t) + 1.0 - sine;
  });
  for (const auto& t : made) after += faults(Triangle{t[0], t[1], t[2]});
  if (after >= before || mesh_.replace_veto(cavity, made) != Veto::kNone) return false;
  mesh_.replace(cavity, made);
  return true;
}

// Lets a vertex of the core vanish.
bool Mender::remove(VertexH v) {
  if (!is_loose(v) || mesh_.data(v).layer != 0) return false;
  std::vector<FaceH> star;
  std::vector<VertexH> ring;
  const HalfedgeH first = mesh_.outgoing(v);
  HalfedgeH h = first;
  do {
    star.push_back(mesh_.face(h));
    for (HalfedgeH side = mesh_.next(h); mesh_.to(side) != v; side = mesh_.next(side)) {
      ring.push_back(mesh_.from(side));
    }
    h = mesh_.rotate_ccw(h);
  } while (h != first);
  return recut_cavity(star, ring);
}

// Cuts a triangle together with the triangles beside it anew.
bool Mender::recut_about(FaceH face) {
  std::vector<FaceH> cavity{face};
  std::vector<VertexH> ring;
  const HalfedgeH first = mesh_.halfedge(face);
  HalfedgeH h = first;
  do {
    const HalfedgeH t = SurfaceMesh::twin(h);
    ring.push_back(mesh_.from(h));
    if (!mesh_.is_border(t) && mesh_.is_triangle(t) && !mesh_.curve(h).valid()) {
      cavity.push_back(mesh_.face(t));
      ring.push_back(mesh_.to(mesh_.next(t)));
    }
    h = mesh_.next(h);
  } while (h != first);
  return recut_cavity(cavity, ring);
}

bool Mender::mend(FaceH face, bool thoroughly) {
  if (mend_by_edges(face)) return true;
  for (const VertexH v : corners_around(mesh_, face)) {
    if (thoroughly && relocate(v)) return true;
  }
  for (const VertexH v : corners_around(mesh_, face)) {
    if (remove(v)) return true;
  }
  const HalfedgeH first = mesh_.halfedge(face);
  if (mesh_.is_triangle(first)) return recut_about(face);
  // No better, but the next pass has more to choose from.
  return divide_quad(face, faults(face));
}

bool Mender::mend_by_edges(FaceH face) {
  const HalfedgeH first = mesh_.halfedge(face);
  if (!mesh_.is_triangle(first) && divide_quad(face, faults(face) - 1)) return true;
  HalfedgeH h = first;
  do {
    const HalfedgeH t = SurfaceMesh::twin(h);
    if (!mesh_.is_border(t)) {
      const bool left = mesh_.is_triangle(h), right = mesh_.is_triangle(t);
      if (left && right && flip_side(h)) return true;
      if (left && !right && recut_beside(h)) return true;
      if (!left && right && recut_beside(t)) return true;
    }
    h = mesh_.next(h);
  } while (h != first);
  return false;
}

}  // namespace

bool is_inverted(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface) {
  return uprightness(mesh, corners_around(mesh, face), surface) < 0.0;
}

bool is_steep(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface) {
  return uprightness(mesh, corners_around(mesh, face), surface) < kSteep;
}

int mend_inverted(SurfaceMesh& mesh, PatchSurface& surface, const CancelFlag& cancel) {
  Mender mender(mesh, surface);
  int left = 0;
  bool thoroughly = false;
  for (int pass = 0; pass < kPasses; ++pass) {
    left = 0;
    bool mended = false;
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      cancel.check();
      const FaceH f(i);
      if (!mesh.alive(f) || !mender.is_faulty(f)) continue;
      ++left;
      mended = mender.mend(f, thoroughly) || mended;
    }
    const bool few = left > 0 && left <= kMostThoroughly;
    if (!mended && (thoroughly || !few)) break;
    thoroughly = few;
  }
  return left;
}

}  // namespace advlayers
