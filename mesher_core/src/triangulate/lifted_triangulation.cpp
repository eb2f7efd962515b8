#include "triangulate/lifted_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/predicates.h"

namespace advlayers {
namespace {

// Sine by which two opposite angles must exceed pi together before their edge is flipped: metrics
// differ from point to point, so that flips without a margin could go round in circles.
constexpr double kFlipMargin = 1e-3;
constexpr std::size_t kFlipLimit = 500;  // after one insertion

}  // namespace

LiftedTriangulation::LiftedTriangulation(FaceSheet sheet, PlanarTriangulation mesh,
                                         Evaluator& evaluator, TargetSize target)
    : sheet_(std::move(sheet)),
      mesh_(std::move(mesh)),
      evaluator_(&evaluator),
      target_(target),
      versions_(mesh_.triangles().size(), 0) {
  vertices_.resize(mesh_.points().size());
  for (std::size_t i = 0; i < sheet_.points.size(); ++i) {
    vertices_[i] = evaluate(sheet_.points[i]);
    vertices_[i].node = sheet_.nodes[i];
  }
  set_boundary_sizes(target);
}

// A boundary point wants the mean length of the mesh edges beside it; a pole what the surface does.
void LiftedTriangulation::set_boundary_sizes(const TargetSize& target) {
  std::vector<int> edges_beside(sheet_.points.size(), 0);
  for (const SheetSegment& s : sheet_.segments) {
    LiftedVertex &a = vertices_[static_cast<std::size_t>(s.from)],
                 &b = vertices_[static_cast<std::size_t>(s.to)];
    if (s.pole) {
      a.pole = b.pole = true;
      continue;
    }
    const double length = (b.point.xyz - a.point.xyz).norm();
    for (const int end : {s.from, s.to}) {
      vertices_[static_cast<std::size_t>(end)].size += length;
      ++edges_beside[static_cast<std::size_t>(end)];
    }
  }
  TargetSize wanted = target;
  for (std::size_t i = 0; i < sheet_.points.size(); ++i) {
    LiftedVertex& v = vertices_[i];
    v.size = edges_beside[i] > 0 ? v.size / edges_beside[i] : wanted.at(v.point);
  }
}

LiftedVertex LiftedTriangulation::evaluate(const Vec2& p) {
  const Vec2 uv = sheet_.to_uv(p);
  const SurfaceFrame frame = evaluator_->frame(sheet_.face, uv.x(), uv.y());
  const Vec3 dx = frame.du / sheet_.scale.x(), dy = frame.dv / sheet_.scale.y();
  LiftedVertex v;
  v.point = {sheet_.face, uv.x(), uv.y(), frame.xyz};
  v.normal = frame.normal;
  v.metric = {dx.squaredNorm(), dx.dot(dy), dy.squaredNorm()};
  return v;
}

int LiftedTriangulation::add_vertex(const Vec2& p, std::initializer_list<int> near) {
  LiftedVertex v = evaluate(p);
  const int index = mesh_.add_point(p);
  double lower = 0, upper = std::numeric_limits<double>::infinity();
  vertices_.push_back(v);
  for (const int n : near) {
    const double change = kGradation * std::sqrt(squared_length(index, n));
    lower = std::max(lower, vertex(n).size - change);
    upper = std::min(upper, vertex(n).size + change);
  }
  vertices_.back().size = std::min(upper, std::max(lower, target_.at(v.point)));
  return index;
}

int LiftedTriangulation::insert_in(int t, const Vec2& p) {
  const auto& v = mesh_.triangle(t).v;
  for (int i = 0; i < 3; ++i) {
    if (orient2d(mesh_.point(mesh_.from({t, i})), mesh_.point(mesh_.to({t, i})), p) <= 0) return -1;
  }
  const int index = add_vertex(p, {v[0], v[1], v[2]});
  mesh_.split_triangle(t, index);
  settle(index);
  return index;
}

int LiftedTriangulation::insert_on(Side s, const Vec2& p) {
  if (!mesh_.splittable(s, p)) return -1;
  const int index = add_vertex(p, {mesh_.from(s), mesh_.to(s)});
  mesh_.split_side(s, index);
  settle(index);
  return index;
}

void LiftedTriangulation::touch(int t) {
  ++versions_[static_cast<std::size_t>(t)];
  touched_.push_back(t);
}

// Flips about the new vertex, and lets sizes spread between it and its neighbours.
void LiftedTriangulation::settle(int v) {
  versions_.resize(mesh_.triangles().size(), 0);
  touched_.clear();
  pending_.clear();
  mesh_.append_link(v, pending_);
  for (const Side& s : pending_) touch(s.t);
  std::size_t flips = 0;
  while (!pending_.empty()) {
    const Side s = pending_.back();
    pending_.pop_back();
    const int other = mesh_.triangle(s.t).n[s.i];
    if (other < 0 || mesh_.segment(s) >= 0 || flips >= kFlipLimit || !wants_flip(s)) continue;
    mesh_.flip(s);
    ++flips;
    touch(s.t);
    touch(other);
    pending_.push_back({s.t, 0});
    pending_.push_back({other, 0});
  }
  mesh_.append_link(v, pending_);
  LiftedVertex& center = vertices_[static_cast<std::size_t>(v)];
  for (const Side& s : pending_) {
    const int n = mesh_.from(s);
    const double change = kGradation * std::sqrt(squared_length(v, n));
    center.size = std::min(center.size, vertex(n).size + change);
  }
  for (const Side& s : pending_) {
    LiftedVertex& beside = vertices_[static_cast<std::size_t>(mesh_.from(s))];
    if (beside.node.valid()) continue;
    const double change = kGradation * std::sqrt(squared_length(v, mesh_.from(s)));
    beside.size = std::min(beside.size, center.size + change);
  }
}

bool LiftedTriangulation::wants_flip(Side s) const {
  const Side o = mesh_.opposite(s);
  const int a = mesh_.from(s), b = mesh_.to(s), c = mesh_.apex(s), d = mesh_.apex(o);
  const Metric m =
      (vertex(a).metric + vertex(b).metric + vertex(c).metric + vertex(d).metric) * 0.25;
  const Vec2 ca = mesh_.point(a) - mesh_.point(c), cb = mesh_.point(b) - mesh_.point(c);
  const Vec2 da = mesh_.point(a) - mesh_.point(d), db = mesh_.point(b) - mesh_.point(d);
  const double area = std::sqrt(std::max(0.0, m.determinant()));
  const double sin_c = area * (ca.x() * cb.y() - ca.y() * cb.x()), cos_c = m.dot(ca, cb);
  const double sin_d = area * (db.x() * da.y() - db.y() * da.x()), cos_d = m.dot(da, db);
  const double sine = sin_c * cos_d + cos_c * sin_d;
  const double norm = std::sqrt((sin_c * sin_c + cos_c * cos_c) * (sin_d * sin_d + cos_d * cos_d));
  return sine < -kFlipMargin * norm && mesh_.flippable(s);
}

void LiftedTriangulation::flip_all() {
  pending_.clear();
  for (int t = 0; t < mesh_.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (mesh_.triangle(t).n[i] > t) pending_.push_back({t, i});
    }
  }
  const std::size_t limit = 20 * mesh_.triangles().size() + kFlipLimit;
  mesh_.restore(pending_, limit, [this](Side s) { return wants_flip(s); });
  for (unsigned& version : versions_) ++version;
}

}  // namespace advlayers
