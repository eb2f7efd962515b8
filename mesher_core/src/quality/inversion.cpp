#include "quality/inversion.h"

#include <array>

#include "quality/element_measures.h"
#include "quality/pentagon.h"

namespace advlayers {
namespace {

constexpr int kPasses = 4;
// The corners' normals decide where all agree with the element by this cosine; the projection of
// the centroid is spared then.
constexpr double kClearlyUpright = 0.3;

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

template <class Corners>
bool is_turned_over(const SurfaceMesh& mesh, const Corners& corners, PatchSurface& surface) {
  const Vec3 area = area_of(mesh, corners);
  const double size = area.norm();
  if (!(size > 0.0)) return true;
  bool upright = true;
  Vec3 center = Vec3::Zero();
  for (const VertexH v : corners) {
    upright = upright && mesh.data(v).normal.dot(area) > kClearlyUpright * size;
    center += mesh.position(v) / static_cast<double>(corners.size());
  }
  if (upright) return false;
  for (const VertexH v : corners) {
    SurfacePoint foot;
    if (surface.project(center, mesh.data(v).point, foot)) {
      return surface.normal(foot).dot(area) < 0.0;
    }
  }
  return false;
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

// True for what mending is to remove.
template <class Corners>
bool is_faulty_shape(const SurfaceMesh& mesh, const Corners& v, PatchSurface& surface) {
  return is_turned_over(mesh, v, surface) || (v.size() == 4 && has_folded_corner(mesh, v));
}

class Mender {
 public:
  Mender(SurfaceMesh& mesh, PatchSurface& surface) : mesh_(mesh), surface_(surface) {}
  bool is_faulty(FaceH face) { return count(face) > 0; }
  // True where fewer elements are faulty than before.
  bool mend(FaceH face);

 private:
  template <class Corners>
  int count(const Corners& corners) {
    return is_faulty_shape(mesh_, corners, surface_) ? 1 : 0;
  }
  int count(FaceH face) { return count(corners_around(mesh_, face)); }

  bool divide_quad(FaceH face);
  bool flip_side(HalfedgeH h);
  bool recut_beside(HalfedgeH h);

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
};

using Triangle = std::array<VertexH, 3>;

bool Mender::divide_quad(FaceH face) {
  const auto v = corners_around(mesh_, face);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const VertexH a = v[k], b = v[k + 1], c = v[(k + 2) % 4], d = v[(k + 3) % 4];
    if (count(Triangle{a, b, c}) + count(Triangle{a, c, d}) > 0) continue;
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
  const int before = count(mesh_.face(h)) + count(mesh_.face(t));
  if (count(Triangle{a, d, c}) + count(Triangle{d, b, c}) >= before) return false;
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
  const Pentagon pentagon = pentagon_at(mesh_, h, mesh_.to(mesh_.next(h)));
  const int before = count(mesh_.face(h)) + count(mesh_.face(t));
  for (const auto cut : {PentagonCut::kA, PentagonCut::kB, PentagonCut::kC, PentagonCut::kD}) {
    const PentagonHalves halves = halves_of(pentagon, cut);
    if (count(halves.triangle) + count(halves.quad) >= before) continue;
    const bool frozen = mesh_.frozen(h);
    mesh_.set_frozen(h, false);
    if (recut(mesh_, h, cut)) return true;
    mesh_.set_frozen(h, frozen);
  }
  return false;
}

bool Mender::mend(FaceH face) {
  const HalfedgeH first = mesh_.halfedge(face);
  if (!mesh_.is_triangle(first) && divide_quad(face)) return true;
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
  return is_turned_over(mesh, corners_around(mesh, face), surface);
}

int mend_inverted(SurfaceMesh& mesh, PatchSurface& surface, const CancelFlag& cancel) {
  Mender mender(mesh, surface);
  int left = 0;
  bool mended = true;
  for (int pass = 0; pass < kPasses && mended; ++pass) {
    left = 0;
    mended = false;
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      cancel.check();
      const FaceH f(i);
      if (!mesh.alive(f) || !mender.is_faulty(f)) continue;
      ++left;
      mended = mender.mend(f) || mended;
    }
  }
  return left;
}

}  // namespace advlayers
