#include "layers/recover.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "mesh/triangle_measures.h"

namespace advlayers {
namespace {

// Barycentric coordinates nearer to zero than this count as on the edge (paper, II.C).
constexpr double kOnEdge = 1e-5;
// The point goes on the edge where the second-smallest coordinate exceeds the smallest by this.
constexpr double kEdgeRatio = 100.0;
// A vertex nearer to the cut than this, relative to the length of the segment, lies on it.
constexpr double kOnCut = 1e-9;

// The cutting plane through a segment and the surface normal; sides are measured in mm.
struct Cut {
  Vec3 origin, left, along;
  double length;

  Cut(const Corner& a, const Corner& b) : origin(a.xyz), along(b.xyz - a.xyz) {
    length = along.norm();
    left = (a.normal + b.normal).cross(along).normalized();
    along /= length;
  }
  // Which side of the cut: -1 right, 0 on it, 1 left.
  int side(const Vec3& p) const {
    const double s = left.dot(p - origin);
    if (std::abs(s) <= kOnCut * std::max(length, (p - origin).norm())) return 0;
    return s > 0.0 ? 1 : -1;
  }
  bool ahead(const Vec3& p) const { return along.dot(p - origin) > 0.0; }
};

// How a trace from a vertex went on.
struct Trace {
  std::vector<HalfedgeH> crossed;  // each from the right of the cut to the left
  VertexH hit;                     // a vertex on the cut that the trace ran into
  FaceH face;                      // where it ended; invalid if blocked
};

// The first crossed edge opposite `a`, or the vertex hit at once.
Trace start_trace(const SurfaceMesh& mesh, VertexH a, const Cut& cut) {
  Trace trace;
  for (const HalfedgeH o : mesh.around(a)) {
    const VertexH p = mesh.to(o);
    const int side_p = cut.side(mesh.position(p));
    if (side_p == 0 && cut.ahead(mesh.position(p))) {
      trace.hit = p;
      return trace;
    }
    if (!mesh.is_border(o) && mesh.is_triangle(o)) {
      const VertexH q = mesh.to(mesh.next(o));
      if (side_p < 0 && cut.side(mesh.position(q)) > 0) {
        trace.face = mesh.face(o);
        trace.crossed.push_back(mesh.next(o));
      }
    }
  }
  return trace;
}

// Goes through the edge crossed last; false when the trace ends there.
bool go_on(const SurfaceMesh& mesh, const Cut& cut, Trace& trace) {
  const HalfedgeH crossed = trace.crossed.back();
  const HalfedgeH beyond = SurfaceMesh::twin(crossed);
  if (mesh.frozen(crossed) || mesh.is_border(beyond) || !mesh.is_triangle(beyond)) {
    trace.face = FaceH();
    return false;
  }
  trace.face = mesh.face(beyond);
  const VertexH apex = mesh.to(mesh.next(beyond));
  const int side = cut.side(mesh.position(apex));
  if (side == 0) {
    trace.hit = apex;
    return false;
  }
  // beyond runs from left to right; the apex takes the place of the end on its own side.
  trace.crossed.push_back(side > 0 ? mesh.next(beyond) : mesh.prev(beyond));
  return true;
}

// The edges between a and b; `hit` is b where the way is free.
Trace trace_to_vertex(const SurfaceMesh& mesh, VertexH a, VertexH b) {
  const Cut cut(corner(mesh, a), corner(mesh, b));
  Trace trace = start_trace(mesh, a, cut);
  std::size_t limit = mesh.face_capacity();
  while (!trace.crossed.empty() && trace.face.valid() && !trace.hit.valid() && limit-- > 0) {
    const HalfedgeH beyond = SurfaceMesh::twin(trace.crossed.back());
    if (!mesh.frozen(beyond) && !mesh.is_border(beyond) && mesh.is_triangle(beyond) &&
        mesh.to(mesh.next(beyond)) == b) {
      trace.hit = b;
      return trace;
    }
    if (!go_on(mesh, cut, trace)) break;
  }
  return trace;
}

// The core face that holds the point, seen along `normal`.
Trace trace_to_point(const SurfaceMesh& mesh, VertexH from, const Corner& target) {
  const Cut cut(corner(mesh, from), target);
  Trace trace = start_trace(mesh, from, cut);
  std::size_t limit = mesh.face_capacity();
  while (trace.face.valid() && !trace.hit.valid() && limit-- > 0) {
    const HalfedgeH exit = trace.crossed.back();
    const Corner p = corner(mesh, mesh.from(exit)), q = corner(mesh, mesh.to(exit));
    if (signed_area2(p, q, target) >= 0.0) {
      trace.crossed.pop_back();
      return trace;
    }
    if (!go_on(mesh, cut, trace)) break;
  }
  return trace;
}

bool crosses(const SurfaceMesh& mesh, HalfedgeH h, VertexH a, VertexH b, const Cut& cut) {
  for (const VertexH v : {mesh.from(h), mesh.to(h)}) {
    if (v == a || v == b) return false;
  }
  return cut.side(mesh.position(mesh.from(h))) * cut.side(mesh.position(mesh.to(h))) < 0;
}

// Swaps the crossed edges away one after the other; those whose pair is not convex wait.
bool swap_away(SurfaceMesh& mesh, const std::vector<HalfedgeH>& crossed, VertexH a, VertexH b,
               VetoTally& tally) {
  const Cut cut(corner(mesh, a), corner(mesh, b));
  std::deque<HalfedgeH> queue(crossed.begin(), crossed.end());
  std::size_t waits = 0;
  std::size_t budget = 8 * crossed.size() * crossed.size() + 16;
  while (!queue.empty() && budget-- > 0) {
    const HalfedgeH h = queue.front();
    queue.pop_front();
    const Veto veto = orientation_veto(mesh, h);
    count(tally, veto);
    if (veto != Veto::kNone) {
      queue.push_back(h);
      if (++waits > queue.size()) return false;
      continue;
    }
    mesh.flip(h);
    waits = 0;
    if (crosses(mesh, h, a, b, cut)) queue.push_back(h);
  }
  return queue.empty();
}

// The target's barycentric coordinates in a triangle's plane; each opposite the edge it is listed
// with.
struct Barycentric {
  std::array<HalfedgeH, 3> edges;
  std::array<double, 3> values;
};
Barycentric barycentric(const SurfaceMesh& mesh, FaceH f, const Corner& target) {
  Barycentric result;
  double sum = 0.0;
  std::size_t side = 0;
  for (const HalfedgeH h : mesh.sides(f)) {
    const Vec3 p = mesh.position(mesh.from(h)) - target.xyz;
    const Vec3 q = mesh.position(mesh.to(h)) - target.xyz;
    result.edges[side] = h;
    result.values[side] = p.cross(q).dot(target.normal);
    sum += result.values[side++];
  }
  for (double& value : result.values) value /= sum;
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < 2; ++k) {
      if (result.values[k] > result.values[k + 1]) {
        std::swap(result.values[k], result.values[k + 1]);
        std::swap(result.edges[k], result.edges[k + 1]);
      }
    }
  }
  return result;
}

bool upright_with(const SurfaceMesh& mesh, HalfedgeH h, const Corner& apex) {
  return signed_area2(corner(mesh, mesh.from(h)), corner(mesh, mesh.to(h)), apex) > 0.0;
}

// May the edge be split at the target: all four triangles stay upright.
bool edge_takes(const SurfaceMesh& mesh, HalfedgeH h, const Corner& target) {
  if (mesh.split_edge_veto(h) != Veto::kNone) return false;
  for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
    if (mesh.is_border(side)) return false;
    if (!upright_with(mesh, mesh.next(side), target)) return false;
    if (!upright_with(mesh, mesh.prev(side), target)) return false;
  }
  return true;
}

VertexH insert_in_face(SurfaceMesh& mesh, FaceH f, const VertexData& data) {
  const Corner target{data.point.xyz, data.normal};
  const Barycentric at = barycentric(mesh, f, target);
  const bool near_edge = at.values[0] < kOnEdge || at.values[1] > kEdgeRatio * at.values[0];
  if (near_edge && edge_takes(mesh, at.edges[0], target)) return mesh.split_edge(at.edges[0], data);
  for (const HalfedgeH h : at.edges) {
    if (!upright_with(mesh, h, target)) {
      return edge_takes(mesh, h, target) ? mesh.split_edge(h, data) : VertexH();
    }
  }
  return mesh.split_face(f, data);
}

}  // namespace

VertexH insert_point(SurfaceMesh& mesh, VertexH from, const VertexData& data,
                     const ReconnectLimits& limits, VetoTally& tally) {
  const Corner target{data.point.xyz, data.normal};
  const double reach = (target.xyz - mesh.position(from)).norm();
  // Core vertices that the trace runs into give way; each pass removes one.
  for (int tries = 0; tries < 16; ++tries) {
    const Trace trace = trace_to_point(mesh, from, target);
    if (trace.hit.valid()) {
      const double distance = (mesh.position(trace.hit) - mesh.position(from)).norm();
      if (distance > reach * (1.0 + kOnEdge)) {
        // The vertex lies beyond: the point is in the last face, or on the edge that leads there.
        if (trace.face.valid()) return insert_in_face(mesh, trace.face, data);
        const HalfedgeH h = mesh.find_halfedge(from, trace.hit);
        return h.valid() && edge_takes(mesh, h, target) ? mesh.split_edge(h, data) : VertexH();
      }
      if (!is_core_vertex(mesh, trace.hit) ||
          !remove_core_vertex(mesh, trace.hit, Removal::kForced, limits, tally)) {
        return {};
      }
      continue;
    }
    return trace.face.valid() ? insert_in_face(mesh, trace.face, data) : VertexH();
  }
  return {};
}

HalfedgeH recover_edge(SurfaceMesh& mesh, VertexH a, VertexH b, const ReconnectLimits& limits,
                       VetoTally& tally) {
  for (int tries = 0; tries < 64; ++tries) {
    if (const HalfedgeH h = mesh.find_halfedge(a, b); h.valid()) return h;
    const Trace trace = trace_to_vertex(mesh, a, b);
    if (!trace.hit.valid()) return {};
    if (trace.hit != b) {
      if (!is_core_vertex(mesh, trace.hit) ||
          !remove_core_vertex(mesh, trace.hit, Removal::kForced, limits, tally)) {
        return {};
      }
      continue;
    }
    if (!swap_away(mesh, trace.crossed, a, b, tally)) return {};
  }
  return {};
}

std::vector<FaceH> clear_region(SurfaceMesh& mesh, HalfedgeH h, std::size_t most,
                                const ReconnectLimits& limits, VetoTally& tally) {
  std::vector<FaceH> faces;
  for (std::size_t tries = 0; tries <= most; ++tries) {
    faces.assign(1, mesh.face(h));
    VertexH inside;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (const HalfedgeH e : mesh.sides(faces[i])) {
        if (is_core_vertex(mesh, mesh.to(e))) inside = mesh.to(e);
        if (mesh.frozen(e)) continue;
        const FaceH beyond = mesh.face(SurfaceMesh::twin(e));
        if (std::find(faces.begin(), faces.end(), beyond) == faces.end()) faces.push_back(beyond);
      }
      if (faces.size() > most) return {};
    }
    if (!inside.valid()) return faces;
    if (!remove_core_vertex(mesh, inside, Removal::kForced, limits, tally)) return {};
  }
  return {};
}

}  // namespace advlayers
