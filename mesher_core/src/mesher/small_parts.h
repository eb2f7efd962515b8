// Edges and faces of the shape that are far smaller than the elements.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "geometry/model.h"
#include "sizing/settings.h"

namespace advlayers {

// Of a strip with the face's area and boundary [mm]; 0 without a boundary.
double width_of(const Model& model, FaceId face);

// Tells of edges shorter, and of faces narrower, than a tenth of the size there: one note for all
// of each, with the smallest by name. The facets of a faceted model are no such parts.
void note_small_parts(const Model& model, const Settings& settings,
                      const std::vector<FaceId>& faces, std::vector<Diagnostic>& diagnostics);

}  // namespace advlayers
