// The initial isotropic triangulation of a patch (paper, III): boundary kept as it is, interior by
// size and curvature, every triangle within the angle bound of the exact surface.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"
#include "triangulate/target_size.h"

namespace advlayers {

struct Triangulation {
  // All triangles, layer 0. Every border edge is frozen and names its CAD edge. A boundary node
  // where the border touches itself becomes one vertex per touching run, with the same NodeId.
  // Seams and smooth edges between the patch's faces leave no trace. A tip that is sharp (a cone's
  // apex) is a fixed vertex inside the patch, with Support::kVertex; so are points on a fold that
  // is too sharp to be followed, with Support::kEdge and no node.
  SurfaceMesh mesh;
  std::vector<Diagnostic> diagnostics;
  // Sorted: curved edges beside which triangles are turned over, as their mesh edges leave them by
  // more than a narrow face is wide. Cut finer, they may do better.
  std::vector<EdgeId> coarse_edges;
  int initial_nodes = 0;  // vertices that the nodes of an initial mesh became
};

// The mesh edges on these CAD edges are too long for the shape between them: they cross each other,
// or leave a part of the boundary on the wrong side. Cut finer, they may do.
class BoundaryTooCoarse : public GeometryError {
 public:
  BoundaryTooCoarse(Sentence sentence, std::vector<EdgeId> coarse_edges)
      : GeometryError(std::move(sentence)), edges_(std::move(coarse_edges)) {}
  // Sorted, each once.
  const std::vector<EdgeId>& edges() const { return edges_; }

 private:
  std::vector<EdgeId> edges_;
};

// Some of the patch's several faces cannot be triangulated; without them the others may be.
class FacesNotTriangulated : public GeometryError {
 public:
  FacesNotTriangulated(Sentence sentence, std::vector<FaceId> faces,
                       std::vector<EdgeId> coarse_edges)
      : GeometryError(std::move(sentence)),
        faces_(std::move(faces)),
        edges_(std::move(coarse_edges)) {}
  const std::vector<FaceId>& faces() const { return faces_; }
  // Those that are too coarse for some of the faces; sorted.
  const std::vector<EdgeId>& edges() const { return edges_; }

 private:
  std::vector<FaceId> faces_;
  std::vector<EdgeId> edges_;
};

// `density`: within the boundary, which is kept as it is cut.
// With an initial mesh its nodes inside the faces become vertices where they lie, as far as there
// is room; what is too coarse is refined, and what is poor moved, as anywhere.
// A face whose sides are one line in the boundary holds nothing: alone it gives an empty mesh.
// Throws BoundaryTooCoarse naming face and edges, and GeometryError naming the face where no valid
// triangulation is found for another reason; for a patch of several faces FacesNotTriangulated.
Triangulation triangulate(const RunContext& context, PatchSurface& surface, Evaluator& evaluator,
                          const Discretization& boundary, const Settings& settings,
                          Density density = Density::kAsked);

}  // namespace advlayers
