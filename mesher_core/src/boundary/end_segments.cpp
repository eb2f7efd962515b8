#include "boundary/end_segments.h"

#include <algorithm>
#include <cmath>

#include "boundary/divide_length.h"

namespace advlayers {
namespace {

using Shares = std::vector<double>;  // ends of segments, of the length, from 0 to 1

constexpr int kBisections = 100;     // beyond the digits of a double
constexpr int kCorrections = 30;     // of the slopes at the ends: their steps come out to rounding
constexpr double kEven = 1e-6;       // of a steepness from one: the steps are even
constexpr double kSteepest = 700.0;  // sinh of more is out of range
constexpr double kLargestRatio = 1e3;  // of a step to the one before

// x in (0, high) with f(x) = y, f monotonous.
template <class Function>
double solve(double y, double high, const Function& f) {
  double low = 0.0;
  const bool rising = f(0.99 * high) > f(0.01 * high);
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) < y) == rising ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Where the steps are `a` and `b` times even ones at the two ends.
Shares vinokur(std::size_t n, double a, double b) {
  const double skew = std::sqrt(a / b), steepness = 1.0 / std::sqrt(a * b);
  const bool steep = steepness > 1.0 + kEven, slack = steepness < 1.0 - kEven;
  double turn = 0.0;
  if (steep) turn = solve(steepness, kSteepest, [](double x) { return std::sinh(x) / x; });
  if (slack) turn = solve(steepness, M_PI, [](double x) { return std::sin(x) / x; });
  Shares shares;
  for (std::size_t k = 0; k <= n; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(n);
    double u = x;
    if (steep) u = 0.5 * (1.0 + std::tanh(turn * (x - 0.5)) / std::tanh(0.5 * turn));
    if (slack) u = 0.5 * (1.0 + std::tan(turn * (x - 0.5)) / std::tan(0.5 * turn));
    shares.push_back(u / (1.0 / skew + (1.0 - 1.0 / skew) * u));
  }
  return shares;
}

// Vinokur's are the slopes of the curve at its ends, not its first and last step: corrections make
// them those that were asked for.
Shares smooth(std::size_t n, double first, double last) {
  double a = first * static_cast<double>(n), b = last * static_cast<double>(n);
  Shares shares = vinokur(n, a, b);
  for (int i = 0; i < kCorrections; ++i) {
    a *= first / shares[1];
    b *= last / (1.0 - shares[n - 1]);
    shares = vinokur(n, a, b);
  }
  return shares;
}

// From `first` on, each step as many times the one before.
Shares geometric(std::size_t n, double first) {
  const auto sum = [&](double ratio) {
    return std::abs(ratio - 1.0) < 1e-12
               ? first * static_cast<double>(n)
               : first * std::expm1(static_cast<double>(n) * std::log(ratio)) / (ratio - 1.0);
  };
  const double ratio = solve(1.0, kLargestRatio, [&](double x) { return sum(x); });
  Shares shares{0.0};
  double step = first;
  for (std::size_t k = 0; k < n; ++k, step *= ratio) shares.push_back(shares.back() + step);
  for (double& share : shares) share /= shares.back();
  return shares;
}

Shares turned(Shares shares) {
  std::reverse(shares.begin(), shares.end());
  for (double& share : shares) share = 1.0 - share;
  return shares;
}

Shares both_geometric(std::size_t n, double first, double last) {
  const std::size_t half = n / 2;
  const Shares up = geometric(half, 2.0 * first), down = turned(geometric(n - half, 2.0 * last));
  Shares shares;
  for (const double share : up) shares.push_back(0.5 * share);
  for (std::size_t k = 1; k < down.size(); ++k) shares.push_back(0.5 + 0.5 * down[k]);
  return shares;
}

Shares constant(std::size_t n, double first, double last) {
  Shares shares{0.0};
  for (std::size_t k = 1; k < n; ++k) {
    const double part = static_cast<double>(k - 1) / static_cast<double>(n - 2);
    shares.push_back(first + part * (1.0 - first - last));
  }
  shares.push_back(1.0);
  return shares;
}

// An end that is not given: of a constant distribution as long as the rest, else as the size.
Shares shares_of(std::size_t n, double size, const EndSegments& ends, double length) {
  const double even = 1.0 / static_cast<double>(n);
  const auto held = [&](double end) { return std::min(end / length, even); };
  if (n == 1) return {0.0, 1.0};
  if (n == 2) return {0.0, ends.first ? held(*ends.first) : 1.0 - held(*ends.last), 1.0};
  if (ends.distribution == Distribution::kConstant) {
    const double given =
        (ends.first ? held(*ends.first) : 0.0) + (ends.last ? held(*ends.last) : 0.0);
    const std::size_t open = n - (ends.first ? 1 : 0) - (ends.last ? 1 : 0);
    const double rest = (1.0 - given) / static_cast<double>(open);
    return constant(n, ends.first ? held(*ends.first) : rest, ends.last ? held(*ends.last) : rest);
  }
  if (ends.distribution == Distribution::kGeometric) {
    if (!ends.last) return geometric(n, held(*ends.first));
    if (!ends.first) return turned(geometric(n, held(*ends.last)));
    return both_geometric(n, held(*ends.first), held(*ends.last));
  }
  const double open = std::min(size / length, 1.0);
  return smooth(n, ends.first ? held(*ends.first) : open, ends.last ? held(*ends.last) : open);
}

double longest(const Shares& shares) {
  double most = 0.0;
  for (std::size_t k = 1; k < shares.size(); ++k) most = std::max(most, shares[k] - shares[k - 1]);
  return most;
}

}  // namespace

std::vector<double> cut_with_ends(double length, double size, const EndSegments& ends) {
  auto n = static_cast<std::size_t>(ends.segments);
  const bool given = ends.first || ends.last;
  if (n == 0) {
    n = static_cast<std::size_t>(std::max(1.0, std::ceil(length / size - kEvenSpread)));
    const double shortest = std::min({size, ends.first.value_or(size), ends.last.value_or(size)});
    const auto most = static_cast<std::size_t>(length / shortest) + 2;
    while (given && n < most &&
           (n == 2 || longest(shares_of(n, size, ends, length)) * length > size)) {
      n += 1 + n / 20;
    }
  }
  Shares cuts;
  if (given) {
    cuts = shares_of(n, size, ends, length);
  } else {
    for (std::size_t k = 0; k <= n; ++k) {
      cuts.push_back(static_cast<double>(k) / static_cast<double>(n));
    }
  }
  for (double& cut : cuts) cut *= length;
  cuts.back() = length;
  return cuts;
}

}  // namespace advlayers
