#include "core/edge_swaps.h"

#include "core/core_room.h"

namespace advlayers {

void EdgeSwaps::enlist_about(VertexH v) {
  const HalfedgeH first = mesh_.outgoing(v);
  HalfedgeH h = first;
  do {
    if (!mesh_.is_border(h)) {
      enlist(h);
      enlist(mesh_.next(h));
    }
    h = mesh_.rotate_cw(h);
  } while (h != first);
}

bool EdgeSwaps::swap(HalfedgeH h) {
  if (!mesh_.alive(h) || !is_room_edge(mesh_, h)) return false;
  if (quality_veto(mesh_, h, limits_) != Veto::kNone) return false;
  mesh_.flip(h);
  const HalfedgeH t = SurfaceMesh::twin(h);
  for (const HalfedgeH side : {mesh_.next(h), mesh_.prev(h), mesh_.next(t), mesh_.prev(t)}) {
    waiting_.push_back(side);
  }
  return true;
}

}  // namespace advlayers
