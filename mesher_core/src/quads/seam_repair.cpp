#include "quads/seam_repair.h"

#include <algorithm>
#include <array>

#include "quads/pentagon.h"

namespace advlayers {
namespace {

// A triangle with an angle below 21 or above 159 degrees is worth a cut into the layers.
constexpr double kBadShape = 0.42;

// The least sine of an element's angles over the ideal's; negative where a corner turns back, or
// where the element is turned over against the surface.
template <std::size_t kCorners>
double shape_of(const SurfaceMesh& mesh, const std::array<VertexH, kCorners>& corner) {
  constexpr double kIdealSine = kCorners == 3 ? 0.8660254037844386 : 1.0;  // at a corner
  const auto at = [&](std::size_t k) -> const Vec3& { return mesh.position(corner[k % kCorners]); };
  const Vec3 area =
      kCorners == 3 ? (at(1) - at(0)).cross(at(2) - at(0)) : (at(2) - at(0)).cross(at(3) - at(1));
  double least = 1.0;
  for (std::size_t k = 0; k < kCorners; ++k) {
    if (mesh.data(corner[k]).normal.dot(area) <= 0.0) return -1.0;
    const Vec3 ahead = at(k + 1) - at(k), behind = at(k + kCorners - 1) - at(k);
    const Vec3 turn = ahead.cross(behind);
    const double lengths = ahead.norm() * behind.norm();
    if (lengths <= 0.0 || turn.dot(area) <= 0.0) return -1.0;
    least = std::min(least, turn.norm() / lengths / kIdealSine);
  }
  return least;
}

// The best cut across one side of a triangle, if it beats what is there.
struct Recut {
  double shape = 0.0;
  HalfedgeH shared;
  PentagonCut cut = PentagonCut::kP;
};

void consider(const SurfaceMesh& mesh, HalfedgeH shared, LayerCells cells, Recut& best) {
  const HalfedgeH beyond = SurfaceMesh::twin(shared);
  if (mesh.is_border(beyond) || mesh.is_triangle(beyond) || mesh.curve(shared).valid()) return;
  if (cells == LayerCells::kStay && is_layer_cell(mesh, mesh.face(beyond))) return;
  const Pentagon pentagon = pentagon_at(mesh, shared, mesh.to(mesh.next(shared)));
  const auto shape = [&](PentagonCut cut) {
    const PentagonHalves halves = halves_of(pentagon, cut);
    return std::min(shape_of(mesh, halves.triangle), shape_of(mesh, halves.quad));
  };
  const double now = shape(PentagonCut::kP);
  for (const auto cut : {PentagonCut::kA, PentagonCut::kB, PentagonCut::kC, PentagonCut::kD}) {
    const double cut_shape = shape(cut);
    if (cut_shape > 1.1 * std::max(now, 0.0) && cut_shape > best.shape) {
      best = {cut_shape, shared, cut};
    }
  }
}

bool recut_triangle(SurfaceMesh& mesh, FaceH f, LayerCells cells) {
  const HalfedgeH first = mesh.halfedge(f);
  // A triangle in which a layer ends is as flat as the layer: no cut would make more of it.
  if (!mesh.is_triangle(first) || mesh.data(f).layer > 0) return false;
  const std::array<HalfedgeH, 3> sides{first, mesh.next(first), mesh.prev(first)};
  const std::array<VertexH, 3> corners{mesh.from(sides[0]), mesh.to(sides[0]), mesh.to(sides[1])};
  if (shape_of(mesh, corners) > kBadShape) return false;
  if (cells == LayerCells::kStay && is_layer_cell(mesh, f)) return false;
  Recut best;
  for (const HalfedgeH side : sides) consider(mesh, side, cells, best);
  if (!best.shared.valid()) return false;
  const HalfedgeH shared = best.shared;
  const bool frozen = mesh.frozen(shared);
  const int layer = mesh.data(f).layer;
  mesh.set_frozen(shared, false);
  // Both pieces count as the layer's, until return_to_core() looks for the quad's extrusions.
  mesh.data(f).layer = mesh.data(mesh.face(SurfaceMesh::twin(shared))).layer;
  const bool done = recut(mesh, shared, best.cut);
  if (!done) {
    mesh.set_frozen(shared, frozen);
    mesh.data(f).layer = layer;
  }
  return done;
}

}  // namespace

int recut_pentagons(const RunContext& context, SurfaceMesh& mesh, LayerCells cells) {
  constexpr int kPasses = 3;  // a cut may make room for another
  int total = 0;
  for (int pass = 0, cuts = 1; pass < kPasses && cuts > 0; ++pass) {
    cuts = 0;
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      context.check();
      if (mesh.alive(FaceH(i))) cuts += recut_triangle(mesh, FaceH(i), cells);
    }
    total += cuts;
  }
  return total;
}

}  // namespace advlayers
