// The work on one patch, from triangulation to the finished mesh. Trouble is data: a patch that
// cannot be triangulated is left out, one whose layers fail keeps its last valid mesh.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "boundary/periodic_pairs.h"
#include "geometry/four_sides.h"
#include "geometry/patch_surface.h"
#include "layers/patch_layers.h"
#include "mesh/surface_mesh.h"
#include "mesher/core_completion.h"
#include "mesher/match_plan.h"
#include "mesher/patch_plan.h"
#include "mesher/patch_record.h"
#include "mesher/result.h"
#include "sizing/settings.h"

namespace advlayers {

class PatchJob {
 public:
  PatchJob(PatchId id, std::vector<FaceId> faces, const Model& model, const Settings& settings);
  PatchJob(const PatchJob&) = delete;

  // The stages, in this order; each throws Cancelled and nothing else.
  void plan(const RunContext& context);  // what grows from each edge, where layers run along one
  // The CAD edges that are cut too coarsely for this patch: once these are cut finer, it may be
  // triangulated again. A patch that is meshed may ask for better, too.
  std::vector<EdgeId> triangulate(const RunContext& context, const Discretization& boundary);
  std::optional<LayerReport> advance(const RunContext& context);  // empty: no front is left
  void finish(const RunContext& context, const Discretization& boundary);
  // Takes the mesh of another finished patch of one face, moved; between finish() and measure().
  void copy_moved(const PatchJob& given, const FacePair& pair, const Discretization& boundary);
  // Splits edges inside the finished patch; between finish() and measure().
  void split_edges(const RunContext& context, const std::vector<HalfedgeH>& edges,
                   const Discretization& boundary);
  void measure(const RunContext& context);

  bool meshed() const { return stage_ > Stage::kUnmeshed; }
  // Of a patch of several faces that is not meshed: those without which it may be.
  const std::vector<FaceId>& failed_faces() const { return failed_; }
  // Meshed to the end: the stages above pass it over from then on.
  bool finished() const { return stage_ == Stage::kFinished; }
  // Patches of a run are numbered in order; the others may have changed.
  void renumber(PatchId id) { record_.renumber(id); }
  bool borders_on(EdgeId edge) const { return walls_.edges.count(edge) > 0; }
  PatchId id() const { return record_.id(); }
  const std::vector<FaceId>& faces() const { return faces_; }
  // Of triangulate(): vertices that the nodes of an initial mesh became.
  int initial_nodes() const { return initial_nodes_; }
  // Of finish(): those of several faces that the patch's mesh could not follow.
  const std::vector<FaceId>& strained_faces() const { return strained_; }
  const std::vector<MatchEnd>& match_ends() const { return matches_.ends; }
  const std::optional<FourSides>& strip() const { return strip_; }    // of plan()
  const std::optional<FourSides>& mapped() const { return mapped_; }  // of plan()
  double area() const { return area_; }  // [mm^2] of the faces, as a measure of the work
  const SurfaceMesh& mesh() const { return mesh_; }

  // Of measure(), but for the diagnostics:
  const PatchReport& report() const { return record_.report(); }
  const std::vector<WallReport>& wall_reports() const { return record_.wall_reports(); }
  const FigureCounts& counts() const { return record_.counts(); }
  std::vector<Diagnostic> diagnostics() const;

  // The CAD face that an element lies on.
  FaceId face_of(FaceH f) const;

 private:
  // One follows the other; halving and parting may lead back to kUnmeshed.
  enum class Stage {
    kDefective,  // cannot be meshed
    kUnmeshed,   // planned, or not even that
    kInRows,     // meshed by rows across a strip, without layers, or mapped
    kGrowing,    // triangulated, with fronts
    kGrown,      // no front is left
    kFinished    // the core, too
  };

  void make_triangles(const RunContext& context, const Discretization& boundary,
                      std::vector<EdgeId>& coarse);
  bool mend_without_layers(const RunContext& context, const std::string& fault,
                           const Discretization& boundary);
  void plan_mapped();
  bool fill_in_rows(const RunContext& context, const Discretization& boundary);
  bool fill_mapped(const RunContext& context, const Discretization& boundary);
  bool fill_as_offered(const RunContext& context, const Discretization& boundary);
  void begin_layers(const RunContext& context);
  void end_layers();
  bool grow_again(const RunContext& context, const Discretization& boundary);
  Completion complete(const RunContext& context, const Discretization& boundary);
  void tell_of(const Completion& made);
  void find_faces(const RunContext& context, const Discretization& boundary);

  std::vector<FaceId> faces_;
  PatchRecord record_;
  Stage stage_ = Stage::kUnmeshed;
  const Settings* settings_;
  double area_ = 0.0;
  Evaluator evaluator_;
  PatchSurface surface_;
  WallPlan walls_;     // of plan(), heights of triangulate()
  MatchPlan matches_;  // of plan()
  SurfaceMesh mesh_;
  int initial_nodes_ = 0;
  std::unique_ptr<PatchLayers> layers_;
  std::optional<FourSides> strip_;   // of plan(): too narrow for layers
  std::optional<FourSides> mapped_;  // of plan(), where that was asked for
  // Of plan(), without layers: mapped where the sides agree by themselves.
  std::optional<FourSides> offered_;
  std::vector<FaceId> face_of_;  // by FaceH, of a finished patch of several faces
  std::vector<FaceId> strained_, failed_;
  std::vector<StopRecord> stops_;
};

using PatchJobs = std::vector<std::unique_ptr<PatchJob>>;

}  // namespace advlayers
