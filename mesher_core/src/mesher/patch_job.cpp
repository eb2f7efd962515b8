#include "mesher/patch_job.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "core/core_collapses.h"
#include "core/core_improvement.h"
#include "imprint/imprint_edges.h"
#include "measure/core_region.h"
#include "mend/inversion.h"
#include "mend/split_inside.h"
#include "mesh/validate.h"
#include "mesher/element_faces.h"
#include "mesher/narrow_strip.h"
#include "mesher/triangle_cause.h"
#include "mesher/wall_report.h"
#include "mesher/wall_shortfalls.h"
#include "quads/recombine.h"
#include "triangulate/triangulate.h"

namespace advlayers {
namespace {

template <class Id, std::size_t kCount>
void add_named(const std::array<int, kCount>& counts, const std::array<Named<Id>, kCount>& names,
               std::map<std::string, int>& total) {
  for (const auto& [id, name] : names) {
    const int count = counts[static_cast<std::size_t>(id)];
    if (count > 0) total[name] += count;
  }
}

}  // namespace

PatchJob::PatchJob(PatchId id, std::vector<FaceId> faces, const Model& model,
                   const Settings& settings)
    : id_(id),
      faces_(std::move(faces)),
      settings_(&settings),
      evaluator_(model),
      surface_(evaluator_, faces_, feature_rule(settings)) {
  for (const FaceId face : faces_) area_ += model.face(face).area;
  report_.patch = id;
  report_.faces = faces_;
  for (const FaceId face : faces_) {
    const Sentence& defect = model.face(face).defect;
    if (defect.empty()) continue;
    complain(Severity::kError, "face-defect",
             Sentence("{} is not meshed: {}", face_name(face), defect));
    defective_ = true;
  }
}

void PatchJob::complain(Severity severity, const char* code, Sentence sentence) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.patch = id_;
  diagnostic.layer = report_.layers;
  diagnostic.sentence = std::move(sentence);
  diagnostics_.push_back(std::move(diagnostic));
}

// Runs a stage of this patch; what it throws becomes a diagnostic, and the other patches go on.
template <class Stage>
bool PatchJob::guard(const char* code, const Stage& stage) {
  try {
    stage();
    return true;
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    const std::string name = patch_name(faces_);
    const auto* told = dynamic_cast<const Told*>(&error);
    const Sentence why = told ? told->sentence() : Sentence("{}", error.what());
    const bool named = why.english().find(name) != std::string::npos;
    complain(Severity::kError, code, named ? why : Sentence("{}: {}", name, why));
    return false;
  }
}

void PatchJob::plan(const RunContext& context) {
  context.check();
  if (defective_) return;
  defective_ = !guard("face-not-meshed", [&] {
    walls_ = plan_walls(evaluator_, *settings_, faces_);
    matches_ = plan_matches(evaluator_, faces_, walls_);
    for (Diagnostic& note : matches_.notes) note.patch = id_;
    strip_ = find_narrow_strip(evaluator_, faces_, walls_, *settings_);
  });
}

std::vector<EdgeId> PatchJob::triangulate(const RunContext& context,
                                          const Discretization& boundary) {
  if (defective_) return {};
  diagnostics_ = matches_.notes;
  std::vector<EdgeId> coarse;
  meshed_ = guard("face-not-meshed", [&] {
    resolve_heights(evaluator_, boundary, walls_);
    if (walls_.edges.empty()) {
      complain(Severity::kInfo, "no-boundary",
               Sentence("{} has no boundary edge that layers could grow from", patch_name(faces_)));
    }
    if (fill_in_rows(boundary)) return;
    try {
      Triangulation made =
          advlayers::triangulate(context, surface_, evaluator_, boundary, *settings_);
      mesh_ = std::move(made.mesh);
      coarse = std::move(made.coarse_edges);
      initial_nodes_ = made.initial_nodes;
      for (Diagnostic& diagnostic : made.diagnostics) {
        diagnostic.patch = id_;
        diagnostics_.push_back(std::move(diagnostic));
      }
    } catch (const BoundaryTooCoarse& error) {
      coarse = error.edges();
      throw;
    }
  });
  growing_ = meshed_ && !in_rows_;
  return coarse;
}

// A strip too narrow for layers is finished at once: each of its walls' columns has met the other.
bool PatchJob::fill_in_rows(const Discretization& boundary) {
  std::optional<SurfaceMesh> rows;
  if (strip_) rows = mesh_in_rows(evaluator_, surface_, boundary, *strip_, walls_, *settings_);
  in_rows_ = rows.has_value();
  stops_.clear();
  if (!in_rows_) return false;
  mesh_ = std::move(*rows);
  for (std::size_t i = 0; i < mesh_.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (mesh_.data(v).node.valid()) stops_.push_back({v, Stop::kCollision, 1});
  }
  return true;
}

std::optional<LayerReport> PatchJob::advance(const RunContext& context) {
  std::optional<LayerReport> report;
  if (!growing_) return report;
  growing_ = guard("layers-stopped",
                   [&] {
                     if (!layers_) {
                       layers_ =
                           std::make_unique<PatchLayers>(context, id_, mesh_, surface_, walls_);
                     }
                     report = layers_->advance();
                   }) &&
             report.has_value();
  if (!growing_) return std::nullopt;
  report_.layers = report->layer;
  add_named(report->vetoes, kVetoes, report_.vetoes);
  add_named(report->events, kEvents, report_.events);
  return report;
}

// The layers watch the mesh for edges to swap; what follows is no business of theirs.
void PatchJob::end_layers() {
  growing_ = false;
  if (!layers_) return;
  const auto& told = layers_->diagnostics();
  diagnostics_.insert(diagnostics_.end(), told.begin(), told.end());
  stops_ = layers_->stops();
  layers_.reset();
  thaw_core_edges(mesh_);
}

void PatchJob::complete(const RunContext& context) {
  improve_core(context, mesh_, surface_);
  if (settings_->core == CoreElements::kQuads) recombine(context, mesh_, surface_);
  mend_inverted(context, mesh_, surface_);
  return_to_core(mesh_);
}

int PatchJob::count_inverted(const RunContext& context) {
  int inverted = 0;
  for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
    context.check();
    if (mesh_.alive(FaceH(i)) && is_inverted(mesh_, FaceH(i), surface_)) ++inverted;
  }
  return inverted;
}

// The layers ran across the edges inside the patch; here every element comes to lie on one face.
// Where that would cost an element turned over, elements reach over the edges instead.
void PatchJob::complete_along_edges(const RunContext& context, const Discretization& boundary) {
  SurfaceMesh across = mesh_;
  int crossing = imprint_edges(context, mesh_, surface_, boundary);
  collapse_slivers(context, mesh_);
  complete(context);
  if (const int inverted = count_inverted(context); inverted > 0) {
    std::swap(mesh_, across);
    complete(context);
    if (count_inverted(context) < inverted) {
      crossing = -1;
    } else {
      std::swap(mesh_, across);
    }
  }
  if (crossing == 0) return;
  const Sentence some(
      "{}: {} elements reach over edges inside the patch; lower feature_angle to part its faces",
      patch_name(faces_), crossing);
  const Sentence all(
      "{}: its elements reach over edges inside the patch; lower feature_angle to part its faces",
      patch_name(faces_));
  complain(Severity::kWarning, "elements-cross-edges", crossing > 0 ? some : all);
}

void PatchJob::renumber(PatchId id) {
  id_ = report_.patch = id;
  for (auto* notes : {&diagnostics_, &matches_.notes}) {
    for (Diagnostic& note : *notes) note.patch = id;
  }
}

void PatchJob::finish(const RunContext& context, const Discretization& boundary) {
  if (finished_) return;
  end_layers();
  if (!meshed_) return;
  if (in_rows_) {
    finished_ = true;
    return;
  }
  if (const std::string fault = find_connectivity_fault(mesh_); !fault.empty()) {
    complain(Severity::kError, "face-not-meshed",
             Sentence("{}: its layers broke the mesh: {}", patch_name(faces_), fault));
    meshed_ = false;
    return;
  }
  mesh_.put_in_order();
  const SurfaceMesh before = mesh_;
  const bool done = guard("core-not-improved", [&] {
    return_to_core(mesh_);
    if (surface_.has_inner_edges() && !surface_.faceted()) {
      complete_along_edges(context, boundary);
    } else {
      complete(context);
    }
    if (faces_.size() > 1) find_faces(boundary);
    const std::string fault = find_connectivity_fault(mesh_);
    if (!fault.empty()) throw InternalError(fault);
  });
  finished_ = true;
  if (done) return;
  mesh_ = before;
  face_of_.clear();
}

void PatchJob::find_faces(const Discretization& boundary) {
  ElementFaces found = find_element_faces(mesh_, surface_, boundary, SizeField(*settings_));
  face_of_ = std::move(found.of);
  if (!surface_.faceted()) strained_ = std::move(found.strained);
}

void PatchJob::split_edges(const std::vector<HalfedgeH>& edges, const Discretization& boundary) {
  guard("edges-not-split", [&] {
    for (const HalfedgeH h : edges) split_inside(mesh_, surface_, h);
    if (faces_.size() > 1) find_faces(boundary);
  });
}

void PatchJob::measure(const RunContext& context) {
  if (!meshed_) return;
  guard("not-measured", [&] {
    count_elements(context);
    judge_inverted();
    wall_reports_ = measure_walls(mesh_, surface_, walls_, stops_, report_.layers);
    for (WallReport& wall : wall_reports_) {
      wall.face = face_beside(evaluator_.model(), faces_, wall.edge);
    }
    judge_walls();
  });
}

void PatchJob::count_elements(const RunContext& context) {
  counts_ = FigureCounts();
  inverted_.clear();
  report_.quads = report_.triangles = 0;
  report_.triangles_by_cause = triangle_causes(mesh_);
  for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
    context.check();
    const FaceH f(i);
    if (!mesh_.alive(f)) continue;
    const ElementCorners element = corners_of(mesh_, f);
    counts_.add(element, mesh_.data(f).layer);
    if (is_inverted(mesh_, f, surface_)) {
      counts_.add_inverted();
      inverted_.push_back(f);
    }
    ++(element.count == 4 ? report_.quads : report_.triangles);
  }
}

// A wall that got fewer layers than its number, none that could be measured, or layers of another
// height, says so.
void PatchJob::judge_walls() {
  std::vector<const WallReport*> missed;
  for (const WallReport& wall : wall_reports_) {
    for (Shortfall& shortfall : shortfalls_of(wall)) {
      if (shortfall.code == kHeightMissed) {
        missed.push_back(&wall);
      } else {
        complain(Severity::kWarning, shortfall.code, std::move(shortfall.sentence));
      }
    }
  }
  if (!missed.empty()) {
    complain(Severity::kWarning, kHeightMissed, missed_heights(std::move(missed)));
  }
}

// What was turned over in the triangulation may be mended by now: the finished mesh decides.
void PatchJob::judge_inverted() {
  for (Diagnostic& diagnostic : diagnostics_) {
    if (diagnostic.code == "triangulation-inverted") diagnostic.severity = Severity::kInfo;
  }
  std::map<FaceId, std::vector<FaceH>> by_face;
  for (const FaceH f : inverted_) by_face[face_of(f)].push_back(f);
  for (const auto& [face, elements] : by_face) {
    complain(Severity::kError, "inverted-elements",
             Sentence("{}: {} elements are turned over against the surface", face_name(face),
                      elements.size()));
    diagnostics_.back().point = centroid(corners_of(mesh_, elements.front()));
  }
}

// An element that lies on no face as a whole belongs to the one that most of its corners lie on.
FaceId PatchJob::face_of(FaceH f) const {
  if (faces_.size() == 1) return faces_.front();
  if (f.index() < face_of_.size() && face_of_[f.index()].valid()) return face_of_[f.index()];
  FaceId best;
  int best_votes = 0;
  const HalfedgeH first = mesh_.halfedge(f);
  HalfedgeH h = first;
  do {
    const FaceId candidate = mesh_.data(mesh_.to(h)).point.face;
    int votes = 0;
    HalfedgeH other = first;
    do {
      votes += mesh_.data(mesh_.to(other)).point.face == candidate;
      other = mesh_.next(other);
    } while (other != first);
    if (votes > best_votes || (votes == best_votes && candidate < best)) {
      best = candidate;
      best_votes = votes;
    }
    h = mesh_.next(h);
  } while (h != first);
  return best;
}

std::vector<Diagnostic> PatchJob::diagnostics() const {
  std::vector<Diagnostic> all = diagnostics_;
  if (layers_) all.insert(all.end(), layers_->diagnostics().begin(), layers_->diagnostics().end());
  return all;
}

}  // namespace advlayers
