// Where a search for a least value by golden sections divides its interval.
#pragma once

namespace advlayers {

inline constexpr double kGoldenRatio = 0.6180339887498949;  // (sqrt(5) - 1) / 2

}  // namespace advlayers
