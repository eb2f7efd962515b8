#include "sizing/settings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "geometry/model.h"
#include "sizing/schema.h"
#include "sizing/size_field.h"
#include "sizing/wall_spacing.h"

namespace advlayers {

namespace {

constexpr double kLeastHeight = 1e-12;    // of the box diagonal
constexpr double kSharpestSmooth = 70.0;  // [deg] elements can be cut along the edge below it
constexpr double kMostElements = 1e8;     // some 50 GB of mesh

// A layer must be higher than coordinates are exact, by an order of magnitude or two.
void check_height(const std::string& name, double value, const Model& model,
                  const std::string& where = "") {
  if (value >= kLeastHeight * model.diagonal()) return;
  refuse_value(name,
               Sentence("> {} mm, {} of the shape's diagonal", kLeastHeight * model.diagonal(),
                        kLeastHeight),
               value, where);
}

// Edges with a length that are degenerate are too short for anything, but no fault of the user's.
bool is_pole(const Edge& edge) { return edge.degenerate && !(edge.length > 0.0); }

void check_edge(EdgeId e, const Model& model, const char* list) {
  if (e.value >= 0 && e.index() < model.edges().size()) return;
  throw InvalidInput("{}: there is no {}, edges of the model: {}", list, edge_name(e),
                     model.edges().size());
}

void check_face(FaceId f, const Model& model, const char* list) {
  if (f.value >= 0 && f.index() < model.faces().size()) return;
  throw InvalidInput("{}: there is no {}, faces of the model: {}", list, face_name(f),
                     model.faces().size());
}

void check_wall(const WallSpec& wall, const Model& model) {
  if (wall.edges.empty()) throw InvalidInput("{}: an entry lists no edge", "walls");
  for (const EdgeId e : wall.edges) {
    check_edge(e, model, "walls");
    if (wall.end_height && model.edge(e).start == model.edge(e).end) {
      throw InvalidInput("{}: {} needs an edge with two ends, {} is closed", "walls", "end_height",
                         edge_name(e));
    }
    if (!is_pole(model.edge(e))) continue;
    throw InvalidInput("{}: {} is a pole without length, nothing grows there", "walls",
                       edge_name(e));
  }
  const std::string where = edge_name(wall.edges.front());
  for (const FaceId f : wall.faces) {
    check_face(f, model, "walls");
    const bool touches = std::any_of(wall.edges.begin(), wall.edges.end(), [&](EdgeId e) {
      const std::vector<FaceId>& beside = model.edge(e).faces;
      return std::find(beside.begin(), beside.end(), f) != beside.end();
    });
    if (!touches) {
      throw InvalidInput("{}: {} touches none of the edges it is listed for ({})", "walls",
                         face_name(f), where + (wall.edges.size() > 1 ? ", ..." : ""));
    }
  }
  check_ranges(wall, wall_rows(), "", where);
  if (wall.first_height) check_height("first_height", *wall.first_height, model, where);
  if (wall.end_height) check_height("end_height", *wall.end_height, model, where);
  if (wall.thickness) check_height("thickness", *wall.thickness, model, where);
}

void check_size(const SizeSpec& spec, const Model& model) {
  if (spec.edges.empty() && spec.faces.empty()) {
    throw InvalidInput("{}: an entry lists neither edge nor face", "sizes");
  }
  for (const EdgeId e : spec.edges) check_edge(e, model, "sizes");
  for (const FaceId f : spec.faces) check_face(f, model, "sizes");
  const std::string where =
      spec.edges.empty() ? face_name(spec.faces.front()) : edge_name(spec.edges.front());
  const auto refuse_entry = [&where](const Sentence& why) {
    throw InvalidInput("{}: {} ({})", "sizes", why, where);
  };
  const bool ends = spec.first_segment || spec.last_segment;
  if (!spec.size && !spec.segments && !spec.cluster && !ends) {
    refuse_entry(Sentence("an entry needs a size, segments, cluster or a segment at an end"));
  }
  if (ends && spec.cluster) {
    refuse_entry(Sentence("{} and {} exclude each other", "cluster",
                          spec.first_segment ? "first_segment" : "last_segment"));
  }
  check_ranges(spec, size_rows(), "sizes: ", where);
  if (spec.both_ends && !spec.cluster) refuse_entry(Sentence("both_ends needs a cluster"));
  if (spec.edges.empty() && (spec.segments || spec.cluster || ends)) {
    refuse_entry(Sentence("segments and cluster are of edges, and the entry lists none"));
  }
  if (spec.faces.empty() && spec.size && spec.segments) {
    refuse_entry(Sentence("size and segments of an edge exclude each other"));
  }
  if (!spec.faces.empty() && !spec.size) refuse_entry(Sentence("a face needs a size"));
}

void check_sizes(const Settings& settings, const Model& model) {
  std::map<EdgeId, int> edges;
  std::map<FaceId, int> faces;
  for (const SizeSpec& spec : settings.sizes) {
    check_size(spec, model);
    for (const EdgeId e : spec.edges) {
      if (++edges[e] > 1) throw InvalidInput("{}: {} is listed twice", "sizes", edge_name(e));
    }
    for (const FaceId f : spec.faces) {
      if (++faces[f] > 1) throw InvalidInput("{}: {} is listed twice", "sizes", face_name(f));
    }
  }
  for (const Refinement& r : settings.refinements) {
    check_ranges(r, refinement_rows(), "refinements: ");
    for (const Vec3& p : {r.point, r.end.value_or(r.point), r.corner.value_or(r.point)}) {
      if (!p.allFinite()) throw InvalidInput("{}: point must be finite", "refinements");
    }
    if (r.end && r.corner) {
      throw InvalidInput("{}: {} and {} exclude each other", "refinements", "end", "corner");
    }
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
      if (overlap) throw InvalidInput("{}: {} is listed twice", "walls", edge_name(edge));
      taken.insert(taken.end(), wall->faces.begin(), wall->faces.end());
    }
  }
}

void check_conditions(const Settings& settings, const Model& model) {
  std::map<EdgeId, const char*> condition;
  const auto claim = [&](EdgeId e, const char* list) {
    const auto [it, fresh] = condition.emplace(e, list);
    if (fresh || it->second == list) return;
    throw InvalidInput("{} is in both {} and {}", edge_name(e), it->second, list);
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
    if (is_pole(model.edge(e))) {
      throw InvalidInput("{}: {} is a pole without length", "boundary", edge_name(e));
    }
    if (std::binary_search(rule.smooth.begin(), rule.smooth.end(), e)) {
      throw InvalidInput("{} is in both {} and {}", edge_name(e), "boundary", "smooth");
    }
  }
  Evaluator evaluator(model);
  for (const EdgeId e : rule.smooth) {
    const auto refuse_edge = [e](const Sentence& why) {
      throw InvalidInput("{}: {} must bound its patch: {}", "smooth", edge_name(e), why);
    };
    if (const Sentence why = reason_to_bound(evaluator, e); !why.empty()) refuse_edge(why);
    const double angle = model.dihedral_angle(e) * 180.0 / M_PI;
    if (angle > kSharpestSmooth) {
      refuse_edge(Sentence("its faces meet at {} degrees, and {} is the most that layers run over",
                           std::lround(angle), kSharpestSmooth));
    }
    for (const FaceId face : model.edge(e).faces) {
      const auto& meshed = settings.faces;
      if (meshed.empty() || std::find(meshed.begin(), meshed.end(), face) != meshed.end()) continue;
      refuse_edge(Sentence("{} is not among the faces to mesh", face_name(face)));
    }
  }
}

void check_periodic(const Settings& settings, const Model& model) {
  for (const PeriodicSpec& spec : settings.periodic) {
    if (spec.given_edges.empty() && spec.given_faces.empty()) {
      throw InvalidInput("{}: an entry lists neither edge nor face", "periodic");
    }
    for (const EdgeId e : spec.given_edges) check_edge(e, model, "periodic");
    for (const FaceId f : spec.given_faces) check_face(f, model, "periodic");
    check_ranges(spec, periodic_rows(), "periodic: ");
    for (const Vec3& p : {spec.translation, spec.axis_point, spec.axis}) {
      if (!p.allFinite()) throw InvalidInput("{}: coordinates must be finite", "periodic");
    }
    if (!(spec.axis.norm() > 0.0)) {
      throw InvalidInput("{}: {} must not be zero", "periodic", "axis_direction");
    }
    if (spec.translation.isZero() && spec.angle == 0.0) {
      throw InvalidInput("{}: an entry needs a translation or an angle", "periodic");
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
  throw InvalidInput("{} is too small: {} mm asks for {} elements, and {} are the most", "size",
                     least, elements, kMostElements);
}

}  // namespace

double Refinement::distance(const Vec3& p) const {
  if (corner) {
    const Vec3 low = point.cwiseMin(*corner), high = point.cwiseMax(*corner);
    return (p - p.cwiseMax(low).cwiseMin(high)).norm();
  }
  if (!end) return (p - point).norm();
  const Vec3 along = *end - point;
  const double length2 = along.squaredNorm();
  const double part = length2 > 0.0 ? std::clamp((p - point).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - point - part * along).norm();
}

FeatureRule feature_rule(const Settings& settings) {
  FeatureRule rule(settings.feature_angle);
  rule.boundary = settings.boundary_edges;
  rule.smooth = settings.smooth_edges;
  std::sort(rule.boundary.begin(), rule.boundary.end());
  std::sort(rule.smooth.begin(), rule.smooth.end());
  return rule;
}

void check(const Settings& settings, const Model& model) {
  check_ranges(settings, mesh_rows());
  check_height("first_height", settings.first_height, model);
  if (settings.end == EndOfGrowth::kLayers && settings.layers < 1) {
    refuse_value("layers", Sentence(">= 1"), settings.layers);
  }
  for (const FaceId f : settings.faces) check_face(f, model, "faces");
  for (const FaceId f : settings.mapped_faces) check_face(f, model, "mapped");
  check_sizes(settings, model);
  check_amount(settings, model);
  check_conditions(settings, model);
  check_walls_apart(settings);
  check_patch_edges(settings, model);
  check_periodic(settings, model);
}

}  // namespace advlayers
