#include "sizing/wall_spacing.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "geometry/model.h"
#include "sizing/schema.h"

namespace advlayers {
namespace {

[[noreturn]] void refuse(const WallSpec& spec, const Sentence& why) {
  if (spec.edges.empty()) throw InvalidInput("{}: {}", "walls", why);
  throw InvalidInput("{}: {} ({})", "walls", why, edge_name(spec.edges.front()));
}

void check_height_rules(const WallSpec& spec) {
  const int given = (spec.first_height || spec.end_height ? 1 : 0) + (spec.aspect_ratio ? 1 : 0) +
                    (spec.turning_angle ? 1 : 0);
  if (given > 1) {
    refuse(spec, Sentence("{}, {} and {} exclude each other", "first_height", "aspect_ratio",
                          "turning_angle"));
  }
  if (spec.thickness && spec.thickness_share) {
    refuse(spec, Sentence("{} and {} exclude each other", "thickness", "thickness_share"));
  }
  const bool thick = spec.thickness || spec.thickness_share;
  if (thick && (spec.end_height || spec.aspect_ratio || spec.turning_angle)) {
    refuse(spec, Sentence("thickness needs a first height that is the same along the wall"));
  }
}

int layers_for(const WallSpec& spec, double height, double growth, double thickness) {
  if (thickness < height * (1.0 - 1e-9)) {
    refuse(spec,
           Sentence("thickness {} mm is less than the first height {} mm", thickness, height));
  }
  const double layers = growth - 1.0 < 1e-12
                            ? thickness / height
                            : std::log1p(thickness * (growth - 1.0) / height) / std::log(growth);
  if (!(layers < kMostLayers)) refuse(spec, Sentence("thickness would take {} layers", layers));
  return std::max(1, static_cast<int>(std::lround(layers)));
}

double growth_for(const WallSpec& spec, double height, int layers, double thickness) {
  if (thickness < height * layers * (1.0 - 1e-9) ||
      thickness > thickness_of(height, kMostGrowth, layers)) {
    refuse(spec, Sentence("no growth from 1 to {} makes {} layers from {} mm {} mm thick",
                          kMostGrowth, layers, height, thickness));
  }
  double low = 1.0, high = kMostGrowth;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (thickness_of(height, middle, layers) < thickness ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double thickness_of(double first_height, double growth, int layers) {
  if (growth - 1.0 < 1e-12) return first_height * layers;
  return first_height * std::expm1(layers * std::log(growth)) / (growth - 1.0);
}

// The thickness [mm] that is asked for, of the whole mesh's size where no edge tells it.
WallSpacing spacing_of(const WallSpec& given, const Settings& settings) {
  check_height_rules(given);
  WallSpec spec = given;
  if (spec.thickness_share) spec.thickness = *spec.thickness_share * settings.size;
  WallSpacing spacing;
  spacing.first_height = spec.first_height.value_or(settings.first_height);
  spacing.growth = spec.growth.value_or(settings.growth);
  if (spec.layers) {
    spacing.layers = *spec.layers > 0 ? *spec.layers : kUntilClosed;
  } else if (settings.end == EndOfGrowth::kLayers) {
    spacing.layers = settings.layers;
  }
  spacing.rule = {spec.end_height, spec.aspect_ratio, spec.turning_angle};
  if (!spec.thickness) return spacing;
  if (!spec.layers) {
    spacing.layers = layers_for(spec, spacing.first_height, spacing.growth, *spec.thickness);
  } else if (*spec.layers == 0) {
    refuse(spec,
           Sentence("layers 0 grows until the fronts close, which leaves no choice of thickness"));
  } else if (spec.first_height && spec.growth) {
    refuse(spec, Sentence("{}, {}, {} and {} are one too many: leave one out", "first_height",
                          "growth", "layers", "thickness"));
  } else if (spec.first_height) {
    spacing.growth = growth_for(spec, spacing.first_height, *spec.layers, *spec.thickness);
  } else {
    spacing.first_height = *spec.thickness / thickness_of(1.0, spacing.growth, *spec.layers);
  }
  return spacing;
}

double first_height_at(const WallSpacing& spacing, const WallPlace& place, double most) {
  const HeightRule& rule = spacing.rule;
  if (rule.end_height) {
    return spacing.first_height + place.part * (*rule.end_height - spacing.first_height);
  }
  if (rule.aspect_ratio) return place.segment / *rule.aspect_ratio;
  if (rule.turning_angle) {
    const double angle = *rule.turning_angle * kDegree;
    return place.curvature * most > angle ? angle / place.curvature : most;
  }
  return spacing.first_height;
}

}  // namespace advlayers
