#include "core/cross_directions.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>

namespace advlayers {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;
using Values = Eigen::VectorXcd;

// A border vertex whose two edges agree less on a cross has none of its own: those of a circle of
// twelve edges do, half.
constexpr double kLeastAgreement = 0.45;
// Which arm comes first may not hang on round-off where a cross lies at 45 degrees in its frame:
// the turn changes over elsewhere [rad, times the arms].
constexpr double kFirstArm = 0.3;
// Times, in shares of the room's area, for which crosses spread before they are made unit ones
// again, and how often.
constexpr double kSpreadTimes[] = {0.02, 0.002, 0.0003};
constexpr int kSpreads = 8;        // for each of these times
constexpr int kInverseSteps = 12;  // towards the smoothest field of a closed patch

// The same for each of the arms.
Complex power(const Complex& z, int arms) {
  const Complex square = z * z;
  return arms == 4 ? square * square : square * square * square;
}

Complex unit(const Complex& z) {
  const double size = std::abs(z);
  return size > 0.0 ? z / size : Complex(1.0, 0.0);
}

struct Frame {
  Vec3 x, y;
  Complex of(const Vec3& v) const { return {v.dot(x), v.dot(y)}; }
};

class DirectionSolver {
 public:
  DirectionSolver(const RunContext& context, const SurfaceMesh& mesh, const CoreRoom& room,
                  int arms)
      : mesh_(mesh), room_(room), arms_(arms), context_(context) {
    for (const VertexH v : room.vertices) {
      // Of the mesh itself, so that a patch that is turned gets the same.
      const Vec3 edge = mesh.position(mesh.to(mesh.outgoing(v))) - mesh.position(v);
      const Vec3& normal = mesh.data(v).normal;
      const Vec3 x = (edge - edge.dot(normal) * normal).normalized();
      frames_.push_back({x, normal.cross(x)});
    }
    values_.assign(room.vertices.size(), 0.0);
    given_.assign(room.vertices.size(), 0);
  }

  void run() {
    take_border();
    number_unknowns();
    if (unknowns_ == 0) return;
    assemble();
    if (static_cast<std::size_t>(unknowns_) < values_.size()) {
      find_harmonic();
    } else {
      find_smoothest();
    }
    for (const double time : kSpreadTimes) spread(time * area_);
  }

  std::vector<CrossDirection> crosses() const {
    std::vector<CrossDirection> crosses(values_.size());
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const double angle = (std::arg(values_[k] * std::polar(1.0, -kFirstArm)) + kFirstArm) / arms_;
      crosses[k].along = std::cos(angle) * frames_[k].x + std::sin(angle) * frames_[k].y;
      crosses[k].weight = std::max(1e-3, std::abs(values_[k]));
      crosses[k].given = given_[k] != 0;
    }
    return crosses;
  }

 private:
  void take_border() {
    std::vector<double> count(given_.size(), 0.0);
    for (const HalfedgeH h : room_.border) {
      const Vec3 edge = mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h));
      for (const VertexH v : {mesh_.from(h), mesh_.to(h)}) {
        const std::size_t k = room_.number(v);
        values_[k] += power(unit(frames_[k].of(edge)), arms_);
        count[k] += 1.0;
      }
    }
    for (std::size_t k = 0; k < given_.size(); ++k) {
      given_[k] = count[k] > 0.0 && std::abs(values_[k]) >= kLeastAgreement * count[k];
      values_[k] = given_[k] ? unit(values_[k]) : 0.0;
    }
  }

  void number_unknowns() {
    unknown_.assign(given_.size(), -1);
    for (std::size_t k = 0; k < given_.size(); ++k) {
      if (!given_[k]) unknown_[k] = unknowns_++;
    }
  }

  // The Laplacian of the unknown ones, the masses, and what the given ones add on the right.
  void assemble() {
    std::vector<Eigen::Triplet<Complex>> entries;
    right_ = Values::Zero(unknowns_);
    masses_ = Eigen::VectorXd::Zero(unknowns_);
    for (const RoomEdge& edge : room_.edges(mesh_)) {
      const std::size_t i = room_.number(edge.from), j = room_.number(edge.to);
      const int a = unknown_[i], b = unknown_[j];
      const Vec3 way = mesh_.position(edge.to) - mesh_.position(edge.from);
      const Complex turn = power(unit(frames_[j].of(way) / frames_[i].of(way)), arms_);
      const double mass = edge.area / 6.0;
      area_ += edge.area / 3.0;
      if (a >= 0) {
        entries.emplace_back(a, a, edge.weight);
        masses_[a] += mass;
      }
      if (b >= 0) {
        entries.emplace_back(b, b, edge.weight);
        masses_[b] += mass;
      }
      if (a >= 0 && b >= 0) {
        entries.emplace_back(b, a, -edge.weight * turn);
        entries.emplace_back(a, b, -edge.weight * std::conj(turn));
      } else if (a >= 0) {
        right_[a] += edge.weight * std::conj(turn) * values_[j];
      } else if (b >= 0) {
        right_[b] += edge.weight * turn * values_[i];
      }
    }
    laplacian_.resize(unknowns_, unknowns_);
    laplacian_.setFromTriplets(entries.begin(), entries.end());
  }

  Values known_unknowns() const {
    Values values(unknowns_);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (unknown_[k] >= 0) values[unknown_[k]] = values_[k];
    }
    return values;
  }

  void store(const Values& found) {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (unknown_[k] >= 0) values_[k] = found[unknown_[k]];
    }
  }

  Matrix shifted(double share) const {
    Matrix matrix = laplacian_;
    for (int a = 0; a < unknowns_; ++a) matrix.coeffRef(a, a) += share * masses_[a];
    return matrix;
  }

  void find_harmonic() {
    const Eigen::SimplicialLDLT<Matrix> solver(shifted(1e-9 / area_));
    context_.check();
    store(solver.solve(right_));
  }

  // The eigenvector of the least eigenvalue, by inverse iteration.
  void find_smoothest() {
    const Eigen::SimplicialLDLT<Matrix> solver(shifted(1e-6 / area_));
    Values values = Values::Ones(unknowns_);
    for (int step = 0; step < kInverseSteps; ++step) {
      context_.check();
      values = solver.solve(masses_.asDiagonal() * values).eval();
      values *= std::sqrt(unknowns_) / values.norm();
    }
    store(values);
  }

  // Harmonic crosses fade towards the middle of the room, and their singular points fall together
  // there. Spread for a while and made unit ones in turn, these part to where they cost least.
  void spread(double time) {
    const Eigen::SimplicialLDLT<Matrix> solver(shifted(1.0 / time));
    Values values = known_unknowns();
    for (int step = 0; step < kSpreads; ++step) {
      context_.check();
      for (int a = 0; a < unknowns_; ++a) values[a] = unit(values[a]);
      values = solver.solve(right_ + (masses_.asDiagonal() * values) / time).eval();
    }
    store(values);
  }

  const SurfaceMesh& mesh_;
  const CoreRoom& room_;
  int arms_;
  const RunContext& context_;
  std::vector<Frame> frames_;
  std::vector<Complex> values_;  // powers in the frames
  std::vector<char> given_;
  std::vector<int> unknown_;
  int unknowns_ = 0;
  Matrix laplacian_;
  Values right_;
  Eigen::VectorXd masses_;
  double area_ = 0.0;
};

}  // namespace

std::vector<CrossDirection> find_cross_directions(const RunContext& context,
                                                  const SurfaceMesh& mesh, const CoreRoom& room,
                                                  int arms) {
  DirectionSolver solver(context, mesh, room, arms);
  solver.run();
  return solver.crosses();
}

}  // namespace advlayers
