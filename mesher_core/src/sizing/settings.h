// What the user asks for, checked. Lengths in mm, angles in degrees, as in the job file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/types.h"
#include "geometry/patch_edges.h"

namespace advlayers {

class InitialNodes;
class Model;
struct InitialMesh;

enum class CoreElements { kQuads, kTriangles };
enum class EndOfGrowth { kFrontsClose, kLayers, kIsotropic };

// Layers from the listed edges, with their own spacing where given.
struct WallSpec {
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;  // empty: on every side
  std::optional<double> first_height, growth;
  std::optional<int> layers;
  std::optional<double> end_height{};     // [mm] linear from first_height to this along each edge
  std::optional<double> aspect_ratio{};   // first height: local segment / aspect_ratio
  std::optional<double> turning_angle{};  // [deg] first height: turning_angle / curvature
  std::optional<double> thickness{};      // [mm] of all layers together
};

// An edge length, or a number of segments, for some edges and faces.
struct SizeSpec {
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;
  std::optional<double> size;     // [mm]
  std::optional<int> segments;    // along each of the edges
  std::optional<double> cluster;  // last segment of an edge / its first one, in geometric steps
  bool both_ends = false;         // clustered towards both: the ratio is that of middle to ends
};

// Finer about a point.
struct Refinement {
  Vec3 point = Vec3::Zero();
  double size = 0.0;    // [mm] within `radius` of the point; grows by size_growth from there
  double radius = 0.0;  // [mm]
};

struct Settings {
  double size = 0.0;          // target edge length [mm]; a segment may be a tenth longer
  double first_height = 0.0;  // [mm]
  double growth = 1.2;
  EndOfGrowth end = EndOfGrowth::kFrontsClose;
  int layers = 0;                 // for EndOfGrowth::kLayers
  double feature_angle = 0.0;     // [deg]; 0: every CAD face is a patch of its own
  double curvature_angle = 20.0;  // [deg] an edge segment or triangle side may turn
  double size_growth = 1.4;       // neighbouring edges differ by no more through size alone
  std::vector<SizeSpec> sizes;
  std::vector<Refinement> refinements;
  CoreElements core = CoreElements::kQuads;
  int order = 1;  // 2: with a node in the middle of each mesh edge, on the exact CAD
  bool walls_all = true;
  std::vector<WallSpec> walls;
  std::vector<EdgeId> match_edges, off_edges;
  std::vector<EdgeId> boundary_edges;  // bound their faces' patches, however smooth they are
  std::vector<EdgeId> smooth_edges;    // lie inside a patch, however sharp they are
  std::vector<FaceId> faces;           // empty: all
  int threads = 0;                     // 0: as many as there are
  // A triangulation of the shape to start from, or none, and where Mesher found its nodes to lie.
  std::shared_ptr<const InitialMesh> initial_mesh{};
  std::shared_ptr<const InitialNodes> initial_nodes{};
};

FeatureRule feature_rule(const Settings& settings);

// Throws InvalidInput naming the setting and its value.
void check(const Settings& settings, const Model& model);

}  // namespace advlayers
