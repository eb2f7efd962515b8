#include "mesher/wall_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "layers/corner_class.h"

namespace advlayers {
namespace {

constexpr int kNoKid = -1;
constexpr int kSeveralKids = -2;

// The mesh as columns: each vertex and the one that was extruded from it.
struct Columns {
  Columns(const RunContext& context, const SurfaceMesh& mesh)
      : kid(mesh.vertex_capacity(), kNoKid) {
    for (std::size_t i = 0; i < kid.size(); ++i) {
      context.check();
      const VertexH v(i);
      if (!mesh.alive(v)) continue;
      const VertexH parent = mesh.data(v).parent;
      if (!parent.valid() || !mesh.alive(parent)) continue;
      // A boundary vertex that two chains' ends passed knows the later one alone: without the order
      // of layers such columns could run in a circle.
      if (mesh.data(parent).layer >= mesh.data(v).layer) continue;
      if (!mesh.find_halfedge(parent, v).valid()) continue;
      int& slot = kid[parent.index()];
      slot = slot == kNoKid ? v.value : kSeveralKids;
    }
  }
  VertexH only_kid(VertexH v) const { return VertexH(std::max(kid[v.index()], kNoKid)); }

  std::vector<int> kid;
};

bool is_straight(const SurfaceMesh& mesh, HalfedgeH border) {
  static const double least_cosine = std::cos(kRegularTurn);
  const Vec3 in = mesh.position(mesh.from(border)) - mesh.position(mesh.from(mesh.prev(border)));
  const Vec3 out = mesh.position(mesh.to(border)) - mesh.position(mesh.from(border));
  return in.dot(out) > least_cosine * in.norm() * out.norm();
}

int regularity(const SurfaceMesh& mesh, const Columns& columns, HalfedgeH border) {
  if (!is_straight(mesh, border)) return 0;
  HalfedgeH h = mesh.prev(mesh.prev(border));
  for (int k = 0; k < 5; ++k, h = mesh.next(h)) {
    if (!is_straight(mesh, h) || !columns.only_kid(mesh.from(h)).valid()) return 1;
  }
  return 2;
}

struct Sample {
  double first = 0.0;   // [mm]
  double second = 0.0;  // [mm]; 0: the column has one layer
  double whole = 0.0;   // of all its layers [mm]
  double asked = 0.0;   // first height [mm]
  int regularity = 0;   // 0: a corner; 1: the wall is straight here; 2: and two edges around
};

// A corner's column runs along its bisector: what of it stands square to the wall, per length.
double square_to_wall(const SurfaceMesh& mesh, HalfedgeH border, VertexH kid) {
  const Vec3 foot = mesh.position(mesh.from(border));
  const Vec3 along = (mesh.position(mesh.to(border)) - foot).normalized();
  return (mesh.position(kid) - foot).normalized().cross(along).norm();
}

Sample measure_column(const SurfaceMesh& mesh, PatchSurface& surface, const Columns& columns,
                      HalfedgeH border) {
  Sample sample;
  const VertexH foot = mesh.from(border);
  VertexH kid = columns.only_kid(foot);
  if (!kid.valid()) {  // of several, the one over this wall: it bounds the wall's own element
    kid = mesh.to(mesh.next(SurfaceMesh::twin(border)));
    if (mesh.data(kid).parent != foot) return sample;
  }
  sample.first = arc_length(surface, mesh.data(foot).point, mesh.data(kid).point);
  sample.regularity = regularity(mesh, columns, border);
  sample.whole = sample.first;
  VertexH top = kid;
  for (VertexH next = columns.only_kid(top); next.valid(); next = columns.only_kid(top)) {
    const double height = arc_length(surface, mesh.data(top).point, mesh.data(next).point);
    if (top == kid) sample.second = height;
    sample.whole += height;
    top = next;
  }
  if (sample.regularity == 0) {
    const double square = square_to_wall(mesh, border, kid);
    for (double* height : {&sample.first, &sample.second, &sample.whole}) *height *= square;
  }
  return sample;
}

void summarize(const std::vector<Sample>& samples, WallReport& report) {
  int best = 0;
  for (const Sample& s : samples) {
    if (s.first > 0.0) best = std::max(best, s.regularity);
  }
  int heights = 0, ratios = 0;
  double sum = 0.0, ratio_sum = 0.0, asked_sum = 0.0, whole_sum = 0.0;
  for (const Sample& s : samples) {
    if (s.first <= 0.0 || s.regularity < best) continue;
    report.achieved_min = heights > 0 ? std::min(report.achieved_min, s.first) : s.first;
    report.achieved_max = std::max(report.achieved_max, s.first);
    report.height_error = std::max(report.height_error, std::abs(s.first / s.asked - 1.0));
    report.thickness_min = heights > 0 ? std::min(report.thickness_min, s.whole) : s.whole;
    report.thickness_max = std::max(report.thickness_max, s.whole);
    sum += s.first;
    asked_sum += s.asked;
    whole_sum += s.whole;
    ++heights;
    if (s.second <= 0.0) continue;
    ratio_sum += s.second / s.first;
    ++ratios;
  }
  if (heights > 0) {  // a mean of equal heights may leave them by round-off
    report.achieved_mean = std::clamp(sum / heights, report.achieved_min, report.achieved_max);
    report.thickness_mean =
        std::clamp(whole_sum / heights, report.thickness_min, report.thickness_max);
    report.first_height = asked_sum / heights;
  }
  if (ratios > 0) report.achieved_growth = ratio_sum / ratios;
}

// The records of each wall vertex, as a range of the records sorted by vertex.
class Stops {
 public:
  explicit Stops(std::vector<StopRecord> records) : records_(std::move(records)) {
    std::stable_sort(records_.begin(), records_.end(),
                     [](const StopRecord& a, const StopRecord& b) { return a.root < b.root; });
  }
  template <class Visit>
  void visit(VertexH root, const Visit& visit_record) const {
    const auto first = std::lower_bound(
        records_.begin(), records_.end(), root,
        [](const StopRecord& record, VertexH vertex) { return record.root < vertex; });
    for (auto it = first; it != records_.end() && it->root == root; ++it) visit_record(*it);
  }

 private:
  std::vector<StopRecord> records_;
};

// Where fronts or columns met there was no room for another layer; elsewhere one is missing.
bool ran_out_of_room(Stop reason) { return reason == Stop::kClosed || reason == Stop::kMerged; }

// The column's last vertex, as far as it has one kid after the other.
Vec3 top_of(const SurfaceMesh& mesh, const Columns& columns, VertexH root) {
  VertexH top = root;
  for (VertexH kid = columns.only_kid(root); kid.valid(); kid = columns.only_kid(top)) top = kid;
  return mesh.position(top);
}

void keep_first(const SurfaceMesh& mesh, const Columns& columns, const StopRecord& record,
                WallReport& report) {
  const auto [place, fresh] = report.first_stops.try_emplace(name_in(kStops, record.reason));
  if (!fresh && place->second.layer <= record.layer) return;
  place->second = {top_of(mesh, columns, record.root), record.layer};
}

// The layers of a column that the mesh still has: an extrusion with an element of the layer beside
// it, from each vertex to one of its kids.
int layers_over(const SurfaceMesh& mesh, VertexH from, int layer) {
  int most = layer;
  for (const HalfedgeH h : mesh.around(from)) {
    const VertexH kid = mesh.to(h);
    const VertexData& data = mesh.data(kid);
    const auto in_layer = [&](HalfedgeH side) {
      return !mesh.is_border(side) && mesh.data(mesh.face(side)).layer == data.layer;
    };
    if (data.parent == from && data.layer > layer &&
        (in_layer(h) || in_layer(SurfaceMesh::twin(h)))) {
      most = std::max(most, layers_over(mesh, kid, data.layer));
    }
  }
  return most;
}

// The record as the finished mesh bears it out.
StopRecord borne_out(const SurfaceMesh& mesh, StopRecord record) {
  if (ran_out_of_room(record.reason)) return record;
  const int found = layers_over(mesh, record.root, 0);
  if (found >= record.layer - 1) return record;
  if (record.reason == Stop::kLayersReached) record.reason = Stop::kBlocked;
  record.layer = found + 1;
  return record;
}

void count_layers(const RunContext& context, const SurfaceMesh& mesh, const Columns& columns,
                  const Stops& stops, const std::vector<VertexH>& roots, int layers_made,
                  WallReport& report) {
  int shortest = layers_made, longest = 0;
  bool all_closed = true;
  for (const VertexH root : roots) {
    context.check();
    bool stopped = false;
    stops.visit(root, [&](const StopRecord& noted) {
      const StopRecord record = borne_out(mesh, noted);
      ++report.stops[name_in(kStops, record.reason)];
      keep_first(mesh, columns, record, report);
      stopped = true;
      longest = std::max(longest, record.layer - 1);
      if (ran_out_of_room(record.reason)) return;
      all_closed = false;
      shortest = std::min(shortest, record.layer - 1);
    });
    if (!stopped) all_closed = false;
  }
  report.layers = all_closed ? longest : shortest;
}

struct Wall {
  std::vector<Sample> samples;
  std::vector<VertexH> roots;
};

}  // namespace

double arc_length(PatchSurface& surface, const SurfacePoint& from, const SurfacePoint& to) {
  const double chord = (to.xyz - from.xyz).norm();
  SurfacePoint middle;
  if (!surface.project(0.5 * (from.xyz + to.xyz), from, middle)) return chord;
  const double halves = (middle.xyz - from.xyz).norm() + (to.xyz - middle.xyz).norm();
  const double arc = (4.0 * halves - chord) / 3.0;
  // A midpoint that landed on another sheet of the surface says nothing about this edge.
  return arc < 1.6 * chord ? arc : chord;
}

std::vector<WallReport> measure_walls(const RunContext& context, const SurfaceMesh& mesh,
                                      PatchSurface& surface, const WallPlan& plan,
                                      const std::vector<StopRecord>& stops, int layers_made) {
  const Columns columns(context, mesh);
  const Stops stops_by_root(stops);
  std::map<EdgeId, Wall> walls;
  const auto is_wall = [&](HalfedgeH h) {
    const auto planned = plan.edges.find(mesh.curve(h));
    return planned != plan.edges.end() && planned->second.condition == EdgeCondition::kWall;
  };
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    context.check();
    const HalfedgeH h(i);
    if (!mesh.alive(h) || !mesh.is_border(h) || !is_wall(h)) continue;
    Wall& wall = walls[mesh.curve(h)];
    wall.samples.push_back(measure_column(mesh, surface, columns, h));
    wall.samples.back().asked =
        plan.edges.at(mesh.curve(h)).height_at(mesh.data(mesh.from(h)).node);
    // Where walls end beside another condition, that one decides about the column.
    if (is_wall(mesh.prev(h))) wall.roots.push_back(mesh.from(h));
  }
  std::vector<WallReport> reports;
  for (const auto& [edge, wall] : walls) {
    WallReport report;
    const EdgePlan& asked = plan.edges.at(edge);
    report.edge = edge;
    report.first_height = asked.growth.height;
    report.first_heights = asked.heights_along;
    report.growth = asked.growth.ratio;
    const bool until_closed = asked.growth.layers_left == kUntilClosed;
    report.until_isotropic = plan.stop_at_isotropy && until_closed;
    report.requested_layers = until_closed ? 0 : asked.growth.layers_left;
    summarize(wall.samples, report);
    if (report.requested_layers > 0) {
      report.thickness = thickness_of(report.first_height, report.growth, report.requested_layers);
    }
    count_layers(context, mesh, columns, stops_by_root, wall.roots, layers_made, report);
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace advlayers
