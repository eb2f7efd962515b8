#include "quads/recombine.h"

#include <algorithm>
#include <vector>

#include "base/ties.h"
#include "core/star_smoothing.h"
#include "measure/core_region.h"
#include "measure/element_measures.h"
#include "quads/matching.h"
#include "quads/seam_repair.h"
#include "quads/triangle_pairs.h"
#include "quads/triangle_walk.h"

namespace advlayers {
namespace {

constexpr int kSeamSweeps = 10;  // of smoothing where layers and core meet
constexpr int kSweeps = 5;       // of smoothing between two rounds
constexpr int kRounds = 8;       // of walks, pairs and smoothing

struct Candidates {
  std::vector<HalfedgeH> diagonal;  // one per pair edge
  std::vector<PairEdge> pairs;
  std::vector<FaceH> face;  // by node of the pair graph
};

double pair_quality(const SurfaceMesh& mesh, HalfedgeH h) {
  return quad_quality(mesh, mesh.from(h), mesh.to(mesh.next(SurfaceMesh::twin(h))), mesh.to(h),
                      mesh.to(mesh.next(h)));
}

Candidates find_candidates(const RunContext& context, const SurfaceMesh& mesh) {
  Candidates found;
  std::vector<int> node(mesh.face_capacity(), -1);
  const auto node_of = [&](FaceH f) {
    int& number = node[f.index()];
    if (number < 0) {
      number = static_cast<int>(found.face.size());
      found.face.push_back(f);
    }
    return number;
  };
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
    context.check();
    const HalfedgeH h(i);
    if (!mesh.alive(h) || mesh.combine_veto(h) != Veto::kNone) continue;
    const double quality = settled(pair_quality(mesh, h));
    if (quality < kLeastPairQuality) continue;
    found.diagonal.push_back(h);
    const int a = node_of(mesh.face(h));
    found.pairs.push_back({a, node_of(mesh.face(SurfaceMesh::twin(h))), quality});
  }
  return found;
}

void combine_pair(SurfaceMesh& mesh, HalfedgeH diagonal) {
  const int layer = std::max(mesh.data(mesh.face(diagonal)).layer,
                             mesh.data(mesh.face(SurfaceMesh::twin(diagonal))).layer);
  mesh.data(mesh.combine(diagonal)).layer = layer;
}

void pair_triangles(const RunContext& context, SurfaceMesh& mesh) {
  const Candidates found = find_candidates(context, mesh);
  const auto matched = match_pairs(context, static_cast<int>(found.face.size()), found.pairs);
  for (std::size_t e = 0; e < found.pairs.size(); ++e) {
    context.check();
    if (matched[static_cast<std::size_t>(found.pairs[e].a)] != static_cast<int>(e)) continue;
    const HalfedgeH diagonal = found.diagonal[e];
    if (mesh.combine_veto(diagonal) == Veto::kNone) combine_pair(mesh, diagonal);
  }
}

}  // namespace

void recombine(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
               LayerCells cells, const RecombineSteps& steps) {
  pair_triangles(context, mesh);
  const auto seam_of = [&] {
    return cells == LayerCells::kTraded ? seam_vertices(mesh) : std::vector<VertexH>();
  };
  const std::vector<VertexH> free = free_vertices(mesh), seam = seam_of();
  for (int round = 0; round < kRounds; ++round) {
    const int joined = steps.walks ? join_triangles(context, mesh, surface) : 0;
    if (round > 0 && joined == 0) break;
    if (!steps.smoothing) continue;
    smooth_stars(context, mesh, surface, free, QuadTarget::kSquare, kSweeps);
    smooth_stars(context, mesh, surface, seam, QuadTarget::kRectangle, kSweeps);
  }
  if (steps.pairs) close_triangle_pairs(context, mesh, cells);
  if (steps.pentagons) recut_pentagons(context, mesh, cells);
  if (!steps.smoothing) return;
  smooth_stars(context, mesh, surface, seam_of(), QuadTarget::kRectangle, kSeamSweeps);
}

}  // namespace advlayers
