#include "sizing/schema.h"

#include <cmath>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr Range kAny{};
constexpr Range kAboveZero{0.0, Range().highest, true};
constexpr Range kFromZero{0.0};
constexpr Range kGrowth{1.0, kMostGrowth};
constexpr Range kRightAngle{0.0, 90.0, true};
constexpr Range kLayers{0.0, kMostLayers};

}  // namespace

const char* kind_name(Kind kind) {
  switch (kind) {
    case Kind::kNumber:
      return "number";
    case Kind::kCount:
      return "count";
    case Kind::kFlag:
      return "flag";
    case Kind::kPoint:
      return "point";
    case Kind::kEdges:
      return "edges";
    case Kind::kFaces:
      return "faces_only";
    case Kind::kAllFaces:
      return "faces";
    case Kind::kLayers:
      return "layers";
    case Kind::kChoice:
      return "choice";
    case Kind::kWalls:
      return "walls";
    case Kind::kSizes:
      return "sizes";
    case Kind::kRefinements:
      return "refinements";
    case Kind::kPeriodic:
      return "periodic";
    case Kind::kInitialMesh:
      break;
  }
  return "mesh";
}

bool Range::holds(double value) const {
  return std::isfinite(value) && (above ? value > lowest : value >= lowest) &&
         (below ? value < highest : value <= highest);
}

Sentence Range::said(const std::string& unit) const {
  const std::string end = unit.empty() ? "" : " " + unit;
  const Sentence low("{}", Sentence("{} {}{}", above ? ">" : ">=", lowest, end).english());
  const Sentence high("{}", Sentence("{} {}{}", below ? "<" : "<=", highest, end).english());
  if (std::isinf(highest)) return std::isinf(lowest) ? Sentence("a finite number") : low;
  if (std::isinf(lowest)) return high;
  const Sentence bare("{}", Sentence("{} {}", above ? ">" : ">=", lowest).english());
  return Sentence("{} and {}", bare, high);
}

void refuse_value(const std::string& name, const Sentence& rule, double value,
                  const std::string& where) {
  if (where.empty()) throw InvalidInput("{} must be {}, got {}", name, rule, value);
  throw InvalidInput("{} must be {}, got {} ({})", name, rule, value, where);
}

const std::vector<Row<Settings>>& mesh_rows() {
  static const std::vector<Row<Settings>> kRows = {
      {"faces", Kind::kAllFaces, "", kAny, "The CAD faces to mesh, by name, or all of them.",
       &Settings::faces},
      {"feature_angle",
       Kind::kNumber,
       "deg",
       {0.0, 180.0, false, true},
       "Faces that meet at an angle below this are meshed as one patch; layers run across the "
       "edge between them. 0 makes every CAD face a patch of its own; an STL file is meshed with "
       "20.",
       &Settings::feature_angle},
      {"initial_mesh",
       Kind::kInitialMesh,
       "",
       kAny,
       "An existing mesh of the shape to start from. Inside the faces its nodes are where the "
       "triangulation starts; where it is finer than size, edges and core become as fine. Its "
       "layers and its order do not come over.",
       {}},
      {"size", Kind::kNumber, "mm", kAboveZero,
       "Edge length of the mesh away from the layers. Default: 1/40 of the diagonal of the "
       "shape's bounding box.",
       &Settings::size, true},
      {"curvature_angle", Kind::kNumber, "deg", kRightAngle,
       "The most that one element edge may turn along a curved edge or face; finer than size "
       "where the shape is curved.",
       &Settings::curvature_angle},
      {"min_size", Kind::kNumber, "mm", kFromZero,
       "The least edge length that curvature and chords may ask for; 0: any. Sizes of edges, faces "
       "and regions are not held to it.",
       &Settings::min_size},
      {"chord_deviation", Kind::kNumber, "mm", kFromZero,
       "The most that the middle of a mesh edge may lie off the curve or surface that it stands "
       "for; 0: any.",
       &Settings::chord_deviation},
      {"relative_chord",
       Kind::kNumber,
       "",
       {0.0, 0.5},
       "The same over the length of the mesh edge; 0: any.",
       &Settings::relative_chord},
      {"cells_across", Kind::kCount, "", kFromZero,
       "The least number of elements over the extent of each face, however small it is beside the "
       "whole, down to a tenth of size; a small outline inside a plane face, such as an airfoil in "
       "its domain, gets twelve times as many around it, fewer where there are several. First "
       "heights of a tenth of size or more are held to a tenth of the mesh edges along their wall. "
       "0: none. Default: 10 where neither size nor first_height is given.",
       &Settings::cells_across},
      {"size_growth",
       Kind::kNumber,
       "",
       {1.0, 3.0, true},
       "The most that neighbouring mesh edges differ in length where the size changes, through "
       "the surface and along edges.",
       &Settings::size_growth},
      {"sizes",
       Kind::kSizes,
       "",
       kAny,
       "Edge lengths, numbers of segments and clustering of some edges and faces.",
       {}},
      {"refinements",
       Kind::kRefinements,
       "",
       kAny,
       "Points, lines and boxes about which the mesh is finer; as a property, texts: x y z size "
       "radius, or line x y z x y z size radius, or box x y z x y z size radius.",
       {}},
      {"first_height", Kind::kNumber, "mm", kAboveZero,
       "Height of the first layer, measured along the surface. Default: 1/10 of size.",
       &Settings::first_height, true},
      {"growth", Kind::kNumber, "", kGrowth,
       "Each layer is this much higher than the one before it.", &Settings::growth},
      {"layers", Kind::kLayers, "", kLayers,
       "Number of layers; 0 grows them until the fronts close; \"isotropic\" grows each until "
       "its height reaches the spacing along the wall.",
       &Settings::layers},
      {"walls",
       Kind::kWalls,
       "",
       kAny,
       "The boundary edges that layers grow from: all, or a list of walls with their own spacing.",
       {}},
      {"others",
       Kind::kChoice,
       "",
       kAny,
       "What becomes of boundary edges that a list of walls leaves out: those that meet a wall are "
       "match edges, or all are off, or all are walls of the mesh's own values.",
       &Settings::others,
       false,
       {"match", "off", "wall"}},
      {"match", Kind::kEdges, "", kAny,
       "Boundary edges that layers run along: their nodes lie where the layers of the walls at "
       "their ends arrive.",
       &Settings::match_edges},
      {"off", Kind::kEdges, "", kAny,
       "Boundary edges that no layer grows from or runs along: beside them each layer ends in a "
       "triangle.",
       &Settings::off_edges},
      {"boundary", Kind::kEdges, "", kAny,
       "Edges that bound the patches of their faces whatever feature_angle says, so that layers "
       "may grow from them: also smooth edges, and the seams of closed faces.",
       &Settings::boundary_edges},
      {"smooth", Kind::kEdges, "", kAny,
       "Edges between two faces that layers run across whatever feature_angle says. The faces "
       "may meet there at up to 70 degrees.",
       &Settings::smooth_edges},
      {"core",
       Kind::kChoice,
       "",
       kAny,
       "What fills the part that no layer reaches: quads where they come out well, or triangles.",
       &Settings::core,
       false,
       {"quads", "triangles"}},
      {"order",
       Kind::kCount,
       "",
       {1.0, 2.0},
       "2 puts a node in the middle of each mesh edge, on the shape.",
       &Settings::order},
      {"mapped", Kind::kFaces, "", kAny,
       "Faces with four sides that are filled with rows and columns of quads from side to side, "
       "with the layers of walls along them; facing sides get as many mesh edges.",
       &Settings::mapped_faces},
      {"periodic",
       Kind::kPeriodic,
       "",
       kAny,
       "Edges and faces that a motion brings onto others: these are cut and meshed as copies of "
       "those; as a property, texts: Face1 move x y z, or Edge1 Edge2 turn x y z x y z angle, with "
       "a point on the axis and its direction.",
       {}},
      {"threads", Kind::kCount, "", kFromZero,
       "Threads to mesh with; 0 uses all processors. The mesh does not depend on it.",
       &Settings::threads},
  };
  return kRows;
}

const std::vector<Row<WallSpec>>& wall_rows() {
  static const std::vector<Row<WallSpec>> kRows = {
      {"edges", Kind::kEdges, "", kAny, "The edges of the wall.", &WallSpec::edges, true},
      {"faces", Kind::kFaces, "", kAny,
       "Layers grow on these faces only. Default: on every side of the edges.", &WallSpec::faces},
      {"first_height", Kind::kNumber, "mm", kAboveZero, "Height of this wall's first layer.",
       &WallSpec::first_height},
      {"end_height", Kind::kNumber, "mm", kAboveZero,
       "The first height at the end of each edge; it changes linearly along the edge, from "
       "first_height at its first vertex.",
       &WallSpec::end_height},
      {"aspect_ratio",
       Kind::kNumber,
       "",
       {0.0, 1e8, true},
       "Instead of first_height: the length of the mesh edges along the wall over the first "
       "height, everywhere.",
       &WallSpec::aspect_ratio},
      {"turning_angle", Kind::kNumber, "deg", kRightAngle,
       "Instead of first_height: the angle that the wall turns over a length of one first "
       "height; the height is size where the wall is straight.",
       &WallSpec::turning_angle},
      {"growth", Kind::kNumber, "", kGrowth,
       "Each layer of this wall is this much higher than the one before it.", &WallSpec::growth},
      {"layers", Kind::kCount, "", kLayers,
       "Number of this wall's layers; 0 grows them until the fronts close.", &WallSpec::layers},
      {"thickness", Kind::kNumber, "mm", kAboveZero,
       "Height of all layers together. With two of first_height, growth and layers it gives the "
       "third; where fewer are given, those of the whole mesh stand in, and layers are worked out "
       "first.",
       &WallSpec::thickness},
      {"thickness_share", Kind::kNumber, "", kAboveZero,
       "Instead of thickness: the height of all layers together over the size along the edge.",
       &WallSpec::thickness_share},
  };
  return kRows;
}

const std::vector<Row<SizeSpec>>& size_rows() {
  static const std::vector<Row<SizeSpec>> kRows = {
      {"edges", Kind::kEdges, "", kAny, "The edges that the size holds for.", &SizeSpec::edges},
      {"faces", Kind::kFaces, "", kAny, "The faces that the size holds for.", &SizeSpec::faces},
      {"size", Kind::kNumber, "mm", kAboveZero, "Edge length of the mesh.", &SizeSpec::size},
      {"segments",
       Kind::kCount,
       "",
       {1.0, 1e6},
       "Number of mesh edges along each of the edges.",
       &SizeSpec::segments},
      {"cluster",
       Kind::kNumber,
       "",
       {1e-6, 1e6},
       "Ratio of the last mesh edge along a CAD edge to the first, in geometric steps.",
       &SizeSpec::cluster},
      {"both_ends", Kind::kFlag, "", kAny,
       "Clusters towards both ends: the ratio is then that of the middle to the ends.",
       &SizeSpec::both_ends},
      {"first_segment", Kind::kNumber, "mm", kAboveZero,
       "Length of the first mesh edge at the first vertex of each CAD edge.",
       &SizeSpec::first_segment},
      {"last_segment", Kind::kNumber, "mm", kAboveZero,
       "Length of the last mesh edge at the last vertex of each CAD edge.",
       &SizeSpec::last_segment},
      {"distribution",
       Kind::kChoice,
       "",
       kAny,
       "How mesh edges grow between first and last segment: smoothly towards both, in geometric "
       "steps, or not at all beyond one step.",
       &SizeSpec::distribution,
       false,
       {"tanh", "geometric", "constant"}},
  };
  return kRows;
}

const std::vector<Row<Refinement>>& refinement_rows() {
  static const std::vector<Row<Refinement>> kRows = {
      {"point", Kind::kPoint, "", kAny, "Its coordinates [mm].", &Refinement::point, true},
      {"size", Kind::kNumber, "mm", kAboveZero,
       "Edge length about the point; away from it, size_growth leads back to the other sizes.",
       &Refinement::size, true},
      {"radius", Kind::kNumber, "mm", kFromZero,
       "The size holds within this distance of the point.", &Refinement::radius},
      {"end", Kind::kPoint, "", kAny,
       "End of a line from the point [mm]: the size holds within radius of the line.",
       &Refinement::end},
      {"corner", Kind::kPoint, "", kAny,
       "Opposite corner of a box along the axes [mm]: the size holds in it, and within radius of "
       "it.",
       &Refinement::corner},
  };
  return kRows;
}

const std::vector<Row<PeriodicSpec>>& periodic_rows() {
  static const std::vector<Row<PeriodicSpec>> kRows = {
      {"edges", Kind::kEdges, "", kAny,
       "Edges whose copies are to be cut alike. Those of the faces need not be listed.",
       &PeriodicSpec::given_edges},
      {"faces", Kind::kFaces, "", kAny, "Faces whose copies are to be meshed alike.",
       &PeriodicSpec::given_faces},
      {"translation", Kind::kPoint, "", kAny, "How far they are moved [mm].",
       &PeriodicSpec::translation},
      {"angle",
       Kind::kNumber,
       "deg",
       {-360.0, 360.0},
       "How far they are turned about the axis, before they are moved.",
       &PeriodicSpec::angle},
      {"axis_point", Kind::kPoint, "", kAny, "A point on the axis [mm]. Default: the origin.",
       &PeriodicSpec::axis_point},
      {"axis_direction", Kind::kPoint, "", kAny, "Direction of the axis. Default: z.",
       &PeriodicSpec::axis},
  };
  return kRows;
}

}  // namespace advlayers
