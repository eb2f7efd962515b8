// Geometric decisions whose sign is exact: a floating-point filter first, expansions of doubles
// where it cannot decide (Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997). Exact as
// long as no product of two coordinates over- or underflows.
#pragma once

#include "base/types.h"

namespace advlayers {

// +1 where a, b, c turn counter-clockwise, -1 clockwise, 0 on one line.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

// Whether d lies inside the circle through a, b, c (counter-clockwise) for certain: false where
// rounding leaves it open, so that flips that follow it end.
bool surely_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

}  // namespace advlayers
