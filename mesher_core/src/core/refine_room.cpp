#include "core/refine_room.h"

#include <algorithm>
#include <vector>

#include "core/core_room.h"
#include "core/edge_swaps.h"

namespace advlayers {
namespace {

// Of the longest allowed: where an edge is longer than that, what lies between its ends counts.
constexpr double kWorthALook = 0.4;
// Of the size: an edge of no length would have its neighbours halved for ever.
constexpr double kSmallest = 1e-3;
constexpr double kLongestHalf = 0.8;   // of the edge that is halved
constexpr double kClearOfApex = 0.15;  // likewise
// Halvings at most, for each vertex of the core: far more than any sound one needs.
constexpr std::size_t kMostHalvings = 100;
constexpr std::size_t kCancelStride = 64;  // edges between looks at the run

class RoomRefiner {
 public:
  RoomRefiner(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
              TargetSize& target, double longest)
      : mesh_(mesh),
        surface_(surface),
        target_(target),
        longest_(longest),
        context_(context),
        swaps_(mesh) {}

  void run() {
    measure_vertices();
    std::vector<HalfedgeH> waiting;
    for (std::size_t i = 0; i < mesh_.halfedge_capacity(); i += 2) waiting.emplace_back(i);
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (i % kCancelStride == 0) context_.check();
      const HalfedgeH h = waiting[i];
      if (!mesh_.alive(h) || !is_room_edge(mesh_, h)) continue;
      const VertexH v = halve(h);
      if (!v.valid()) continue;
      if (--most_ == 0) return;
      swaps_.enlist_about(v);
      swaps_.run([&](HalfedgeH swapped) { waiting.push_back(swapped); });
      const HalfedgeH first = mesh_.outgoing(v);
      HalfedgeH spoke = first;
      do {
        waiting.push_back(spoke);
        spoke = mesh_.rotate_cw(spoke);
      } while (spoke != first);
    }
  }

 private:
  double length(HalfedgeH h) const {
    return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  }

  // The size wanted at each vertex, on the border no more than the edges there.
  void measure_vertices() {
    const CoreRoom room = find_core_room(mesh_);
    most_ = kMostHalvings * (kMostHalvings + room.vertices.size());
    sizes_.assign(mesh_.vertex_capacity(), 0.0);
    for (const VertexH v : room.vertices) sizes_[v.index()] = target_.at(mesh_.data(v).point);
    const std::vector<double> wanted = sizes_;
    for (const HalfedgeH h : room.border) {
      for (const VertexH v : {mesh_.from(h), mesh_.to(h)}) {
        const double least = kSmallest * wanted[v.index()];
        sizes_[v.index()] = std::max(least, std::min(sizes_[v.index()], length(h)));
      }
    }
  }

  // The size may grow along the edge from either end, and be less between them.
  bool is_long(HalfedgeH h, double size) const {
    return length(h) > longest_ * size + target_.gradation() * length(h);
  }

  // The surface is folded, or as good as that: the point lies beside a corner across the edge.
  bool crowds(HalfedgeH h, const Vec3& xyz) const {
    for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
      const Vec3& apex = mesh_.position(mesh_.to(mesh_.next(side)));
      if ((xyz - apex).norm() < kClearOfApex * length(h)) return true;
    }
    return false;
  }

  VertexH halve(HalfedgeH h) {
    const VertexH a = mesh_.from(h), b = mesh_.to(h);
    const double ends = 0.5 * (sizes_[a.index()] + sizes_[b.index()]);
    if (length(h) < kWorthALook * longest_ * ends || mesh_.split_edge_veto(h) != Veto::kNone)
      return {};
    const Vec3 middle = 0.5 * (mesh_.position(a) + mesh_.position(b));
    VertexData data;
    if (!surface_.project(middle, mesh_.data(a).point, data.point)) return {};
    // A foot far away is one on another sheet of the surface; halves no shorter would have no end.
    const double longer = std::max((data.point.xyz - mesh_.position(a)).norm(),
                                   (data.point.xyz - mesh_.position(b)).norm());
    if (longer > kLongestHalf * length(h) || crowds(h, data.point.xyz)) return {};
    const double wanted = target_.at(data.point);
    if (!is_long(h, std::min(ends, wanted))) return {};
    data.normal = surface_.normal(data.point);
    const double grown =
        std::min(sizes_[a.index()], sizes_[b.index()]) + 0.5 * length(h) * target_.gradation();
    const VertexH v = mesh_.split_edge(h, data);
    sizes_.resize(mesh_.vertex_capacity(), 0.0);
    sizes_[v.index()] = std::min(grown, wanted);
    return v;
  }

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  TargetSize& target_;
  double longest_;
  const RunContext& context_;
  EdgeSwaps swaps_;
  std::size_t most_ = 0;       // halvings that are left
  std::vector<double> sizes_;  // by vertex [mm]
};

}  // namespace

void refine_room(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                 TargetSize& target, double longest) {
  RoomRefiner(context, mesh, surface, target, longest).run();
}

}  // namespace advlayers
