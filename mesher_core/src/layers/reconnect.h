// Local reconnection of the core (paper, II.D and II.F): swaps that raise the minimum angle, and
// the removal of core vertices. Only core triangles change; frozen edges and fixed vertices stay.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh_observer.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

using VetoTally = std::array<int, kVetoes.size()>;
inline void count(VetoTally& tally, Veto veto) {
  if (veto != Veto::kNone) ++tally[static_cast<std::size_t>(veto)];
}

// Thresholds of the paper, II.D and II.F.
struct ReconnectLimits {
  double deviation = 30.0;  // [deg] a triangle's normal against the surface's
  double at_corner = 50.0;  // [deg] against the surface's at a corner
  double edge_turn = 40.0;  // [deg] of the surface along an edge made by a collapse
  double dihedral = 40.0;   // [deg] between neighbours made by a collapse
  double area_ratio = 1e8;  // between triangles made by a collapse
};

// A vertex of the initial triangulation, free to be removed or moved.
inline bool is_core_vertex(const SurfaceMesh& mesh, VertexH v) {
  return mesh.data(v).support == Support::kPatch && mesh.data(v).layer == 0;
}

// May h be swapped without turning a triangle over? Surface deviation is not asked (II.E).
Veto orientation_veto(const SurfaceMesh& mesh, HalfedgeH h);

// May h be swapped for quality: raises the minimum angle, deviates from the surface no further than
// the limit or than before.
Veto quality_veto(const SurfaceMesh& mesh, HalfedgeH h, const ReconnectLimits& limits);

// How much a removal may cost: kGuarded keeps the paper's limits, kForced only the
// orientation and the surface at the corners.
enum class Removal { kGuarded, kForced };

// Removes a core vertex by the collapse onto the neighbour that gives the best minimum angle; a
// forced removal first swaps edges away from it where no collapse is possible. False: nothing
// fitted.
bool remove_core_vertex(SurfaceMesh& mesh, VertexH v, Removal removal,
                        const ReconnectLimits& limits, VetoTally& tally);

// Collects the core faces that changed, and swaps their edges until no swap pays.
class SwapQueue : public MeshObserver {
 public:
  explicit SwapQueue(SurfaceMesh& mesh);
  ~SwapQueue() override;
  SwapQueue(const SwapQueue&) = delete;
  SwapQueue& operator=(const SwapQueue&) = delete;

  void face_created(const SurfaceMesh& mesh, FaceH f) override;
  void face_changed(const SurfaceMesh& mesh, FaceH f) override;
  void run(const ReconnectLimits& limits, VetoTally& tally);

 private:
  SurfaceMesh* mesh_;
  std::vector<FaceH> faces_;
};

}  // namespace advlayers
