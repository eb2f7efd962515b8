#include "imprint/embed_edges.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/core_room.h"
#include "imprint/near_vertices.h"
#include "layers/recover.h"

namespace advlayers {
namespace {

// Of the distance between nodes: one nearer to the core's border is left out.
constexpr double kClear = 0.5;
constexpr std::size_t kTried = 6;  // vertices that a node is looked for from

class Embedder {
 public:
  Embedder(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
           Evaluator& evaluator, const Discretization& boundary)
      : mesh_(mesh),
        surface_(surface),
        evaluator_(evaluator),
        boundary_(boundary),
        context_(context),
        near_(mesh) {
    for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
      const VertexH v(i);
      if (mesh.alive(v) && mesh.data(v).node.valid()) at_node_[mesh.data(v).node.index()] = v;
    }
    for (const FaceId face : surface.faces()) {
      for (const auto& loop : surface.model().face(face).loops) {
        for (const CoEdge& of : loop) {
          if (!of.degenerate) beside_.try_emplace(of.edge.index(), face, &of);
        }
      }
    }
  }

  int run() {
    int missing = 0;
    for (const EdgeId edge : surface_.inner_edges()) missing += embed(edge);
    for (const VertexH v : made_) {
      if (!has_curve(v)) mesh_.data(v).support = Support::kPatch;
    }
    return missing;
  }

 private:
  int embed(EdgeId edge) {
    const EdgeNodes& cut = boundary_.edges[edge.index()];
    const auto beside = beside_.find(edge.index());
    if (beside == beside_.end()) return 0;
    const auto& [face, coedge] = beside->second;
    std::vector<VertexH> line;
    VertexH last;
    for (std::size_t k = 0; k < cut.nodes.size(); ++k) {
      context_.check();
      const VertexH v = vertex_at(cut, k, face, *coedge, last);
      if (v.valid()) last = v;
      line.push_back(v);
    }
    int missing = 0;
    for (std::size_t k = 1; k < line.size(); ++k) {
      if (line[k - 1].valid() && line[k].valid()) missing += !join(line[k - 1], line[k], edge);
    }
    return missing;
  }

  VertexH vertex_at(const EdgeNodes& cut, std::size_t k, FaceId face, const CoEdge& coedge,
                    VertexH last) {
    VertexH& there = at_node_[cut.nodes[k].index()];
    if (there.valid()) return there;
    const BoundaryNode& node = boundary_.nodes[cut.nodes[k].index()];
    VertexData data;
    const Vec2 uv = evaluator_.edge_uv(face, coedge, cut.params[k]);
    data.point = {face, uv.x(), uv.y(), node.xyz};
    data.normal = surface_.normal(data.point);
    data.support = node.vertex.valid() ? Support::kVertex : Support::kEdge;
    const VertexH v = insert(data, spacing(cut, k), last);
    if (v.valid()) made_.push_back(v);
    there = v;
    return v;
  }

  double spacing(const EdgeNodes& cut, std::size_t k) const {
    double least = INFINITY;
    const auto place = [&](std::size_t i) { return boundary_.nodes[cut.nodes[i].index()].xyz; };
    if (k > 0) least = std::min(least, (place(k) - place(k - 1)).norm());
    if (k + 1 < cut.nodes.size()) least = std::min(least, (place(k + 1) - place(k)).norm());
    return least;
  }

  VertexH insert(const VertexData& data, double spacing, VertexH last) {
    const auto near = near_.nearest(data.point.xyz, kTried);
    std::vector<VertexH> from;
    if (last.valid()) from.push_back(last);
    for (const auto& [distance, v] : near) {
      if (!mesh_.alive(v)) continue;
      const bool fixed = !is_core_vertex(mesh_, v);
      if (fixed && distance < kClear * spacing) return {};
      from.push_back(v);
    }
    for (const VertexH v : from) {
      if (!mesh_.alive(v)) continue;
      const Vec3 way = data.point.xyz - mesh_.position(v);
      if (!room_towards(mesh_, v, way).valid()) continue;
      const VertexH made = insert_point(mesh_, v, data, limits_, tally_);
      if (!made.valid()) continue;
      if (is_clear(made, kClear * spacing)) return made;
      mesh_.data(made).support = Support::kPatch;
      remove_core_vertex(mesh_, made, Removal::kForced, limits_, tally_);
      return {};
    }
    return {};
  }

  // Of the edges across from it that are to stay.
  bool is_clear(VertexH v, double distance) const {
    const HalfedgeH first = mesh_.outgoing(v);
    HalfedgeH h = first;
    do {
      const HalfedgeH across = mesh_.next(h);
      if (!is_room_edge(mesh_, across) && !mesh_.curve(across).valid() &&
          distance_to_edge(mesh_, across, mesh_.position(v)) < distance) {
        return false;
      }
      h = mesh_.rotate_cw(h);
    } while (h != first);
    return true;
  }

  bool join(VertexH a, VertexH b, EdgeId edge) {
    if (!mesh_.alive(a) || !mesh_.alive(b)) return false;
    if (!room_towards(mesh_, a, mesh_.position(b) - mesh_.position(a)).valid() &&
        !mesh_.find_halfedge(a, b).valid()) {
      return true;  // under the layers
    }
    const HalfedgeH h = recover_edge(mesh_, a, b, limits_, tally_);
    if (!h.valid()) return false;
    if (mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::twin(h))) return true;
    if (!is_in_room(mesh_, h) || !is_in_room(mesh_, SurfaceMesh::twin(h))) return true;
    mesh_.set_frozen(h, true);
    mesh_.set_curve(h, edge);
    return true;
  }

  bool has_curve(VertexH v) const {
    if (!mesh_.alive(v)) return true;
    const HalfedgeH first = mesh_.outgoing(v);
    HalfedgeH h = first;
    do {
      if (mesh_.curve(h).valid()) return true;
      h = mesh_.rotate_cw(h);
    } while (h != first);
    return false;
  }

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  Evaluator& evaluator_;
  const Discretization& boundary_;
  const RunContext& context_;
  NearVertices near_;
  const ReconnectLimits limits_;
  VetoTally tally_{};
  std::unordered_map<std::size_t, VertexH> at_node_;
  std::unordered_map<std::size_t, std::pair<FaceId, const CoEdge*>> beside_;  // each edge's first
  std::vector<VertexH> made_;
};

}  // namespace

int embed_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                Evaluator& evaluator, const Discretization& boundary) {
  return Embedder(context, mesh, surface, evaluator, boundary).run();
}

}  // namespace advlayers
