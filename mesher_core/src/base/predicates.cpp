#include "base/predicates.h"

#include <array>
#include <cmath>
#include <limits>

namespace advlayers {
namespace {

constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;  // of one rounding
constexpr double kOrientBound = (3 + 16 * kHalfUlp) * kHalfUlp;     // Shewchuk, Adaptive Precision
constexpr double kInCircleBound = (10 + 96 * kHalfUlp) * kHalfUlp;  // the same

// A sum of doubles that do not overlap, smallest first: its sign is the sign of its last term.
class Expansion {
 public:
  void add_product(double x, double y) {
    const double high = x * y;
    add(std::fma(x, y, -high));
    add(high);
  }

  int sign() const {
    for (int i = size_ - 1; i >= 0; --i) {
      if (terms_[i] != 0) return terms_[i] > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  void add(double value) {
    for (int i = 0; i < size_; ++i) {
      const double sum = value + terms_[i];
      const double virtual_term = sum - value;
      terms_[i] = (value - (sum - virtual_term)) + (terms_[i] - virtual_term);
      value = sum;
    }
    terms_[size_++] = value;
  }

  std::array<double, 12> terms_{};
  int size_ = 0;
};

int exact_orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  Expansion det;
  det.add_product(a.x(), b.y());
  det.add_product(-a.y(), b.x());
  det.add_product(b.x(), c.y());
  det.add_product(-b.y(), c.x());
  det.add_product(c.x(), a.y());
  det.add_product(-c.y(), a.x());
  return det.sign();
}

}  // namespace

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = kOrientBound * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exact_orient2d(a, b, c);
}

bool surely_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 ad = a - d, bd = b - d, cd = c - d;
  const double bc = bd.x() * cd.y(), cb = cd.x() * bd.y();
  const double ca = cd.x() * ad.y(), ac = ad.x() * cd.y();
  const double ab = ad.x() * bd.y(), ba = bd.x() * ad.y();
  const double a2 = ad.squaredNorm(), b2 = bd.squaredNorm(), c2 = cd.squaredNorm();
  const double det = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
  const double magnitude = a2 * (std::abs(bc) + std::abs(cb)) + b2 * (std::abs(ca) + std::abs(ac)) +
                           c2 * (std::abs(ab) + std::abs(ba));
  return det > kInCircleBound * magnitude;
}

}  // namespace advlayers
