#include "sizing/initial_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "geometry/evaluator.h"
#include "geometry/face_boxes.h"

namespace advlayers {
namespace {

constexpr double kOff = 0.25;    // of the spacing, that a node may lie off the shape
constexpr double kExact = 1e-3;  // of the spacing: surely on the face
constexpr int kMostOff = 100;    // nodes off the shape before the rest is not looked at any more
constexpr int kRounds = 3;       // over nodes not found on the shape at once
constexpr int kSamples = 8;      // per direction of a face, to find what is missing
constexpr double kReach = 1.2;   // of a triangle about its centroid, in radii
constexpr double kInfinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(const Sentence& reason) {
  throw InvalidInput("{}: {}", "initial_mesh", reason);
}

std::string shown(const Vec3& p) {
  std::ostringstream text;
  text << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
  return text.str();
}

void check_arrays(const InitialMesh& mesh) {
  if (mesh.triangles.empty()) refuse(Sentence("it has no surface elements"));
  const int count = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (mesh.points[i].allFinite()) continue;
    refuse(Sentence("node {} (from 0) has the coordinates {}", i, shown(mesh.points[i])));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      if (v >= 0 && v < count) continue;
      refuse(Sentence("triangle {} (from 0) has node {}, but there are {}", t, v, count));
    }
  }
}

// The nodes joined to each node, and the median length of its edges: one sliver beside it does not
// make a place fine.
class Neighbours {
 public:
  Neighbours(const RunContext& context, const InitialMesh& mesh)
      : begin_(mesh.points.size() + 1, 0), spacing_(mesh.points.size(), 0.0) {
    std::vector<std::pair<int, int>> edges;
    for (const auto& t : mesh.triangles) {
      context.check();
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        if (a != b) edges.insert(edges.end(), {{a, b}, {b, a}});
      }
    }
    std::sort(edges.begin(), edges.end(), [&context](const auto& a, const auto& b) {
      context.check();
      return a < b;
    });
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) {
      ++begin_[index(a) + 1];
      to_.push_back(b);
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    std::vector<double> lengths;
    for (std::size_t i = 0; i < spacing_.size(); ++i) {
      context.check();
      lengths.clear();
      for (std::size_t k = 0; k < degree(i); ++k) {
        lengths.push_back((mesh.points[of(i, k)] - mesh.points[i]).norm());
      }
      if (lengths.empty()) continue;
      const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
      std::nth_element(lengths.begin(), middle, lengths.end());
      spacing_[i] = *middle;
    }
  }

  std::size_t count() const { return spacing_.size(); }
  std::size_t degree(std::size_t node) const { return begin_[node + 1] - begin_[node]; }
  std::size_t of(std::size_t node, std::size_t k) const { return index(to_[begin_[node] + k]); }
  double spacing(std::size_t node) const { return spacing_[node]; }
  double averaged(std::size_t node) const {
    double sum = spacing_[node];
    for (std::size_t k = 0; k < degree(node); ++k) sum += spacing_[of(node, k)];
    return sum / static_cast<double>(degree(node) + 1);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  std::vector<std::size_t> begin_;
  std::vector<int> to_;
  std::vector<double> spacing_;
};

class Placer {
 public:
  Placer(const RunContext& context, const Model& model, const InitialMesh& mesh)
      : model_(model),
        mesh_(mesh),
        context_(context),
        neighbours_(context, mesh),
        evaluator_(model),
        boxes_(face_boxes(model)),
        feet_(mesh.points.size()),
        distances_(mesh.points.size(), kInfinity) {}

  // From node to node along the mesh: a node's neighbours tell where to look for its foot. What is
  // not on the shape then is looked at again, once all its neighbours have their feet.
  void run() {
    std::vector<char> reached(neighbours_.count(), 0);
    for (std::size_t start = 0; start < neighbours_.count(); ++start) {
      if (neighbours_.degree(start) == 0 || reached[start]) continue;
      std::vector<std::size_t> queue{start};
      reached[start] = 1;
      for (std::size_t i = 0; i < queue.size(); ++i) {
        place(queue[i]);
        for (std::size_t k = 0; k < neighbours_.degree(queue[i]); ++k) {
          const std::size_t next = neighbours_.of(queue[i], k);
          if (!std::exchange(reached[next], 1)) queue.push_back(next);
        }
      }
    }
    for (int round = 0; round < kRounds; ++round) {
      for (const std::size_t node : doubtful_) {
        context_.check();
        follow_neighbours(node);
      }
    }
    for (const std::size_t node : doubtful_) {
      if (is_off(node)) refuse_node(node);
    }
  }

  const Neighbours& neighbours() const { return neighbours_; }
  bool placed(std::size_t node) const { return feet_[node].face.valid(); }
  const SurfacePoint& foot(std::size_t node) const { return feet_[node]; }
  double distance(std::size_t node) const { return distances_[node]; }

  // Throws InvalidInput where a part of the faces is bare.
  void check_cover(const std::vector<FaceId>& faces);

 private:
  void consider(std::size_t node, const SurfacePoint& foot) {
    const double distance = (foot.xyz - mesh_.points[node]).norm();
    if (distance >= distances_[node]) return;
    distances_[node] = distance;
    feet_[node] = foot;
  }

  void place(std::size_t node) {
    context_.check();
    const std::vector<FaceId> asked = follow_neighbours(node);
    if (is_exact(node)) return;
    search(node, asked);
    doubtful_.push_back(node);
    if (is_off(node)) ++off_;
    if (off_ > kMostOff) refuse_node(node);
  }

  bool is_exact(std::size_t node) const {
    return distances_[node] <= kExact * neighbours_.spacing(node);
  }
  bool is_off(std::size_t node) const {
    return !(distances_[node] <= kOff * neighbours_.spacing(node));
  }

  // Returns the faces that hold a foot.
  std::vector<FaceId> follow_neighbours(std::size_t node) {
    std::vector<FaceId> asked;
    for (std::size_t k = 0; k < neighbours_.degree(node); ++k) {
      const SurfacePoint& seed = feet_[neighbours_.of(node, k)];
      if (!seed.face.valid()) continue;
      SurfacePoint foot;
      if (!evaluator_.project(mesh_.points[node], seed, foot)) continue;
      if (!evaluator_.inside(foot.face, foot.u, foot.v)) continue;
      if (!contains(asked, seed.face)) asked.push_back(seed.face);
      consider(node, foot);
      if (is_exact(node)) break;
    }
    return asked;
  }

  [[noreturn]] void refuse_node(std::size_t node) const {
    refuse(Sentence(
        "node {} (from 0) at {} lies {} mm off the shape; the most is {} mm, a quarter of "
        "the mesh's edge length there",
        node, shown(mesh_.points[node]), distances_[node], kOff * neighbours_.spacing(node)));
  }

  static bool contains(const std::vector<FaceId>& faces, FaceId face) {
    return std::find(faces.begin(), faces.end(), face) != faces.end();
  }

  // The nearest of all faces but those asked already.
  void search(std::size_t node, const std::vector<FaceId>& asked) {
    std::vector<std::pair<double, FaceId>> near;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const double distance = boxes_[i].exteriorDistance(mesh_.points[node]);
      if (boxes_[i].isEmpty() || distance >= distances_[node]) continue;
      if (model_.faces()[i].defect.empty()) near.emplace_back(distance, FaceId(i));
    }
    std::sort(near.begin(), near.end());
    for (const auto& [distance, face] : near) {
      if (distance >= distances_[node]) return;
      if (!contains(asked, face)) consider(node, evaluator_.closest(face, mesh_.points[node]));
    }
  }

  std::vector<FaceId> faces_near(const std::array<int, 3>& triangle) const;
  std::vector<Vec3> samples(FaceId face);

  const Model& model_;
  const InitialMesh& mesh_;
  const RunContext& context_;
  Neighbours neighbours_;
  Evaluator evaluator_;
  std::vector<Box> boxes_;
  std::vector<SurfacePoint> feet_;
  std::vector<double> distances_;
  std::vector<std::size_t> doubtful_;  // nodes not found on the shape at once
  int off_ = 0;
};

std::vector<Vec3> Placer::samples(FaceId id) {
  const Face& face = model_.face(id);
  std::vector<Vec3> points;
  for (int i = 0; i < kSamples; ++i) {
    for (int j = 0; j < kSamples; ++j) {
      const double u = face.u_min + (face.u_max - face.u_min) * (i + 0.5) / kSamples;
      const double v = face.v_min + (face.v_max - face.v_min) * (j + 0.5) / kSamples;
      if (evaluator_.inside(id, u, v)) points.push_back(evaluator_.frame(id, u, v).xyz);
    }
  }
  return points;
}

// The faces that its corners lie on, and those beside these: a corner on an edge is on one of the
// edge's faces only.
std::vector<FaceId> Placer::faces_near(const std::array<int, 3>& triangle) const {
  std::vector<FaceId> faces;
  for (const int corner : triangle) {
    const FaceId on = feet_[static_cast<std::size_t>(corner)].face;
    if (!on.valid() || contains(faces, on)) continue;
    for (const auto& loop : model_.face(on).loops) {
      for (const CoEdge& coedge : loop) {
        const auto& beside = model_.edge(coedge.edge).faces;
        faces.insert(faces.end(), beside.begin(), beside.end());
      }
    }
    faces.push_back(on);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void Placer::check_cover(const std::vector<FaceId>& faces) {
  std::vector<std::vector<Vec3>> bare(model_.faces().size());
  for (const FaceId face : faces) {
    context_.check();
    if (model_.face(face).defect.empty()) bare[face.index()] = samples(face);
  }
  for (const auto& triangle : mesh_.triangles) {
    context_.check();
    Vec3 centroid = Vec3::Zero();
    for (const int v : triangle) centroid += mesh_.points[static_cast<std::size_t>(v)] / 3;
    double radius = 0.0;
    for (const int v : triangle) {
      radius = std::max(radius, (mesh_.points[static_cast<std::size_t>(v)] - centroid).norm());
    }
    for (const FaceId face : faces_near(triangle)) {
      auto& points = bare[face.index()];
      const auto covered = [&](const Vec3& p) { return (p - centroid).norm() <= kReach * radius; };
      points.erase(std::remove_if(points.begin(), points.end(), covered), points.end());
    }
  }
  for (const FaceId face : faces) {
    if (bare[face.index()].empty()) continue;
    refuse(Sentence("it has no element about {} on {}: it is a mesh of another shape, or not whole",
                    shown(bare[face.index()].front()), face_name(face)));
  }
}

}  // namespace

InitialNodes::InitialNodes(const RunContext& context, const Model& model, const InitialMesh& mesh,
                           const std::vector<FaceId>& faces)
    : on_face_(model.faces().size()) {
  check_arrays(mesh);
  Placer placer(context, model, mesh);
  placer.run();
  placer.check_cover(faces);
  const Neighbours& neighbours = placer.neighbours();
  for (std::size_t i = 0; i < neighbours.count(); ++i) {
    context.check();
    if (!placer.placed(i)) continue;
    OnFace& on = on_face_[placer.foot(i).face.index()];
    on.nodes.push_back(placer.foot(i));
    on.spacings.push_back(neighbours.averaged(i));
    if (placer.distance(i) <= kExact * neighbours.spacing(i)) continue;
    ++moved_;
    farthest_ = std::max(farthest_, placer.distance(i));
  }
  for (OnFace& on : on_face_) {
    std::vector<Vec3> points;
    for (const SurfacePoint& node : on.nodes) points.push_back(node.xyz);
    on.tree = PointTree(context, std::move(points));
  }
}

double InitialNodes::spacing(FaceId face, const Vec3& p) const {
  const OnFace& on = on_face_[face.index()];
  const int nearest = on.tree.nearest(p);
  return nearest < 0 ? kInfinity : on.spacings[static_cast<std::size_t>(nearest)];
}

}  // namespace advlayers
