// Basic types that every module speaks: vectors and typed 32-bit ids.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>

namespace advlayers {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

// An index that knows what it counts: a FaceId is no EdgeId. Zero-based; -1 is "none".
template <class Tag>
struct Id {
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::int32_t v) : value(v) {}
  constexpr explicit Id(std::size_t v) : value(static_cast<std::int32_t>(v)) {}
  constexpr bool valid() const { return value >= 0; }
  constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value != b.value; }
  friend constexpr bool operator<(Id a, Id b) { return a.value < b.value; }
};

// CAD entities, numbered as FreeCAD numbers them less one: FaceId{2} is "Face3".
using FaceId = Id<struct FaceTag>;
using EdgeId = Id<struct EdgeTag>;
using VertexId = Id<struct VertexTag>;

// A set of CAD faces that one front system meshes.
using PatchId = Id<struct PatchTag>;

// A mesh node on a CAD vertex or edge, numbered over the whole model, shared by patches.
using NodeId = Id<struct NodeTag>;

// A point on the exact surface; xyz [mm] is S(u, v) of the face.
struct SurfacePoint {
  FaceId face;
  double u = 0.0;
  double v = 0.0;
  Vec3 xyz = Vec3::Zero();
};

}  // namespace advlayers

template <class Tag>
struct std::hash<advlayers::Id<Tag>> {
  std::size_t operator()(advlayers::Id<Tag> id) const noexcept {
    return std::hash<std::int32_t>{}(id.value);
  }
};
