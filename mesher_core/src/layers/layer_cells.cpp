#include "layers/layer_cells.h"

#include <algorithm>
#include <utility>

namespace advlayers {
namespace {

class CellPlanner {
 public:
  explicit CellPlanner(PlanDraft& draft) : draft_(draft) {}

  void run() {
    for (int i = 0; i < draft_.front.size(); ++i) {
      if (draft_.front[i].next >= 0) add_cell_on(i, draft_.front[i].next);
      add_fan_cells(i);
    }
    for (Cell& top : draft_.tops) add_cell(std::move(top));
  }

 private:
  bool stands(int kid) const {
    const Kid& k = draft_.kid(kid);
    return k.given && k.parents.empty();
  }

  void add_cell(Cell cell) {
    cell.alive = draft_.convex(cell);
    draft_.plan.cells.push_back(std::move(cell));
  }
  // The triangle in which a layer ends is as flat as the layer is.
  void add_end_cell(Cell cell) {
    cell.alive = signed_area2(draft_.corner_of(cell.corners[0]), draft_.corner_of(cell.corners[1]),
                              draft_.corner_of(cell.corners[2])) > 0.0;
    draft_.plan.cells.push_back(std::move(cell));
  }

  bool is_parent(int kid, int node) const {
    const auto& parents = draft_.kid(kid).parents;
    return std::find(parents.begin(), parents.end(), node) != parents.end();
  }
  // Where the layer ends at one of the two.
  void add_step_on(int from, int to) {
    const auto& kids_from = draft_.kids_of(from);
    const auto& kids_to = draft_.kids_of(to);
    const int grown = kids_from.empty() ? to : from;
    const double length = (draft_.position(to) - draft_.position(from)).norm();
    if (length < kStepAspect * draft_.height(grown)) return leave_idle(from, to);
    if (!kids_from.empty() && is_parent(kids_from.back(), from)) {
      add_end_cell({{at_node(from), at_node(to), at_kid(kids_from.back())}, {}});
    } else if (!kids_to.empty() && is_parent(kids_to.front(), to)) {
      add_end_cell({{at_node(from), at_node(to), at_kid(kids_to.front())}, {}});
    } else {
      leave_idle(from, to);
    }
  }
  void leave_idle(int from, int to) {
    const HalfedgeH h =
        draft_.mesh.find_halfedge(draft_.front[from].vertex, draft_.front[to].vertex);
    if (h.valid()) draft_.front.add_idle_edge(h);
  }
  void add_cell_on(int from, int to) {
    if (draft_.kids_of(from).empty() || draft_.kids_of(to).empty()) {
      add_step_on(from, to);
      return;
    }
    const int p = draft_.kids_of(from).back(), q = draft_.kids_of(to).front();
    if (stands(p) || stands(q)) {
      if (stands(p) && stands(q)) return;
      const CellCorner foot = stands(p) ? at_node(to) : at_node(from);
      if (stands(p)) add_end_cell({{at_kid(p), foot, at_kid(q)}, {{p, q}}});
      if (stands(q)) add_end_cell({{foot, at_kid(q), at_kid(p)}, {{p, q}}});
      return;
    }
    if (p != q) {
      if (!draft_.kid(p).tread && !draft_.kid(q).tread) {
        add_cell({{at_node(from), at_node(to), at_kid(q), at_kid(p)}, {{p, q}}});
      } else {
        add_cell({{at_node(from), at_node(to), at_kid(q), at_kid(p)}, {}});
      }
    } else if (!is_parent(p, to)) {  // a row end: from, its corner, and the node beyond
      add_cell({{at_node(from), at_node(to), at_node(draft_.front[to].next), at_kid(p)}, {}});
    } else if (is_parent(p, from)) {
      add_cell({{at_node(from), at_node(to), at_kid(p)}, {}});
    }  // else the row end's second edge
  }

  void add_fan_cells(int i) {
    const auto& kids = draft_.kids_of(i);
    for (std::size_t k = 0; k + 2 < kids.size(); k += 2) {
      add_cell({{at_node(i), at_kid(kids[k + 2]), at_kid(kids[k + 1]), at_kid(kids[k])},
                {{kids[k], kids[k + 1]}, {kids[k + 1], kids[k + 2]}}});
    }
  }

  PlanDraft& draft_;
};

}  // namespace

void plan_cells(PlanDraft& draft) { CellPlanner(draft).run(); }

}  // namespace advlayers
