#include "triangulate/triangulate.h"

#include <algorithm>
#include <string>

#include "geometry/patch_edges.h"
#include "sizing/initial_nodes.h"
#include "triangulate/check_deviation.h"
#include "triangulate/constrained_delaunay.h"
#include "triangulate/fill_sheet.h"
#include "triangulate/glue.h"
#include "triangulate/improve_surface.h"

namespace advlayers {
namespace {

using Side = PlanarTriangulation::Side;

void sort_unique(std::vector<EdgeId>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

std::string names(const std::vector<EdgeId>& edges) {
  std::string text;
  for (const EdgeId e : edges) text += (text.empty() ? "" : ", ") + edge_name(e);
  return text;
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double s = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * d).norm();
}

// Whether the mesh edges leave the CAD edge: cut finer, they would leave it less.
bool is_bent(const Model& model, const Discretization& boundary, EdgeId edge) {
  const auto& nodes = boundary.edges[edge.index()].nodes;
  double chords = 0;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    chords +=
        (boundary.nodes[nodes[k].index()].xyz - boundary.nodes[nodes[k - 1].index()].xyz).norm();
  }
  return model.edge(edge).length > chords * (1 + 1e-6);
}

// The boundary of one face as a triangulation without interior points.
class BoundaryTriangulation {
 public:
  BoundaryTriangulation(const RunContext& context, const FaceSheet& sheet)
      : context_(context),
        sheet_(sheet),
        delaunay_(context, sheet.points),
        overlapping_(sheet.segments.size(), 0) {}

  PlanarTriangulation run() {
    for (std::size_t i = 0; i < sheet_.segments.size(); ++i) {
      context_.check();
      constrain(static_cast<int>(i));
    }
    if (!coarse_.empty())
      throw too_coarse(Sentence("{}: mesh edges of {} cross or touch each other"));
    const auto windings = delaunay_.carve(context_);
    find_segments_facing_away();
    if (!coarse_.empty())
      throw too_coarse(Sentence("{}: mesh edges of {} leave boundary on the wrong side"));
    if (windings.lowest < 0 || windings.highest != 1) {
      throw GeometryError("{}: its boundary does not enclose a region", face_name(sheet_.face));
    }
    return delaunay_.release();
  }

 private:
  const SheetSegment& segment(int i) const { return sheet_.segments[static_cast<std::size_t>(i)]; }
  const Vec2& point(int p) const { return sheet_.points[static_cast<std::size_t>(p)]; }

  void constrain(int i) {
    const SheetSegment& s = segment(i);
    const int a = delaunay_.vertex(s.from), b = delaunay_.vertex(s.to);
    // Two nodes in one place: the edge has no extent here, or another one passes through its node.
    if (a != s.from || b != s.to) {
      coarse_.push_back(s.edge);
      return;
    }
    const auto conflict = delaunay_.constrain(a, b, i);
    if (conflict.crossed >= 0)
      coarse_.insert(coarse_.end(), {s.edge, segment(conflict.crossed).edge});
    if (conflict.overlaps >= 0) overlapping_[static_cast<std::size_t>(i)] = 1;
    if (conflict.overlaps >= 0 && segment(conflict.overlaps).edge != s.edge) {
      coarse_.insert(coarse_.end(), {s.edge, segment(conflict.overlaps).edge});
    }
    if (conflict.through >= 0) {
      coarse_.push_back(s.edge);
      for (const SheetSegment& other : sheet_.segments) {
        if (other.from == conflict.through) coarse_.push_back(other.edge);
      }
    }
  }

  // After carving every segment has the face on its left. One that has not lies beyond another
  // segment that cuts a curve short.
  void find_segments_facing_away() {
    std::vector<char> faces_inside(overlapping_);
    const PlanarTriangulation& mesh = delaunay_.mesh();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const int mark = mesh.segment({t, i});
        if (mark >= 0 && mesh.from({t, i}) == segment(mark).from) {
          faces_inside[static_cast<std::size_t>(mark)] = 1;
        }
      }
    }
    for (std::size_t i = 0; i < sheet_.segments.size(); ++i) {
      if (faces_inside[i]) continue;
      const SheetSegment& s = sheet_.segments[i];
      coarse_.push_back(s.edge);
      const Vec2 middle = (point(s.from) + point(s.to)) / 2;
      const SheetSegment* nearest = nullptr;
      double least = 0;
      for (const SheetSegment& other : sheet_.segments) {
        if (other.edge == s.edge) continue;
        const double d = distance_to_segment(middle, point(other.from), point(other.to));
        if (nearest != nullptr && d >= least) continue;
        nearest = &other;
        least = d;
      }
      if (nearest != nullptr) coarse_.push_back(nearest->edge);
    }
  }

  BoundaryTooCoarse too_coarse(const Sentence& said) {
    sort_unique(coarse_);
    return {said.about(face_name(sheet_.face), names(coarse_)), coarse_};
  }

  const RunContext& context_;
  const FaceSheet& sheet_;
  ConstrainedDelaunay delaunay_;
  std::vector<char> overlapping_;  // segments that lie on another: the far side of a slit
  std::vector<EdgeId> coarse_;
};

struct BoundarySheet {
  FaceSheet sheet;
  PlanarTriangulation mesh;
};

// The faces of a patch that cannot be triangulated, and why the first of them cannot.
class Failures {
 public:
  explicit Failures(std::size_t faces) : alone_(faces == 1) {}

  template <class Work>
  void run(FaceId face, const Work& work) {
    if (alone_) return work();
    try {
      work();
    } catch (const BoundaryTooCoarse& error) {
      add(face, error.sentence());
      edges_.insert(edges_.end(), error.edges().begin(), error.edges().end());
    } catch (const GeometryError& error) {
      add(face, error.sentence());
    }
  }

  void add(FaceId face, const Sentence& why) {
    if (faces_.empty()) why_ = why;
    faces_.push_back(face);
  }

  void check() {
    if (faces_.empty()) return;
    sort_unique(edges_);
    throw FacesNotTriangulated(why_, std::move(faces_), std::move(edges_));
  }

 private:
  bool alone_;
  Sentence why_;
  std::vector<FaceId> faces_;
  std::vector<EdgeId> edges_;
};

std::vector<BoundarySheet> bound_faces(const RunContext& context, const PatchSurface& surface,
                                       Evaluator& evaluator, const Discretization& boundary,
                                       const std::vector<EdgeId>& inner) {
  std::vector<BoundarySheet> bounded;
  Failures failures(surface.faces().size());
  for (const FaceId face : surface.faces()) {
    failures.run(face, [&] {
      FaceSheet sheet = lay_out_face(evaluator, boundary, face, inner);
      if (sheet.segments.empty()) {
        if (surface.faces().size() == 1) return;
        failures.add(face, Sentence("{}: its sides are one line", face_name(face)));
        return;
      }
      PlanarTriangulation planar = BoundaryTriangulation(context, sheet).run();
      bounded.push_back({std::move(sheet), std::move(planar)});
    });
  }
  failures.check();
  return bounded;
}

}  // namespace

Triangulation triangulate(const RunContext& context, PatchSurface& surface, Evaluator& evaluator,
                          const Discretization& boundary, const Settings& settings,
                          Density density) {
  const std::vector<EdgeId> inner = inner_edges(evaluator, surface.faces(), feature_rule(settings));
  std::vector<BoundarySheet> bounded = bound_faces(context, surface, evaluator, boundary, inner);
  std::vector<LiftedTriangulation> sheets;
  const InitialNodes* initial = settings.initial_nodes.get();
  const std::vector<SurfacePoint> none;
  Triangulation result;
  if (bounded.empty()) return result;
  for (BoundarySheet& face : bounded) {
    const FaceId id = face.sheet.face;
    sheets.emplace_back(std::move(face.sheet), std::move(face.mesh), evaluator,
                        TargetSize(evaluator, settings, density));
    result.initial_nodes +=
        fill_sheet(context, sheets.back(), initial == nullptr ? none : initial->on(id));
  }
  GluedMesh glued = glue_sheets(context, sheets, boundary);
  sheets.clear();
  improve_surface(context, glued, surface,
                  result.initial_nodes > 0 ? Places::kKept : Places::kEvened);
  result.mesh = std::move(glued.mesh);
  Deviations deviations = check_deviation(context, result.mesh, surface);
  result.diagnostics = std::move(deviations.diagnostics);
  for (const EdgeId edge : deviations.edges_of_inverted) {
    if (is_bent(evaluator.model(), boundary, edge)) result.coarse_edges.push_back(edge);
  }
  return result;
}

}  // namespace advlayers
