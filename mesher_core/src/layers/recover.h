// Insertion of points (paper, II.C) and recovery of edges (II.E) in the core's triangulation. Both
// trace the plane through the two ends that holds the mean surface normal: a cut of the
// triangulation that visits each triangle once, so it always ends.
#pragma once

#include "layers/reconnect.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Inserts a vertex at `data.point`, found by a trace from the vertex `from`. The point splits a
// face, or an edge where its second-smallest barycentric coordinate exceeds the smallest a
// hundredfold. Invalid where a frozen edge lies between, where the trace ends on a vertex that
// cannot go, or where a triangle would turn over.
VertexH insert_point(SurfaceMesh& mesh, VertexH from, const VertexData& data,
                     const ReconnectLimits& limits, VetoTally& tally);

// Forces the edge a -> b by swaps, removing core vertices that lie on it. Invalid where a frozen
// edge or a fixed vertex lies between.
HalfedgeH recover_edge(SurfaceMesh& mesh, VertexH a, VertexH b, const ReconnectLimits& limits,
                       VetoTally& tally);

// Empties the region left of `h`, bounded by frozen edges, of core vertices, and gives its faces.
// An empty list where a vertex would not go or the region holds more than `most` faces.
std::vector<FaceH> clear_region(SurfaceMesh& mesh, HalfedgeH h, std::size_t most,
                                const ReconnectLimits& limits, VetoTally& tally);

}  // namespace advlayers
