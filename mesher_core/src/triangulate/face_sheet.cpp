#include "triangulate/face_sheet.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr int kScaleSamples = 4;  // per direction
// Two passages of the boundary through one node are one point of the sheet if they are this much
// nearer to each other than the next boundary point.
constexpr double kSamePoint = 1e-3;
constexpr double kPoleSector = M_PI / 3;  // [rad] of triangles about a pole
constexpr int kPoleSamples = 24;          // to measure the angle about a pole

Vec2 sheet_scale(Evaluator& evaluator, FaceId id) {
  const Face& face = evaluator.model().face(id);
  double along_u = 0, along_v = 0;
  for (int i = 0; i < kScaleSamples; ++i) {
    for (int j = 0; j < kScaleSamples; ++j) {
      const double s = (i + 0.5) / kScaleSamples, t = (j + 0.5) / kScaleSamples;
      const SurfaceFrame frame = evaluator.frame(id, face.u_min + s * (face.u_max - face.u_min),
                                                 face.v_min + t * (face.v_max - face.v_min));
      along_u += frame.du.norm();
      along_v += frame.dv.norm();
    }
  }
  constexpr double kCount = kScaleSamples * kScaleSamples;  // of samples in both directions
  const double u = along_u > 0 ? along_u / kCount : 1.0, v = along_v > 0 ? along_v / kCount : 1.0;
  return {face.reversed ? -u : u, v};
}

class SheetBuilder {
 public:
  SheetBuilder(Evaluator& evaluator, const Discretization& boundary, FaceId face,
               const std::vector<EdgeId>& inner)
      : evaluator_(evaluator), boundary_(boundary), inner_(inner) {
    sheet_.face = face;
    sheet_.scale = sheet_scale(evaluator, face);
  }

  FaceSheet build() {
    const Face& face = evaluator_.model().face(sheet_.face);
    for (const auto& loop : face.loops) {
      ring_.clear();
      for (const CoEdge& coedge : loop) add_coedge(coedge);
      close_ring();
    }
    return std::move(sheet_);
  }

 private:
  // The start of a boundary segment.
  struct Start {
    Vec2 point;
    NodeId node;
    const CoEdge* coedge;
  };

  void add_coedge(const CoEdge& coedge) {
    const EdgeNodes& cut = boundary_.edges[coedge.edge.index()];
    if (coedge.degenerate) {
      add_pole(coedge, cut.nodes.front());
      return;
    }
    const std::size_t count = cut.nodes.size();
    for (std::size_t k = 0; k + 1 < count; ++k) {
      const std::size_t i = coedge.forward ? k : count - 1 - k;
      const Vec2 uv = evaluator_.edge_uv(sheet_.face, coedge, cut.params[i]);
      ring_.push_back({sheet_.from_uv(uv), cut.nodes[i], &coedge});
    }
  }

  // A pole is a whole segment of the sheet: one start per sector of triangles about it.
  void add_pole(const CoEdge& coedge, NodeId node) {
    const Edge& edge = evaluator_.model().edge(coedge.edge);
    const double begin = coedge.forward ? edge.first : edge.last;
    const double end = coedge.forward ? edge.last : edge.first;
    const Vec2 p = sheet_.from_uv(evaluator_.edge_uv(sheet_.face, coedge, begin));
    const Vec2 q = sheet_.from_uv(evaluator_.edge_uv(sheet_.face, coedge, end));
    const int sectors = std::max(2, static_cast<int>(std::ceil(pole_angle(p, q) / kPoleSector)));
    for (int k = 0; k < sectors; ++k) {
      ring_.push_back({p + (q - p) * (static_cast<double>(k) / sectors), node, &coedge});
    }
  }

  // The angle [rad] in space that the face takes up about a pole, which is p -> q in the sheet.
  double pole_angle(const Vec2& p, const Vec2& q) {
    const Vec2 inward(-(q - p).y(), (q - p).x());
    const Vec2 inward_uv = sheet_.to_uv(inward);
    double angle = 0;
    Vec3 last = Vec3::Zero();
    for (int k = 0; k <= kPoleSamples; ++k) {
      const Vec2 uv = sheet_.to_uv(p + (q - p) * (static_cast<double>(k) / kPoleSamples));
      const SurfaceFrame frame = evaluator_.frame(sheet_.face, uv.x(), uv.y());
      const Vec3 direction = frame.du * inward_uv.x() + frame.dv * inward_uv.y();
      if (k > 0) angle += std::atan2(last.cross(direction).norm(), last.dot(direction));
      last = direction;
    }
    return angle;
  }

  // Where the boundary runs back along an edge that has the same nodes as the one it came by, it
  // encloses nothing.
  void cut_spikes() {
    const auto is_spike = [this](std::size_t i) {
      const Start &before = ring_[(i + ring_.size() - 1) % ring_.size()], &at = ring_[i];
      const bool pole = before.coedge->degenerate || at.coedge->degenerate;
      return !pole && before.coedge->edge != at.coedge->edge &&
             before.node == ring_[(i + 1) % ring_.size()].node;
    };
    for (std::size_t i = 0; i < ring_.size() && ring_.size() > 1;) {
      if (!is_spike(i)) {
        ++i;
        continue;
      }
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i > 0 ? i - 1 : ring_.size() - 1));
      i = i > 1 ? i - 2 : 0;
    }
  }

  void close_ring() {
    cut_spikes();
    const std::size_t count = ring_.size();
    std::vector<int> index(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double to_next = (ring_[(k + 1) % count].point - ring_[k].point).norm();
      index[k] = point_of(ring_[k], kSamePoint * to_next);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const EdgeId edge = ring_[k].coedge->edge;
      const bool inner = std::binary_search(inner_.begin(), inner_.end(), edge);
      sheet_.segments.push_back(
          {index[k], index[(k + 1) % count], edge, inner, ring_[k].coedge->degenerate});
    }
  }

  int point_of(const Start& start, double tolerance) {
    std::vector<int>& known = points_of_node_[start.node];
    for (const int p : known) {
      if ((sheet_.points[static_cast<std::size_t>(p)] - start.point).norm() <= tolerance) return p;
    }
    sheet_.points.push_back(start.point);
    sheet_.nodes.push_back(start.node);
    known.push_back(static_cast<int>(sheet_.points.size()) - 1);
    return known.back();
  }

  Evaluator& evaluator_;
  const Discretization& boundary_;
  const std::vector<EdgeId>& inner_;
  FaceSheet sheet_;
  std::vector<Start> ring_;
  std::unordered_map<NodeId, std::vector<int>> points_of_node_;
};

}  // namespace

FaceSheet lay_out_face(Evaluator& evaluator, const Discretization& boundary, FaceId face,
                       const std::vector<EdgeId>& inner) {
  const Sentence& defect = evaluator.model().face(face).defect;
  if (!defect.empty()) throw GeometryError("{} cannot be meshed: {}", face_name(face), defect);
  return SheetBuilder(evaluator, boundary, face, inner).build();
}

}  // namespace advlayers
