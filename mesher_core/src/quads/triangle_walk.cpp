#include "quads/triangle_walk.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/ties.h"
#include "core/star_smoothing.h"
#include "measure/core_region.h"
#include "measure/element_measures.h"
#include "quads/pentagon.h"
#include "quads/recombine.h"

namespace advlayers {
namespace {

// Quads a triangle may walk across, and faces one search may look at.
constexpr std::size_t kLongestWalk = 10;
constexpr std::size_t kSearchLimit = 250;
constexpr std::size_t kMostGoals = 8;
constexpr double kLeastTriangle = 0.1;  // sine of the smallest angle
// A vertex in line between its neighbours moves by so much of the edge that goes, and then the quad
// has to be as good as that.
constexpr double kOpeningSteps[] = {0.35, 0.25, 0.15};
constexpr double kLeastOpened = 0.12;  // quality: corners of 28 to 152 degrees

// With kOpened the last edge goes after one of its ends was moved.
enum class Last { kAsItIs, kOpened };

struct Plan {
  double worst = -1.0;
  std::array<PentagonCut, kLongestWalk> cuts{};
};

class Walker {
 public:
  Walker(SurfaceMesh& mesh, PatchSurface& surface)
      : mesh_(mesh), surface_(surface), reached_(mesh.face_capacity(), HalfedgeH()) {}
  bool join(FaceH start);

 private:
  void find_goals(FaceH start);
  void trace_route(FaceH start, FaceH goal);
  bool walk_to(FaceH start, FaceH goal, Last last);
  void plan_from(std::size_t step, VertexH p, double worst, Plan& plan, Plan& best) const;
  double last_quality(VertexH p) const;
  bool open(HalfedgeH h);
  bool carry_out(const Plan& plan);
  double triangle_quality(VertexH a, VertexH b, VertexH c) const;

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  Last last_ = Last::kAsItIs;
  bool moved_ = false;              // a walk has changed the mesh
  std::vector<HalfedgeH> reached_;  // by face: the half-edge, inside it, that it was entered over
  std::vector<FaceH> touched_, goals_;
  std::vector<HalfedgeH> route_;  // half-edges crossed, seen from the face that is left
};

VertexH apex(const SurfaceMesh& mesh, HalfedgeH h) { return mesh.to(mesh.next(h)); }

double Walker::triangle_quality(VertexH a, VertexH b, VertexH c) const {
  return min_angle_sine(mesh_.position(a), mesh_.position(b), mesh_.position(c),
                        mesh_.data(a).normal);
}

// Breadth first over quads to the nearest other triangles.
void Walker::find_goals(FaceH start) {
  goals_.clear();
  if (reached_.size() < mesh_.face_capacity()) reached_.resize(mesh_.face_capacity());
  touched_.assign(1, start);
  reached_[start.index()] = mesh_.halfedge(start);
  for (std::size_t i = 0; i < touched_.size() && i < kSearchLimit; ++i) {
    if (i > 0 && mesh_.is_triangle(mesh_.halfedge(touched_[i]))) continue;
    for (const HalfedgeH h : mesh_.sides(touched_[i])) {
      const HalfedgeH beyond = SurfaceMesh::twin(h);
      if (is_core_edge(mesh_, h) && !reached_[mesh_.face(beyond).index()].valid()) {
        const FaceH next = mesh_.face(beyond);
        reached_[next.index()] = beyond;
        touched_.push_back(next);
        if (mesh_.is_triangle(beyond)) goals_.push_back(next);
      }
    }
    if (goals_.size() >= kMostGoals) break;
  }
}

void Walker::trace_route(FaceH start, FaceH goal) {
  route_.clear();
  for (FaceH f = goal; f != start;) {
    const HalfedgeH left = SurfaceMesh::twin(reached_[f.index()]);
    route_.push_back(left);
    f = mesh_.face(left);
  }
  std::reverse(route_.begin(), route_.end());
}

// The two corners to cut so that the triangle reaches the edge that leads on.
std::array<PentagonCut, 2> cuts_towards(const SurfaceMesh& mesh, HalfedgeH entered,
                                        HalfedgeH leaving) {
  if (leaving == mesh.next(entered)) return {PentagonCut::kA, PentagonCut::kD};
  if (leaving == mesh.prev(entered)) return {PentagonCut::kB, PentagonCut::kC};
  return {PentagonCut::kC, PentagonCut::kD};
}

// Every way to go on from here, depth first; `best` holds the one whose worst element is best.
void Walker::plan_from(std::size_t step, VertexH p, double worst, Plan& plan, Plan& best) const {
  if (worst <= best.worst) return;
  const HalfedgeH leaving = route_[step];
  if (step + 1 == route_.size()) {
    const double last = settled(last_quality(p));
    if (last < kLeastPairQuality || std::min(worst, last) <= best.worst) return;
    best = plan;
    best.worst = std::min(worst, last);
    return;
  }
  const Pentagon pentagon = pentagon_at(mesh_, leaving, p);
  for (const PentagonCut cut : cuts_towards(mesh_, SurfaceMesh::twin(leaving), route_[step + 1])) {
    const PentagonHalves halves = halves_of(pentagon, cut);
    const auto& [t0, t1, t2] = halves.triangle;
    if (triangle_quality(t0, t1, t2) < kLeastTriangle) continue;
    const double quad = settled(
        quad_quality(mesh_, halves.quad[0], halves.quad[1], halves.quad[2], halves.quad[3]));
    if (quad < kLeastPairQuality) continue;
    const VertexH from = mesh_.from(route_[step + 1]), to = mesh_.to(route_[step + 1]);
    VertexH third = t0;
    if (third == from || third == to) third = t1;
    if (third == from || third == to) third = t2;
    plan.cuts[step] = cut;
    plan_from(step + 1, third, std::min(worst, quad), plan, best);
  }
}

// Of the quad across the route's last edge, the third corner of the triangle being p.
double Walker::last_quality(VertexH p) const {
  const HalfedgeH h = route_.back();
  const VertexH a = mesh_.from(h), b = mesh_.to(h), q = apex(mesh_, SurfaceMesh::twin(h));
  const double quality = quad_quality(mesh_, p, a, q, b);
  if (last_ == Last::kAsItIs) return quality;
  for (const VertexH v : {a, b}) {
    if (!is_free(mesh_, v)) continue;
    SurfacePoint& point = mesh_.data(v).point;
    const SurfacePoint before = point;
    point.xyz += kOpeningSteps[0] * (before.xyz - mesh_.position(v == a ? b : a));
    const double opened = quad_quality(mesh_, p, a, q, b);
    point = before;
    if (opened > kLeastOpened) return opened;
  }
  return -1.0;
}

// Moves an end of the edge away from the other, if the quad across it becomes a good one and all
// faces about the end stay upright.
bool Walker::open(HalfedgeH h) {
  for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
    const VertexH v = mesh_.from(side);
    if (!is_free(mesh_, v)) continue;
    VertexData& data = mesh_.data(v);
    const SurfacePoint before = data.point;
    for (const double step : kOpeningSteps) {
      const Vec3 goal = before.xyz + step * (before.xyz - mesh_.position(mesh_.to(side)));
      SurfacePoint foot;
      if (!surface_.project(goal, before, foot)) continue;
      if (!keeps_faces_upright(mesh_, v, foot.xyz)) continue;
      data.point = foot;
      if (quad_quality(mesh_, apex(mesh_, side), v, apex(mesh_, SurfaceMesh::twin(side)),
                       mesh_.to(side)) > kLeastOpened) {
        data.normal = surface_.normal(foot);
        return true;
      }
      data.point = before;
    }
  }
  return false;
}

bool Walker::carry_out(const Plan& plan) {
  for (std::size_t step = 0; step + 1 < route_.size(); ++step) {
    if (!recut(mesh_, route_[step], plan.cuts[step])) return false;
    moved_ = true;
  }
  if (mesh_.combine_veto(route_.back()) != Veto::kNone) return false;
  if (last_ == Last::kOpened && !open(route_.back())) return false;
  mesh_.combine(route_.back());
  return true;
}

bool Walker::walk_to(FaceH start, FaceH goal, Last last) {
  last_ = last;
  trace_route(start, goal);
  if (route_.size() > kLongestWalk) return false;
  Plan plan, best;
  plan_from(0, apex(mesh_, route_.front()), 2.0, plan, best);
  return best.worst >= kLeastPairQuality && carry_out(best);
}

bool Walker::join(FaceH start) {
  find_goals(start);
  bool joined = false;
  moved_ = false;
  for (const Last last : {Last::kAsItIs, Last::kOpened}) {
    // A walk that was stopped half-way has moved the triangle: what was found is void.
    for (std::size_t i = 0; i < goals_.size() && !joined && !moved_; ++i) {
      joined = walk_to(start, goals_[i], last);
    }
  }
  for (const FaceH f : touched_) reached_[f.index()] = HalfedgeH();
  return joined;
}

}  // namespace

int join_triangles(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface) {
  Walker walker(mesh, surface);
  int pairs = 0;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f) || !is_core(mesh, f) || !mesh.is_triangle(mesh.halfedge(f))) continue;
    context.check();
    pairs += walker.join(f);
  }
  return pairs;
}

}  // namespace advlayers
