// Puts a planned layer into the mesh: inserts the kids (paper, II.C), recovers the edges to their
// parents and to each other (II.E), and combines the cells into quads (II.H). A cell that fails
// stays core, and the front keeps its parents there: never a broken front.
#pragma once

#include "layers/layer_plan.h"

namespace advlayers {

void insert_kids(LayerState& state, LayerPlan& plan);
void recover_cells(LayerState& state, LayerPlan& plan);
void combine_cells(LayerState& state, const LayerPlan& plan);

// The front of the next layer, from the cells that were closed.
void advance_front(LayerState& state, const LayerPlan& plan);

}  // namespace advlayers
