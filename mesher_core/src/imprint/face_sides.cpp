#include "imprint/face_sides.h"

#include <algorithm>

namespace advlayers {
namespace {

void sort_unique(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

}  // namespace

FaceSides::FaceSides(const SurfaceMesh& mesh, const PatchSurface& surface,
                     const Discretization& boundary)
    : model_(surface.model()), patch_(surface.faces()), faces_at_(model_.vertices().size()) {
  sort_unique(patch_);
  for (const FaceId face : patch_) {
    for (const auto& loop : model_.face(face).loops) {
      for (const CoEdge& coedge : loop) {
        const Edge& edge = model_.edge(coedge.edge);
        for (const VertexId end : {edge.start, edge.end}) {
          if (end.valid()) faces_at_[end.index()].push_back(face);
        }
      }
    }
  }
  for (auto& faces : faces_at_) sort_unique(faces);
  sides_.resize(mesh.vertex_capacity());
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!mesh.alive(v)) continue;
    const VertexData& data = mesh.data(v);
    if (!data.node.valid()) {
      if (data.support != Support::kPatch) put_by_curves(mesh, v);
      if (sides_[i].empty()) sides_[i] = {data.point.face};
      continue;
    }
    const BoundaryNode& node = boundary.nodes[data.node.index()];
    if (node.vertex.valid()) {
      sides_[i] = at(node.vertex);
    } else {
      for (const FaceId face : model_.edge(node.edge).faces) {
        if (in_patch(face)) sides_[i].push_back(face);
      }
      sort_unique(sides_[i]);
    }
    if (sides_[i].empty()) sides_[i] = {data.point.face};
  }
}

bool FaceSides::in_patch(FaceId face) const {
  return std::binary_search(patch_.begin(), patch_.end(), face);
}

// A vertex inside the patch that was brought onto edges of the model lies on all faces beside them.
void FaceSides::put_by_curves(const SurfaceMesh& mesh, VertexH v) {
  std::vector<FaceId>& faces = sides_[v.index()];
  for (const HalfedgeH h : mesh.around(v)) {
    if (mesh.curve(h).valid()) {
      for (const FaceId face : model_.edge(mesh.curve(h)).faces) {
        if (in_patch(face)) faces.push_back(face);
      }
    }
  }
  sort_unique(faces);
}

std::vector<FaceId> FaceSides::at(VertexId vertex) const { return faces_at_[vertex.index()]; }

void FaceSides::put(VertexH v, std::vector<FaceId> faces) {
  if (v.index() >= sides_.size()) sides_.resize(v.index() + 1);
  sides_[v.index()] = std::move(faces);
}

bool FaceSides::share_face(VertexH a, VertexH b) const {
  for (const FaceId face : of(a)) {
    if (std::binary_search(of(b).begin(), of(b).end(), face)) return true;
  }
  return false;
}

std::vector<FaceId> FaceSides::all_common(const std::vector<VertexH>& vertices) const {
  std::vector<FaceId> found;
  for (const FaceId face : of(vertices.front())) {
    const bool all = std::all_of(vertices.begin(), vertices.end(), [&](VertexH v) {
      return std::binary_search(of(v).begin(), of(v).end(), face);
    });
    if (all) found.push_back(face);
  }
  return found;
}

FaceId FaceSides::under(const SurfaceMesh& mesh, PatchSurface& surface,
                        const std::vector<VertexH>& corners) const {
  const std::vector<FaceId> common = all_common(corners);
  if (common.empty()) return {};
  if (common.size() == 1) return common.front();
  Vec3 middle = Vec3::Zero();
  for (const VertexH v : corners) middle += mesh.position(v) / static_cast<double>(corners.size());
  SurfacePoint foot;
  if (!surface.project(middle, mesh.data(corners.front()).point, foot)) return common.front();
  surface.settle(foot);
  const bool beside = std::find(common.begin(), common.end(), foot.face) != common.end();
  return beside ? foot.face : common.front();
}

FaceId FaceSides::common(const std::vector<VertexH>& vertices) const {
  const std::vector<FaceId> all = all_common(vertices);
  return all.empty() ? FaceId() : all.front();
}

}  // namespace advlayers
