#include "sizing/local_sizes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/evaluator.h"

namespace advlayers {
namespace {

constexpr int kSamples = 8;              // pieces of an edge
constexpr double kFinestFace = 0.1;      // of the size
constexpr double kFinestOutline = 1e-3;  // of the size
constexpr double kSmall = 0.25;          // extent of an outline over that of its face
// Around one outline, in elements over the extent of a face; several share twice as many.
constexpr double kAround = 12.0;
constexpr double kAroundAll = 2.0 * kAround;
constexpr double kSameCurvature = 1e-3;  // of the greatest, or of one turn over the edge

class LocalSizes {
 public:
  LocalSizes(const Model& model, const Settings& settings)
      : model_(model), settings_(settings), evaluator_(model) {}

  std::vector<SizeSpec> run() {
    for (std::size_t f = 0; f < model_.faces().size(); ++f) {
      const auto& meshed = settings_.faces;
      const bool chosen =
          meshed.empty() || std::find(meshed.begin(), meshed.end(), FaceId(f)) != meshed.end();
      if (chosen && model_.faces()[f].defect.empty()) add_face(FaceId(f));
    }
    return std::move(found_);
  }

 private:
  void add_face(FaceId id) {
    const Face& face = model_.face(id);
    std::vector<double> extents;  // by loop
    double extent = std::sqrt(face.area);
    for (const auto& loop : face.loops) {
      extents.push_back(extent_of(loop));
      extent = std::max(extent, extents.back());
    }
    const double size = std::max(extent / settings_.cells_across, kFinestFace * settings_.size);
    if (size < settings_.size) {
      found_.emplace_back();
      found_.back().faces = {id};
      found_.back().size = size;
    }
    if (face.kind == SurfaceKind::kPlane) add_outlines(face, extents, extent);
  }

  void add_outlines(const Face& face, const std::vector<double>& extents, double extent) {
    std::vector<std::size_t> small;
    for (std::size_t k = 0; k < extents.size(); ++k) {
      if (extents[k] > 0.0 && extents[k] < kSmall * extent && is_free_form(face.loops[k])) {
        small.push_back(k);
      }
    }
    for (const std::size_t k : small) {
      const double part = std::min(kAround, kAroundAll / static_cast<double>(small.size()));
      const double around = std::max(1.0, part) * settings_.cells_across;
      SizeSpec spec;
      double length = 0.0;
      for (const CoEdge& coedge : face.loops[k]) {
        if (coedge.degenerate) continue;
        spec.edges.push_back(coedge.edge);
        length += model_.edge(coedge.edge).length;
      }
      spec.size = std::max(length / around, kFinestOutline * settings_.size);
      if (*spec.size < settings_.size) found_.push_back(std::move(spec));
    }
  }

  double extent_of(const std::vector<CoEdge>& loop) {
    Eigen::AlignedBox3d box;
    for (const CoEdge& coedge : loop) {
      if (coedge.degenerate) continue;
      const Edge& edge = model_.edge(coedge.edge);
      for (int k = 0; k <= kSamples; ++k) {
        box.extend(evaluator_.edge_point(coedge.edge,
                                         edge.first + (edge.last - edge.first) * k / kSamples));
      }
    }
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
  }

  bool is_free_form(const std::vector<CoEdge>& loop) {
    return std::any_of(loop.begin(), loop.end(), [this](const CoEdge& coedge) {
      return !coedge.degenerate && !has_one_curvature(coedge.edge);
    });
  }

  bool has_one_curvature(EdgeId id) {
    const Edge& edge = model_.edge(id);
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (int k = 0; k <= kSamples; ++k) {
      const double inner = (k + 0.5) / (kSamples + 1);
      const double curvature =
          evaluator_.edge_curvature(id, edge.first + (edge.last - edge.first) * inner);
      least = std::min(least, curvature);
      most = std::max(most, curvature);
    }
    return most - least <= kSameCurvature * std::max(most, 1.0 / edge.length);
  }

  const Model& model_;
  const Settings& settings_;
  Evaluator evaluator_;
  std::vector<SizeSpec> found_;
};

}  // namespace

std::vector<SizeSpec> local_sizes(const Model& model, const Settings& settings) {
  if (settings.cells_across <= 0) return {};
  return LocalSizes(model, settings).run();
}

Settings with_local_sizes(const Model& model, Settings settings) {
  std::vector<SizeSpec> sizes = local_sizes(model, settings);
  std::move(settings.sizes.begin(), settings.sizes.end(), std::back_inserter(sizes));
  settings.sizes = std::move(sizes);
  return settings;
}

}  // namespace advlayers
