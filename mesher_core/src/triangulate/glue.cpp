#include "triangulate/glue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "base/angles.h"
#include "triangulate/triangulate.h"

namespace advlayers {
namespace {

using Side = PlanarTriangulation::Side;

constexpr int kRounds = 30;  // of dividing edges that spoil the manifold
// Normals that lean this far from their mean about a pole make it a tip.
const double kSmoothTip = std::cos(10 * kDegree);

class Gluer {
 public:
  Gluer(const RunContext& context, std::vector<LiftedTriangulation>& sheets,
        const Discretization& boundary)
      : sheets_(sheets), boundary_(boundary), context_(context) {}

  GluedMesh run() {
    for (int round = 0; round < kRounds; ++round) {
      unite_corners();
      if (divide_doubled_edges()) continue;
      return make_mesh();
    }
    throw GeometryError("{} does not close to a manifold mesh",
                        face_name(sheets_.front().sheet().face));
  }

 private:
  struct SheetSide {
    std::size_t sheet;
    Side side;
  };

  const SheetSegment* segment(const SheetSide& s) const {
    const LiftedTriangulation& sheet = sheets_[s.sheet];
    const int mark = sheet.mesh().segment(s.side);
    return mark < 0 ? nullptr : &sheet.sheet().segments[static_cast<std::size_t>(mark)];
  }
  bool is_border(const SheetSide& s) const {
    const SheetSegment* on = segment(s);
    return on != nullptr && !on->inner && !on->pole;
  }
  // Gluing cannot double an edge between two points inside of a sheet.
  bool is_inside(const SheetSide& s) const {
    const LiftedTriangulation& sheet = sheets_[s.sheet];
    return !sheet.vertex(sheet.mesh().from(s.side)).node.valid() &&
           !sheet.vertex(sheet.mesh().to(s.side)).node.valid();
  }
  bool vanishes(std::size_t sheet, int t) const { return sheets_[sheet].vanishes(t); }

  // --- corners of triangles, united to vertices ---

  std::size_t corner(std::size_t sheet, int t, int i) const {
    return first_corner_[sheet] + 3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(i);
  }
  std::size_t from_corner(const SheetSide& s) const {
    return corner(s.sheet, s.side.t, PlanarTriangulation::ccw(s.side.i));
  }
  std::size_t to_corner(const SheetSide& s) const {
    return corner(s.sheet, s.side.t, PlanarTriangulation::cw(s.side.i));
  }
  std::size_t root(std::size_t c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }
  // The smallest corner stands for all, so that the outcome does not depend on the order.
  void unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  void unite_sides(const SheetSide& a, const SheetSide& b) {
    unite(from_corner(a), to_corner(b));
    unite(to_corner(a), from_corner(b));
  }

  template <class Act>
  void for_each_side(Act&& act) const {
    for (std::size_t s = 0; s < sheets_.size(); ++s) {
      for (int t = 0; t < sheets_[s].mesh().triangle_count(); ++t) {
        context_.check();
        for (int i = 0; i < 3; ++i) act(SheetSide{s, {t, i}});
      }
    }
  }

  void unite_corners() {
    first_corner_.assign(sheets_.size(), 0);
    std::size_t count = 0;
    for (std::size_t s = 0; s < sheets_.size(); ++s) {
      first_corner_[s] = count;
      count += 3 * sheets_[s].mesh().triangles().size();
    }
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});

    std::map<std::tuple<EdgeId, NodeId, NodeId>, SheetSide> waiting;
    for_each_side([&](const SheetSide& s) {
      const LiftedTriangulation& sheet = sheets_[s.sheet];
      const SheetSegment* on = segment(s);
      if (on == nullptr) {
        const Side o = sheet.mesh().opposite(s.side);
        if (o.t > s.side.t) unite_sides(s, {s.sheet, o});
      } else if (on->pole) {
        unite(from_corner(s), to_corner(s));
      } else if (on->inner) {
        const NodeId a = sheet.vertex(sheet.mesh().from(s.side)).node;
        const NodeId b = sheet.vertex(sheet.mesh().to(s.side)).node;
        const auto key = std::make_tuple(on->edge, std::min(a, b), std::max(a, b));
        const auto [it, first] = waiting.emplace(key, s);
        if (!first) {
          unite_sides(it->second, s);
          waiting.erase(it);
        }
      }
    });
    if (!waiting.empty()) {
      throw GeometryError("{} joins no two sides of {}",
                          edge_name(std::get<0>(waiting.begin()->first)),
                          face_name(sheets_.front().sheet().face));
    }
  }

  // --- edges that occur twice ---

  // Divides free edges that would spoil the manifold. False: there were none.
  bool divide_doubled_edges() {
    std::unordered_map<std::uint64_t, SheetSide> directed;
    std::vector<SheetSide> spoiling;
    const auto key = [](std::size_t a, std::size_t b) {
      return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
    };
    const auto spoil = [&](const SheetSide& a, const SheetSide& b) {
      const SheetSegment *on_a = segment(a), *on_b = segment(b);
      if (on_a == nullptr) spoiling.push_back(a);
      if (on_b == nullptr) spoiling.push_back(b);
      if (on_a != nullptr && on_b != nullptr) throw too_coarse(*on_a, *on_b, a.sheet);
    };
    for_each_side([&](const SheetSide& s) {
      if (is_inside(s) || vanishes(s.sheet, s.side.t)) return;
      const std::size_t a = root(from_corner(s)), b = root(to_corner(s));
      if (a == b) {
        spoil(s, s);
        return;
      }
      const auto [it, first] = directed.emplace(key(a, b), s);
      if (!first) spoil(it->second, s);
      const auto back = directed.find(key(b, a));
      if (back != directed.end() && (is_border(s) || is_border(back->second))) {
        spoil(back->second, s);
      }
    });
    return divide(spoiling);
  }

  bool divide(const std::vector<SheetSide>& sides) {
    std::vector<std::tuple<std::size_t, int, int>> ends;
    for (const SheetSide& s : sides) {
      const PlanarTriangulation& mesh = sheets_[s.sheet].mesh();
      const int a = mesh.from(s.side), b = mesh.to(s.side);
      ends.emplace_back(s.sheet, std::min(a, b), std::max(a, b));
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (const auto& [sheet, a, b] : ends) {
      const PlanarTriangulation& mesh = sheets_[sheet].mesh();
      const Side side = mesh.search_side(a, b);
      if (side.t < 0 || mesh.segment(side) >= 0) continue;
      sheets_[sheet].insert_on(side, (mesh.point(a) + mesh.point(b)) / 2);
    }
    return !ends.empty();
  }

  BoundaryTooCoarse too_coarse(const SheetSegment& a, const SheetSegment& b,
                               std::size_t sheet) const {
    std::vector<EdgeId> edges{std::min(a.edge, b.edge), std::max(a.edge, b.edge)};
    if (edges[0] == edges[1]) edges.pop_back();
    return {Sentence("{}: mesh edges of {} and {} join the same two nodes; they are too long",
                     face_name(sheets_[sheet].sheet().face), edge_name(a.edge), edge_name(b.edge)),
            edges};
  }

  // --- the mesh ---

  const LiftedVertex& vertex_at(std::size_t sheet, int t, int i) const {
    return sheets_[sheet].vertex(sheets_[sheet].mesh().triangle(t).v[i]);
  }

  GluedMesh make_mesh() {
    GluedMesh glued;
    make_vertices(glued);
    std::vector<std::array<VertexH, 3>> triangles;
    for (std::size_t s = 0; s < sheets_.size(); ++s) {
      for (int t = 0; t < sheets_[s].mesh().triangle_count(); ++t) {
        context_.check();
        if (vanishes(s, t)) continue;
        const auto vertex = [&](int i) { return vertex_of_root_[root(corner(s, t, i))]; };
        triangles.push_back({vertex(0), vertex(1), vertex(2)});
      }
    }
    glued.mesh.build_triangles(context_, triangles);
    // A border side of a triangle that vanishes at a pole is the far side of that triangle as well.
    for_each_side([&](const SheetSide& side) {
      if (!is_border(side)) return;
      const HalfedgeH h = glued.mesh.find_halfedge(vertex_of_root_[root(from_corner(side))],
                                                   vertex_of_root_[root(to_corner(side))]);
      if (!h.valid()) throw InternalError("a border edge is lost at a pole");
      glued.mesh.set_frozen(h, true);
      glued.mesh.set_curve(h, segment(side)->edge);
    });
    return glued;
  }

  void make_vertices(GluedMesh& glued) {
    vertex_of_root_.assign(parent_.size(), VertexH());
    std::vector<Vec3> pole_normals(parent_.size(), Vec3::Zero());
    std::vector<int> pole_uses(parent_.size(), 0);
    for (std::size_t s = 0; s < sheets_.size(); ++s) {
      for (int t = 0; t < sheets_[s].mesh().triangle_count(); ++t) {
        context_.check();
        for (int i = 0; i < 3; ++i) {
          const std::size_t r = root(corner(s, t, i));
          const LiftedVertex& lifted = vertex_at(s, t, i);
          if (lifted.pole) {
            pole_normals[r] += lifted.normal;
            ++pole_uses[r];
          }
          if (!vertex_of_root_[r].valid()) {
            VertexData data;
            data.point = lifted.point;
            data.normal = lifted.normal;
            if (lifted.crease) data.support = Support::kEdge;
            vertex_of_root_[r] = glued.mesh.add_vertex(data);
            glued.sizes.push_back(lifted.size);
          }
          double& size = glued.sizes[vertex_of_root_[r].index()];
          size = std::min(size, lifted.size);
        }
      }
    }
    set_border_support(glued);
    set_tips(glued, pole_normals, pole_uses);
  }

  void set_node(VertexData& data, NodeId node) const {
    const BoundaryNode& on = boundary_.nodes[node.index()];
    data.node = node;
    data.support = on.vertex.valid() ? Support::kVertex : Support::kEdge;
    data.point.xyz = on.xyz;
  }

  void set_border_support(GluedMesh& glued) {
    for_each_side([&](const SheetSide& s) {
      if (!is_border(s)) return;
      const PlanarTriangulation& mesh = sheets_[s.sheet].mesh();
      set_node(glued.mesh.data(vertex_of_root_[root(from_corner(s))]),
               sheets_[s.sheet].vertex(mesh.from(s.side)).node);
      set_node(glued.mesh.data(vertex_of_root_[root(to_corner(s))]),
               sheets_[s.sheet].vertex(mesh.to(s.side)).node);
    });
  }

  // Poles have the mean normal of their surroundings; where these lean apart, the pole is a tip
  // that no smoothing may cut off.
  void set_tips(GluedMesh& glued, const std::vector<Vec3>& normals, const std::vector<int>& uses) {
    for (std::size_t s = 0; s < sheets_.size(); ++s) {
      for (int t = 0; t < sheets_[s].mesh().triangle_count(); ++t) {
        context_.check();
        for (int i = 0; i < 3; ++i) {
          const LiftedVertex& lifted = vertex_at(s, t, i);
          const std::size_t r = root(corner(s, t, i));
          if (!lifted.pole || uses[r] == 0) continue;
          VertexData& data = glued.mesh.data(vertex_of_root_[r]);
          const double length = normals[r].norm();
          if (length > 0) data.normal = normals[r] / length;
          if (length < kSmoothTip * uses[r] && !data.node.valid()) set_node(data, lifted.node);
        }
      }
    }
  }

  std::vector<LiftedTriangulation>& sheets_;
  const Discretization& boundary_;
  const RunContext& context_;
  std::vector<std::size_t> first_corner_;
  std::vector<std::size_t> parent_;
  std::vector<VertexH> vertex_of_root_;
};

}  // namespace

GluedMesh glue_sheets(const RunContext& context, std::vector<LiftedTriangulation>& sheets,
                      const Discretization& boundary) {
  return Gluer(context, sheets, boundary).run();
}

}  // namespace advlayers
