#include "imprint/snap_to_edges.h"

#include <algorithm>

#include "imprint/near_vertices.h"
#include "measure/element_measures.h"

namespace advlayers {
namespace {

// An end so near to where its edge crosses, as a share of the edge, moves there: in the core, along
// a front, and along a column of layers, whose heights are to stay.
constexpr double kSnapCore = 0.45, kSnapFront = 0.4, kSnapColumn = 0.12;
// The elements about a vertex that moved keep this share of their worst quality.
constexpr double kKept = 0.3;
constexpr int kSnapRounds = 2;

class Snapper {
 public:
  Snapper(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface, FaceSides& sides,
          EdgeCrossings& crossings)
      : mesh_(mesh), surface_(surface), sides_(sides), crossings_(crossings), context_(context) {}

  std::vector<VertexId> run() {
    for (std::size_t i = 0; i < mesh_.vertex_capacity(); ++i) settle(VertexH(i));
    snap_to_vertices();
    for (int round = 0; round < kSnapRounds && snap_all(); ++round) {
    }
    return std::move(missed_);
  }

 private:
  struct Snap {
    double share;
    VertexH vertex;
    CutPoint to;
    bool operator<(const Snap& o) const {
      return share != o.share ? share < o.share : vertex < o.vertex;
    }
  };

  void settle(VertexH v) {
    if (!mesh_.alive(v) || mesh_.data(v).support != Support::kPatch) return;
    context_.check();
    VertexData& data = mesh_.data(v);
    const FaceId before = data.point.face;
    surface_.settle(data.point);
    if (data.point.face == before) return;
    data.normal = surface_.normal(data.point);
    sides_.put(v, {data.point.face});
  }

  bool movable(VertexH v) const {
    return mesh_.data(v).support == Support::kPatch && sides_.of(v).size() == 1;
  }

  // The worst quality of the elements about v: sines and cosines, below zero where one is folded.
  double worst_about(VertexH v) const {
    double worst = 1.0;
    for (const HalfedgeH h : mesh_.around(v)) {
      const VertexH b = mesh_.to(h), c = mesh_.to(mesh_.next(h));
      const VertexH d = mesh_.from(mesh_.prev(h));
      if (mesh_.is_triangle(h)) {
        worst = std::min(worst, min_angle_sine(mesh_.position(v), mesh_.position(b),
                                               mesh_.position(c), mesh_.data(v).normal));
      } else {
        worst = std::min(worst, quad_quality(mesh_, v, b, c, d));
      }
    }
    return worst;
  }

  bool move(VertexH v, const SurfacePoint& point, Support support) {
    const VertexData before = mesh_.data(v);
    const double worst = worst_about(v);
    VertexData& data = mesh_.data(v);
    data.point = point;
    data.normal = surface_.normal(point);
    data.support = support;
    if (worst_about(v) > kKept * std::max(worst, 0.0)) return true;
    mesh_.data(v) = before;
    return false;
  }

  std::vector<VertexId> vertices_inside() const {
    const Model& model = surface_.model();
    std::vector<VertexId> found;
    for (const EdgeId e : surface_.inner_edges()) {
      for (const VertexId end : {model.edge(e).start, model.edge(e).end}) {
        if (end.valid()) found.push_back(end);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  void snap_to_vertices() {
    NearVertices vertices(mesh_);
    for (const VertexId vertex : vertices_inside()) {
      context_.check();
      snap_to(vertex, vertices);
    }
  }

  // A vertex of the model inside the patch takes the nearest vertex of the mesh that can move.
  void snap_to(VertexId vertex, NearVertices& vertices) {
    constexpr std::size_t kTried = 4;  // nearest vertices, of which one can move mostly
    const Vec3& xyz = surface_.model().vertex(vertex).xyz;
    const auto near = vertices.nearest(xyz, kTried);
    for (const auto& [distance, v] : near) {
      if (!movable(v)) {
        const bool first = v == near.front().second;
        if (first && distance <= surface_.model().vertex(vertex).tolerance) {
          sides_.put(v, sides_.at(vertex));
          return;
        }
        continue;
      }
      SurfacePoint foot;
      if (!surface_.project(xyz, mesh_.data(v).point, foot)) continue;
      foot.xyz = xyz;
      const Vec3 before = mesh_.position(v);
      if (!move(v, foot, Support::kVertex)) continue;
      vertices.moved(v, before);
      sides_.put(v, sides_.at(vertex));
      return;
    }
    missed_.push_back(vertex);
  }

  double snap_limit(VertexH v, VertexH other) const {
    if (mesh_.data(v).layer == 0) return kSnapCore;
    const bool column = mesh_.data(v).parent == other || mesh_.data(other).parent == v;
    return column ? kSnapColumn : kSnapFront;
  }

  bool snap_all() {
    std::vector<Snap> snaps;
    for (std::size_t i = 0; i < mesh_.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      if (!mesh_.alive(h)) continue;
      context_.check();
      const VertexH a = mesh_.from(h), b = mesh_.to(h);
      const std::vector<CutPoint> cuts = crossings_.between(a, b);
      if (cuts.empty()) continue;
      if (movable(a) && cuts.front().share < snap_limit(a, b)) {
        snaps.push_back({cuts.front().share, a, cuts.front()});
      }
      if (movable(b) && 1.0 - cuts.back().share < snap_limit(b, a)) {
        snaps.push_back({1.0 - cuts.back().share, b, cuts.back()});
      }
    }
    std::sort(snaps.begin(), snaps.end());
    bool moved = false;
    for (const Snap& snap : snaps) {
      if (!movable(snap.vertex) || !still_crosses(snap.vertex)) continue;
      if (!move(snap.vertex, snap.to.point, Support::kEdge)) continue;
      sides_.put(snap.vertex, snap.to.faces);
      moved = true;
    }
    return moved;
  }

  // False where the neighbours that made the vertex cross have moved onto the edge themselves.
  bool still_crosses(VertexH v) const {
    for (const HalfedgeH h : mesh_.around(v)) {
      if (!sides_.share_face(v, mesh_.to(h))) return true;
    }
    return false;
  }

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  FaceSides& sides_;
  EdgeCrossings& crossings_;
  const RunContext& context_;
  std::vector<VertexId> missed_;
};

}  // namespace

std::vector<VertexId> snap_to_edges(const RunContext& context, SurfaceMesh& mesh,
                                    PatchSurface& surface, FaceSides& sides,
                                    EdgeCrossings& crossings) {
  return Snapper(context, mesh, surface, sides, crossings).run();
}

}  // namespace advlayers
