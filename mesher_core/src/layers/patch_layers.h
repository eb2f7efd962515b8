// The front system of one patch: Algorithm 1 of the paper (II.K), one layer per call.
// Before and after each call the mesh is a valid, conforming mesh of the patch.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/named.h"
#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "layers/layer_steps.h"
#include "layers/wall_plan.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// In their order; the list with their names and functions is kLayerSteps in patch_layers.cpp.
enum class Step : std::uint8_t {
  kMakeWay,
  kRedefine,
  kCollapse,
  kExtrude,
  kRecover,
  kCombine,
  kSmooth,
  kImprove,
  kGrow
};
const char* step_name(Step step);

// Why a front vertex got no further kid.
enum class Stop : std::uint8_t {
  kLayersReached,
  kIsotropic,
  kCollision,
  kClosed,
  kBlocked,
  kMerged,
  kNeighbour,
  kBent
};
inline constexpr std::array<Named<Stop>, 8> kStops{{{Stop::kLayersReached, "layers-reached"},
                                                    {Stop::kIsotropic, "isotropic"},
                                                    {Stop::kCollision, "collision"},
                                                    {Stop::kClosed, "closed"},
                                                    {Stop::kBlocked, "blocked"},
                                                    {Stop::kMerged, "merged"},
                                                    {Stop::kNeighbour, "neighbour-stopped"},
                                                    {Stop::kBent, "surface-bends"}}};
static_assert(in_order(kStops));

// Why the front lost edges; each names the triangles it cost.
enum class Event : std::uint8_t {
  kCollapse,
  kCoarsen,
  kRowEnd,
  kCloseTriangle,
  kZip,
  kRung,
  kBridge,
  kFan
};
inline constexpr std::array<Named<Event>, 8> kEvents{{{Event::kCollapse, "collapse"},
                                                      {Event::kCoarsen, "coarsen"},
                                                      {Event::kRowEnd, "row-end"},
                                                      {Event::kCloseTriangle, "close-triangle"},
                                                      {Event::kZip, "zip"},
                                                      {Event::kRung, "rung"},
                                                      {Event::kBridge, "bridge"},
                                                      {Event::kFan, "fan"}}};
static_assert(in_order(kEvents));

// The end of one wall vertex's column.
struct StopRecord {
  VertexH root;  // the wall vertex
  Stop reason = Stop::kBlocked;
  int layer = 0;  // the layer that was not made
};

struct LayerReport {
  PatchId patch;
  int layer = 0;
  int front_vertices = 0;        // after the layer
  int quads = 0, triangles = 0;  // made in this layer
  std::array<int, kVetoes.size()> vetoes{};
  std::array<int, kEvents.size()> events{};
  std::array<int, kStops.size()> stops{};
};

using LocalSize = std::function<double(const SurfacePoint&)>;  // [mm]

class PatchLayers {
 public:
  // Called after each step of a layer; the mesh is valid then. For tests and previews.
  using StepHook = std::function<void(Step, const SurfaceMesh&)>;

  // The context, the mesh and the surface must outlive it.
  PatchLayers(const RunContext& context, PatchId patch, SurfaceMesh& mesh, PatchSurface& surface,
              const WallPlan& plan, const LayerSteps& steps = {});
  ~PatchLayers();

  // Advances one layer; empty, and nothing changes, once no front is left.
  // Throws Cancelled at the next local operation after a stop was asked for.
  std::optional<LayerReport> advance();

  void set_step_hook(StepHook hook);
  // Where layers end once they are isotropic, they end at this edge length, too.
  void set_local_size(LocalSize size);
  const std::vector<Diagnostic>& diagnostics() const;
  const std::vector<StopRecord>& stops() const;

  struct Impl;

 private:
  std::unique_ptr<Impl> impl_;
};

// Frees the edges that have core on both sides: rungs across gaps that were never zipped. Called
// when the layers have ended, so that the core may be reconnected across them.
void thaw_core_edges(SurfaceMesh& mesh);

}  // namespace advlayers
