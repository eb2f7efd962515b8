// Boost 1.74 includes headers of its own that it has deprecated; it says so at every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include "layers/front_index.h"

#include <algorithm>
#include <array>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>  // newer Boosts leave it to the user
#include <cmath>

#include "base/ties.h"

namespace advlayers {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using BoostBox = bg::model::box<BoostPoint>;

BoostBox box_of(const Vec3& a, const Vec3& b) {
  const Vec3 low = a.cwiseMin(b), high = a.cwiseMax(b);
  return {BoostPoint(low.x(), low.y(), low.z()), BoostPoint(high.x(), high.y(), high.z())};
}

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

constexpr double kAheadCosine = 0.5;  // 60 degrees
// Layers run along a boundary edge that nothing grows from, if it lies this nearly in their
// direction.
constexpr double kAlongCosine = 0.7;
constexpr double kSameSideCosine = 0.3;  // a thin shell's other side does not count

}  // namespace

struct FrontIndex::Tree {
  struct Edge {
    VertexH from, to;
    int node;
    bool boundary;
  };
  std::vector<Edge> edges;
  bg::index::rtree<std::pair<BoostBox, std::size_t>, bg::index::linear<16>> boxes;
};

FrontIndex::FrontIndex(const SurfaceMesh& mesh, const Front& front)
    : mesh_(&mesh), front_(&front), tree_(std::make_unique<Tree>()) {
  for (int i = 0; i < front.size(); ++i) {
    const int next = front[i].next;
    if (next >= 0) tree_->edges.push_back({front[i].vertex, front[next].vertex, i, false});
  }
  for (const HalfedgeH h : front.idle_edges()) {
    tree_->edges.push_back({mesh.from(h), mesh.to(h), -1, mesh.is_border(SurfaceMesh::twin(h))});
  }
  std::vector<std::pair<BoostBox, std::size_t>> boxes;
  boxes.reserve(tree_->edges.size());
  for (std::size_t i = 0; i < tree_->edges.size(); ++i) {
    const Tree::Edge& edge = tree_->edges[i];
    boxes.emplace_back(box_of(mesh.position(edge.from), mesh.position(edge.to)), i);
  }
  tree_->boxes = decltype(tree_->boxes)(boxes.begin(), boxes.end());  // packed
}

FrontIndex::~FrontIndex() = default;

bool FrontIndex::nearest_ahead(int node, const NodeShape& shape, double reach, Hit& hit) const {
  std::array<VertexH, 5> near{};
  near[0] = (*front_)[node].vertex;
  int ahead = node, behind = node;
  for (std::size_t k = 1; k < near.size(); k += 2) {
    ahead = ahead < 0 ? -1 : (*front_)[ahead].next;
    behind = behind < 0 ? -1 : (*front_)[behind].prev;
    if (ahead >= 0) near[k] = (*front_)[ahead].vertex;
    if (behind >= 0) near[k + 1] = (*front_)[behind].vertex;
  }
  const auto runs_along = [&](const Tree::Edge& edge, const Vec3& direction) {
    const Vec3 along = mesh_->position(edge.to) - mesh_->position(edge.from);
    return std::abs(along.dot(direction)) > kAlongCosine * along.norm();
  };
  // The far side of a slit has vertices of its own on the same nodes.
  const auto joined = [&](VertexH v) {
    const NodeId own = mesh_->data(v).node;
    return std::any_of(near.begin(), near.end(), [&](VertexH other) {
      return other == v || (own.valid() && other.valid() && mesh_->data(other).node == own);
    });
  };
  const Vec3& p = mesh_->position(near[0]);
  const Vec3 spread = Vec3::Constant(reach);
  hit.distance = reach;
  bool found = false;
  std::size_t nearest = 0;
  const auto visit = [&](const std::pair<BoostBox, std::size_t>& entry) {
    const Tree::Edge& edge = tree_->edges[entry.second];
    if (joined(edge.from) || joined(edge.to)) return;
    const Vec3 to = closest_on_segment(mesh_->position(edge.from), mesh_->position(edge.to), p) - p;
    const double distance = settled(to.norm());
    if (edge.boundary && runs_along(edge, shape.inward)) return;
    if (distance > hit.distance || to.dot(shape.inward) < kAheadCosine * distance) return;
    if (found && distance == hit.distance && entry.second > nearest) return;
    if (mesh_->data(edge.from).normal.dot(shape.normal) < kSameSideCosine) return;
    hit = {distance, edge.from, edge.to, edge.node};
    nearest = entry.second;
    found = true;
  };
  const BoostBox window = box_of(p - spread, p + spread);
  for (auto it = tree_->boxes.qbegin(bg::index::intersects(window)); it != tree_->boxes.qend();
       ++it) {
    visit(*it);
  }
  return found;
}

}  // namespace advlayers
