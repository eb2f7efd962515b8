// Boost 1.74 includes headers of its own that it has deprecated; it says so at every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include "imprint/near_vertices.h"

#include <algorithm>
#include <boost/geometry/algorithms/covered_by.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>  // newer Boosts leave it to the user
#include <iterator>

namespace advlayers {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Point, VertexH>;

Point point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

// Entries are told apart by the vertex alone, where they are taken out again.
struct SameVertex {
  bool operator()(const Entry& a, const Entry& b) const { return a.second == b.second; }
};
using Tree =
    bg::index::rtree<Entry, bg::index::quadratic<16>, bg::index::indexable<Entry>, SameVertex>;

}  // namespace

struct NearVertices::Impl {
  const SurfaceMesh& mesh;
  Tree tree;
};

NearVertices::NearVertices(const SurfaceMesh& mesh) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (mesh.alive(v)) entries.emplace_back(point_of(mesh.position(v)), v);
  }
  impl_.reset(new Impl{mesh, Tree(entries)});
}

NearVertices::~NearVertices() = default;

std::vector<std::pair<double, VertexH>> NearVertices::nearest(const Vec3& p,
                                                              std::size_t count) const {
  std::vector<Entry> some;
  impl_->tree.query(bg::index::nearest(point_of(p), static_cast<unsigned>(count)),
                    std::back_inserter(some));
  double reach = 0.0;
  for (const Entry& entry : some) {
    reach = std::max(reach, (impl_->mesh.position(entry.second) - p).norm());
  }
  // Of those as far away as the last one the tree has chosen as it liked.
  const Vec3 margin = Vec3::Constant(reach * (1.0 + 1e-12));
  const bg::model::box<Point> box(point_of(p - margin), point_of(p + margin));
  some.clear();
  impl_->tree.query(bg::index::intersects(box), std::back_inserter(some));
  std::vector<std::pair<double, VertexH>> near;
  for (const Entry& entry : some) {
    near.emplace_back((impl_->mesh.position(entry.second) - p).norm(), entry.second);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), count));
  return near;
}

void NearVertices::moved(VertexH v, const Vec3& from) {
  impl_->tree.remove({point_of(from), v});
  impl_->tree.insert({point_of(impl_->mesh.position(v)), v});
}

}  // namespace advlayers
