#include "boundary/periodic_pairs.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr int kSamples = 4;      // pieces of an edge
constexpr double kClose = 1e-6;  // of the model's diagonal, beside the edges' own tolerances

class PairFinder {
 public:
  PairFinder(const RunContext& context, const Model& model, const Motion& motion)
      : context_(context), model_(model), motion_(motion), evaluator_(model) {
    samples_.resize(model.edges().size());
  }

  EdgePair edge(EdgeId given) {
    const std::optional<EdgePair> pair = find(given);
    if (pair) return *pair;
    throw InvalidInput("{}: no edge lies where {} comes to lie", "periodic", edge_name(given));
  }

  FacePair face(FaceId given) {
    FacePair pair{given, FaceId(), motion_, {}};
    std::set<EdgeId> around;
    for (const EdgeId edge : edges_of(given)) {
      pair.edges.push_back(this->edge(edge));
      around.insert(pair.edges.back().found);
    }
    for (std::size_t f = 0; f < model_.faces().size(); ++f) {
      const std::vector<EdgeId> edges = edges_of(FaceId(f));
      if (FaceId(f) != given && std::set<EdgeId>(edges.begin(), edges.end()) == around) {
        pair.found = FaceId(f);
      }
    }
    if (pair.found.valid()) return pair;
    throw InvalidInput("{}: no face lies where {} comes to lie", "periodic", face_name(given));
  }

 private:
  std::vector<EdgeId> edges_of(FaceId face) const {
    std::vector<EdgeId> edges;
    for (const auto& loop : model_.face(face).loops) {
      for (const CoEdge& coedge : loop) {
        const bool known = std::find(edges.begin(), edges.end(), coedge.edge) != edges.end();
        if (!coedge.degenerate && !known) edges.push_back(coedge.edge);
      }
    }
    return edges;
  }

  const std::vector<Vec3>& points_on(EdgeId id) {
    std::vector<Vec3>& points = samples_[id.index()];
    if (!points.empty()) return points;
    const Edge& edge = model_.edge(id);
    for (int k = 0; k <= kSamples; ++k) {
      points.push_back(evaluator_.edge_point(
          id, evaluator_.edge_parameter(id, edge.first, edge.length * k / kSamples)));
    }
    return points;
  }

  std::optional<EdgePair> find(EdgeId given) {
    context_.check();
    std::vector<Vec3> moved;
    for (const Vec3& p : points_on(given)) moved.push_back(motion_ * p);
    for (std::size_t e = 0; e < model_.edges().size(); ++e) {
      const Edge& edge = model_.edges()[e];
      const double near =
          kClose * model_.diagonal() + edge.tolerance + model_.edge(given).tolerance;
      if (edge.degenerate || edge.faces.empty()) continue;
      if (std::abs(edge.length - model_.edge(given).length) > near) continue;
      const std::vector<Vec3>& points = points_on(EdgeId(e));
      for (const bool reversed : {false, true}) {
        bool all = true;
        for (std::size_t k = 0; k < moved.size() && all; ++k) {
          all = (points[reversed ? moved.size() - 1 - k : k] - moved[k]).norm() <= near;
        }
        if (all) return EdgePair{given, EdgeId(e), reversed, motion_};
      }
    }
    return std::nullopt;
  }

  const RunContext& context_;
  const Model& model_;
  Motion motion_;
  Evaluator evaluator_;
  std::vector<std::vector<Vec3>> samples_;  // by EdgeId, as far as they were asked for
};

void add_edge(const EdgePair& pair, PeriodicPairs& pairs) {
  const bool known = std::any_of(pairs.edges.begin(), pairs.edges.end(),
                                 [&](const EdgePair& p) { return p.found == pair.found; });
  if (pair.given != pair.found && !known) pairs.edges.push_back(pair);
}

}  // namespace

Motion motion_of(const PeriodicSpec& spec) {
  const Eigen::AngleAxisd turn(spec.angle * M_PI / 180.0, spec.axis.normalized());
  return Eigen::Translation3d(spec.translation) * Eigen::Translation3d(spec.axis_point) * turn *
         Eigen::Translation3d(-spec.axis_point);
}

PeriodicPairs find_periodic(const RunContext& context, const Model& model,
                            const PeriodicSpec& spec) {
  PeriodicPairs pairs;
  PairFinder finder(context, model, motion_of(spec));
  for (const FaceId face : spec.given_faces) {
    pairs.faces.push_back(finder.face(face));
    for (const EdgePair& pair : pairs.faces.back().edges) add_edge(pair, pairs);
  }
  for (const EdgeId edge : spec.given_edges) add_edge(finder.edge(edge), pairs);
  return pairs;
}

PeriodicPairs find_periodic(const RunContext& context, const Model& model,
                            const Settings& settings) {
  PeriodicPairs all;
  for (const PeriodicSpec& spec : settings.periodic) {
    PeriodicPairs pairs = find_periodic(context, model, spec);
    for (const EdgePair& pair : pairs.edges) add_edge(pair, all);
    all.faces.insert(all.faces.end(), pairs.faces.begin(), pairs.faces.end());
  }
  return all;
}

}  // namespace advlayers
