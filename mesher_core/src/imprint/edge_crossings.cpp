#include "imprint/edge_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace advlayers {
namespace {

constexpr int kApproaches = 8;  // of chord and curve
constexpr int kDeepest = 6;     // halvings of a chord over several faces
// How far off the chord the crossing may lie, as a share of it: at first, and at the most.
constexpr double kNearBy = 0.15, kFarOff = 1.0;

}  // namespace

// Where the chord a -> b crosses the edges between two faces.
bool EdgeCrossings::find_cut(const Vec3& a, const Vec3& b, FaceId from, FaceId onto, double off,
                             CutPoint& cut) {
  const Vec3 chord = b - a;
  const double length2 = chord.squaredNorm();
  double share = 0.5;
  PatchSurface::InnerPoint inner;
  for (int i = 0; i < kApproaches; ++i) {
    if (!surface_.nearest_between(from, onto, a + share * chord, inner)) return false;
    const double before = share;
    share = std::clamp((inner.point.xyz - a).dot(chord) / length2, 0.0, 1.0);
    if (std::abs(share - before) < 1e-12) break;
  }
  // Beyond the end of the edge the chord crosses another one.
  if (inner.at_end && off < kFarOff) return false;
  cut.point = inner.point;
  cut.share = share;
  cut.faces = {std::min(from, onto), std::max(from, onto)};
  return (cut.point.xyz - a - share * chord).squaredNorm() < off * off * length2;
}

bool EdgeCrossings::nearest_cut(const Vec3& a, const Faces& faces_a, const Vec3& b,
                                const Faces& faces_b, double most_off, CutPoint& best) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const FaceId from : faces_a) {
    for (const FaceId onto : faces_b) {
      CutPoint cut;
      if (!find_cut(a, b, from, onto, most_off, cut)) continue;
      const double off = (a + cut.share * (b - a) - cut.point.xyz).norm();
      if (off >= nearest) continue;
      nearest = off;
      best = std::move(cut);
    }
  }
  return nearest < std::numeric_limits<double>::infinity();
}

// Where the chord passes over a face between the two, and where it leaves that.
std::vector<CutPoint> EdgeCrossings::cuts_over_third(const Vec3& a, const Faces& faces_a,
                                                     const Vec3& b, const Faces& faces_b) {
  std::vector<CutPoint> best;
  double least = std::numeric_limits<double>::infinity();
  const auto off = [&](const CutPoint& cut) {
    return (a + cut.share * (b - a) - cut.point.xyz).norm();
  };
  for (const FaceId third : surface_.faces()) {
    CutPoint in, out;
    if (!nearest_cut(a, faces_a, b, {third}, kFarOff, in) ||
        !nearest_cut(a, {third}, b, faces_b, kFarOff, out)) {
      continue;
    }
    if (in.share >= out.share || off(in) + off(out) >= least) continue;
    least = off(in) + off(out);
    best = {in, out};
  }
  return best;
}

// All crossings of a mesh edge in order; empty where they cannot be told.
std::vector<CutPoint> EdgeCrossings::between(VertexH a, VertexH b) {
  std::vector<CutPoint> cuts;
  if (sides_.share_face(a, b)) return cuts;
  const SurfacePoint &from = mesh_.data(a).point, &to = mesh_.data(b).point;
  if (collect(from, sides_.of(a), 0.0, to, sides_.of(b), 1.0, kDeepest, cuts)) return cuts;
  // A chord that leaves the surface far behind, as over a valley.
  cuts.clear();
  CutPoint cut;
  if (nearest_cut(from.xyz, sides_.of(a), to.xyz, sides_.of(b), kFarOff, cut)) {
    cuts.push_back(cut);
  } else {
    cuts = cuts_over_third(from.xyz, sides_.of(a), to.xyz, sides_.of(b));
  }
  return cuts;
}

bool EdgeCrossings::collect(const SurfacePoint& a, const Faces& faces_a, double share_a,
                            const SurfacePoint& b, const Faces& faces_b, double share_b, int depth,
                            std::vector<CutPoint>& cuts) {
  for (const FaceId face : faces_a) {
    if (std::binary_search(faces_b.begin(), faces_b.end(), face)) return true;
  }
  CutPoint best;
  if (nearest_cut(a.xyz, faces_a, b.xyz, faces_b, depth > 0 ? kNearBy : kFarOff, best)) {
    best.share = share_a + best.share * (share_b - share_a);
    cuts.push_back(std::move(best));
    return true;
  }
  if (depth == 0) return false;
  SurfacePoint middle;
  if (!surface_.project(0.5 * (a.xyz + b.xyz), a, middle)) return false;
  surface_.settle(middle);
  const double half = 0.5 * (share_a + share_b);
  const Faces faces{middle.face};
  return collect(a, faces_a, share_a, middle, faces, half, depth - 1, cuts) &&
         collect(middle, faces, half, b, faces_b, share_b, depth - 1, cuts);
}

}  // namespace advlayers
