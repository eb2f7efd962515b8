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
// What is to become of boundary edges that a list of walls leaves out: layers run along those that
// meet a wall, nothing happens at them, or they are walls by the mesh's own values.
enum class OtherEdges { kMatch, kOff, kWall };
// How segments between given ends grow.
enum class Distribution { kTanh, kGeometric, kConstant };
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
  // Of all layers together, over the size of the edge where it is least.
  std::optional<double> thickness_share{};
};

// An edge length, or a number of segments, for some edges and faces.
struct SizeSpec {
  std::vector<EdgeId> edges;
  std::vector<FaceId> faces;
  std::optional<double> size;     // [mm]
  std::optional<int> segments;    // along each of the edges
  std::optional<double> cluster;  // last segment of an edge / its first one, in geometric steps
  bool both_ends = false;         // clustered towards both: the ratio is that of middle to ends
  std::optional<double> first_segment{};            // [mm] at the first vertex of each edge
  std::optional<double> last_segment{};             // [mm] at its last one
  Distribution distribution = Distribution::kTanh;  // between them
};

// Finer about a point, a line or in a box.
struct Refinement {
  Vec3 point = Vec3::Zero();
  double size = 0.0;             // [mm] within `radius` of it; grows by size_growth from there
  double radius = 0.0;           // [mm]
  std::optional<Vec3> end{};     // the line from `point` to here
  std::optional<Vec3> corner{};  // the box between `point` and here, along the axes

  double distance(const Vec3& p) const;  // [mm] of the point, the line or the box
};

// Edges and faces that are cut and meshed as their counterparts are: those are where these come to
// by a rotation about the axis and then the translation.
struct PeriodicSpec {
  std::vector<EdgeId> given_edges;
  std::vector<FaceId> given_faces;
  Vec3 translation = Vec3::Zero();  // [mm]
  Vec3 axis_point = Vec3::Zero();   // [mm]
  Vec3 axis = Vec3::UnitZ();
  double angle = 0.0;  // [deg]
};

struct Settings {
  double size = 0.0;          // target edge length [mm]; a segment may be a tenth longer
  double first_height = 0.0;  // [mm]
  double growth = 1.2;
  EndOfGrowth end = EndOfGrowth::kFrontsClose;
  int layers = 0;                 // for EndOfGrowth::kLayers
  double feature_angle = 15.0;    // [deg]; 0: every CAD face is a patch of its own
  double curvature_angle = 20.0;  // [deg] an edge segment or triangle side may turn
  double size_growth = 1.4;       // neighbouring edges differ by no more through size alone
  int cells_across = 0;           // elements over the extent of each face at least; 0: any
  double min_size = 0.0;          // [mm] curvature asks for no less
  double chord_deviation = 0.0;   // [mm] of a mesh edge from its curve or surface; 0: any
  double relative_chord = 0.0;    // the same over the edge's length; 0: any
  std::vector<SizeSpec> sizes;
  std::vector<Refinement> refinements;
  CoreElements core = CoreElements::kQuads;
  int order = 1;  // 2: with a node in the middle of each mesh edge, on the exact CAD
  bool walls_all = true;
  std::vector<WallSpec> walls;
  OtherEdges others = OtherEdges::kMatch;
  std::vector<EdgeId> match_edges, off_edges;
  std::vector<EdgeId> boundary_edges;  // bound their faces' patches, however smooth they are
  std::vector<EdgeId> smooth_edges;    // lie inside a patch, however sharp they are
  std::vector<FaceId> faces;           // empty: all
  std::vector<FaceId> mapped_faces;    // filled with rows and columns from side to side
  std::vector<PeriodicSpec> periodic;
  int threads = 0;  // 0: as many as there are
  // A triangulation of the shape to start from, or none, and where Mesher found its nodes to lie.
  std::shared_ptr<const InitialMesh> initial_mesh{};
  std::shared_ptr<const InitialNodes> initial_nodes{};
};

FeatureRule feature_rule(const Settings& settings);

// Throws InvalidInput naming the setting and its value.
void check(const Settings& settings, const Model& model);

}  // namespace advlayers
