// What the core's elements are to be like at each vertex of its triangulation: their direction, a
// cross in the tangent plane, and their lengths along its arms. Aligned with the room's border, and
// as smooth as can be within. Where triangles are to be, a star of six arms of one length.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/run_context.h"
#include "base/ties.h"
#include "core/core_room.h"
#include "mesh/surface_mesh.h"
#include "triangulate/target_size.h"

namespace advlayers {

struct Cross {
  Vec3 along = Vec3::Zero();  // unit tangent; the cross has it, its opposite, and both across
  double size_along = 0.0, size_across = 0.0;  // edge lengths [mm]
  double weight = 0.0;                         // how sure the direction is, 0 … 1

  Vec3 across(const Vec3& normal) const { return normal.cross(along); }
  // Of the arms next to a direction: whether that is the one across.
  bool is_across(const Vec3& direction, const Vec3& normal) const {
    return settled(std::abs(direction.dot(along))) <
           settled(std::abs(direction.dot(across(normal))));
  }
};

class CoreField {
 public:
  CoreField(std::vector<Cross> crosses, int arms) : crosses_(std::move(crosses)), arms_(arms) {}

  int arms() const { return arms_; }  // 4 or 6

  const Cross& at(VertexH v) const { return crosses_[v.index()]; }
  void set(VertexH v, const Cross& cross) {
    if (crosses_.size() <= v.index()) crosses_.resize(v.index() + 1);
    crosses_[v.index()] = cross;
  }
  // How far `offset` reaches, in edge lengths: from a corner of a quad to that across it as far as
  // along its sides.
  double reach(const Cross& cross, const Vec3& offset, const Vec3& normal) const {
    if (arms_ == 6) return offset.norm() / cross.size_along;
    return std::max(std::abs(offset.dot(cross.along)) / cross.size_along,
                    std::abs(offset.dot(cross.across(normal))) / cross.size_across);
  }
  // Between the corners of a triangle, by shares that add up to 1, where the surface has `normal`.
  Cross between(const std::array<VertexH, 3>& corners, const std::array<double, 3>& shares,
                const Vec3& normal) const;

 private:
  std::vector<Cross> crosses_;
  int arms_;
};

// Throws Cancelled.
CoreField find_core_field(const RunContext& context, const SurfaceMesh& mesh, const CoreRoom& room,
                          int arms, TargetSize& target);

}  // namespace advlayers
