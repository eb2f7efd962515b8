// Meshes a model: cuts the boundaries, triangulates the patches, then grows layers. The caller
// owns the loop, one layer of one patch at a time. Patches are independent once the boundaries are
// cut; they run side by side, with the same result, bit for bit, for any number of threads.
#pragma once

#include <memory>
#include <optional>

#include "base/run_context.h"
#include "geometry/model.h"
#include "mesher/result.h"
#include "sizing/settings.h"

namespace advlayers {

class Mesher {
 public:
  // Throws InvalidInput naming a wrong setting, and Cancelled. The context, made for this run, and
  // the model must outlive the mesher; once the context is cancelled it stops for good.
  Mesher(RunContext& context, const Model& model, const Settings& settings);
  ~Mesher();

  // Advances one layer of one patch (the first call also triangulates); empty when no front is
  // left. Throws Cancelled.
  std::optional<LayerReport> next();

  // True where next() has a report at hand, without work.
  bool ready() const;

  // The mesh as it stands, at any time before result(); its walls and figures are not measured.
  // Throws Cancelled where the stop is asked for meanwhile; one asked for before leaves the mesh.
  MeshResult snapshot() const;
  // Finishes the core (improves, recombines), measures, and gives the mesh. Call once. Grows all
  // layers where next() was never called; where it was, the layers so far are kept. Throws
  // Cancelled.
  MeshResult result();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace advlayers
