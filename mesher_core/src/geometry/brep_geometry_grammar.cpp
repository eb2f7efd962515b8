#include "geometry/brep_geometry_grammar.h"

#include <algorithm>
#include <cmath>

namespace advlayers {

BrepGeometryGrammar::Span BrepGeometryGrammar::curve(int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  const Span closed{0.0, 2.0 * M_PI, true};
  const int type = in_.integer(1, 9, "a curve is of no known type");
  switch (type) {
    case 1:
      in_.reals(d);
      direction(d);
      return {};
    case 2:
      placement(d);
      radius();
      return closed;
    case 3:
      placement(d);
      descending_radii();
      return closed;
    case 4:
    case 5:
      placement(d);
      radius();
      if (type == 5) radius();
      return {};
    case 6:
      return bezier(d);
    case 7:
      return bspline(d);
    case 8: {
      const double first = in_.real(), last = in_.real();
      return trimmed(curve(dimension), first, last);
    }
    default:
      in_.real();
      if (dimension == 3) direction(d);
      return curve(dimension);
  }
}

std::array<BrepGeometryGrammar::Span, 2> BrepGeometryGrammar::surface() {
  const Span closed{0.0, 2.0 * M_PI, true};
  const int type = in_.integer(1, 11, "a surface is of no known type");
  switch (type) {
    case 1:
      placement_with_axis();
      return {};
    case 2:
    case 3:
    case 4:
    case 5:
      placement_with_axis();
      radius();
      if (type == 3) half_angle();
      if (type == 5) radius();
      return {closed, type == 5 ? closed : type == 4 ? Span{-M_PI / 2, M_PI / 2, false} : Span{}};
    case 6:
      direction(3);
      return {curve(3), Span{}};
    case 7:
      in_.reals(3);
      direction(3);
      return {closed, curve(3)};
    case 8:
      return bezier_surface();
    case 9:
      return bspline_surface();
    case 10: {
      const double u1 = in_.real(), u2 = in_.real(), v1 = in_.real(), v2 = in_.real();
      const std::array<Span, 2> basis = surface();
      return {trimmed(basis[0], u1, u2), trimmed(basis[1], v1, v2)};
    }
    default:
      in_.real();
      return surface();
  }
}

BrepGeometryGrammar::Direction BrepGeometryGrammar::direction(std::size_t dimension) {
  Direction d;
  d.x = in_.real();
  d.y = in_.real();
  if (dimension == 3) d.z = in_.real();
  in_.expect(std::hypot(d.x, d.y, d.z) > 1e-300, "a direction is null");
  return d;
}

void BrepGeometryGrammar::expect_apart(const Direction& a, const Direction& b) {
  const double cross =
      std::hypot(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  const double size = std::hypot(a.x, a.y, a.z) * std::hypot(b.x, b.y, b.z);
  in_.expect(cross > 1e-9 * size, "two axes are parallel");
}

void BrepGeometryGrammar::placement(std::size_t dimension) {
  if (dimension == 3) return placement_with_axis();
  in_.reals(2);
  const Direction x = direction(2), y = direction(2);
  expect_apart(x, y);
}

void BrepGeometryGrammar::placement_with_axis() {
  in_.reals(3);
  const Direction axis = direction(3), x = direction(3), y = direction(3);
  expect_apart(axis, x);
  expect_apart(x, y);
}

double BrepGeometryGrammar::radius() {
  const double r = in_.real();
  in_.expect(r >= 0.0, "a radius is negative");
  return r;
}

void BrepGeometryGrammar::descending_radii() {
  const double major = radius(), minor = radius();
  in_.expect(major >= minor, "the radii of an ellipse are swapped");
}

void BrepGeometryGrammar::half_angle() {
  const double angle = std::abs(in_.real());
  in_.expect(angle > 0.0 && angle < M_PI / 2, "the angle of a cone is impossible");
}

BrepGeometryGrammar::Span BrepGeometryGrammar::trimmed(const Span& basis, double first,
                                                       double last) {
  const double slack = 1e-6;
  const bool inside = basis.periodic || (std::min(first, last) >= basis.first - slack &&
                                         std::max(first, last) <= basis.last + slack);
  in_.expect(first != last && inside, "a range is empty or leaves its curve");
  return {std::min(first, last), std::max(first, last), false};
}

int BrepGeometryGrammar::degree() {
  return in_.integer(1, 25, "the degree of a curve is impossible");
}

void BrepGeometryGrammar::poles(int count, std::size_t dimension, bool rational) {
  for (int i = 0; i < count; ++i) {
    in_.reals(dimension);
    if (rational) in_.expect(in_.real() > 0.0, "a weight is not positive");
  }
}

BrepGeometryGrammar::Span BrepGeometryGrammar::bezier(std::size_t dimension) {
  const bool rational = in_.flag();
  poles(degree() + 1, dimension, rational);
  return {0.0, 1.0, false};
}

BrepGeometryGrammar::Span BrepGeometryGrammar::bspline(std::size_t dimension) {
  const bool rational = in_.flag(), periodic = in_.flag();
  const int p = degree(), n = in_.count(2), k = in_.count(2);
  poles(n, dimension, rational);
  return knots(k, n, p, periodic);
}

BrepGeometryGrammar::Span BrepGeometryGrammar::knots(int count, int poles, int p, bool periodic) {
  Span span;
  span.periodic = periodic;
  long total = 0, last = 0;
  double previous = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    const double knot = in_.real();
    in_.expect(knot > previous, "knots do not increase");
    const bool end = i == 0 || i + 1 == count;
    last = in_.integer(1, end && !periodic ? p + 1 : p, "the multiplicity of a knot is impossible");
    total += last;
    if (i == 0) span.first = knot;
    span.last = previous = knot;
  }
  in_.expect(total - (periodic ? last : p + 1L) == poles, "poles and knots do not match");
  return span;
}

std::array<BrepGeometryGrammar::Span, 2> BrepGeometryGrammar::bezier_surface() {
  const bool u_rational = in_.flag(), v_rational = in_.flag();
  const int p = degree(), q = degree();
  poles((p + 1) * (q + 1), 3, u_rational || v_rational);
  const Span unit{0.0, 1.0, false};
  return {unit, unit};
}

std::array<BrepGeometryGrammar::Span, 2> BrepGeometryGrammar::bspline_surface() {
  const bool u_rational = in_.flag(), v_rational = in_.flag();
  const bool u_periodic = in_.flag(), v_periodic = in_.flag();
  const int p = degree(), q = degree();
  const int nu = in_.count(2), nv = in_.count(2), ku = in_.count(2), kv = in_.count(2);
  for (int i = 0; i < nu; ++i) poles(nv, 3, u_rational || v_rational);
  const Span u = knots(ku, nu, p, u_periodic);
  return {u, knots(kv, nv, q, v_periodic)};
}

}  // namespace advlayers
