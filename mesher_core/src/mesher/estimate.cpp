#include "mesher/estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/angles.h"
#include "base/directions.h"
#include "geometry/evaluator.h"
#include "mesher/sewn_edges.h"
#include "sizing/local_sizes.h"
#include "sizing/size_field.h"
#include "sizing/wall_spacing.h"

namespace advlayers {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kSamples = 6;  // cells along each parameter of a face, and pieces of an edge
// Measured on meshes of 10 000 to 1 000 000 elements (docs/trust.md).
constexpr double kBytesPerElement = 1000.0, kSecondsPerElement = 2e-5;
// A front of segments far finer than the size beside it is searched again and again.
constexpr double kSecondsPerPair = 1e-7;
constexpr double kTrianglesPerQuad = 2.3;

// Along one direction: how long, and how many segments that takes.
struct Way {
  double length = 0.0;  // [mm]
  double turn = 0.0;    // [rad]

  double segments(double size, double angle) const {
    return std::max({1.0, length / size, turn / angle});
  }
};

class Estimator {
 public:
  Estimator(const RunContext& context, const Model& model, const Settings& settings)
      : context_(context),
        model_(model),
        settings_(with_local_sizes(model, in_edges_of(model, settings))),
        sizes_(settings_),
        evaluator_(model) {
    for (const WallSpec& wall : settings_.walls) {
      for (const EdgeId e : wall.edges) walls_[e].push_back(&wall);
    }
  }

  Estimate run() {
    std::vector<FaceId> faces = settings_.faces;
    for (std::size_t f = 0; settings_.faces.empty() && f < model_.faces().size(); ++f) {
      faces.emplace_back(f);
    }
    for (const FaceId f : faces) {
      context_.check();
      if (model_.face(f).defect.empty()) add_face(f);
    }
    for (const Refinement& r : settings_.refinements) add_refinement(r);
    Estimate all;
    double most = -1.0;
    for (const auto& [key, elements] : elements_) {
      all.elements += elements;
      if (elements > most) all.driver = key;
      most = std::max(most, elements);
    }
    all.megabytes = all.elements * kBytesPerElement / (1 << 20);
    all.seconds = all.elements * kSecondsPerElement + seconds_of_fine_fronts_;
    return all;
  }

 private:
  double angle() const { return settings_.curvature_angle * kDegree; }

  void add_face(FaceId f) {
    const Face& face = model_.face(f);
    double perimeter = 0.0;
    for (const auto& loop : face.loops) {
      for (const CoEdge& c : loop) perimeter += model_.edge(c.edge).length;
    }
    const double room = perimeter > 0.0 ? 2.0 * face.area / perimeter : 0.0;
    double covered = 0.0;
    for (const auto& loop : face.loops) {
      for (const CoEdge& c : loop) {
        if (!c.degenerate) covered += add_side(f, c.edge, room);
      }
    }
    const double left = std::max(0.0, 1.0 - covered / face.area);
    const double each = settings_.core == CoreElements::kTriangles ? kTrianglesPerQuad : 1.0;
    const double size = sizes_.of_face(f), by_size = face.area / (size * size);
    const double all = face.kind == SurfaceKind::kPlane ? by_size : curved_cells(f, size);
    elements_["size"] += each * left * by_size;
    elements_["curvature_angle"] += each * left * std::max(0.0, all - by_size);
  }

  // Elements of a curved face, were it meshed by its size and its curvature alone.
  double curved_cells(FaceId f, double size) {
    const Face& face = model_.face(f);
    Way along_u, along_v;
    double box = 0.0;  // area of the whole range of parameters
    const double du = (face.u_max - face.u_min) / kSamples;
    const double dv = (face.v_max - face.v_min) / kSamples;
    for (int i = 0; i < kSamples; ++i) {
      for (int j = 0; j < kSamples; ++j) {
        const double u = face.u_min + (i + 0.5) * du, v = face.v_min + (j + 0.5) * dv;
        const SurfaceFrame here = evaluator_.frame(f, u, v);
        const SurfaceFrame right = evaluator_.frame(f, u + 0.5 * du, v);
        const SurfaceFrame up = evaluator_.frame(f, u, v + 0.5 * dv);
        const double a = here.du.norm() * du, b = here.dv.norm() * dv;
        along_u.length += a / kSamples;
        along_v.length += b / kSamples;
        along_u.turn += 2.0 * angle_between(here.normal, right.normal) / kSamples;
        along_v.turn += 2.0 * angle_between(here.normal, up.normal) / kSamples;
        box += a * b;
      }
    }
    const double part = box > 0.0 ? std::min(1.0, face.area / box) : 1.0;
    return part * along_u.segments(size, angle()) * along_v.segments(size, angle());
  }

  double segments_of(EdgeId e) {
    const auto known = segments_.find(e);
    if (known != segments_.end()) return known->second;
    const Edge& edge = model_.edge(e);
    const SizeSpec* spec = sizes_.edge_spec(e);
    Way way{edge.length, 0.0};
    const double dt = (edge.last - edge.first) / kSamples;
    for (int i = 0; i < kSamples; ++i) {
      way.turn += angle_between(evaluator_.edge_tangent(e, edge.first + (i + 0.01) * dt),
                                evaluator_.edge_tangent(e, edge.first + (i + 0.99) * dt));
    }
    const double n = spec && spec->segments ? *spec->segments
                                            : way.segments(sizes_.of_edge(e, edge.faces), angle());
    return segments_[e] = n;
  }

  // The rows beside one side of an edge; the area that they cover [mm^2].
  double add_side(FaceId f, EdgeId e, double room) {
    const double n = segments_of(e), length = model_.edge(e).length;
    if (!(length > 0.0) || !(room > 0.0)) return 0.0;
    const double segment = length / n;
    double covered = 0.0;
    if (const auto spacing = wall_spacing(f, e)) covered = add_layers(*spacing, n, segment, room);
    const double size = sizes_.of_face(f);
    if (segment < 0.7 * size) {
      // Rows of ever fewer, larger elements.
      const double rows = n / (1.0 - 1.0 / settings_.size_growth);
      const SizeSpec* spec = sizes_.edge_spec(e);
      elements_[spec ? "sizes" : "curvature_angle"] += rows;
      if (segment < 0.1 * size) seconds_of_fine_fronts_ += 0.5 * kSecondsPerPair * n * n;
    }
    return covered;
  }

  std::optional<WallSpacing> wall_spacing(FaceId f, EdgeId e) const {
    const auto given = walls_.find(e);
    if (settings_.walls_all) {
      const bool inner = model_.edge(e).faces.size() == 2 &&
                         model_.dihedral_angle(e) < settings_.feature_angle * kDegree;
      if (inner) return std::nullopt;
      return spacing_of(WallSpec(), settings_);
    }
    if (given == walls_.end()) return std::nullopt;
    for (const WallSpec* wall : given->second) {
      const auto& on = wall->faces;
      if (on.empty() || std::find(on.begin(), on.end(), f) != on.end()) {
        return spacing_of(*wall, settings_);
      }
    }
    return std::nullopt;
  }

  double add_layers(const WallSpacing& spacing, double n, double segment, double room) {
    double h = spacing.first_height;
    if (spacing.rule.aspect_ratio) h = segment / *spacing.rule.aspect_ratio;
    if (!(h > 0.0)) return 0.0;
    const double g = spacing.growth;
    const bool grows = g > 1.0 + 1e-12;
    const double to_room = grows ? std::log1p(room * (g - 1.0) / h) / std::log(g) : room / h;
    // From there on a row has fewer and fewer elements, as it would without layers.
    const double to_square = !grows         ? (h < segment ? kInfinite : 0.0)
                             : h >= segment ? 0.0
                                            : std::log(segment / h) / std::log(g);
    const double asked = spacing.layers == kUntilClosed ? kInfinite : spacing.layers;
    const double rows = std::max(1.0, std::min({asked, to_room, to_square}));
    const double thickness =
        std::min(room, grows ? h * (std::pow(g, rows) - 1.0) / (g - 1.0) : h * rows);
    const double narrower = 1.0 - 0.5 * thickness / room;  // the front that closes, on average
    elements_[grows && g > 1.02 ? "first_height" : "growth"] += n * rows;
    return n * segment * thickness * narrower;
  }

  void add_refinement(const Refinement& r) {
    if (!(r.size > 0.0) || r.size >= settings_.size) return;
    const double slope = sizes_.slope();
    elements_["refinements"] += M_PI * (r.radius / r.size) * (r.radius / r.size) +
                                2.0 * M_PI / (slope * slope) * std::log(settings_.size / r.size);
  }

  const RunContext& context_;
  const Model& model_;
  Settings settings_;
  SizeField sizes_;
  Evaluator evaluator_;
  std::unordered_map<EdgeId, std::vector<const WallSpec*>> walls_;
  std::unordered_map<EdgeId, double> segments_;
  std::map<std::string, double> elements_;  // by the setting that they are for
  double seconds_of_fine_fronts_ = 0.0;
};

}  // namespace

Estimate estimate(const RunContext& context, const Model& model, const Settings& settings) {
  check(in_edges_of(model, settings), model);
  return Estimator(context, model, settings).run();
}

}  // namespace advlayers
