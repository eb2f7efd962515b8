#include "geometry/evaluator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "geometry/edge_curve.h"
#include "geometry/face_domain.h"
#include "geometry/face_samples.h"
#include "geometry/face_surface.h"
#include "geometry/geodesic_walk.h"
#include "geometry/occt_shape.h"

namespace advlayers {

namespace {

// What was made of some of the model's many faces or edges, page by page: every patch has an
// evaluator, and with a place for each face in each of them thousands of faces would take
// gigabytes.
template <class Made>
class Slots {
 public:
  void resize(std::size_t count) { pages_.resize((count + kPage - 1) / kPage); }
  std::unique_ptr<Made>& operator[](std::size_t i) {
    std::unique_ptr<Page>& page = pages_[i / kPage];
    if (!page) page = std::make_unique<Page>();
    return (*page)[i % kPage];
  }

 private:
  static constexpr std::size_t kPage = 64;  // slots made at once
  using Page = std::array<std::unique_ptr<Made>, kPage>;
  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace

struct Evaluator::Impl {
  explicit Impl(const Model& m) : model(&m) {
    surfaces.resize(m.faces().size());
    domains.resize(m.faces().size());
    samples.resize(m.faces().size());
    curves.resize(m.edges().size());
  }

  const FaceSurface& surface(FaceId f) {
    std::unique_ptr<FaceSurface>& slot = surfaces[f.index()];
    if (!slot) {
      slot = translated("face", [&] {
        return std::make_unique<FaceSurface>(model->shape().face(f), model->face(f));
      });
    }
    return *slot;
  }

  EdgeCurve& curve(EdgeId e) {
    std::unique_ptr<EdgeCurve>& slot = curves[e.index()];
    if (!slot) {
      const Edge& edge = model->edge(e);
      if (!(edge.last > edge.first)) throw GeometryError("{} has no curve", edge_name(e));
      const Vec3 pole = edge.start.valid() ? model->vertex(edge.start).xyz : pole_of(e);
      slot = translated(
          "edge", [&] { return std::make_unique<EdgeCurve>(model->shape().edge(e), edge, pole); });
    }
    return *slot;
  }

  // Where a degenerate edge without a vertex lies: on any face that has it.
  Vec3 pole_of(EdgeId e) {
    for (const FaceId f : model->edge(e).faces) {
      const Pcurve* pcurve = model->shape().pcurve(f, e, 0);
      if (!pcurve) continue;
      const Vec2 uv = pcurve->at(model->edge(e).first, model->edge(e));
      return surface(f).value(uv.x(), uv.y());
    }
    return Vec3::Zero();
  }

  Vec2 edge_uv(FaceId f, const CoEdge& coedge, double t) {
    const Edge& edge = model->edge(coedge.edge);
    const Pcurve* pcurve = model->shape().pcurve(f, coedge.edge, coedge.pcurve);
    if (!pcurve)
      throw GeometryError("{} has no (u, v) on {}", edge_name(coedge.edge), face_name(f));
    Vec2 uv = pcurve->at(t, edge) + coedge.uv_shift;
    if (coedge.degenerate) return uv;
    const FaceSurface& s = surface(f);
    const Vec3 xyz = curve(coedge.edge).value(t);
    const double stray = (s.value(uv.x(), uv.y()) - xyz).norm();
    if (stray <= std::max(edge.tolerance, model->face(f).tolerance)) return uv;
    double u = uv.x(), v = uv.y();
    Vec3 foot;
    if (s.project(xyz, u, v, foot) && (foot - xyz).norm() < stray) uv = {u, v};
    return uv;
  }

  const FaceDomain& domain(FaceId f) {
    std::unique_ptr<FaceDomain>& slot = domains[f.index()];
    if (!slot) {
      const Face& face = model->face(f);
      if (!face.defect.empty()) throw GeometryError("{}: {}", face_name(f), face.defect);
      slot = std::make_unique<FaceDomain>(
          *model, face, [&](const CoEdge& coedge, double t) { return edge_uv(f, coedge, t); });
    }
    return *slot;
  }

  const FaceSamples& sampled(FaceId f) {
    std::unique_ptr<FaceSamples>& slot = samples[f.index()];
    if (!slot) slot = std::make_unique<FaceSamples>(model->face(f), surface(f), domain(f));
    return *slot;
  }

  const Model* model;
  Slots<FaceSurface> surfaces;
  Slots<FaceDomain> domains;
  Slots<FaceSamples> samples;
  Slots<EdgeCurve> curves;
};

Evaluator::Evaluator(const Model& model) : impl_(std::make_unique<Impl>(model)) {}
Evaluator::~Evaluator() = default;
Evaluator::Evaluator(Evaluator&&) noexcept = default;

const Model& Evaluator::model() const { return *impl_->model; }

SurfaceFrame Evaluator::frame(FaceId face, double u, double v) {
  return translated("surface", [&] { return impl_->surface(face).frame(u, v); });
}

double Evaluator::max_curvature(FaceId face, double u, double v) {
  return translated("surface", [&] { return impl_->surface(face).max_curvature(u, v); });
}

bool Evaluator::project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot) {
  foot = seed;
  return translated(
      "surface", [&] { return impl_->surface(seed.face).project(xyz, foot.u, foot.v, foot.xyz); });
}

SurfacePoint Evaluator::closest(FaceId face, const Vec3& xyz) {
  return translated("surface", [&] {
    const FaceSamples& samples = impl_->sampled(face);
    return samples.closest(face, xyz, [&](const CoEdge& coedge, double t) {
      const Vec2 uv = impl_->edge_uv(face, coedge, t);
      return SurfacePoint{face, uv.x(), uv.y(), impl_->curve(coedge.edge).value(t)};
    });
  });
}

bool Evaluator::inside(FaceId face, double u, double v) {
  return translated("face", [&] { return impl_->domain(face).contains({u, v}); });
}

bool Evaluator::walk(const SurfacePoint& from, double length, Vec3& heading, SurfacePoint& to) {
  return translated("surface", [&] {
    GeodesicWalk walk(impl_->surface(from.face), impl_->model->face(from.face).kind, from, heading);
    const bool arrived = walk.advance(length);
    to = walk.point();
    heading = walk.heading();
    return arrived;
  });
}

Vec3 Evaluator::edge_point(EdgeId edge, double t) {
  return translated("edge", [&] { return impl_->curve(edge).value(t); });
}

Vec3 Evaluator::edge_tangent(EdgeId edge, double t) {
  return translated("edge", [&] { return impl_->curve(edge).tangent(t); });
}

double Evaluator::edge_curvature(EdgeId edge, double t) {
  return translated("edge", [&] { return impl_->curve(edge).curvature(t); });
}

double Evaluator::edge_length(EdgeId edge, double t0, double t1) {
  return translated("edge", [&] {
    EdgeCurve& curve = impl_->curve(edge);
    return curve.length_at(t1) - curve.length_at(t0);
  });
}

double Evaluator::edge_parameter(EdgeId edge, double t0, double length) {
  return translated("edge", [&] {
    EdgeCurve& curve = impl_->curve(edge);
    return curve.parameter_at(curve.length_at(t0) + length);
  });
}

std::vector<double> Evaluator::edge_pieces(EdgeId edge) {
  return translated("edge", [&] { return impl_->curve(edge).pieces(); });
}

std::vector<double> Evaluator::edge_kinks(EdgeId edge, double angle) {
  return translated("edge", [&] { return impl_->curve(edge).kinks(angle); });
}

Vec2 Evaluator::edge_uv(FaceId face, const CoEdge& coedge, double t) {
  return translated("edge", [&] { return impl_->edge_uv(face, coedge, t); });
}

}  // namespace advlayers
