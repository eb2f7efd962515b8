#include "boundary/joined_edges.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/directions.h"
#include "base/golden_ratio.h"

namespace advlayers {
namespace {

constexpr double kTangent = 0.2;    // [rad] between edges that may go together
constexpr int kSteps = 64;          // along the shorter edge, in search of the parting
constexpr int kHalvings = 20;       // of the way between two steps
constexpr double kSearched = 0.05;  // of the way from the vertex, for the nearest point
// Tolerances above this part of the shorter edge say nothing about where the edges part.
constexpr double kLargestShare = 0.01;
// What is left of an edge beyond the parting, at least, as part of what is joined.
constexpr double kLeastRest = 0.05;

// An edge as it leaves one of its vertices, by the length from there.
class Leaving {
 public:
  Leaving(Evaluator& evaluator, EdgeId edge, bool from_start)
      : evaluator_(&evaluator), edge_(edge), from_start_(from_start) {}

  const Edge& edge() const { return evaluator_->model().edge(edge_); }
  EdgeId id() const { return edge_; }
  double length() const { return edge().length; }
  double t_vertex() const { return from_start_ ? edge().first : edge().last; }
  VertexId far_vertex() const { return from_start_ ? edge().end : edge().start; }
  std::pair<EdgeId, bool> end() const { return {edge_, from_start_}; }
  double parameter(double s) const {
    if (s >= length()) return from_start_ ? edge().last : edge().first;
    return evaluator_->edge_parameter(edge_, edge().first, from_start_ ? s : length() - s);
  }
  Vec3 at(double s) const { return evaluator_->edge_point(edge_, parameter(s)); }

  // The length at which the edge is nearest to a point, between two.
  double nearest(const Vec3& p, double low, double high) const {
    for (int i = 0; i < 2 * kHalvings; ++i) {
      const double a = high - kGoldenRatio * (high - low), b = low + kGoldenRatio * (high - low);
      if ((at(a) - p).norm() < (at(b) - p).norm()) {
        high = b;
      } else {
        low = a;
      }
    }
    return 0.5 * (low + high);
  }

 private:
  Evaluator* evaluator_;
  EdgeId edge_;
  bool from_start_;
};

class Pair {
 public:
  Pair(const Leaving& kept, const Leaving& other)
      : kept_(kept),
        other_(other),
        near_(std::min(kept.edge().tolerance + other.edge().tolerance,
                       kLargestShare * std::min(kept.length(), other.length()))) {}

  // How far along `kept` the two go together; 0 where they part at once.
  double joined(double least) const {
    const double shorter = std::min(kept_.length(), other_.length());
    if (shorter < least) return 0.0;
    const Vec3 along = kept_.at(least) - kept_.at(0.0);
    if (angle_between(along, other_.at(least) - other_.at(0.0)) > kTangent) return 0.0;
    if (!together(least)) return 0.0;
    double low = least;
    for (int k = 1; k <= kSteps; ++k) {
      const double s = least + (shorter - least) * k / kSteps;
      if (together(s)) {
        low = s;
        continue;
      }
      double high = s;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (together(middle) ? low : high) = middle;
      }
      break;
    }
    return low;
  }

  double beside(double s) const {
    const double reach = kSearched * s + near_;
    return other_.nearest(kept_.at(s), std::max(0.0, s - reach),
                          std::min(other_.length(), s + reach));
  }

 private:
  bool together(double s) const { return (kept_.at(s) - other_.at(beside(s))).norm() <= near_; }

  const Leaving& kept_;
  const Leaving& other_;
  double near_;
};

// The shorter is the one that is kept: its far end may lie on the other.
bool join(const Leaving& a, const Leaving& b, double least, JoinedEnds& found) {
  const Leaving& kept = b.length() < a.length() ? b : a;
  const Leaving& other = &kept == &a ? b : a;
  const Pair pair(kept, other);
  double s = pair.joined(least);
  if (s <= 0.0) return false;
  const bool whole = s > kept.length() * (1.0 - 1e-6);
  if (whole) s = kept.length();
  const bool same_end = whole && kept.far_vertex() == other.far_vertex();
  const double on_other = same_end ? other.length() : pair.beside(s);
  const double rest =
      std::min(whole ? s : kept.length() - s, same_end ? s : other.length() - on_other);
  if (rest < kLeastRest * s) return false;
  found.kept = {kept.id(), kept.t_vertex(), kept.parameter(s)};
  found.other = {other.id(), other.t_vertex(), other.parameter(on_other)};
  found.parting_vertex = whole ? kept.far_vertex() : VertexId();
  return true;
}

}  // namespace

JoinedEdges::JoinedEdges(const RunContext& context, Evaluator& evaluator,
                         const std::vector<bool>& meshed_faces, const std::vector<double>& least) {
  const Model& model = evaluator.model();
  std::set<std::pair<EdgeId, bool>> taken;
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    if (!meshed_faces[f]) continue;
    context.check();
    for (const auto& loop : model.faces()[f].loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const CoEdge &in = loop[i], &out = loop[(i + 1) % loop.size()];
        if (in.edge == out.edge || in.seam || out.seam || in.degenerate || out.degenerate) continue;
        const Leaving a(evaluator, in.edge, !in.forward), b(evaluator, out.edge, out.forward);
        if (taken.count(a.end()) + taken.count(b.end()) > 0) continue;
        const double enough = std::min(least[in.edge.index()], least[out.edge.index()]);
        JoinedEnds found;
        if (!join(a, b, enough, found)) continue;
        taken.insert({a.end(), b.end()});
        ends_.push_back(found);
      }
    }
  }
}

void JoinedEdges::add_joints(std::vector<std::vector<double>>& joints) const {
  for (const JoinedEnds& joined : ends_) {
    for (const JoinedEnds::End& end : {joined.kept, joined.other}) {
      std::vector<double>& of_edge = joints[end.edge.index()];
      if (of_edge.empty() || end.t_parting <= of_edge.front()) continue;
      const auto at = std::lower_bound(of_edge.begin(), of_edge.end(), end.t_parting);
      if (at != of_edge.end() && *at != end.t_parting) of_edge.insert(at, end.t_parting);
    }
  }
}

int JoinedEdges::parting_at(EdgeId edge, double t, VertexId& vertex) const {
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    for (const JoinedEnds::End& end : {ends_[i].kept, ends_[i].other}) {
      if (end.edge != edge || end.t_parting != t) continue;
      vertex = ends_[i].parting_vertex;
      return static_cast<int>(i);
    }
  }
  return -1;
}

namespace {

// Indices of an edge's nodes from its vertex to the parting, both included.
std::vector<std::size_t> joined_nodes(const JoinedEnds::End& end, const EdgeNodes& cut) {
  std::vector<std::size_t> found;
  const double low = std::min(end.t_vertex, end.t_parting);
  const double high = std::max(end.t_vertex, end.t_parting);
  for (std::size_t k = 0; k < cut.params.size(); ++k) {
    if (cut.params[k] >= low && cut.params[k] <= high) found.push_back(k);
  }
  return found;
}

}  // namespace

void JoinedEdges::share_nodes(Evaluator& evaluator, Discretization& out) const {
  for (const JoinedEnds& joined : ends_) {
    const EdgeNodes& kept = out.edges[joined.kept.edge.index()];
    EdgeNodes& other = out.edges[joined.other.edge.index()];
    const std::vector<std::size_t> from = joined_nodes(joined.kept, kept);
    const std::vector<std::size_t> to = joined_nodes(joined.other, other);
    if (from.size() < 2 || to.size() < 2) continue;
    const bool same_way = (joined.kept.t_parting > joined.kept.t_vertex) ==
                          (joined.other.t_parting > joined.other.t_vertex);
    const double t0 = other.params[to.front()], t1 = other.params[to.back()];
    const double whole = evaluator.edge_length(joined.other.edge, t0, t1);
    const double kept_whole = evaluator.edge_length(joined.kept.edge, kept.params[from.front()],
                                                    kept.params[from.back()]);
    EdgeNodes between;
    for (std::size_t k = 1; k + 1 < from.size(); ++k) {
      const std::size_t i = from[same_way ? k : from.size() - 1 - k];
      const double s =
          evaluator.edge_length(joined.kept.edge, kept.params[from.front()], kept.params[i]);
      const double share = same_way ? s / kept_whole : 1.0 - s / kept_whole;
      between.nodes.push_back(kept.nodes[i]);
      between.params.push_back(evaluator.edge_parameter(joined.other.edge, t0, share * whole));
    }
    const auto first = static_cast<std::ptrdiff_t>(to.front() + 1);
    const auto last = static_cast<std::ptrdiff_t>(to.back());
    other.nodes.erase(other.nodes.begin() + first, other.nodes.begin() + last);
    other.params.erase(other.params.begin() + first, other.params.begin() + last);
    other.nodes.insert(other.nodes.begin() + first, between.nodes.begin(), between.nodes.end());
    other.params.insert(other.params.begin() + first, between.params.begin(), between.params.end());
  }
}

}  // namespace advlayers
