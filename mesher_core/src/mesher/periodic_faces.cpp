#include "mesher/periodic_faces.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/point_tree.h"
#include "boundary/periodic_cuts.h"

namespace advlayers {
namespace {

constexpr double kOffFace = 1e-5;    // of the model's diagonal
constexpr double kSamePlace = 2e-6;  // likewise: nodes that the motion brings onto each other

// The nodes on the found edges, by those of the given ones.
std::optional<std::map<NodeId, NodeId>> nodes_of(const FacePair& pair,
                                                 const Discretization& boundary) {
  std::map<NodeId, NodeId> of;
  for (const EdgePair& edge : pair.edges) {
    const std::vector<NodeId>& given = boundary.edges[edge.given.index()].nodes;
    const std::vector<NodeId>& found = boundary.edges[edge.found.index()].nodes;
    if (given.size() != found.size()) return std::nullopt;
    for (std::size_t k = 0; k < given.size(); ++k) {
      of[given[k]] = found[edge.reversed ? found.size() - 1 - k : k];
    }
  }
  return of;
}

class Mover {
 public:
  Mover(Evaluator& evaluator, const SurfaceMesh& given, const FacePair& pair,
        const Discretization& boundary, const std::map<NodeId, NodeId>& nodes)
      : evaluator_(evaluator), given_(given), pair_(pair), boundary_(boundary), nodes_(nodes) {}

  std::optional<MovedMesh> run() {
    moved_.of.resize(given_.vertex_capacity());
    for (std::size_t i = 0; i < given_.vertex_capacity(); ++i) {
      if (given_.alive(VertexH(i)) && !add_vertex(VertexH(i))) return std::nullopt;
    }
    for (std::size_t i = 0; i < given_.vertex_capacity(); ++i) {
      const VertexH v(i);
      if (!given_.alive(v)) continue;
      const VertexH parent = given_.data(v).parent;
      if (parent.valid()) moved_.mesh.data(moved_.of[i]).parent = moved_.of[parent.index()];
    }
    add_faces();
    mark_border();
    return std::move(moved_);
  }

 private:
  bool add_vertex(VertexH v) {
    VertexData data = given_.data(v);
    const Vec3 place = pair_.motion * data.point.xyz;
    if (data.node.valid()) {
      const auto node = nodes_.find(data.node);
      if (node == nodes_.end()) return false;
      data.node = node->second;
    }
    SurfacePoint foot;
    if (!last_.face.valid() || !evaluator_.project(place, last_, foot) ||
        (foot.xyz - place).norm() > kOffFace * evaluator_.model().diagonal()) {
      foot = evaluator_.closest(pair_.found, place);
    }
    if ((foot.xyz - place).norm() > kOffFace * evaluator_.model().diagonal()) return false;
    last_ = foot;
    data.point = foot;
    if (data.node.valid()) {
      data.point.xyz = boundary_.nodes[data.node.index()].xyz;
    } else if ((foot.xyz - place).norm() <= kOnShape * evaluator_.model().diagonal()) {
      data.point.xyz = place;  // the motion is exact: so are the copies
    }
    data.normal = evaluator_.normal(foot);
    data.parent = VertexH();
    // Faces of a shell that lie opposite each other have their outward sides so, too.
    if (data.normal.dot(pair_.motion.linear() * given_.data(v).normal) < 0.0) ++turned_;
    moved_.of[v.index()] = moved_.mesh.add_vertex(data);
    return true;
  }

  void add_faces() {
    const bool turned = 2 * turned_ > given_.vertex_count();
    std::vector<std::vector<VertexH>> faces;
    std::vector<FaceData> data;
    for (std::size_t i = 0; i < given_.face_capacity(); ++i) {
      const FaceH f(i);
      if (!given_.alive(f)) continue;
      faces.emplace_back();
      for (const HalfedgeH h : given_.sides(f)) {
        faces.back().push_back(moved_.of[given_.from(h).index()]);
      }
      if (turned) std::reverse(faces.back().begin(), faces.back().end());
      data.push_back(given_.data(f));
    }
    moved_.mesh.build(faces);
    for (std::size_t i = 0; i < data.size(); ++i) moved_.mesh.data(FaceH(i)) = data[i];
  }

  void mark_border() {
    std::map<EdgeId, EdgeId> edges;
    for (const EdgePair& pair : pair_.edges) edges[pair.given] = pair.found;
    for (std::size_t i = 0; i < given_.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      if (!given_.alive(h)) continue;
      const VertexH a = moved_.of[given_.from(h).index()], b = moved_.of[given_.to(h).index()];
      HalfedgeH copy = moved_.mesh.find_halfedge(a, b);
      if (!copy.valid()) copy = moved_.mesh.find_halfedge(b, a);
      if (!copy.valid()) continue;
      moved_.mesh.set_frozen(copy, given_.frozen(h));
      const auto edge = edges.find(given_.curve(h));
      if (edge != edges.end()) moved_.mesh.set_curve(copy, edge->second);
    }
  }

  Evaluator& evaluator_;
  const SurfaceMesh& given_;
  const FacePair& pair_;
  const Discretization& boundary_;
  const std::map<NodeId, NodeId>& nodes_;
  MovedMesh moved_;
  SurfacePoint last_;
  int turned_ = 0;
};

// The nodes of some faces and edges.
std::set<int> nodes_on(const MeshResult& mesh, const std::set<FaceId>& faces,
                       const std::set<EdgeId>& edges) {
  std::set<int> nodes;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    if (faces.count(mesh.quad_face[i])) nodes.insert(mesh.quads[i].begin(), mesh.quads[i].end());
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!faces.count(mesh.triangle_face[i])) continue;
    nodes.insert(mesh.triangles[i].begin(), mesh.triangles[i].end());
  }
  for (const EdgeId edge : edges) {
    for (const auto& segment : mesh.edge_segments[edge.index()]) {
      nodes.insert(segment.begin(), segment.end());
    }
  }
  return nodes;
}

}  // namespace

std::optional<MovedMesh> move_mesh(Evaluator& evaluator, const SurfaceMesh& given,
                                   const FacePair& pair, const Discretization& boundary) {
  const std::optional<std::map<NodeId, NodeId>> nodes = nodes_of(pair, boundary);
  if (!nodes) return std::nullopt;
  return Mover(evaluator, given, pair, boundary, *nodes).run();
}

std::vector<std::vector<std::array<int, 2>>> periodic_nodes(const RunContext& context,
                                                            const Model& model,
                                                            const Settings& settings,
                                                            const MeshResult& mesh) {
  std::vector<std::vector<std::array<int, 2>>> all;
  for (const PeriodicSpec& spec : settings.periodic) {
    all.emplace_back();
    const PeriodicPairs pairs = find_periodic(context, model, spec);
    std::set<FaceId> given_faces, found_faces;
    std::set<EdgeId> given_edges, found_edges;
    for (const FacePair& pair : pairs.faces) {
      given_faces.insert(pair.given);
      found_faces.insert(pair.found);
    }
    for (const EdgePair& pair : pairs.edges) {
      given_edges.insert(pair.given);
      found_edges.insert(pair.found);
    }
    const std::set<int> there = nodes_on(mesh, found_faces, found_edges);
    const std::vector<int> found(there.begin(), there.end());
    std::vector<Vec3> points;
    for (const int node : found) points.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
    const PointTree tree(context, points);
    const Motion motion = motion_of(spec);
    for (const int node : nodes_on(mesh, given_faces, given_edges)) {
      context.check();
      const Vec3 place = motion * mesh.nodes[static_cast<std::size_t>(node)];
      const int nearest = tree.nearest(place);
      if (nearest < 0) continue;
      const auto n = static_cast<std::size_t>(nearest);
      if ((points[n] - place).norm() > kSamePlace * model.diagonal()) continue;
      if (found[n] != node) all.back().push_back({node, found[n]});
    }
  }
  return all;
}

}  // namespace advlayers
