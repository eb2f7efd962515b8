// One face laid out in the plane: its boundary, as discretized, in (u, v) scaled so that lengths
// are roughly those in space [mm], mirrored where needed so that counter-clockwise in the sheet is
// counter-clockwise against the outward normal.
#pragma once

#include <vector>

#include "boundary/discretization.h"
#include "geometry/evaluator.h"

namespace advlayers {

// A boundary mesh edge; the face lies on the left of from -> to.
struct SheetSegment {
  int from, to;  // into FaceSheet::points
  EdgeId edge;
  bool inner;  // the surface continues beyond it: a seam, or a smooth edge inside the patch
  bool pole;   // one point in space
};

struct FaceSheet {
  FaceId face;
  Vec2 scale;  // sheet point = (u, v) * scale, component by component; scale.x() < 0: mirrored
  std::vector<Vec2> points;
  std::vector<NodeId> nodes;  // by point; several points may stand for one node
  std::vector<SheetSegment> segments;

  Vec2 to_uv(const Vec2& p) const { return p.cwiseQuotient(scale); }
  Vec2 from_uv(const Vec2& uv) const { return uv.cwiseProduct(scale); }
};

// `inner` holds the sorted edges inside the patch. Throws GeometryError naming the face where it
// has a defect. No segment where its sides have the same nodes all along.
FaceSheet lay_out_face(Evaluator& evaluator, const Discretization& boundary, FaceId face,
                       const std::vector<EdgeId>& inner);

}  // namespace advlayers
