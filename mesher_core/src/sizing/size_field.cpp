#include "sizing/size_field.h"

#include <algorithm>
#include <cmath>

#include "sizing/initial_nodes.h"

namespace advlayers {
namespace {

// Of the size: an initial mesh this much finer is meant to be, a lesser difference is its noise.
constexpr double kClearlyFiner = 0.8;

}  // namespace

SizeField::SizeField(const Settings& settings)
    : size_(settings.size),
      slope_(std::log(settings.size_growth)),
      refinements_(settings.refinements),
      initial_(settings.initial_nodes) {
  for (const SizeSpec& spec : settings.sizes) {
    for (const FaceId f : spec.faces) {
      if (spec.size) faces_[f] = *spec.size;
    }
    for (const EdgeId e : spec.edges) edges_[e] = spec;
  }
}

double SizeField::of_face(FaceId face) const {
  const auto found = faces_.find(face);
  return found == faces_.end() ? size_ : found->second;
}

double SizeField::of_edge(EdgeId edge, const std::vector<FaceId>& beside) const {
  const SizeSpec* spec = edge_spec(edge);
  if (spec != nullptr && spec->size) return *spec->size;
  if (beside.empty()) return size_;
  double least = of_face(beside.front());
  for (const FaceId f : beside) least = std::min(least, of_face(f));
  return least;
}

const SizeSpec* SizeField::edge_spec(EdgeId edge) const {
  const auto found = edges_.find(edge);
  return found == edges_.end() ? nullptr : &found->second;
}

double SizeField::near(const Vec3& p, FaceId face, double size) const {
  if (initial_ != nullptr) {
    const double spacing = initial_->spacing(face, p);
    if (spacing < kClearlyFiner * size) size = spacing;
  }
  for (const Refinement& r : refinements_) {
    const double beyond = std::max(0.0, r.distance(p) - r.radius);
    size = std::min(size, r.size + slope_ * beyond);
  }
  return size;
}

}  // namespace advlayers
