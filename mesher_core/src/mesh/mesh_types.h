// Handles and per-entity data of the surface mesh.
#pragma once

#include <array>

#include "base/named.h"
#include "base/types.h"

namespace advlayers {

using VertexH = Id<struct MeshVertexTag>;
using HalfedgeH = Id<struct MeshHalfedgeTag>;
using FaceH = Id<struct MeshFaceTag>;

// What a mesh vertex lies on. A vertex on a CAD vertex or boundary edge never moves or vanishes.
enum class Support : std::uint8_t { kPatch, kEdge, kVertex };

struct VertexData {
  SurfacePoint point;
  Vec3 normal = Vec3::Zero();  // outward unit normal of the surface at the point
  NodeId node;                 // the model-wide boundary node, where the support is edge or vertex
  Support support = Support::kPatch;
  int layer = 0;   // layer it was extruded in; 0: boundary or core
  VertexH parent;  // the front vertex it was extruded from
};

struct FaceData {
  int layer = 0;  // 0: core
};

// Why a local operation was refused. Topological reasons come from mesh/, geometric ones from
// above.
enum class Veto : std::uint8_t {
  kBorder,         // the edge has no face on one side
  kFrozen,         // front, parent-kid, or CAD boundary edge
  kNotTriangles,   // a face beside the edge is a quad
  kEdgeExists,     // the new edge, or a doubled one, is there already
  kLink,           // the collapse would pinch the surface
  kFixedVertex,    // the vertex lies on the CAD's boundary or on the front
  kInverts,        // a triangle would turn over
  kLowersQuality,  // the minimum angle would drop
  kLeavesSurface,  // a triangle would deviate too far from the surface
  kTooSharp,       // two neighbours would fold past the dihedral bound
  kAreaRatio,      // triangles of too different areas would result
  kNone,           // it was not
};
inline constexpr std::array<Named<Veto>, 11> kVetoes{{{Veto::kBorder, "border"},
                                                      {Veto::kFrozen, "frozen"},
                                                      {Veto::kNotTriangles, "not-triangles"},
                                                      {Veto::kEdgeExists, "edge-exists"},
                                                      {Veto::kLink, "link"},
                                                      {Veto::kFixedVertex, "fixed-vertex"},
                                                      {Veto::kInverts, "inverts"},
                                                      {Veto::kLowersQuality, "lowers-quality"},
                                                      {Veto::kLeavesSurface, "leaves-surface"},
                                                      {Veto::kTooSharp, "too-sharp"},
                                                      {Veto::kAreaRatio, "area-ratio"}}};
static_assert(in_order(kVetoes));

}  // namespace advlayers
