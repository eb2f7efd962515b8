// What there is to say of one patch in the end: diagnostics, counts, what its walls got.
#pragma once

#include <exception>
#include <functional>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "mesher/patch_plan.h"
#include "mesher/result.h"

namespace advlayers {

struct MeshOfPatch {
  const SurfaceMesh& mesh;
  PatchSurface& surface;
  std::function<FaceId(FaceH)> face_of;  // the CAD face that an element lies on
};

class PatchRecord {
 public:
  PatchRecord(PatchId id, std::vector<FaceId> faces);

  PatchId id() const { return report_.patch; }
  int layers() const { return report_.layers; }
  const PatchReport& report() const { return report_; }
  const std::vector<WallReport>& wall_reports() const { return wall_reports_; }
  const FigureCounts& counts() const { return counts_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  void complain(Severity severity, std::string_view code, Sentence sentence);
  // Runs a stage of the patch; what it throws becomes a diagnostic, but for Cancelled and a lack of
  // memory, and the other patches go on. Returns whether it came to its end.
  template <class Stage>
  bool guard(const char* code, const Stage& stage);

  void renumber(PatchId id);
  // Begins anew, with what was said before the patch was triangulated.
  void begin(const std::vector<Diagnostic>& notes);
  void take(const std::vector<Diagnostic>& told);  // of this patch
  void add_layer(const LayerReport& layer);
  void forget_layers() { report_.layers = 0; }
  void tell_layers(int layers) { report_.layers = layers; }  // that came about at once
  // Counts the finished mesh's elements and judges them and the walls. Throws Cancelled.
  void measure(const RunContext& context, const MeshOfPatch& of, std::vector<WallReport> walls);

 private:
  void count_elements(const RunContext& context, const MeshOfPatch& of);
  void judge_inverted(const MeshOfPatch& of);
  void judge_flaws(const RunContext& context, const MeshOfPatch& of);
  void judge_walls(std::vector<WallReport> measured);

  std::vector<FaceId> faces_;
  PatchReport report_;
  std::vector<WallReport> wall_reports_;
  FigureCounts counts_;
  std::vector<FaceH> inverted_;
  std::vector<Diagnostic> diagnostics_;
};

template <class Stage>
bool PatchRecord::guard(const char* code, const Stage& stage) {
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

}  // namespace advlayers
