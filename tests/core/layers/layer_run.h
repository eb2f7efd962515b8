// One face of a shape, triangulated, and the layers that grow on it from all its edges.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/patch_layers.h"
#include "mesh/validate.h"
#include "triangulate/triangulate.h"

namespace advlayers::test {

struct LayerSizes {
  double size = 1.0, first_height = 0.1, growth = 1.2;
};

class LayerRun {
 public:
  explicit LayerRun(const TopoDS_Shape& shape, const LayerSizes& sizes = {})
      : model(model_of(shape)), evaluator(model), surface(evaluator, {FaceId(0)}) {
    settings.size = sizes.size;
    settings.first_height = sizes.first_height;
    settings.growth = sizes.growth;
    const Discretization boundary = discretize(context, evaluator, settings);
    mesh = triangulate(context, surface, evaluator, boundary, settings).mesh;
    for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
      if (mesh.alive(HalfedgeH(i)) && mesh.is_border(HalfedgeH(i))) {
        walls.edges[mesh.curve(HalfedgeH(i))] = {EdgeCondition::kWall,
                                                 {sizes.first_height, sizes.growth}};
      }
    }
  }
  LayerRun(const LayerRun&) = delete;

  // The walls may be changed until this is first called.
  PatchLayers& layers() {
    if (!layers_)
      layers_ = std::make_unique<PatchLayers>(context, PatchId(0), mesh, surface, walls);
    return *layers_;
  }

  bool advance() {
    const std::optional<LayerReport> report = layers().advance();
    if (report) reports.push_back(*report);
    return report.has_value();
  }

  // Until no front is left, or `most` layers more are made.
  void grow(int most = 500) {
    while (most-- > 0 && advance()) {
    }
  }

  int events(Event event) const {
    int sum = 0;
    for (const LayerReport& report : reports) sum += report.events[static_cast<std::size_t>(event)];
    return sum;
  }

  Model model;
  Evaluator evaluator;
  PatchSurface surface;
  Settings settings = test::coarse_settings();
  RunContext context;
  SurfaceMesh mesh;
  WallPlan walls;
  std::vector<LayerReport> reports;

 private:
  std::unique_ptr<PatchLayers> layers_;
};

struct ElementCount {
  int quads = 0, triangles = 0;
  double quad_percent() const { return 100.0 * quads / (quads + triangles); }
  bool operator==(const ElementCount& o) const {
    return quads == o.quads && triangles == o.triangles;
  }
};

inline ElementCount elements_of(const SurfaceMesh& mesh) {
  ElementCount count;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    if (mesh.alive(FaceH(i))) ++(mesh.degree(FaceH(i)) == 4 ? count.quads : count.triangles);
  }
  return count;
}

// [mm^2]; quads are cut in two.
inline double area_of_elements(const SurfaceMesh& mesh) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    if (!mesh.alive(FaceH(i))) continue;
    const HalfedgeH first = mesh.halfedge(FaceH(i));
    const Vec3& origin = mesh.position(mesh.from(first));
    for (HalfedgeH h = mesh.next(first); mesh.to(h) != mesh.from(first); h = mesh.next(h)) {
      const Vec3 a = mesh.position(mesh.from(h)) - origin, b = mesh.position(mesh.to(h)) - origin;
      area += 0.5 * a.cross(b).norm();
    }
  }
  return area;
}

// The border's edges, by ends, CAD edge and place.
using BorderEdge = std::tuple<VertexH, VertexH, EdgeId, double, double, double>;
inline std::vector<BorderEdge> border_of(const SurfaceMesh& mesh) {
  std::vector<BorderEdge> border;
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!mesh.alive(h) || !mesh.is_border(h)) continue;
    const Vec3& p = mesh.position(mesh.from(h));
    border.emplace_back(mesh.from(h), mesh.to(h), mesh.curve(h), p.x(), p.y(), p.z());
  }
  std::sort(border.begin(), border.end());
  return border;
}

// The vertices extruded from each vertex.
inline std::vector<std::vector<VertexH>> kids_by_parent(const SurfaceMesh& mesh) {
  std::vector<std::vector<VertexH>> kids(mesh.vertex_capacity());
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (mesh.alive(v) && mesh.data(v).layer > 0) kids[mesh.data(v).parent.index()].push_back(v);
  }
  return kids;
}

}  // namespace advlayers::test
