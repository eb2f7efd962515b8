#include "imprint/polygon_cuts.h"

#include <algorithm>
#include <iterator>

#include "measure/element_measures.h"
#include "quads/recombine.h"

namespace advlayers {
namespace {

using Corners = std::vector<VertexH>;

constexpr double kUnparted = -10.0;    // what a piece over two faces costs
constexpr std::size_t kMostTried = 9;  // corners: the ways to cut grow by a factor of three each

class Cutter {
 public:
  Cutter(const SurfaceMesh& mesh, const FaceSides& sides, bool triangles)
      : mesh_(mesh), sides_(sides), triangles_(triangles) {}

  PolygonPieces cut(const Corners& corners) const {
    if (corners.size() > kMostTried) return halve(corners);
    const bool parted = sides_.common(corners).valid();
    PolygonPieces whole = as_it_is(corners, parted);
    if (parted && (corners.size() == 3 || whole.quality >= kLeastPairQuality)) return whole;
    PolygonPieces best = whole;
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      for (std::size_t j = i + 2; j < corners.size(); ++j) {
        if (i == 0 && j + 1 == corners.size()) continue;
        // Where the polygon lies on several faces, only their common edge parts it well.
        if (!parted && !on_edge(corners[i], corners[j])) continue;
        PolygonPieces halves = join(cut(between(corners, i, j)), cut(around(corners, i, j)));
        if (best.polygons.empty() || halves.quality > best.quality) best = std::move(halves);
      }
    }
    if (best.polygons.empty()) return fan(corners);
    return best;
  }

 private:
  bool on_edge(VertexH a, VertexH b) const {
    return sides_.of(a).size() > 1 && sides_.of(b).size() > 1 && sides_.share_face(a, b);
  }

  // No pieces where the polygon is too large for one.
  PolygonPieces as_it_is(const Corners& c, bool parted) const {
    PolygonPieces pieces;
    pieces.parted = parted;
    pieces.quality = -100.0;
    if (c.size() == 3) {
      const Vec3 normal =
          mesh_.data(c[0]).normal + mesh_.data(c[1]).normal + mesh_.data(c[2]).normal;
      pieces.quality =
          min_angle_sine(mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2]), normal);
    } else if (c.size() == 4 && (!triangles_ || !parted)) {
      pieces.quality = quad_quality(mesh_, c[0], c[1], c[2], c[3]);
    } else {
      return pieces;
    }
    if (!parted) pieces.quality = std::min(pieces.quality, 0.0) + kUnparted;
    pieces.polygons.push_back(c);
    return pieces;
  }

  static Corners between(const Corners& c, std::size_t i, std::size_t j) {
    return Corners(c.begin() + static_cast<std::ptrdiff_t>(i),
                   c.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  }

  static Corners around(const Corners& c, std::size_t i, std::size_t j) {
    Corners rest(c.begin() + static_cast<std::ptrdiff_t>(j), c.end());
    rest.insert(rest.end(), c.begin(), c.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return rest;
  }

  static PolygonPieces join(PolygonPieces a, PolygonPieces b) {
    a.quality = std::min(a.quality, b.quality);
    a.parted = a.parted && b.parted;
    a.polygons.insert(a.polygons.end(), std::make_move_iterator(b.polygons.begin()),
                      std::make_move_iterator(b.polygons.end()));
    return a;
  }

  // Along the edge of the model that leaves halves of most equal size.
  PolygonPieces halve(const Corners& c) const {
    std::size_t best = 0, from = 0, to = 0;
    for (std::size_t i = 0; i + 2 < c.size(); ++i) {
      for (std::size_t j = i + 2; j < c.size(); ++j) {
        const std::size_t smaller = std::min(j - i, c.size() - (j - i));
        if (smaller < 2 || smaller <= best || !on_edge(c[i], c[j])) continue;
        best = smaller;
        from = i;
        to = j;
      }
    }
    if (best == 0) return fan(c);
    return join(cut(between(c, from, to)), cut(around(c, from, to)));
  }

  // What cannot be parted is cut all the same.
  static PolygonPieces fan(const Corners& c) {
    PolygonPieces pieces;
    pieces.parted = false;
    pieces.quality = kUnparted;
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      pieces.polygons.push_back({c[0], c[k], c[k + 1]});
    }
    return pieces;
  }

  const SurfaceMesh& mesh_;
  const FaceSides& sides_;
  bool triangles_;
};

}  // namespace

PolygonPieces cut_polygon(const SurfaceMesh& mesh, const FaceSides& sides, const Corners& corners,
                          bool triangles) {
  return Cutter(mesh, sides, triangles).cut(corners);
}

}  // namespace advlayers
