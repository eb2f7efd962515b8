#include "triangulate/lifted_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/angles.h"
#include "base/predicates.h"
#include "triangulate/triangle_score.h"

namespace advlayers {
namespace {

// Sine by which two opposite angles must exceed pi together before their edge is flipped: metrics
// differ from point to point, so that flips without a margin could go round in circles.
constexpr double kFlipMargin = 1e-3;
constexpr double kNose = 0.012;    // extent of a nose, as a share of the wanted length
constexpr double kNoseReach = 10;  // times that extent, in the sheet
const double kNoseTurn = std::cos(45 * kDegree);  // of the normal over it
constexpr double kScoreMargin = 1e-4;             // that a flip in space must gain
constexpr std::size_t kFlipLimit = 500;           // after one insertion

}  // namespace

LiftedTriangulation::LiftedTriangulation(FaceSheet sheet, PlanarTriangulation mesh,
                                         Evaluator& evaluator, TargetSize target)
    : sheet_(std::move(sheet)),
      mesh_(std::move(mesh)),
      evaluator_(&evaluator),
      target_(std::move(target)),
      versions_(mesh_.triangles().size(), 0) {
  vertices_.resize(mesh_.points().size());
  for (std::size_t i = 0; i < sheet_.points.size(); ++i) {
    vertices_[i] = evaluate(sheet_.points[i]);
    vertices_[i].node = sheet_.nodes[i];
  }
  set_boundary_sizes();
  set_sagittas();
  blunt_border_normals();
}

// A border point wants the mean length of the border's mesh edges beside it, a point on a seam what
// the surface does.
void LiftedTriangulation::set_boundary_sizes() {
  std::unordered_map<NodeId, std::pair<double, int>> border;
  for (const SheetSegment& s : sheet_.segments) {
    const LiftedVertex &a = vertex(s.from), &b = vertex(s.to);
    if (s.inner || s.pole) continue;
    const double length = (b.point.xyz - a.point.xyz).norm();
    for (const NodeId node : {a.node, b.node}) {
      border[node].first += length;
      ++border[node].second;
    }
  }
  for (const SheetSegment& s : sheet_.segments) {
    if (s.pole) set_pole_sizes(s);
  }
  for (std::size_t i = 0; i < sheet_.points.size(); ++i) {
    LiftedVertex& v = vertices_[i];
    if (const auto found = border.find(v.node); found != border.end()) {
      v.size = v.least = found->second.first / found->second.second;
    } else if (!v.pole) {
      v.size = target_.at(v.point);
    }
  }
}

void LiftedTriangulation::set_sagittas() {
  sagittas_.reserve(sheet_.segments.size());
  for (const SheetSegment& s : sheet_.segments) {
    const Vec3 on_surface = evaluate((mesh_.point(s.from) + mesh_.point(s.to)) / 2).point.xyz;
    const Vec3 on_chord = (vertex(s.from).point.xyz + vertex(s.to).point.xyz) / 2;
    sagittas_.push_back(s.pole ? 0.0 : (on_surface - on_chord).norm());
  }
}

// Lofted surfaces often end in a nose of nearly no radius: the normal right on the border then says
// nothing about the triangles that leave it, and what it is a little inside is taken.
void LiftedTriangulation::blunt_border_normals() {
  std::vector<Vec2> inward(sheet_.points.size(), Vec2::Zero());
  for (const SheetSegment& s : sheet_.segments) {
    if (s.inner || s.pole) continue;
    const Vec2 d = mesh_.point(s.to) - mesh_.point(s.from);
    for (const int end : {s.from, s.to}) {
      const Vec2 across = vertex(end).metric.across(d);
      const double length2 = vertex(end).metric.squared(across);
      if (length2 > 0) inward[static_cast<std::size_t>(end)] += across / std::sqrt(length2);
    }
  }
  for (std::size_t i = 0; i < inward.size(); ++i) {
    LiftedVertex& v = vertices_[i];
    const double length2 = v.metric.squared(inward[i]);
    if (v.pole || !(length2 > 0)) continue;
    // Where the parametrization stands still, the metric leads far off; the sheet's own scale
    // holds.
    const double step = kNose * v.size;
    const Vec2 inset =
        inward[i] * std::min(step / std::sqrt(length2), kNoseReach * step / inward[i].norm());
    const Vec3 beside = evaluate(sheet_.points[i] + inset).normal;
    if (beside.dot(v.normal) < kNoseTurn) v.normal = beside;
  }
}

// The curvature of a tip has no bound: asked for is what the surface wants one edge away from it.
void LiftedTriangulation::set_pole_sizes(const SheetSegment& pole) {
  const Vec2 &p = mesh_.point(pole.from), &q = mesh_.point(pole.to);
  const Vec2 middle = (p + q) / 2;
  const Vec2 inward = Vec2(-(q - p).y(), (q - p).x()).normalized();
  const double speed = std::sqrt(evaluate(middle).metric.squared(inward));
  double away = target_.extent(sheet_.face);
  if (speed > 0) away /= speed;
  const double size = target_.at(evaluate(middle + away * inward).point);
  for (const int end : {pole.from, pole.to}) {
    LiftedVertex& v = vertices_[static_cast<std::size_t>(end)];
    v.size = v.pole ? std::min(v.size, size) : size;
    v.least = v.size;
    v.pole = true;
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

double LiftedTriangulation::squared_length(int a, int b) const {
  const LiftedVertex &va = vertex(a), &vb = vertex(b);
  const Vec2 d = mesh_.point(b) - mesh_.point(a);
  if (va.pole || vb.pole) {
    // Along the pole there is no length: what counts is the way across.
    const double across = va.pole && vb.pole ? 0.0 : (va.pole ? va : vb).metric.squared(d);
    return std::max(across, (vb.point.xyz - va.point.xyz).squaredNorm());
  }
  return (va.metric + vb.metric).squared(d) / 2;
}

int LiftedTriangulation::add_vertex(const Vec2& p, std::initializer_list<int> near) {
  LiftedVertex v = evaluate(p);
  const int index = mesh_.add_point(p);
  double upper = std::numeric_limits<double>::infinity();
  vertices_.push_back(v);
  for (const int n : near) {
    const double change = gradation() * std::sqrt(squared_length(index, n));
    v.least = std::max(v.least, vertex(n).least - change);
    upper = std::min(upper, vertex(n).size + change);
  }
  v.size = std::min(upper, std::max(v.least, target_.at(v.point)));
  vertices_.back() = v;
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
    const double change = gradation() * std::sqrt(squared_length(v, n));
    center.size = std::min(center.size, vertex(n).size + change);
  }
  for (const Side& s : pending_) {
    LiftedVertex& beside = vertices_[static_cast<std::size_t>(mesh_.from(s))];
    if (beside.node.valid()) continue;
    const double change = gradation() * std::sqrt(squared_length(v, mesh_.from(s)));
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

bool LiftedTriangulation::vanishes(int t) const {
  for (int i = 0; i < 3; ++i) {
    const int segment = mesh_.segment({t, i});
    if (segment >= 0 && sheet_.segments[static_cast<std::size_t>(segment)].pole) return true;
  }
  return false;
}

double LiftedTriangulation::score(int a, int b, int c) const {
  const auto corner_of = [this](int v) {
    const LiftedVertex& lifted = vertex(v);
    return Corner{lifted.point.xyz,
                  lifted.pole || lifted.crease ? Vec3(Vec3::Zero()) : lifted.normal};
  };
  return triangle_score(corner_of(a), corner_of(b), corner_of(c));
}

bool LiftedTriangulation::is_better_in_space(Side s) const {
  const Side o = mesh_.opposite(s);
  const int a = mesh_.from(s), b = mesh_.to(s), c = mesh_.apex(s), d = mesh_.apex(o);
  if (!vertex(a).pole && !vertex(b).pole && !vertex(c).pole && !vertex(d).pole) return false;
  if (vanishes(s.t) || vanishes(o.t) || !mesh_.flippable(s)) return false;
  const double before = std::min(score(a, b, c), score(b, a, d));
  return std::min(score(d, c, a), score(c, d, b)) > before + kScoreMargin;
}

void LiftedTriangulation::straighten_poles() {
  pending_.clear();
  for (int t = 0; t < mesh_.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (vertex(mesh_.triangle(t).v[i]).pole) {
        pending_.insert(pending_.end(), {{t, 0}, {t, 1}, {t, 2}});
        break;
      }
    }
  }
  const std::size_t limit = 10 * pending_.size() + kFlipLimit;
  mesh_.restore(pending_, limit, [this](Side s) { return is_better_in_space(s); });
  for (unsigned& version : versions_) ++version;
}

void LiftedTriangulation::put_in_order(const RunContext& context) {
  mesh_.keep(context, std::vector<char>(mesh_.triangles().size(), 1));
  for (unsigned& version : versions_) ++version;
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
