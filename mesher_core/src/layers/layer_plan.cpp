#include "layers/layer_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "layers/chain_end.h"
#include "layers/concave_scaling.h"
#include "layers/opposing_fronts.h"
#include "sizing/gap_rule.h"

namespace advlayers {
namespace {

constexpr double kDegree = M_PI / 180.0;
// A row end (three nodes, one kid) takes interior angles up to this; wider ones turn too little.
constexpr double kRowEndAngle = 135.0 * kDegree;
constexpr double kLeastRowEndAngle = 30.0 * kDegree;
constexpr double kNeighbourTurn =
    40.0 * kDegree;                     // the ends beside a corner run on nearly straight
constexpr double kRowEndHeights = 2.5;  // its quad is no higher than this many heights
constexpr double kCollapseLength = 2.0 * 0.41421356237309503;  // 2 tan(pi / 8), paper II.F
constexpr int kFanLayers = 2;                       // fan edges are exempt from collapse this long
constexpr double kFanAngle = 247.5 * kDegree;       // from here three quads meet at the corner
constexpr double kReversalAngle = 315.0 * kDegree;  // and from here four
constexpr double kEndTurn = 50.0 * kDegree;         // both ends turn this much: the end of a strip
// Three front edges become one where their kids' edges are on average shorter than this many
// heights.
constexpr double kCoarsenLength = 0.95;
constexpr double kCoarsenLongest = 1.2;
constexpr double kCoarsenTurn = 25.0 * kDegree;
constexpr double kTreadHeight = 0.42;  // of the inner kids, in heights: evens the angles out
// A layer that ends beside one this many heights long closes with a triangle; the side of a shorter
// one is no worse an edge for the core.
constexpr double kStepAspect = 20.0;
constexpr double kLeastCellAngle = 4.0 * kDegree;

class Planner {
 public:
  explicit Planner(LayerState& state)
      : state_(state),
        mesh_(state.mesh),
        front_(state.front),
        heights_(front_.nodes().size(), 0.0) {
    plan_.shapes.resize(front_.nodes().size());
    plan_.kids_of.resize(front_.nodes().size());
  }

  LayerPlan run() {
    measure();
    cap_by_gaps();
    step_ends();
    for (int i = 0; i < front_.size(); ++i) {
      if (advances(i)) try_row_end(i);
    }
    for (int i = 0; i < front_.size(); ++i) {
      state_.cancel->check();
      if (advances(i) && plan_.kids_of[index(i)].empty()) extrude(i);
    }
    for (int i = 0; i < front_.size(); ++i) try_coarsen(i);
    merge_close_kids();
    for (int i = 0; i < front_.size(); ++i) {
      if (front_[i].next >= 0) add_cell_on(i, front_[i].next);
      add_fan_cells(i);
    }
    for (Cell& top : tops_) add_cell(std::move(top));
    return std::move(plan_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const NodeShape& shape(int i) const { return plan_.shapes[index(i)]; }
  bool advances(int i) const { return front_[i].active; }
  const Vec3& position(int i) const { return mesh_.position(front_[i].vertex); }

  void measure() {
    for (int i = 0; i < front_.size(); ++i) {
      const FrontNode& node = front_[i];
      if (!node.active || (node.prev < 0 && node.next < 0)) continue;
      plan_.shapes[index(i)] = node_shape(mesh_, front_, i);
      heights_[index(i)] = std::min(node.height, state_.max_height);
      if (node.layers_left <= 0) {
        end(i, Stop::kLayersReached);
      } else if (state_.stop_at_isotropy && node.height >= shape(i).length()) {
        end(i, Stop::kIsotropic);
      }
    }
    drop_lone_nodes(Stop::kNeighbour);
  }

  // The node stops; neighbours that go on close the layer beside it with a triangle, and stop
  // themselves a layer later, so that neighbouring columns differ by one layer at most.
  void end(int i, Stop reason) {
    state_.note_stop(i, reason);
    front_[i].active = false;
    drop_kids_of(i);
  }

  // Opposing fronts meet evenly: where two more rows of this height would leave less than one, the
  // height is a third of the gap; where not even two fit, the column stops.
  void cap_by_gaps() {
    opposites_ = opposing_fronts(state_, plan_.shapes, heights_);
    std::vector<int> crowded;
    for (int i = 0; i < front_.size(); ++i) {
      if (!advances(i) || is_chain_end(front_[i])) continue;
      const double height = heights_[index(i)];
      const double rows = 1.0 + concave_factor(shape(i), height);  // ours and the opposing one
      heights_[index(i)] = height_in_gap(height, opposites_[index(i)].gap, rows);
      if (heights_[index(i)] <= 0.0) crowded.push_back(i);
    }
    // The two corners at a strip's end do not see each other; they share its width likewise.
    for (int i = 0; i < front_.size(); ++i) {
      const int k = front_[i].next;
      if (!advances(i) || k < 0 || !is_strip_end(i, k)) continue;
      const double width = shape(i).length_next;
      for (const int end : {i, k}) {
        if (width < 2.0 * heights_[index(end)]) crowded.push_back(end);
        heights_[index(end)] = std::min(heights_[index(end)], width / 3.0);
      }
    }
    for (const int i : crowded) {
      if (advances(i)) end(i, Stop::kCollision);
    }
    drop_lone_nodes(Stop::kCollision);
  }

  // A column without neighbours would stand alone.
  void drop_lone_nodes(Stop reason) {
    for (int i = 0; i < front_.size(); ++i) {
      if (!advances(i)) continue;
      const auto goes_on = [&](int k) { return k >= 0 && advances(k); };
      if (!goes_on(front_[i].prev) && !goes_on(front_[i].next)) end(i, reason);
    }
  }

  // The kids of chains' ends, see chain_end.h.
  void step_ends() {
    const ChainEnds ends(state_);
    for (int i = 0; i < front_.size(); ++i) {
      if (!is_chain_end(front_[i])) continue;
      const int inner = std::max(front_[i].prev, front_[i].next);
      const bool follows = !is_chain_end(front_[inner]);
      if (follows && advances(inner)) {
        heights_[index(i)] = std::min(heights_[index(i)], heights_[index(inner)]);
      }
      const EndStep step = ends.step(i, heights_[index(i)], follows);
      if (!step.kid.valid()) {
        if (shape(i).length() > kStepAspect * heights_[index(i)]) end(i, Stop::kNeighbour);
      } else if (step.height <= 0.0) {
        end(i, Stop::kCollision);
      } else {
        add_given_kid(i, step);
      }
    }
    drop_lone_nodes(Stop::kNeighbour);
  }

  void add_given_kid(int i, const EndStep& step) {
    Kid& kid = plan_.kids[index(add_kid(i, mesh_.data(step.kid).point))];
    kid.vertex = step.kid;
    kid.given = true;
    kid.lag = step.lag;
    if (step.kid == front_[i].vertex) kid.parents.clear();
  }
  bool stands(int kid) const {
    const Kid& k = plan_.kids[index(kid)];
    return k.given && k.parents.empty();
  }

  int add_kid(int node, const SurfacePoint& point) {
    const FrontNode& parent = front_[node];
    Kid kid;
    kid.point = point;
    kid.normal = state_.surface.normal(point);
    kid.parents = {node};
    kid.origin = node;
    kid.height = parent.height * parent.growth;
    kid.growth = parent.growth;
    kid.layers_left = parent.layers_left - 1;
    kid.root = parent.root;
    if (parent.fan_age >= 0 && parent.fan_age < kFanLayers) kid.fan_age = parent.fan_age + 1;
    plan_.kids.push_back(std::move(kid));
    plan_.kids_of[index(node)].push_back(static_cast<int>(plan_.kids.size()) - 1);
    return plan_.kids_of[index(node)].back();
  }

  int step_kid(int node, const Vec3& direction, double length) {
    SurfacePoint to;
    if (!state_.surface.step(mesh_.data(front_[node].vertex).point, direction, length, to))
      return -1;
    return add_kid(node, to);
  }

  void extrude(int i) {
    const NodeShape& s = shape(i);
    const bool on_wall = mesh_.data(front_[i].vertex).support != Support::kPatch;
    if (on_wall && s.angle >= kFanAngle) {
      extrude_fan(i, s.angle >= kReversalAngle ? 2 : 1);
      return;
    }
    const double height = heights_[index(i)];
    const Vec3 along = (s.to_next - s.to_prev).normalized();
    const Vec3 way =
        concave_factor(s, height) * height * s.inward + opposites_[index(i)].slide * along;
    if (step_kid(i, way.normalized(), way.norm()) < 0) end(i, Stop::kBlocked);
  }

  // Several kids at a convex corner: the perpendiculars of both edges, and between each two of
  // `quads` + 1 spokes a diagonal kid at h / cos of half the sector.
  void extrude_fan(int i, int quads) {
    const NodeShape& s = shape(i);
    const double height = heights_[index(i)];
    const double sector = (s.angle - M_PI) / quads;
    const Vec3 first = rotated(s.to_prev, s.normal, -0.5 * M_PI);
    for (int k = 0; k <= 2 * quads; ++k) {
      const bool diagonal = k % 2 == 1;
      const double length = diagonal ? height / std::max(0.4, std::cos(0.5 * sector)) : height;
      const int kid = step_kid(i, rotated(first, s.normal, -0.5 * k * sector), length);
      if (kid < 0) {
        end(i, Stop::kBlocked);
        return;
      }
      plan_.kids[index(kid)].fan_age = 0;
      if (diagonal) plan_.kids[index(kid)].parents.clear();
    }
    state_.count_event(Event::kFan);
  }
  void drop_kids_of(int i) {
    for (const int kid : plan_.kids_of[index(i)]) plan_.kids[index(kid)].alive = false;
    plan_.kids_of[index(i)].clear();
  }

  // May the front end a row at corner a: it turns enough, and its edges are short enough that one
  // more layer with a kid of its own would leave none worth keeping.
  bool ends_row(int a) const {
    if (!advances(a) || front_[a].prev < 0 || front_[a].next < 0) return false;
    if (!plan_.kids_of[index(a)].empty()) return false;
    const NodeShape& s = shape(a);
    if (s.angle > kRowEndAngle) return false;
    const double height = heights_[index(a)];
    if (std::max(s.length_next, s.length_prev) > kRowEndHeights * height) return false;
    const double eaten = height / std::tan(0.5 * s.angle);
    return s.shorter() - eaten <= 1.1 * front_[a].growth * height;
  }
  // Is the node beside a row end free, and the front nearly straight there.
  bool runs_straight(int k) const {
    return k >= 0 && advances(k) && plan_.kids_of[index(k)].empty() && front_[k].prev >= 0 &&
           front_[k].next >= 0 && std::abs(shape(k).turn()) <= kNeighbourTurn;
  }

  //   c ------ kid      A row end: the corner a and both its neighbours share the kid b + c - a.
  //   One |         |       quad, no triangle, two front edges less. a ------- b       (b = prev, c
  //   = next)
  void try_row_end(int a) {
    if (!ends_row(a)) return;
    const int b = front_[a].prev, c = front_[a].next;
    if (front_.ring_size(a, 6) >= 0) return;
    if (try_strip_end(a, c, front_[c].next) || try_strip_end(front_[b].prev, b, a)) return;
    if (!runs_straight(b) || !runs_straight(c)) return;
    share_kid({a}, {b, c}, position(b) + position(c) - position(a));
  }

  //   b --- kid --- e     A strip two edges wide ends: two row ends share the node m between their
  //   |      |      |     corners, and the kid.
  //   a ---- m ---- d     (front: b, a, m, d, e)
  bool try_strip_end(int a, int m, int d) {
    if (a < 0 || d < 0 || !ends_row(a) || !ends_row(d) || !runs_straight(m)) return false;
    const int b = front_[a].prev, e = front_[d].next;
    if (!runs_straight(b) || !runs_straight(e) || b == e || front_[b].prev == e) return false;
    const Vec3 side = 0.5 * (position(b) - position(a) + position(e) - position(d));
    return share_kid({a, d}, {b, m, e}, position(m) + side);
  }

  // One kid for all `parents`; the corners in between get none.
  bool share_kid(const std::vector<int>& corners, const std::vector<int>& parents,
                 const Vec3& xyz) {
    SurfacePoint point;
    if (!state_.surface.project(xyz, mesh_.data(front_[parents[0]].vertex).point, point))
      return false;
    const Corner kid_at{point.xyz, state_.surface.normal(point)};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner p = corner(mesh_, front_[parents[k]].vertex);
      const Corner q = corner(mesh_, front_[parents[k + 1]].vertex);
      const Corner a = corner(mesh_, front_[corners[k]].vertex);
      const double least = std::min({min_angle(p, a, q), min_angle(a, q, kid_at),
                                     min_angle(q, kid_at, p), min_angle(kid_at, p, a)});
      if (least <= 0.0) return false;
      for (const auto& [x, y, z] : {std::array{p, a, q}, std::array{a, q, kid_at},
                                    std::array{q, kid_at, p}, std::array{kid_at, p, a}}) {
        const double angle = inner_angle(x, y, z);
        if (angle < kLeastRowEndAngle || angle > M_PI - kLeastRowEndAngle) return false;
      }
    }
    // Of three parents the middle one: its edge to the kid bounds both quads.
    const std::size_t first = (parents.size() - 1) / 2;
    const int kid = add_kid(parents[first], point);
    plan_.kids[index(kid)].parents = parents;
    double height = 0.0;
    int& layers_left = plan_.kids[index(kid)].layers_left;
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const FrontNode& parent = front_[parents[k]];
      height += parent.height * parent.growth / static_cast<double>(parents.size());
      layers_left = std::min(layers_left, parent.layers_left - 1);
      plan_.kids_of[index(parents[k])] = {kid};
      if (k != first) state_.note_stop(parents[k], Stop::kMerged);
    }
    plan_.kids[index(kid)].height = height;
    for (const int a : corners) {
      plan_.kids_of[index(a)] = {kid};
      state_.note_stop(a, Stop::kClosed);
      state_.count_event(Event::kRowEnd);
    }
    return true;
  }

  double kid_distance(int p, int q) const {
    return (plan_.kids[index(p)].point.xyz - plan_.kids[index(q)].point.xyz).norm();
  }

  // The end edge of a strip shrinks between two corners; it is zipped, not collapsed.
  bool is_strip_end(int i, int k) const {
    return shape(i).turn() > kEndTurn && shape(k).turn() > kEndTurn;
  }

  // Kids nearer to each other than 2 tan(pi/8) h, or that have passed each other, become one at
  // their mean (paper, II.F, Fig. 6, before insertion instead of after). Shortest first.
  void merge_close_kids() {
    struct Pair {
      double length;
      int node;
    };
    std::vector<Pair> pairs;
    for (int i = 0; i < front_.size(); ++i) {
      const int k = front_[i].next;
      if (k < 0 || plan_.kids_of[index(i)].empty() || plan_.kids_of[index(k)].empty()) continue;
      const int p = plan_.kids_of[index(i)].back(), q = plan_.kids_of[index(k)].front();
      if (p == q) continue;
      const Vec3 along = plan_.kids[index(q)].point.xyz - plan_.kids[index(p)].point.xyz;
      const double forward = along.dot((position(k) - position(i)).normalized());
      const double height = 0.5 * (heights_[index(i)] + heights_[index(k)]);
      const bool fan = plan_.kids[index(p)].fan_age >= 0 && plan_.kids[index(q)].fan_age >= 0;
      const double limit = fan || is_strip_end(i, k) ? 0.2 : kCollapseLength;
      if (forward < limit * height) pairs.push_back({forward, i});
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return a.length != b.length ? a.length < b.length : a.node < b.node;
    });
    for (const Pair& pair : pairs) merge(pair.node, front_[pair.node].next);
  }

  void merge(int i, int k) {
    const auto& of_k = plan_.kids_of[index(k)];
    if (of_k.size() == 1 && plan_.kids[index(of_k[0])].given) std::swap(i, k);
    auto& kids_i = plan_.kids_of[index(i)];
    auto& kids_k = plan_.kids_of[index(k)];
    if (kids_i.size() != 1 || kids_k.size() != 1 || is_tread(kids_i[0]) || is_tread(kids_k[0]))
      return;
    Kid& kept = plan_.kids[index(kids_i[0])];
    Kid& gone = plan_.kids[index(kids_k[0])];
    if (kept.parents.size() != 1 || gone.parents.size() != 1 || gone.given) return;
    if (!kept.given) {
      SurfacePoint mean;
      if (!state_.surface.project(0.5 * (kept.point.xyz + gone.point.xyz), kept.point, mean)) {
        return;
      }
      kept.point = mean;
      kept.normal = state_.surface.normal(mean);
    }
    kept.parents.push_back(k);
    kept.height = 0.5 * (kept.height + gone.height);
    kept.growth = 0.5 * (kept.growth + gone.growth);
    kept.layers_left = std::min(kept.layers_left, gone.layers_left);
    gone.alive = false;
    kids_k = kids_i;
    state_.note_stop(k, Stop::kMerged);
    state_.count_event(Event::kCollapse);
  }

  Corner corner_of(const CellCorner& c) const {
    if (c.node >= 0) return corner(mesh_, front_[c.node].vertex);
    return {plan_.kids[index(c.kid)].point.xyz, plan_.kids[index(c.kid)].normal};
  }
  // Every corner of the planned cell is convex, and no angle next to nothing.
  bool convex(const Cell& cell) const {
    const std::size_t n = cell.corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const double angle =
          inner_angle(corner_of(cell.corners[k]), corner_of(cell.corners[(k + 1) % n]),
                      corner_of(cell.corners[(k + 2) % n]));
      if (angle < kLeastCellAngle || angle > M_PI - kLeastCellAngle) return false;
    }
    return true;
  }
  void add_cell(Cell cell) {
    cell.alive = convex(cell);
    plan_.cells.push_back(std::move(cell));
  }
  // The triangle in which a layer ends is as flat as the layer is.
  void add_end_cell(Cell cell) {
    cell.alive = signed_area2(corner_of(cell.corners[0]), corner_of(cell.corners[1]),
                              corner_of(cell.corners[2])) > 0.0;
    plan_.cells.push_back(std::move(cell));
  }

  bool is_parent(int kid, int node) const {
    const auto& parents = plan_.kids[index(kid)].parents;
    return std::find(parents.begin(), parents.end(), node) != parents.end();
  }
  // Where the layer ends at one of the two.
  void add_step_on(int from, int to) {
    const auto& kids_from = plan_.kids_of[index(from)];
    const auto& kids_to = plan_.kids_of[index(to)];
    const int grown = kids_from.empty() ? to : from;
    const double length = (position(to) - position(from)).norm();
    if (length < kStepAspect * heights_[index(grown)]) return leave_idle(from, to);
    if (!kids_from.empty() && is_parent(kids_from.back(), from)) {
      add_end_cell({{at_node(from), at_node(to), at_kid(kids_from.back())}, {}});
    } else if (!kids_to.empty() && is_parent(kids_to.front(), to)) {
      add_end_cell({{at_node(from), at_node(to), at_kid(kids_to.front())}, {}});
    } else {
      leave_idle(from, to);
    }
  }
  void leave_idle(int from, int to) {
    const HalfedgeH h = mesh_.find_halfedge(front_[from].vertex, front_[to].vertex);
    if (h.valid()) front_.add_idle_edge(h);
  }
  void add_cell_on(int from, int to) {
    if (plan_.kids_of[index(from)].empty() || plan_.kids_of[index(to)].empty()) {
      add_step_on(from, to);
      return;
    }
    const int p = plan_.kids_of[index(from)].back(), q = plan_.kids_of[index(to)].front();
    if (stands(p) || stands(q)) {
      if (stands(p) && stands(q)) return;
      const CellCorner foot = stands(p) ? at_node(to) : at_node(from);
      if (stands(p)) add_end_cell({{at_kid(p), foot, at_kid(q)}, {{p, q}}});
      if (stands(q)) add_end_cell({{foot, at_kid(q), at_kid(p)}, {{p, q}}});
      return;
    }
    if (p != q) {
      if (!is_tread(p) && !is_tread(q)) {
        add_cell({{at_node(from), at_node(to), at_kid(q), at_kid(p)}, {{p, q}}});
      } else {
        add_cell({{at_node(from), at_node(to), at_kid(q), at_kid(p)}, {}});
      }
    } else if (!is_parent(p, to)) {  // a row end: from, its corner, and the node beyond
      add_cell({{at_node(from), at_node(to), at_node(front_[to].next), at_kid(p)}, {}});
    } else if (is_parent(p, from)) {
      add_cell({{at_node(from), at_node(to), at_kid(p)}, {}});
    }  // else the row end's second edge
  }
  bool is_tread(int kid) const {
    return std::find(treads_.begin(), treads_.end(), kid) != treads_.end();
  }

  void add_fan_cells(int i) {
    const auto& kids = plan_.kids_of[index(i)];
    for (std::size_t k = 0; k + 2 < kids.size(); k += 2) {
      add_cell({{at_node(i), at_kid(kids[k + 2]), at_kid(kids[k + 1]), at_kid(kids[k])},
                {{kids[k], kids[k + 1]}, {kids[k + 1], kids[k + 2]}}});
    }
  }

  //   k ---------------- m      Three short front edges become one, with quads alone: the inner two
  //   | \              / |      kids stay low, and the outer two are joined over them. It costs no
  //   |   x -------- y   |      triangle where two collapses cost two.
  //   |   |          |   |
  //   a - b -------- c - d
  bool try_coarsen(int a) {
    const int b = front_[a].next;
    const int c = b < 0 ? -1 : front_[b].next;
    const int d = c < 0 ? -1 : front_[c].next;
    if (d < 0 || d == a || front_[d].next == a) return false;
    const std::array<int, 4> nodes{a, b, c, d};
    double height = 0.0;
    for (const int i : nodes) {
      if (!has_plain_kid(i)) return false;
      height += 0.25 * heights_[index(i)];
    }
    if (std::abs(shape(b).turn()) > kCoarsenTurn || std::abs(shape(c).turn()) > kCoarsenTurn) {
      return false;
    }
    double length = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double edge = kid_distance(plain_kid(nodes[index(k)]), plain_kid(nodes[index(k + 1)]));
      if (edge > kCoarsenLongest * height) return false;
      length += edge / 3.0;
    }
    if (length > kCoarsenLength * height) return false;
    return lower_treads(a, b, c, d);
  }
  bool has_plain_kid(int i) const {
    const auto& kids = plan_.kids_of[index(i)];
    if (kids.size() != 1 || is_tread(kids[0])) return false;
    const Kid& kid = plan_.kids[index(kids[0])];
    return kid.parents.size() == 1 && kid.fan_age < 0;
  }
  int plain_kid(int i) const { return plan_.kids_of[index(i)][0]; }

  bool lower_treads(int a, int b, int c, int d) {
    const int k = plain_kid(a), x = plain_kid(b), y = plain_kid(c), m = plain_kid(d);
    const SurfacePoint old_x = plan_.kids[index(x)].point, old_y = plan_.kids[index(y)].point;
    const auto place = [&](int kid, int node) {
      SurfacePoint to;
      const double length = kTreadHeight * heights_[index(node)];
      const SurfacePoint& from = mesh_.data(front_[node].vertex).point;
      if (!state_.surface.step(from, shape(node).inward, length, to)) return false;
      plan_.kids[index(kid)].point = to;
      plan_.kids[index(kid)].normal = state_.surface.normal(to);
      return true;
    };
    Cell top{{at_kid(x), at_kid(y), at_kid(m), at_kid(k)}, {{k, m}}, false};
    if (!place(x, b) || !place(y, c) || !convex(top) ||
        !convex({{at_node(a), at_node(b), at_kid(x), at_kid(k)}, {}}) ||
        !convex({{at_node(c), at_node(d), at_kid(m), at_kid(y)}, {}})) {
      plan_.kids[index(x)].point = old_x;
      plan_.kids[index(y)].point = old_y;
      return false;
    }
    treads_.push_back(x);
    treads_.push_back(y);
    tops_.push_back(std::move(top));
    state_.note_stop(b, Stop::kMerged);
    state_.note_stop(c, Stop::kMerged);
    state_.count_event(Event::kCoarsen);
    return true;
  }

  LayerState& state_;
  SurfaceMesh& mesh_;
  Front& front_;
  LayerPlan plan_;
  std::vector<double> heights_;  // of this extrusion, by node
  std::vector<Opposite> opposites_;
  std::vector<int> treads_;  // the low inner kids of coarsened edges
  std::vector<Cell> tops_;   // the cells over them
};

}  // namespace

LayerPlan plan_layer(LayerState& state) { return Planner(state).run(); }

}  // namespace advlayers
