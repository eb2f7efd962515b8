#include "imprint/imprint_edges.h"

#include <algorithm>
#include <unordered_map>

#include "imprint/edge_crossings.h"
#include "imprint/face_sides.h"
#include "imprint/polygon_cuts.h"
#include "imprint/snap_to_edges.h"

namespace advlayers {
namespace {

constexpr double kNoCutAt = 0.002;   // of the chord from its ends
constexpr double kSamePlace = 1e-3;  // of the element: a vertex this near to a cut is that cut

class Imprinter {
 public:
  Imprinter(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
            const Discretization& boundary)
      : mesh_(mesh),
        surface_(surface),
        context_(context),
        sides_(mesh, surface, boundary),
        crossings_(mesh, surface, sides_) {}

  int run() {
    missed_ = snap_to_edges(context_, mesh_, surface_, sides_, crossings_);
    return rebuild();
  }

 private:
  static std::uint64_t key(VertexH a, VertexH b) {
    const auto low = static_cast<std::uint64_t>(std::min(a, b).index());
    return low << 32 | static_cast<std::uint64_t>(std::max(a, b).index());
  }

  VertexH add_cut(const CutPoint& cut, VertexH a, VertexH b) {
    VertexData data;
    data.point = cut.point;
    data.normal = surface_.normal(cut.point);
    data.support = Support::kEdge;
    const VertexData &at_a = mesh_.data(a), &at_b = mesh_.data(b);
    data.layer = at_a.layer == 0 || at_b.layer == 0 ? 0 : std::max(at_a.layer, at_b.layer);
    const bool up = at_b.parent == a, down = at_a.parent == b;
    if (up || down) {
      data.layer = up ? at_b.layer : at_a.layer;
      data.parent = up ? a : b;
    }
    const VertexH v = mesh_.add_vertex(data);
    if (up) mesh_.data(b).parent = v;
    if (down) mesh_.data(a).parent = v;
    sides_.put(v, cut.faces);
    return v;
  }

  void cut_edges() {
    const std::size_t count = mesh_.halfedge_capacity();
    for (std::size_t i = 0; i < count; i += 2) {
      const HalfedgeH h(i);
      if (!mesh_.alive(h)) continue;
      context_.check();
      const VertexH a = mesh_.from(h), b = mesh_.to(h);
      VertexH last = a;
      std::vector<VertexH> on_edge;
      for (const CutPoint& cut : crossings_.between(a, b)) {
        if (cut.share < kNoCutAt || cut.share > 1.0 - kNoCutAt) continue;
        last = add_cut(cut, last, b);
        on_edge.push_back(last);
      }
      if (on_edge.empty()) continue;
      if (b < a) std::reverse(on_edge.begin(), on_edge.end());
      cuts_[key(a, b)] = std::move(on_edge);  // from the lower handle to the higher
    }
  }

  std::vector<VertexH> polygon_of(FaceH f) const {
    std::vector<VertexH> corners;
    for (const HalfedgeH h : mesh_.sides(f)) {
      const VertexH a = mesh_.from(h), b = mesh_.to(h);
      corners.push_back(a);
      if (const auto found = cuts_.find(key(a, b)); found != cuts_.end()) {
        if (a < b) {
          corners.insert(corners.end(), found->second.begin(), found->second.end());
        } else {
          corners.insert(corners.end(), found->second.rbegin(), found->second.rend());
        }
      }
    }
    return corners;
  }

  // The cut that lies where a vertex of the model does: it becomes that vertex.
  VertexH cut_at(const Vec3& xyz, const std::vector<VertexH>& corners, double near) const {
    for (const VertexH v : corners) {
      const VertexData& data = mesh_.data(v);
      const bool is_cut = data.support == Support::kEdge && !data.node.valid();
      if (is_cut && (data.point.xyz - xyz).norm() <= near) return v;
    }
    return {};
  }

  // Parts a polygon that holds a vertex of the model by lines from there to the cuts.
  bool part_at_vertex(const std::vector<VertexH>& corners, bool triangles, PolygonPieces& pieces) {
    std::vector<std::size_t> spokes;
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (sides_.of(corners[k]).size() > 1) spokes.push_back(k);
      middle += mesh_.position(corners[k]) / static_cast<double>(corners.size());
    }
    double reach = 0.0;
    for (const VertexH v : corners) reach = std::max(reach, (mesh_.position(v) - middle).norm());
    if (spokes.size() < 3) return false;
    for (auto missed = missed_.begin(); missed != missed_.end(); ++missed) {
      const Vec3& xyz = surface_.model().vertex(*missed).xyz;
      SurfacePoint foot;
      if ((xyz - middle).norm() > reach) continue;
      if (const VertexH there = cut_at(xyz, corners, kSamePlace * reach); there.valid()) {
        mesh_.data(there).point.xyz = xyz;
        mesh_.data(there).support = Support::kVertex;
        sides_.put(there, sides_.at(*missed));
        missed_.erase(missed);
        pieces = cut_polygon(mesh_, sides_, corners, triangles);
        return pieces.parted;
      }
      if (!surface_.project(xyz, mesh_.data(corners[spokes[0]]).point, foot)) continue;
      VertexData data;
      foot.xyz = xyz;
      data.point = foot;
      data.normal = surface_.normal(foot);
      data.support = Support::kVertex;
      const VertexH center = mesh_.add_vertex(data);
      sides_.put(center, sides_.at(*missed));
      PolygonPieces parts;
      for (std::size_t k = 0; k < spokes.size(); ++k) {
        std::vector<VertexH> ring{center};
        const std::size_t last = spokes[(k + 1) % spokes.size()];
        for (std::size_t i = spokes[k]; i != last; i = (i + 1) % corners.size()) {
          ring.push_back(corners[i]);
        }
        ring.push_back(corners[last]);
        PolygonPieces part = cut_polygon(mesh_, sides_, ring, triangles);
        parts.parted = parts.parted && part.parted;
        parts.polygons.insert(parts.polygons.end(), part.polygons.begin(), part.polygons.end());
      }
      if (!parts.parted) continue;
      pieces = std::move(parts);
      missed_.erase(missed);
      return true;
    }
    return false;
  }

  // A column that was cut in two continues along the cut.
  void adopt(const std::vector<std::vector<VertexH>>& pieces) {
    for (const auto& corners : pieces) {
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const VertexH a = corners[k], b = corners[(k + 1) % corners.size()];
        const VertexH low = mesh_.data(a).layer < mesh_.data(b).layer ? a : b;
        const VertexH high = low == a ? b : a;
        VertexData& data = mesh_.data(high);
        const bool new_vertex = data.support == Support::kEdge && !data.node.valid();
        if (!new_vertex || data.parent.valid() || sides_.of(low).size() < 2) continue;
        if (data.layer == mesh_.data(low).layer + 1) data.parent = low;
      }
    }
  }

  struct Side {
    VertexH from, to;
    EdgeId curve;
    bool frozen;
  };

  std::vector<Side> marked_sides() const {
    std::vector<Side> marked;
    for (std::size_t i = 0; i < mesh_.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      if (!mesh_.alive(h) || !(mesh_.frozen(h) || mesh_.curve(h).valid())) continue;
      marked.push_back({mesh_.from(h), mesh_.to(h), mesh_.curve(h), mesh_.frozen(h)});
    }
    return marked;
  }

  void mark_again(const std::vector<Side>& marked) {
    for (const Side& side : marked) {
      std::vector<VertexH> line{side.from};
      if (const auto found = cuts_.find(key(side.from, side.to)); found != cuts_.end()) {
        line.insert(line.end(), found->second.begin(), found->second.end());
        if (side.to < side.from) std::reverse(line.begin() + 1, line.end());
      }
      line.push_back(side.to);
      for (std::size_t k = 1; k < line.size(); ++k) {
        const HalfedgeH h = mesh_.find_halfedge(line[k - 1], line[k]);
        if (!h.valid()) continue;
        mesh_.set_frozen(h, side.frozen);
        mesh_.set_curve(h, side.curve);
      }
    }
  }

  int rebuild() {
    cut_edges();
    int unparted = 0;
    std::vector<std::vector<VertexH>> faces;
    std::vector<int> layers;
    std::vector<FaceId> on_face;
    for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
      const FaceH f(i);
      if (!mesh_.alive(f)) continue;
      context_.check();
      std::vector<VertexH> corners = polygon_of(f);
      const int layer = mesh_.data(f).layer;
      std::vector<std::vector<VertexH>> pieces{corners};
      const bool whole = corners.size() == static_cast<std::size_t>(mesh_.degree(f));
      if (!(whole && sides_.common(corners).valid())) {
        PolygonPieces cut = cut_polygon(mesh_, sides_, corners, layer == 0);
        if (!cut.parted && part_at_vertex(corners, layer == 0, cut)) cut.parted = true;
        unparted += cut.parted ? 0 : 1;
        pieces = std::move(cut.polygons);
        if (layer > 0) adopt(pieces);
      }
      for (auto& piece : pieces) {
        on_face.push_back(sides_.under(mesh_, surface_, piece));
        faces.push_back(std::move(piece));
        layers.push_back(layer);
      }
    }
    const std::vector<Side> marked = marked_sides();
    SurfaceMesh made;
    for (std::size_t i = 0; i < mesh_.vertex_capacity(); ++i)
      made.add_vertex(mesh_.data(VertexH(i)));
    made.build(context_, faces);
    mesh_ = std::move(made);
    for (std::size_t i = 0; i < faces.size(); ++i) mesh_.data(FaceH(i)).layer = layers[i];
    mark_again(marked);
    freeze_inner_edges(on_face);
    return unparted;
  }

  // The mesh edges that part two faces of the model lie on the edge between them.
  void freeze_inner_edges(const std::vector<FaceId>& on_face) {
    for (std::size_t i = 0; i < mesh_.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i), t = SurfaceMesh::twin(h);
      if (!mesh_.alive(h) || mesh_.is_border(h) || mesh_.is_border(t)) continue;
      const FaceId a = on_face[mesh_.face(h).index()], b = on_face[mesh_.face(t).index()];
      if (a == b || !a.valid() || !b.valid()) continue;
      PatchSurface::InnerPoint inner;
      const Vec3 middle = 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
      if (!surface_.nearest_between(a, b, middle, inner)) continue;
      mesh_.set_frozen(h, true);
      mesh_.set_curve(h, inner.edge);
    }
  }

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  const RunContext& context_;
  FaceSides sides_;
  EdgeCrossings crossings_;
  // Vertices of the model inside the patch without a vertex of the mesh.
  std::vector<VertexId> missed_;
  std::unordered_map<std::uint64_t, std::vector<VertexH>> cuts_;
};

}  // namespace

int imprint_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  const Discretization& boundary) {
  if (!surface.has_inner_edges()) return 0;
  return Imprinter(context, mesh, surface, boundary).run();
}

}  // namespace advlayers
