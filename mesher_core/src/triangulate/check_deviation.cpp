#include "triangulate/check_deviation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/angles.h"
#include "geometry/model.h"
#include "triangulate/triangle_score.h"

namespace advlayers {
namespace {

// Within these of the corners' normals, the normal at the projected centroid need not be asked for.
const double kSurelyNear = std::cos(15 * kDegree);

struct Offence {
  int count = 0;
  double worst = 0;  // [rad]
  Vec3 point = Vec3::Zero();

  void add(double angle, const Vec3& at) {
    ++count;
    if (angle <= worst) return;
    worst = angle;
    point = at;
  }
};

// Tips have no normal of their own.
bool is_tip(const SurfaceMesh& mesh, VertexH v) {
  return mesh.data(v).support != Support::kPatch && !mesh.is_border(v);
}

// The angle [rad] of the triangle's normal against the surface's at the projected centroid, or at
// the worst corner where there is no foot.
double deviation(const SurfaceMesh& mesh, const std::array<VertexH, 3>& corners, const Vec3& cross,
                 PatchSurface& surface, double worst_corner) {
  Vec3 center = Vec3::Zero();
  for (const VertexH v : corners) center += mesh.position(v) / 3;
  for (const VertexH v : corners) {
    SurfacePoint foot;
    if (is_tip(mesh, v) || !surface.project(center, mesh.data(v).point, foot)) continue;
    const Vec3 normal = surface.normal(foot);
    return std::atan2(cross.cross(normal).norm(), cross.dot(normal));
  }
  return worst_corner;
}

void add_border_edges(const SurfaceMesh& mesh, VertexH v, std::set<EdgeId>& edges) {
  if (!mesh.is_border(v)) return;
  const HalfedgeH out = mesh.outgoing(v);
  edges.insert({mesh.curve(out), mesh.curve(mesh.prev(out))});
}

Diagnostic diagnostic(Severity severity, const std::string& code, FaceId face, const Offence& o,
                      const Sentence& said) {
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.point = o.point;
  d.sentence = said.about(face_name(face), o.count, std::lround(o.worst / kDegree));
  return d;
}

}  // namespace

Deviations check_deviation(const RunContext& context, const SurfaceMesh& mesh,
                           PatchSurface& surface) {
  std::set<EdgeId> edges;
  std::map<FaceId, Offence> inverted, deviating;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    const HalfedgeH h = mesh.halfedge(f);
    const std::array<VertexH, 3> corners{mesh.from(h), mesh.to(h), mesh.to(mesh.next(h))};
    const Vec3& a = mesh.position(corners[0]);
    const Vec3 cross = (mesh.position(corners[1]) - a).cross(mesh.position(corners[2]) - a);
    const double area2 = cross.norm();
    double cosine = 1;
    for (const VertexH v : corners) {
      if (!is_tip(mesh, v)) cosine = std::min(cosine, cross.dot(mesh.data(v).normal) / area2);
    }
    if (cosine > kSurelyNear) continue;
    const double worst_corner = area2 > 0 ? std::acos(std::max(-1.0, cosine)) : M_PI;
    const double angle = deviation(mesh, corners, cross, surface, worst_corner);
    const FaceId face = mesh.data(corners[0]).point.face;
    if (!(cosine > 0) || angle >= M_PI / 2) {
      inverted[face].add(std::max(angle, worst_corner), a);
      for (const VertexH v : corners) add_border_edges(mesh, v, edges);
    } else if (angle > kDeviationBound) {
      deviating[face].add(angle, a);
    }
  }
  Deviations found;
  found.edges_of_inverted.assign(edges.begin(), edges.end());
  for (const auto& [face, o] : inverted) {
    found.diagnostics.push_back(diagnostic(
        Severity::kError, "triangulation-inverted", face, o,
        Sentence(
            "{}: triangles turned over against the surface: {}; the worst leans by {} degrees")));
  }
  for (const auto& [face, o] : deviating) {
    found.diagnostics.push_back(diagnostic(Severity::kWarning, "triangulation-deviates", face, o,
                                           Sentence("{}: triangles more than 30 degrees off the "
                                                    "surface: {}; the worst leans by {} degrees")));
  }
  return found;
}

}  // namespace advlayers
