#include "boundary/discretization.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "boundary/edge_creases.h"
#include "boundary/edge_overshoot.h"
#include "boundary/facing_joints.h"
#include "boundary/facing_parts.h"
#include "boundary/facing_stretches.h"
#include "boundary/joined_edges.h"
#include "boundary/layers_along.h"
#include "boundary/mapped_sides.h"
#include "boundary/periodic_cuts.h"
#include "boundary/stretch.h"

namespace advlayers {

namespace {

// An even edge takes the fewest segments that are no longer than this many times the size.
constexpr double kSizeTolerance = 1.1;
constexpr double kSharpFold = 0.01;  // of the size: a fold narrower than this is not followed
constexpr double kOneJoint = 0.2;    // of such a fold: a kink and a fold this near are one
constexpr int kMaxRounds = 200;      // of grading: a change passes one joint in each
// Stretches that are cut alike, but differ in length, are shortened by their neighbours in so many
// rounds alone: over a ring of strips one could shorten the other without end.
constexpr int kGroupRounds = 12;
constexpr int kFacingRounds = 6;  // of giving both ends of strips as many segments
// Triangles stay within 30 degrees of the surface, so the surface may turn no more along a segment.
constexpr double kNormalAngle = M_PI / 6.0;
constexpr int kMinLoop = 3;  // segments
// Edges that go together for less than this part of the size stay two.
constexpr double kLeastJoined = 0.05;

// A chord over the length of a segment is an eighth of the angle that it turns by.
double turn_of_segment(const Settings& settings) {
  const double angle = settings.curvature_angle * M_PI / 180.0;
  return settings.relative_chord > 0.0 ? std::min(angle, 8.0 * settings.relative_chord) : angle;
}

// Whether the user cuts the edge, and nothing else does.
bool is_cut_by(const SizeSpec& spec) {
  return spec.segments || spec.cluster || spec.first_segment || spec.last_segment;
}

class Discretizer {
 public:
  Discretizer(const RunContext& context, Evaluator& evaluator, const Settings& settings,
              const std::vector<MatchEnd>& match_ends, const std::vector<FourSides>& strips,
              const std::vector<FourSides>& mapped, const std::vector<EdgePair>& periodic)
      : context_(context),
        evaluator_(evaluator),
        model_(evaluator.model()),
        sizes_(settings),
        limits_{0.0,
                &sizes_,
                turn_of_segment(settings),
                0.0,
                settings.chord_deviation,
                settings.min_size,
                true},
        most_jump_(settings.size_growth),
        joint_count_(static_cast<int>(model_.vertices().size())) {
    limits_.normal_angle = std::max(limits_.curve_angle, kNormalAngle);
    choose_faces(settings);
    find_given(match_ends);
    choose_strips(strips);
    hold(mapped, periodic);
    make_stretches();
  }

  Discretization run(const std::vector<MatchEnd>& match_ends, const std::vector<FourSides>& mapped,
                     const std::vector<EdgePair>& periodic) {
    for (Stretch& stretch : stretches_.all) {
      context_.check();
      stretch.spacing.require(stretch.required);
      stretch.spacing.cut();
    }
    grade();
    while (part_coincident() || lengthen_loops()) grade();
    face_strips();
    notes_ = run_layers_along(context_, evaluator_, match_ends, stretches_);
    even_out_sides(context_, mapped, stretches_);
    cut_alike(context_, periodic, stretches_);
    Discretization cut = collect();
    place_alike(evaluator_, periodic, cut);
    return cut;
  }

 private:
  void choose_faces(const Settings& settings) {
    meshed_.assign(model_.faces().size(), settings.faces.empty());
    for (const FaceId f : settings.faces) meshed_[f.index()] = true;
    sides_.resize(model_.edges().size());
    for (std::size_t f = 0; f < model_.faces().size(); ++f) {
      if (!model_.faces()[f].defect.empty()) meshed_[f] = false;
      if (!meshed_[f]) continue;
      for (const auto& loop : model_.faces()[f].loops) {
        for (const CoEdge& coedge : loop)
          sides_[coedge.edge.index()].push_back({FaceId(f), coedge});
      }
    }
  }

  // Edges that the user has cut, or that layers run along.
  void find_given(const std::vector<MatchEnd>& match_ends) {
    given_.assign(model_.edges().size(), 0);
    for (std::size_t i = 0; i < given_.size(); ++i) {
      const SizeSpec* spec = sizes_.edge_spec(EdgeId(i));
      if (spec != nullptr && is_cut_by(*spec)) given_[i] = 1;
    }
    for (const MatchEnd& match : match_ends) given_[match.edge.index()] = 1;
  }

  void choose_strips(const std::vector<FourSides>& strips) {
    for (const FourSides& strip : strips) {
      if (std::none_of(strip.sides.begin(), strip.sides.end(), [&](const auto& side) {
            return std::any_of(side.begin(), side.end(), [&](const CoEdge& coedge) {
              return given_[coedge.edge.index()] != 0;
            });
          })) {
        strips_.push_back(strip);
      }
    }
  }

  void make_stretches() {
    stretches_.of_edge.resize(model_.edges().size());
    const std::vector<std::vector<double>> joints = joints_of_edges();
    for (std::size_t i = 0; i < model_.edges().size(); ++i) {
      const Edge& edge = model_.edges()[i];
      if (sides_[i].empty() || edge.degenerate) continue;
      context_.check();
      limits_.size = longest_segment(EdgeId(i));
      const std::vector<double>& ends = joints[i];
      const int first = edge.start.valid() ? edge.start.value : joint_count_++;
      const int last = edge.end.valid() ? edge.end.value : closed_at(edge, first);
      int from = first;
      for (std::size_t k = 1; k < ends.size(); ++k) {
        const int to = k + 1 == ends.size() ? last : joint_at(EdgeId(i), ends[k]);
        stretches_.of_edge[i].push_back(stretches_.all.size());
        limits_.open = from != to;
        stretches_.all.push_back(
            {EdgeId(i),
             ends[k - 1],
             ends[k],
             {from, to},
             from == to ? 3 : 1,
             EdgeSpacing(evaluator_, EdgeId(i), ends[k - 1], ends[k], sides_[i], limits_)});
        from = to;
      }
      fix_segments(EdgeId(i));
    }
  }

  double longest_segment(EdgeId edge) const {
    std::vector<FaceId> beside;
    for (const EdgeSpacing::Side& side : sides_[edge.index()]) beside.push_back(side.face);
    return kSizeTolerance * sizes_.of_edge(edge, beside);
  }

  std::vector<std::vector<double>> joints_of_edges() {
    std::vector<std::vector<double>> joints(model_.edges().size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      context_.check();
      if (!sides_[i].empty() && !model_.edges()[i].degenerate) joints[i] = own_joints(EdgeId(i));
    }
    face_joints(context_, evaluator_, strips_, joints);
    find_facing(joints);
    find_joined();
    joined_.add_joints(joints);
    return joints;
  }

  // What is made equal to other edges takes no joints for what lies across.
  void hold(const std::vector<FourSides>& mapped, const std::vector<EdgePair>& periodic) {
    held_ = given_;
    for (const EdgePair& pair : periodic) held_[pair.given.index()] = held_[pair.found.index()] = 1;
    for (const FourSides& face : mapped) {
      for (const auto& side : face.sides) {
        for (const CoEdge& coedge : side) held_[coedge.edge.index()] = 1;
      }
    }
  }

  // On all faces but those that are strips as a whole.
  void find_facing(std::vector<std::vector<double>>& joints) {
    if (model_.triangular()) return;
    std::vector<char> wanted(meshed_.begin(), meshed_.end());
    for (const FourSides& strip : strips_) wanted[strip.face.index()] = 0;
    FacingEdges facing(context_, evaluator_, sizes_, limits_.curve_angle, held_);
    for (std::size_t f = 0; f < wanted.size(); ++f) {
      if (wanted[f] != 0) facing.find(FaceId(f), joints);
    }
    facing.face_joints(joints);
    facing_parts_ = facing.release();
  }

  void find_joined() {
    std::vector<double> least(model_.edges().size());
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (!sides_[i].empty()) least[i] = kLeastJoined * longest_segment(EdgeId(i));
    }
    joined_ = JoinedEdges(context_, evaluator_, meshed_, least);
    joint_of_parting_.assign(joined_.size(), -1);
  }

  int joint_at(EdgeId edge, double t) {
    VertexId vertex;
    const int parting = joined_.parting_at(edge, t, vertex);
    if (vertex.valid()) return vertex.value;
    if (parting < 0) return joint_count_++;
    int& joint = joint_of_parting_[static_cast<std::size_t>(parting)];
    if (joint < 0) joint = joint_count_++;
    return joint;
  }

  // The edge's ends and what takes a node between them: kinks of the curve, which turn no matter
  // how short the segments, and folds of a face beside it.
  std::vector<double> own_joints(EdgeId id) {
    const EdgeExtent extent = extent_without_overshoot(evaluator_, id);
    std::vector<double> found = evaluator_.edge_kinks(id, 0.5 * limits_.curve_angle);
    const double least = kSharpFold * std::min(longest_segment(id), model_.edge(id).length);
    for (const double t : edge_creases(evaluator_, id, sides_[id.index()], least)) {
      found.push_back(t);
    }
    std::vector<double> ends{extent.first, extent.last};
    const double apart = std::max(model_.edge(id).tolerance, kOneJoint * least);
    for (const double t : found) {
      const auto is_near = [&](double end) {
        return std::abs(evaluator_.edge_length(id, end, t)) <= apart;
      };
      if (t <= extent.first || t >= extent.last) continue;
      if (std::none_of(ends.begin(), ends.end(), is_near)) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  // A number of segments of the whole edge is shared out by the lengths of its stretches.
  void fix_segments(EdgeId edge) {
    const SizeSpec* spec = sizes_.edge_spec(edge);
    if (spec == nullptr || !is_cut_by(*spec)) return;
    if (spec->first_segment || spec->last_segment) return fix_ends(edge, *spec);
    double length = 0.0;
    for (const std::size_t i : stretches_.of(edge)) length += stretches_[i].spacing.length();
    for (const std::size_t i : stretches_.of(edge)) {
      EdgeSpacing& spacing = stretches_[i].spacing;
      const double ratio = std::pow(spec->cluster.value_or(1.0), spacing.length() / length);
      const int segments =
          spec->segments
              ? static_cast<int>(std::lround(*spec->segments * spacing.length() / length))
              : spacing.segments_for(ratio, spec->both_ends);
      spacing.fix(std::max(1, segments), ratio, spec->both_ends);
    }
  }

  // The first stretch has the segment at the edge's first vertex, the last one that at its last.
  void fix_ends(EdgeId edge, const SizeSpec& spec) {
    double length = 0.0;
    for (const std::size_t i : stretches_.of(edge)) length += stretches_[i].spacing.length();
    const auto& stretches = stretches_.of(edge);
    for (const std::size_t i : stretches) {
      EdgeSpacing& spacing = stretches_[i].spacing;
      EndSegments ends;
      if (i == stretches.front()) ends.first = spec.first_segment;
      if (i == stretches.back()) ends.last = spec.last_segment;
      ends.distribution = spec.distribution;
      if (spec.segments) {
        const double share = *spec.segments * spacing.length() / length;
        ends.segments = std::max(1, static_cast<int>(std::lround(share)));
      }
      spacing.fix_ends(ends);
    }
  }

  // An edge without vertices is closed.
  int closed_at(const Edge& edge, int first) {
    const EdgeId id(static_cast<std::int32_t>(&edge - model_.edges().data()));
    const Vec3 gap = evaluator_.edge_point(id, edge.first) - evaluator_.edge_point(id, edge.last);
    return !edge.start.valid() && gap.norm() <= edge.tolerance ? first : joint_count_++;
  }

  void face_strips() {
    facing_.emplace(context_, strips_, facing_parts_, stretches_);
    facing_->cut(std::vector<char>(stretches_.all.size(), 1));
    grade();
    for (int round = 0; round < kFacingRounds && facing_->even_out_ends(); ++round) grade();
  }

  // Lowers the ends of long segments beside short ones until none jumps. Each round looks at the
  // state before it, so that the outcome does not depend on the order of edges.
  void grade() {
    for (int round = 0; round < kMaxRounds; ++round) {
      context_.check();
      std::vector<double> shortest(static_cast<std::size_t>(joint_count_),
                                   std::numeric_limits<double>::infinity());
      for (const Stretch& s : stretches_.all) {
        for (int end = 0; end < 2; ++end) {
          double& least = shortest[static_cast<std::size_t>(s.joints[end])];
          least = std::min(least, s.spacing.end_segment(end));
        }
      }
      std::vector<char> lowered(stretches_.all.size(), 0);
      for (std::size_t i = 0; i < lowered.size(); ++i) {
        EdgeSpacing& spacing = stretches_[i].spacing;
        if (spacing.fixed()) continue;
        if (facing_ && facing_->is_grouped(i) && round >= kGroupRounds) continue;
        for (int end = 0; end < 2; ++end) {
          const double least = shortest[static_cast<std::size_t>(stretches_[i].joints[end])];
          if (spacing.end_segment(end) <= most_jump_ * (1.0 + 1e-9) * least) continue;
          // It is to begin with half of the growth, which its own growth then brings to all of it.
          spacing.limit_end(end, 0.5 * (1.0 + most_jump_) * least);
          lowered[i] = 1;
        }
      }
      if (std::find(lowered.begin(), lowered.end(), 1) == lowered.end()) return;
      cut(lowered);
    }
  }

  void cut(const std::vector<char>& chosen) {
    if (facing_) return facing_->cut(chosen);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (!chosen[i]) continue;
      context_.check();
      stretches_[i].spacing.cut();
    }
  }

  void require(std::size_t stretch, int count) {
    stretches_[stretch].required = count;
    stretches_[stretch].spacing.require(count);
    stretches_[stretch].spacing.cut();
  }

  // Two stretches of one segment between the same joints would be one mesh edge: those that are
  // not straight, or all where none is, take a node between.
  bool part_coincident() {
    std::map<std::pair<int, int>, std::vector<std::size_t>> single;
    for (std::size_t i = 0; i < stretches_.all.size(); ++i) {
      const Stretch& s = stretches_[i];
      if (s.spacing.count() == 1) single[std::minmax(s.joints[0], s.joints[1])].push_back(i);
    }
    bool changed = false;
    for (const auto& [joints, group] : single) {
      if (group.size() < 2) continue;
      std::vector<std::size_t> curved;
      for (const std::size_t i : group) {
        const Stretch& s = stretches_[i];
        const Vec3 chord =
            evaluator_.edge_point(s.edge, s.t_end) - evaluator_.edge_point(s.edge, s.t_begin);
        if (s.spacing.length() > chord.norm() * (1.0 + 1e-9)) curved.push_back(i);
      }
      for (const std::size_t i : group.size() - curved.size() > 1 ? group : curved) {
        require(i, 2);
        changed = true;
      }
    }
    return changed;
  }

  // A loop needs three segments to hold a triangle: its longest stretches take more.
  bool lengthen_loops() {
    bool changed = false;
    for (std::size_t f = 0; f < model_.faces().size(); ++f) {
      if (!meshed_[f]) continue;
      for (const auto& loop : model_.faces()[f].loops) changed = lengthen(loop) || changed;
    }
    return changed;
  }

  bool lengthen(const std::vector<CoEdge>& loop) {
    int segments = 0;
    double longest = 0.0;
    for (const CoEdge& coedge : loop) {
      for (const std::size_t i : stretches_.of(coedge.edge)) {
        segments += stretches_[i].spacing.count();
        longest = std::max(longest, stretches_[i].spacing.length());
      }
    }
    if (segments == 0 || segments >= kMinLoop) return false;
    for (const CoEdge& coedge : loop) {
      for (const std::size_t i : stretches_.of(coedge.edge)) {
        const EdgeSpacing& spacing = stretches_[i].spacing;
        if (spacing.length() >= longest * (1.0 - 1e-9)) require(i, spacing.count() + 1);
      }
    }
    return true;
  }

  Discretization collect() {
    Discretization out;
    out.notes = std::move(notes_);
    out.edges.resize(model_.edges().size());
    joint_node_.assign(static_cast<std::size_t>(joint_count_), NodeId());
    add_vertices(out);
    for (std::size_t i = 0; i < model_.edges().size(); ++i) {
      if (sides_[i].empty()) continue;
      if (model_.edges()[i].degenerate) {
        add_pole(EdgeId(i), out);
      } else {
        add_edge(EdgeId(i), out);
      }
    }
    joined_.share_nodes(evaluator_, out);
    return out;
  }

  void add_vertices(Discretization& out) {
    std::vector<bool> used(model_.vertices().size(), false);
    for (std::size_t i = 0; i < model_.edges().size(); ++i) {
      if (sides_[i].empty()) continue;
      for (const VertexId v : {model_.edges()[i].start, model_.edges()[i].end}) {
        if (v.valid()) used[v.index()] = true;
      }
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      joint_node_[v] = NodeId(out.nodes.size());
      out.nodes.push_back({model_.vertices()[v].xyz, VertexId(v), EdgeId(), 0.0});
    }
  }

  NodeId add_node(EdgeId edge, double t, Discretization& out) {
    out.nodes.push_back({evaluator_.edge_point(edge, t), VertexId(), edge, t});
    return NodeId(out.nodes.size() - 1);
  }

  void add_pole(EdgeId id, Discretization& out) {
    const Edge& edge = model_.edge(id);
    const NodeId node =
        edge.start.valid() ? joint_node_[edge.start.index()] : add_node(id, edge.first, out);
    out.edges[id.index()] = {{node}, {edge.first}};
  }

  NodeId joint_node(int joint, EdgeId edge, double t, Discretization& out) {
    NodeId& node = joint_node_[static_cast<std::size_t>(joint)];
    if (!node.valid()) node = add_node(edge, t, out);
    return node;
  }

  void add_edge(EdgeId id, Discretization& out) {
    EdgeNodes& edge = out.edges[id.index()];
    for (const std::size_t i : stretches_.of(id)) {
      const Stretch& s = stretches_[i];
      const NodeId begin = joint_node(s.joints[0], id, s.t_begin, out);
      if (edge.nodes.empty()) {
        edge.nodes.push_back(begin);
        edge.params.push_back(s.t_begin);
      }
      const std::vector<double>& cuts = s.spacing.cuts();
      for (std::size_t k = 1; k + 1 < cuts.size(); ++k) {
        context_.check();
        const double t = evaluator_.edge_parameter(id, s.t_begin, cuts[k]);
        edge.nodes.push_back(add_node(id, t, out));
        edge.params.push_back(t);
      }
      edge.nodes.push_back(joint_node(s.joints[1], id, s.t_end, out));
      edge.params.push_back(s.t_end);
    }
  }

  const RunContext& context_;
  Evaluator& evaluator_;
  const Model& model_;
  SizeField sizes_;
  SpacingLimits limits_;  // with the size of the edge at hand
  double most_jump_;      // of neighbouring segments, across a joint of stretches too
  int joint_count_;       // joints below the number of CAD vertices are those
  std::vector<bool> meshed_;
  std::vector<std::vector<EdgeSpacing::Side>> sides_;  // by EdgeId
  Stretches stretches_;
  std::vector<FourSides> strips_;
  std::vector<char> given_;  // by EdgeId: how it is cut is not ours to choose
  std::vector<char> held_;   // the same, and those that others are made equal to
  std::vector<FacingParts> facing_parts_;
  std::optional<FacingStretches> facing_;
  JoinedEdges joined_;
  std::vector<int> joint_of_parting_;  // -1: none yet
  std::vector<NodeId> joint_node_;
  std::vector<Diagnostic> notes_;
};

}  // namespace

Discretization discretize(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                          const std::vector<MatchEnd>& match_ends,
                          const std::vector<FourSides>& strips,
                          const std::vector<FourSides>& mapped,
                          const std::vector<EdgePair>& periodic) {
  return Discretizer(context, evaluator, settings, match_ends, strips, mapped, periodic)
      .run(match_ends, mapped, periodic);
}

bool same_cuts(const Discretization& a, const Discretization& b) {
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(),
                    [](const EdgeNodes& x, const EdgeNodes& y) {
                      return x.nodes == y.nodes && x.params == y.params;
                    });
}

}  // namespace advlayers
