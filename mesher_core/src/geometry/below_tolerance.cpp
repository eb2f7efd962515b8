#include "geometry/below_tolerance.h"

#include <algorithm>
#include <numeric>

namespace advlayers {
namespace {

// Tolerances above this part of the longest edge say nothing about what belongs together.
constexpr double kLargestShare = 1e-4;
// A pole is shorter in space than this part of what its length in (u, v) is elsewhere on the face.
constexpr double kPoleShrinks = 0.01;
constexpr int kScaleSamples = 4;  // per direction
constexpr int kPoleChords = 8;    // along the edge that may be a pole

double tolerance_about(const Edge& edge, const std::vector<Vertex>& vertices) {
  double tolerance = edge.tolerance;
  for (const VertexId end : {edge.start, edge.end}) {
    if (end.valid()) tolerance = std::max(tolerance, vertices[end.index()].tolerance);
  }
  return tolerance;
}

// The vertices that contracted edges make one, each by the first of them.
class VertexGroups {
 public:
  explicit VertexGroups(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
  }
  void unite(VertexId a, VertexId b) {
    const std::size_t i = first(a.index()), j = first(b.index());
    first_[std::max(i, j)] = std::min(i, j);
  }
  VertexId of(VertexId v) const { return v.valid() ? VertexId(first(v.index())) : v; }

 private:
  std::size_t first(std::size_t i) const {
    while (first_[i] != i) i = first_[i];
    return i;
  }
  std::vector<std::size_t> first_;
};

// Mean lengths in space per unit of u and of v.
Vec2 mean_speeds(Evaluator& evaluator, FaceId id) {
  const Face& face = evaluator.model().face(id);
  Vec2 speeds = Vec2::Zero();
  for (int i = 0; i < kScaleSamples; ++i) {
    for (int j = 0; j < kScaleSamples; ++j) {
      const double u = face.u_min + (face.u_max - face.u_min) * (i + 0.5) / kScaleSamples;
      const double v = face.v_min + (face.v_max - face.v_min) * (j + 0.5) / kScaleSamples;
      const SurfaceFrame frame = evaluator.frame(id, u, v);
      speeds += Vec2(frame.du.norm(), frame.dv.norm());
    }
  }
  return speeds / (kScaleSamples * kScaleSamples);
}

bool is_pole(Evaluator& evaluator, FaceId face, const CoEdge& coedge) {
  const Edge& edge = evaluator.model().edge(coedge.edge);
  const Vec2 speeds = mean_speeds(evaluator, face);
  double here = 0.0, elsewhere = 0.0;
  Vec2 last_uv;
  Vec3 last;
  for (int k = 0; k <= kPoleChords; ++k) {
    const double t = edge.first + (edge.last - edge.first) * k / kPoleChords;
    const Vec2 uv = evaluator.edge_uv(face, coedge, t);
    const Vec3 xyz = evaluator.frame(face, uv.x(), uv.y()).xyz;
    if (k > 0) {
      here += (xyz - last).norm();
      elsewhere += (uv - last_uv).cwiseProduct(speeds).norm();
    }
    last_uv = uv;
    last = xyz;
  }
  return here < kPoleShrinks * elsewhere;
}

}  // namespace

void contract_short_edges(const std::vector<Vertex>& vertices, std::vector<Edge>& edges) {
  double longest = 0.0;
  for (const Edge& edge : edges) longest = std::max(longest, edge.length);
  VertexGroups groups(vertices.size());
  for (Edge& edge : edges) {
    if (edge.degenerate || !(edge.last > edge.first)) continue;
    // A loop around nothing is told by its own tolerance at any size.
    const bool closed = edge.start.valid() && edge.start == edge.end;
    const double share = kLargestShare * longest;
    const double tolerance = std::min(tolerance_about(edge, vertices), share);
    if (edge.length > std::max(tolerance, closed ? edge.tolerance : 0.0)) continue;
    edge.degenerate = true;
    if (edge.start.valid() && edge.end.valid()) groups.unite(edge.start, edge.end);
  }
  for (Edge& edge : edges) {
    edge.start = groups.of(edge.start);
    edge.end = groups.of(edge.end);
  }
}

void remove_false_poles(Evaluator& evaluator, std::vector<Face>& faces) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    auto& loops = faces[f].loops;
    const auto closes_gap = [&](const CoEdge& coedge) {
      return coedge.degenerate && !is_pole(evaluator, FaceId(f), coedge);
    };
    for (auto& loop : loops) {
      loop.erase(std::remove_if(loop.begin(), loop.end(), closes_gap), loop.end());
    }
    const bool any = !loops.empty();
    const auto is_empty = [](const auto& loop) { return loop.empty(); };
    loops.erase(std::remove_if(loops.begin(), loops.end(), is_empty), loops.end());
    if (any && loops.empty()) {
      faces[f].defect = Sentence("its whole boundary is shorter than its tolerance");
    }
  }
}

}  // namespace advlayers
