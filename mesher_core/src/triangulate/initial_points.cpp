#include "triangulate/initial_points.h"

#include <algorithm>

#include "base/predicates.h"
#include "triangulate/hilbert_order.h"
#include "triangulate/sheet_room.h"

namespace advlayers {
namespace {

using Side = PlanarTriangulation::Side;

class InitialInsertion {
 public:
  InitialInsertion(const RunContext& context, LiftedTriangulation& sheet)
      : sheet_(sheet), context_(context) {
    for (const Vec2& p : sheet.sheet().points) bounds_.extend(p);
    const Face& face = sheet.face();
    for (const double turns_u : {0.0, -1.0, 1.0}) {
      if (turns_u != 0.0 && face.u_period == 0.0) continue;
      for (const double turns_v : {0.0, -1.0, 1.0}) {
        if (turns_v != 0.0 && face.v_period == 0.0) continue;
        shifts_.push_back(
            sheet.sheet().from_uv({turns_u * face.u_period, turns_v * face.v_period}));
      }
    }
  }

  int run(const std::vector<SurfacePoint>& points) {
    std::vector<Vec2> in_sheet;
    in_sheet.reserve(points.size());
    for (const SurfacePoint& p : points) in_sheet.push_back(sheet_.sheet().from_uv({p.u, p.v}));
    int taken = 0;
    for (const int i : hilbert_order(context_, in_sheet)) {
      context_.check();
      if (insert(in_sheet[static_cast<std::size_t>(i)])) ++taken;
    }
    return taken;
  }

 private:
  const PlanarTriangulation& mesh() const { return sheet_.mesh(); }

  // The sheet of a closed face need not be the period that the point's (u, v) are in.
  bool insert(const Vec2& p) {
    for (const Vec2& shift : shifts_) {
      const Vec2 here = p + shift;
      if (!bounds_.contains(here)) continue;
      const int t = find(here);
      if (t < 0) continue;
      last_ = t;
      return insert_in(t, here);
    }
    return false;
  }

  int find(const Vec2& p) const {
    const int found = walk_to(mesh(), last_, p);
    if (found >= 0) return found;
    for (int t = 0; t < mesh().triangle_count(); ++t) {
      if (holds(t, p)) return t;
    }
    return -1;
  }

  bool holds(int t, const Vec2& p) const {
    for (int i = 0; i < 3; ++i) {
      if (orient2d(mesh().point(mesh().from({t, i})), mesh().point(mesh().to({t, i})), p) < 0) {
        return false;
      }
    }
    return true;
  }

  bool insert_in(int t, const Vec2& p) {
    if (crowds(sheet_, t, p, sheet_.wanted_size(p))) return false;
    if (sheet_.insert_in(t, p) >= 0) return true;
    for (int i = 0; i < 3; ++i) {
      const Side s{t, i};
      if (mesh().segment(s) >= 0) continue;
      if (orient2d(mesh().point(mesh().from(s)), mesh().point(mesh().to(s)), p) != 0) continue;
      if (sheet_.insert_on(s, p) >= 0) return true;
    }
    return false;
  }

  LiftedTriangulation& sheet_;
  const RunContext& context_;
  Eigen::AlignedBox2d bounds_;
  std::vector<Vec2> shifts_;
  int last_ = 0;  // triangle of the point before
};

}  // namespace

int insert_initial_points(const RunContext& context, LiftedTriangulation& sheet,
                          const std::vector<SurfacePoint>& points) {
  if (points.empty() || sheet.mesh().triangle_count() == 0) return 0;
  return InitialInsertion(context, sheet).run(points);
}

}  // namespace advlayers
