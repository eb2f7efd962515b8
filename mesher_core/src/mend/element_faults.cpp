#include "mend/element_faults.h"

#include <limits>

#include "measure/element_measures.h"

namespace advlayers {
namespace {

// The corners' normals decide where all agree with the element by this cosine; the projection of
// the centroid is spared then.
constexpr double kClearlyUpright = 0.55;
constexpr double kBent = -0.2;                      // cosine at a corner
constexpr int kTurnedOver = 4, kFolded = kInvalid;  // weights of faults

Vec3 area_of(const SurfaceMesh& mesh, const FaceCorners& v) {
  const Vec3 &a = mesh.position(v[0]), &b = mesh.position(v[1]), &c = mesh.position(v[2]);
  if (v.size() == 3) return (b - a).cross(c - a);
  return (c - a).cross(mesh.position(v[v.size() - 1]) - b);
}

// True where a corner of a quad turns back, against the surface at its corners or against the
// quad's own normal: over a bend the one says nothing of the other.
bool has_folded_corner(const SurfaceMesh& mesh, const FaceCorners& v) {
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

// Whether the surface at a corner faces away from the element, which reaches around a bend then.
// Tips and folds of the surface have no normal that would tell.
bool is_bent(const SurfaceMesh& mesh, const FaceCorners& corners) {
  const Vec3 area = area_of(mesh, corners);
  const double most = kBent * area.norm();
  for (const VertexH v : corners) {
    const VertexData& data = mesh.data(v);
    const bool tells = data.support == Support::kPatch || mesh.is_border(v);
    if (tells && data.normal.dot(area) < most) return true;
  }
  return false;
}

}  // namespace

FaceCorners corners_around(const SurfaceMesh& mesh, FaceH face) {
  FaceCorners corners;
  for (const HalfedgeH h : mesh.sides(face)) {
    corners.vertex[corners.count++] = mesh.from(h);
  }
  return corners;
}

double uprightness(const SurfaceMesh& mesh, const FaceCorners& corners, PatchSurface& surface) {
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

int faults_of(const SurfaceMesh& mesh, const FaceCorners& v, PatchSurface& surface) {
  const double upright = uprightness(mesh, v, surface);
  if (upright < 0.0) return kTurnedOver;
  if (v.size() == 4 && has_folded_corner(mesh, v)) return kFolded;
  return upright < kSteep || is_bent(mesh, v) ? 1 : 0;
}

}  // namespace advlayers
