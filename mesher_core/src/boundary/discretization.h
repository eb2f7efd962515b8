// Every CAD edge cut once into mesh edges on its exact curve, for all faces that share it.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "base/run_context.h"
#include "base/types.h"
#include "boundary/match_end.h"
#include "boundary/periodic_pairs.h"
#include "geometry/evaluator.h"
#include "geometry/four_sides.h"
#include "sizing/settings.h"

namespace advlayers {

struct BoundaryNode {
  Vec3 xyz;
  VertexId vertex;  // set for a node on a CAD vertex
  EdgeId edge;      // set for a node inside a CAD edge
  double t = 0.0;   // parameter on that edge
};

struct EdgeNodes {
  std::vector<NodeId> nodes;   // from first to last parameter, ends included
  std::vector<double> params;  // one per node
};

struct Discretization {
  std::vector<BoundaryNode> nodes;
  std::vector<EdgeNodes> edges;   // by EdgeId; a degenerate edge has one node and no segment
  std::vector<Diagnostic> notes;  // where the layers of two faces do not fall on the same nodes
};

// Cuts edges by size, curvature angle and a graded transition from short edges. A closed edge gets
// at least three segments; every edge at least one. Edges of no meshed face are left empty. Layers
// that run along an edge take its ends: their nodes come first, and what lies between blends in.
// Facing sides of `strips` get as many segments, facing each other, except on edges whose cuts are
// given otherwise, by the user or by layers; those of `mapped` as many, whatever they are. The
// nodes of `periodic` edges are copies of each other. Throws Cancelled.
Discretization discretize(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                          const std::vector<MatchEnd>& match_ends = {},
                          const std::vector<FourSides>& strips = {},
                          const std::vector<FourSides>& mapped = {},
                          const std::vector<EdgePair>& periodic = {});

// Whether every edge has the same nodes in the same places.
bool same_cuts(const Discretization& a, const Discretization& b);

}  // namespace advlayers
