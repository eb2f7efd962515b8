#include "mesher/element_faces.h"

#include <algorithm>
#include <set>

#include "imprint/face_sides.h"
#include "mend/inversion.h"

namespace advlayers {
namespace {

constexpr double kHoldsElement = 0.5;  // area of a face, in squares of the size

std::vector<VertexH> corners_of(const SurfaceMesh& mesh, FaceH f) {
  std::vector<VertexH> corners;
  for (const HalfedgeH h : mesh.sides(f)) {
    corners.push_back(mesh.from(h));
  }
  return corners;
}

// Of the faces under the corners; an invalid one where these are but one.
FaceId smallest_under(const std::vector<VertexH>& corners, const FaceSides& sides,
                      const Model& model) {
  std::set<FaceId> faces;
  for (const VertexH v : corners) faces.insert(sides.of(v).begin(), sides.of(v).end());
  if (faces.size() < 2) return {};
  return *std::min_element(faces.begin(), faces.end(), [&model](FaceId a, FaceId b) {
    return model.face(a).area < model.face(b).area;
  });
}

// The face under the element's middle.
FaceId face_under_middle(const SurfaceMesh& mesh, const std::vector<VertexH>& corners,
                         PatchSurface& surface) {
  Vec3 middle = Vec3::Zero();
  for (const VertexH v : corners) middle += mesh.position(v) / static_cast<double>(corners.size());
  SurfacePoint foot;
  if (!surface.project(middle, mesh.data(corners.front()).point, foot)) return {};
  surface.settle(foot);
  return foot.face;
}

}  // namespace

ElementFaces find_element_faces(const RunContext& context, const SurfaceMesh& mesh,
                                PatchSurface& surface, const Discretization& boundary,
                                const SizeField& sizes) {
  const FaceSides sides(mesh, surface, boundary);
  ElementFaces found;
  found.of.assign(mesh.face_capacity(), FaceId());
  std::set<FaceId> held, strained;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    const std::vector<VertexH> corners = corners_of(mesh, f);
    found.of[i] = sides.under(mesh, surface, corners);
    const bool crossing = !found.of[i].valid();
    if (crossing) found.of[i] = face_under_middle(mesh, corners, surface);
    held.insert(found.of[i]);
    if (!crossing && !is_steep(mesh, f, surface)) continue;
    const FaceId smallest = smallest_under(corners, sides, surface.model());
    if (smallest.valid()) strained.insert(smallest);
  }
  for (const FaceId face : surface.faces()) {
    const double size = sizes.of_face(face);
    const bool holds_one = surface.model().face(face).area > kHoldsElement * size * size;
    if (holds_one && held.count(face) == 0) strained.insert(face);
  }
  found.strained.assign(strained.begin(), strained.end());
  return found;
}

}  // namespace advlayers
