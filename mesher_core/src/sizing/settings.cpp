#include "sizing/settings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "base/error.h"
#include "geometry/model.h"
#include "sizing/size_field.h"
#include "sizing/wall_spacing.h"

namespace advlayers {

namespace {

constexpr double kMaxGrowth = 10.0;
constexpr int kMostSegments = 1000000;
constexpr double kMostCluster = 1e6;
constexpr double kLeastHeight = 1e-12;  // of the box diagonal
constexpr double kLargestAspect = 1e8;
constexpr double kSharpestSmooth = 70.0;  // [deg] elements can be cut along the edge below it
constexpr double kMostElements = 1e8;     // some 50 GB of mesh

[[noreturn]] void refuse(const std::string& name, const std::string& rule, double value,
                         const std::string& where) {
  std::ostringstream text;
  text << name << " must be " << rule << ", got " << value;
  if (!where.empty()) text << " (" << where << ")";
  throw InvalidInput(text.str());
}

void check_positive(const std::string& name, double value, const std::string& where = "") {
  if (!(std::isfinite(value) && value > 0.0)) refuse(name, "> 0 mm", value, where);
}

// A layer must be higher than coordinates are exact, by an order of magnitude or two.
void check_height(const std::string& name, double value, const Model& model,
                  const std::string& where = "") {
  check_positive(name, value, where);
  if (value >= kLeastHeight * model.diagonal()) return;
  std::ostringstream text;
  text << "> " << kLeastHeight * model.diagonal() << " mm, " << kLeastHeight
       << " of the shape's diagonal";
  refuse(name, text.str(), value, where);
}

void check_growth(double growth, const std::string& where = "") {
  if (!(growth >= 1.0)) refuse("growth", ">= 1", growth, where);
  if (!(growth <= kMaxGrowth)) refuse("growth", "<= 10", growth, where);
}

void check_angles(const Settings& settings) {
  if (!(settings.feature_angle >= 0.0 && settings.feature_angle < 180.0)) {
    refuse("feature_angle", "in [0, 180) degrees", settings.feature_angle, "");
  }
  if (!(settings.curvature_angle > 0.0 && settings.curvature_angle <= 90.0)) {
    refuse("curvature_angle", "in (0, 90] degrees", settings.curvature_angle, "");
  }
}

std::string count_of(std::size_t n, const char* noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

void check_edge(EdgeId e, const Model& model, const char* list) {
  if (e.value >= 0 && e.index() < model.edges().size()) return;
  throw InvalidInput(std::string(list) + ": there is no " + edge_name(e) + ", the model has " +
                     count_of(model.edges().size(), "edge"));
}

void check_face(FaceId f, const Model& model, const char* list) {
  if (f.value >= 0 && f.index() < model.faces().size()) return;
  throw InvalidInput(std::string(list) + ": there is no " + face_name(f) + ", the model has " +
                     count_of(model.faces().size(), "face"));
}

void check_wall(const WallSpec& wall, const Model& model) {
  if (wall.edges.empty()) throw InvalidInput("walls: an entry lists no edge");
  for (const EdgeId e : wall.edges) {
    check_edge(e, model, "walls");
    if (wall.end_height && model.edge(e).start == model.edge(e).end) {
      throw InvalidInput("walls: end_height needs an edge with two ends, " + edge_name(e) +
                         " is closed");
    }
    if (!model.edge(e).degenerate) continue;
    throw InvalidInput("walls: " + edge_name(e) + " is a pole without length, nothing grows there");
  }
  const std::string where = edge_name(wall.edges.front());
  for (const FaceId f : wall.faces) {
    check_face(f, model, "walls");
    const bool touches = std::any_of(wall.edges.begin(), wall.edges.end(), [&](EdgeId e) {
      const std::vector<FaceId>& beside = model.edge(e).faces;
      return std::find(beside.begin(), beside.end(), f) != beside.end();
    });
    if (!touches) {
      throw InvalidInput("walls: " + face_name(f) +
                         " touches none of the edges it is listed for (" + where +
                         (wall.edges.size() > 1 ? ", ...)" : ")"));
    }
  }
  if (wall.first_height) check_height("first_height", *wall.first_height, model, where);
  if (wall.growth) check_growth(*wall.growth, where);
  if (wall.end_height) check_height("end_height", *wall.end_height, model, where);
  if (wall.thickness) check_height("thickness", *wall.thickness, model, where);
  if (wall.aspect_ratio && !(*wall.aspect_ratio > 0.0 && *wall.aspect_ratio <= kLargestAspect)) {
    refuse("aspect_ratio", "in (0, 1e8]", *wall.aspect_ratio, where);
  }
  if (wall.turning_angle && !(*wall.turning_angle > 0.0 && *wall.turning_angle <= 90.0)) {
    refuse("turning_angle", "in (0, 90] degrees", *wall.turning_angle, where);
  }
  if (wall.layers && *wall.layers < 0) refuse("layers", ">= 0", *wall.layers, where);
}

void check_size(const SizeSpec& spec, const Model& model) {
  if (spec.edges.empty() && spec.faces.empty()) {
    throw InvalidInput("sizes: an entry lists neither edge nor face");
  }
  for (const EdgeId e : spec.edges) check_edge(e, model, "sizes");
  for (const FaceId f : spec.faces) check_face(f, model, "sizes");
  const std::string where =
      spec.edges.empty() ? face_name(spec.faces.front()) : edge_name(spec.edges.front());
  const auto refuse_entry = [&where](const char* why) {
    throw InvalidInput("sizes: " + std::string(why) + " (" + where + ")");
  };
  if (!spec.size && !spec.segments && !spec.cluster) {
    refuse_entry("an entry needs a size, segments or cluster");
  }
  if (spec.size) check_positive("sizes: size", *spec.size, where);
  if (spec.segments && (*spec.segments < 1 || *spec.segments > kMostSegments)) {
    refuse("sizes: segments", "from 1 to 1000000", *spec.segments, where);
  }
  if (spec.cluster && !(*spec.cluster >= 1.0 / kMostCluster && *spec.cluster <= kMostCluster)) {
    refuse("sizes: cluster", "from 1e-6 to 1e6", *spec.cluster, where);
  }
  if (spec.both_ends && !spec.cluster) refuse_entry("both_ends needs a cluster");
  if (spec.edges.empty() && (spec.segments || spec.cluster)) {
    refuse_entry("segments and cluster are of edges, and the entry lists none");
  }
  if (spec.faces.empty() && spec.size && spec.segments) {
    refuse_entry("size and segments of an edge exclude each other");
  }
  if (!spec.faces.empty() && !spec.size) refuse_entry("a face needs a size");
}

void check_sizes(const Settings& settings, const Model& model) {
  std::map<EdgeId, int> edges;
  std::map<FaceId, int> faces;
  for (const SizeSpec& spec : settings.sizes) {
    check_size(spec, model);
    for (const EdgeId e : spec.edges) {
      if (++edges[e] > 1) throw InvalidInput("sizes: " + edge_name(e) + " is listed twice");
    }
    for (const FaceId f : spec.faces) {
      if (++faces[f] > 1) throw InvalidInput("sizes: " + face_name(f) + " is listed twice");
    }
  }
  for (const Refinement& r : settings.refinements) {
    check_positive("refinements: size", r.size);
    if (!(r.radius >= 0.0 && std::isfinite(r.radius))) {
      refuse("refinements: radius", ">= 0 mm", r.radius, "");
    }
    if (!r.point.allFinite()) throw InvalidInput("refinements: point must be finite");
  }
  if (!(settings.size_growth > 1.0 && settings.size_growth <= 3.0)) {
    refuse("size_growth", "> 1 and <= 3", settings.size_growth, "");
  }
}

// Two entries of one edge are one too many unless each keeps to faces of its own.
void check_walls_apart(const Settings& settings) {
  std::map<EdgeId, std::vector<const WallSpec*>> entries;
  for (const WallSpec& wall : settings.walls) {
    for (const EdgeId e : wall.edges) entries[e].push_back(&wall);
  }
  for (const auto& [edge, walls] : entries) {
    std::vector<FaceId> taken;
    for (const WallSpec* wall : walls) {
      bool overlap = walls.size() > 1 && wall->faces.empty();
      for (const FaceId f : wall->faces) {
        overlap = overlap || std::find(taken.begin(), taken.end(), f) != taken.end();
      }
      if (overlap) throw InvalidInput("walls: " + edge_name(edge) + " is listed twice");
      taken.insert(taken.end(), wall->faces.begin(), wall->faces.end());
    }
  }
}

void check_conditions(const Settings& settings, const Model& model) {
  std::map<EdgeId, const char*> condition;
  const auto claim = [&](EdgeId e, const char* list) {
    const auto [it, fresh] = condition.emplace(e, list);
    if (fresh || it->second == list) return;
    throw InvalidInput(edge_name(e) + " is in both " + it->second + " and " + list);
  };
  static constexpr const char *kWalls = "walls", *kMatch = "match", *kOff = "off",
                              *kSmooth = "smooth";
  for (const WallSpec& wall : settings.walls) {
    check_wall(wall, model);
    spacing_of(wall, settings);  // refuses what contradicts itself
    for (const EdgeId e : wall.edges) claim(e, kWalls);
  }
  for (const EdgeId e : settings.match_edges) {
    check_edge(e, model, kMatch);
    claim(e, kMatch);
  }
  for (const EdgeId e : settings.off_edges) {
    check_edge(e, model, kOff);
    claim(e, kOff);
  }
  for (const EdgeId e : settings.smooth_edges) {
    check_edge(e, model, kSmooth);
    claim(e, kSmooth);
  }
}

// Edges that were decided by hand: what is to lie inside a patch must be able to.
void check_patch_edges(const Settings& settings, const Model& model) {
  const FeatureRule rule = feature_rule(settings);
  for (const EdgeId e : rule.boundary) {
    check_edge(e, model, "boundary");
    if (model.edge(e).degenerate) {
      throw InvalidInput("boundary: " + edge_name(e) + " is a pole without length");
    }
    if (std::binary_search(rule.smooth.begin(), rule.smooth.end(), e)) {
      throw InvalidInput(edge_name(e) + " is in both boundary and smooth");
    }
  }
  Evaluator evaluator(model);
  for (const EdgeId e : rule.smooth) {
    const auto refuse_edge = [e](const std::string& why) {
      throw InvalidInput("smooth: " + edge_name(e) + " must bound its patch: " + why);
    };
    if (const std::string why = reason_to_bound(evaluator, e); !why.empty()) refuse_edge(why);
    const double angle = model.dihedral_angle(e) * 180.0 / M_PI;
    if (angle > kSharpestSmooth) {
      std::ostringstream text;
      text << "its faces meet at " << std::lround(angle) << " degrees, and " << kSharpestSmooth
           << " is the most that layers run over";
      refuse_edge(text.str());
    }
    for (const FaceId face : model.edge(e).faces) {
      const auto& meshed = settings.faces;
      if (meshed.empty() || std::find(meshed.begin(), meshed.end(), face) != meshed.end()) continue;
      refuse_edge(face_name(face) + " is not among the faces to mesh");
    }
  }
}

// An isotropic mesh is the least that the size asks for; the layers only add to it.
void check_amount(const Settings& settings, const Model& model) {
  const SizeField sizes(settings);
  std::vector<FaceId> faces = settings.faces;
  for (std::size_t f = 0; settings.faces.empty() && f < model.faces().size(); ++f) {
    faces.emplace_back(f);
  }
  double elements = 0.0, least = settings.size;
  for (const FaceId f : faces) {
    const double size = sizes.of_face(f);
    elements += model.face(f).area / (size * size);
    least = std::min(least, size);
  }
  if (elements <= kMostElements) return;
  std::ostringstream text;
  text << "size is too small: " << least << " mm asks for " << elements << " elements, and "
       << kMostElements << " are the most";
  throw InvalidInput(text.str());
}

}  // namespace

FeatureRule feature_rule(const Settings& settings) {
  FeatureRule rule(settings.feature_angle);
  rule.boundary = settings.boundary_edges;
  rule.smooth = settings.smooth_edges;
  std::sort(rule.boundary.begin(), rule.boundary.end());
  std::sort(rule.smooth.begin(), rule.smooth.end());
  return rule;
}

void check(const Settings& settings, const Model& model) {
  check_positive("size", settings.size);
  check_height("first_height", settings.first_height, model);
  check_growth(settings.growth);
  check_angles(settings);
  if (settings.end == EndOfGrowth::kLayers && settings.layers < 1) {
    refuse("layers", ">= 1", settings.layers, "");
  }
  if (settings.threads < 0) refuse("threads", ">= 0", settings.threads, "");
  for (const FaceId f : settings.faces) check_face(f, model, "faces");
  check_sizes(settings, model);
  check_amount(settings, model);
  check_conditions(settings, model);
  check_walls_apart(settings);
  check_patch_edges(settings, model);
}

}  // namespace advlayers
