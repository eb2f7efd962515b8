#include "boundary/facing_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace advlayers {
namespace {

// Segments that a gap may be wide: at two the paper's wing has 5 % more elements.
constexpr double kReach = 1.0;
constexpr double kFacing = 0.77;  // cosine: 40 degrees between the way across and either normal
// Joints that miss each other by less than this part of a segment face each other well enough.
constexpr double kSnap = 0.35;
constexpr double kShortest = 1.0;           // segments: shorter parts stay as they are
constexpr int kFewestSamples = 6;           // from joint to joint, however short
constexpr int kMostSamples = 256;           // the same, however long
constexpr double kSamplesPerSegment = 2.0;  // parts end within half a segment of where they should
constexpr int kRounds = 4;                  // a new joint may ask for others across the next gap
constexpr std::int64_t kMostCells = 64;     // of the search grid that one segment is put into

struct Foot {
  int piece = -1;
  double t = 0.0;
  double gap = 0.0;  // [mm]
};

// From one joint of an edge to the next.
struct Piece {
  CoEdge coedge;
  double spacing = 0.0;  // [mm] about as long as its segments will be
  std::vector<double> t;
  std::vector<Vec3> xyz;
  std::vector<Vec3> inward;  // into the face; zero until it is asked for
};

// A part of piece `a` and the one of `b` that it faces, by parameters of their edges.
struct Run {
  int a = -1, b = -1;
  double length = 0.0;  // of a's part [mm]
  double on_a[2] = {0.0, 0.0}, on_b[2] = {0.0, 0.0};
};

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    return static_cast<std::size_t>(c.x() * 73856093 ^ c.y() * 19349663 ^ c.z() * 83492791);
  }
};

// The boundary of a face as polygons, with a grid to look for what is near.
class FaceBorder {
 public:
  FaceBorder(Evaluator& evaluator, FaceId face) : evaluator_(evaluator), face_(face) {}

  void add(const CoEdge& coedge, double from, double to, double size, double curvature_angle) {
    double curvature = 0.0;
    constexpr int kLooks = 4;  // at the curvature along it
    for (int k = 0; k <= kLooks; ++k) {
      const double t = from + (to - from) * k / kLooks;
      curvature = std::max(curvature, evaluator_.edge_curvature(coedge.edge, t));
    }
    Piece piece;
    piece.coedge = coedge;
    piece.spacing = std::min(size, curvature_angle / std::max(curvature, 1e-300));
    const double length = evaluator_.edge_length(coedge.edge, from, to);
    const double wanted = kSamplesPerSegment * length / piece.spacing;
    const int count = static_cast<int>(std::clamp<double>(wanted, kFewestSamples, kMostSamples));
    for (int k = 0; k <= count; ++k) {
      piece.t.push_back(k == count ? to : from + (to - from) * k / count);
      piece.xyz.push_back(evaluator_.edge_point(coedge.edge, piece.t.back()));
    }
    piece.inward.assign(piece.t.size(), Vec3::Zero());
    reach_ = std::max(reach_, kReach * piece.spacing);
    pieces_.push_back(std::move(piece));
  }

  std::vector<Run> runs() {
    fill_grid();
    std::vector<Run> found;
    for (int a = 0; a < static_cast<int>(pieces_.size()); ++a) find_runs(a, found);
    std::stable_sort(found.begin(), found.end(),
                     [](const Run& x, const Run& y) { return x.length > y.length; });
    return found;
  }
  const Piece& piece(int i) const { return pieces_[static_cast<std::size_t>(i)]; }

  // Where the piece is nearest to a point.
  double nearest_on(int i, const Vec3& p) const {
    const Piece& on = piece(i);
    double best = std::numeric_limits<double>::infinity(), t = on.t.front();
    for (std::size_t k = 0; k + 1 < on.t.size(); ++k) {
      const double part = part_on(on, k, p);
      const double gap = (on.xyz[k] + part * (on.xyz[k + 1] - on.xyz[k]) - p).norm();
      if (gap >= best) continue;
      best = gap;
      t = on.t[k] + part * (on.t[k + 1] - on.t[k]);
    }
    return t;
  }

 private:
  static double part_on(const Piece& on, std::size_t k, const Vec3& p) {
    const Vec3 along = on.xyz[k + 1] - on.xyz[k];
    const double length2 = along.squaredNorm();
    return length2 > 0.0 ? std::clamp((p - on.xyz[k]).dot(along) / length2, 0.0, 1.0) : 0.0;
  }

  Cell cell_of(const Vec3& p) const { return (p / reach_).array().floor().cast<std::int64_t>(); }

  void fill_grid() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (std::size_t k = 0; k + 1 < pieces_[i].t.size(); ++k) {
        const Vec3 &p = pieces_[i].xyz[k], &q = pieces_[i].xyz[k + 1];
        const Cell low = cell_of(p.cwiseMin(q)), high = cell_of(p.cwiseMax(q));
        const Cell size = high - low + Cell::Ones();
        if (size.x() * size.y() * size.z() > kMostCells) continue;
        for_cells(low, high, [&](const Cell& cell) {
          grid_[cell].emplace_back(static_cast<int>(i), static_cast<int>(k));
        });
      }
    }
  }

  template <class Act>
  static void for_cells(const Cell& low, const Cell& high, const Act& act) {
    for (std::int64_t x = low.x(); x <= high.x(); ++x) {
      for (std::int64_t y = low.y(); y <= high.y(); ++y) {
        for (std::int64_t z = low.z(); z <= high.z(); ++z) act(Cell(x, y, z));
      }
    }
  }

  const Vec3& inward(Piece& piece, std::size_t k) {
    Vec3& found = piece.inward[k];
    if (!found.isZero()) return found;
    const Vec2 uv = evaluator_.edge_uv(face_, piece.coedge, piece.t[k]);
    const Vec3 along = (piece.coedge.forward ? 1.0 : -1.0) *
                       evaluator_.edge_tangent(piece.coedge.edge, piece.t[k]);
    found = evaluator_.frame(face_, uv.x(), uv.y()).normal.cross(along).normalized();
    return found;
  }

  // The nearest place on the boundary straight across from the piece's sample.
  Foot foot_of(int a, std::size_t i) {
    Piece& own = pieces_[static_cast<std::size_t>(a)];
    const Vec3& p = own.xyz[i];
    const double reach = kReach * own.spacing;
    Foot best;
    best.gap = reach;
    const Vec3 span = Vec3::Constant(reach);
    for_cells(cell_of(p - span), cell_of(p + span), [&](const Cell& cell) {
      const auto at = grid_.find(cell);
      if (at == grid_.end()) return;
      for (const auto& [b, k] : at->second) {
        const std::size_t from = static_cast<std::size_t>(k);
        Piece& other = pieces_[static_cast<std::size_t>(b)];
        if (b == a && (from <= i || from <= i + 1)) continue;
        const double part = part_on(other, from, p);
        const Vec3 across = other.xyz[from] + part * (other.xyz[from + 1] - other.xyz[from]) - p;
        const double gap = across.norm();
        if (!(gap < best.gap) || gap > kReach * other.spacing || gap <= 0.0) continue;
        if (across.dot(inward(own, i)) < kFacing * gap) continue;
        if (-across.dot(inward(other, part < 0.5 ? from : from + 1)) < kFacing * gap) continue;
        best = {b, other.t[from] + part * (other.t[from + 1] - other.t[from]), gap};
      }
    });
    return best;
  }

  void find_runs(int a, std::vector<Run>& found) {
    const Piece& own = piece(a);
    Run run;
    const auto end = [&] {
      if (run.b >= 0) {
        run.length = evaluator_.edge_length(own.coedge.edge, run.on_a[0], run.on_a[1]);
        const double least = kShortest * std::min(own.spacing, piece(run.b).spacing);
        if (run.length >= least) found.push_back(run);
      }
      run = Run();
    };
    for (std::size_t i = 0; i < own.t.size(); ++i) {
      const Foot foot = foot_of(a, i);
      const bool on = foot.piece >= 0 && foot.piece == run.b && goes_on(a, run, foot);
      if (!on) end();
      if (foot.piece < 0) continue;
      if (!on) {
        run.a = a;
        run.b = foot.piece;
        run.on_a[0] = own.t[i];
        run.on_b[0] = foot.t;
      }
      run.on_a[1] = own.t[i];
      run.on_b[1] = foot.t;
    }
    end();
  }
  // Both boundaries keep the face on their left, so they run against each other.
  bool goes_on(int a, const Run& run, const Foot& foot) const {
    const bool against = piece(a).coedge.forward == piece(run.b).coedge.forward;
    return against ? foot.t <= run.on_b[1] : foot.t >= run.on_b[1];
  }

  Evaluator& evaluator_;
  FaceId face_;
  double reach_ = 0.0;  // [mm] width of the grid's cells
  std::vector<Piece> pieces_;
  std::unordered_map<Cell, std::vector<std::pair<int, int>>, CellHash> grid_;
};

// Gives both parts of a run ends at which their edges have nodes.
class RunEnds {
 public:
  RunEnds(Evaluator& evaluator, const FaceBorder& border,
          const std::vector<std::vector<double>>& joints)
      : evaluator_(evaluator), border_(border), joints_(joints) {}

  // Moves the ends to joints that are there, or leaves them where new ones are to be.
  void settle(Run& run) const {
    for (int end = 0; end < 2; ++end) {
      double &ta = run.on_a[end], &tb = run.on_b[end];
      const bool has_a = snap(run.a, ta), has_b = snap(run.b, tb);
      if (has_a && !has_b) {
        tb = border_.nearest_on(run.b, evaluator_.edge_point(edge_of(run.a), ta));
        snap(run.b, tb);
      } else if (has_b && !has_a) {
        ta = border_.nearest_on(run.a, evaluator_.edge_point(edge_of(run.b), tb));
        snap(run.a, ta);
      }
    }
  }

 private:
  EdgeId edge_of(int piece) const { return border_.piece(piece).coedge.edge; }
  bool snap(int i, double& t) const {
    const Piece& piece = border_.piece(i);
    double nearest = kSnap * piece.spacing;
    const double from = t;
    bool found = false;
    for (const double joint : joints_[piece.coedge.edge.index()]) {
      const double off = std::abs(evaluator_.edge_length(piece.coedge.edge, from, joint));
      if (off >= nearest) continue;
      nearest = off;
      t = joint;
      found = true;
    }
    return found;
  }

  Evaluator& evaluator_;
  const FaceBorder& border_;
  const std::vector<std::vector<double>>& joints_;
};

bool has_joint(const std::vector<double>& joints, double t) {
  return std::binary_search(joints.begin(), joints.end(), t);
}

void add_joint(std::vector<double>& joints, double t) {
  if (!has_joint(joints, t)) joints.insert(std::upper_bound(joints.begin(), joints.end(), t), t);
}

// What parts already have of the boundary.
class Taken {
 public:
  bool is_free(EdgeId edge, double t0, double t1) const {
    return std::none_of(spans_.begin(), spans_.end(), [&](const FacingPart& span) {
      return span.edge == edge && t0 < span.t_end && t1 > span.t_begin;
    });
  }
  void add(EdgeId edge, double t0, double t1) { spans_.push_back({edge, t0, t1}); }

 private:
  std::vector<FacingPart> spans_;
};

}  // namespace

void FacingEdges::find(FaceId face, std::vector<std::vector<double>>& joints) {
  FaceBorder border(evaluator_, face);
  for (const auto& loop : evaluator_.model().face(face).loops) {
    for (const CoEdge& coedge : loop) {
      if (coedge.degenerate || coedge.seam) continue;
      context_.check();
      const std::vector<double>& ends = joints[coedge.edge.index()];
      const double size = sizes_.of_edge(coedge.edge, {face});
      for (std::size_t k = 1; k < ends.size(); ++k) {
        border.add(coedge, ends[k - 1], ends[k], size, curvature_angle_);
      }
    }
  }
  Taken taken;
  for (Run run : border.runs()) {
    context_.check();
    RunEnds(evaluator_, border, joints).settle(run);
    const EdgeId a = border.piece(run.a).coedge.edge, b = border.piece(run.b).coedge.edge;
    const bool reversed = run.on_b[1] < run.on_b[0];
    if (reversed) std::swap(run.on_b[0], run.on_b[1]);
    if (!(run.on_a[0] < run.on_a[1]) || !(run.on_b[0] < run.on_b[1])) continue;
    if (!taken.is_free(a, run.on_a[0], run.on_a[1]) || !taken.is_free(b, run.on_b[0], run.on_b[1]))
      continue;
    const auto may_be = [&](EdgeId edge, double t) {
      return given_[edge.index()] == 0 || has_joint(joints[edge.index()], t);
    };
    if (!may_be(a, run.on_a[0]) || !may_be(a, run.on_a[1])) continue;
    if (!may_be(b, run.on_b[0]) || !may_be(b, run.on_b[1])) continue;
    for (int end = 0; end < 2; ++end) {
      add_joint(joints[a.index()], run.on_a[end]);
      add_joint(joints[b.index()], run.on_b[end]);
    }
    taken.add(a, run.on_a[0], run.on_a[1]);
    taken.add(b, run.on_b[0], run.on_b[1]);
    found_.push_back({{a, run.on_a[0], run.on_a[1]}, {b, run.on_b[0], run.on_b[1]}, reversed});
  }
}

void FacingEdges::face_joints(std::vector<std::vector<double>>& joints) {
  for (int round = 0; round < kRounds; ++round) {
    bool added = false;
    for (const FacingParts& parts : found_) {
      context_.check();
      added = face_joints_of(parts, joints) || added;
    }
    if (!added) return;
  }
}

bool FacingEdges::face_joints_of(const FacingParts& parts,
                                 std::vector<std::vector<double>>& joints) {
  const auto length = [&](const FacingPart& part) {
    return evaluator_.edge_length(part.edge, part.t_begin, part.t_end);
  };
  const double lengths[2] = {length(parts.a), length(parts.b)};
  const FacingPart* sides[2] = {&parts.a, &parts.b};
  std::vector<double> shares[2];
  for (int side = 0; side < 2; ++side) {
    const FacingPart& part = *sides[side];
    for (const double t : joints[part.edge.index()]) {
      if (t <= part.t_begin || t >= part.t_end) continue;
      const double share = evaluator_.edge_length(part.edge, part.t_begin, t) / lengths[side];
      shares[side].push_back(side == 1 && parts.reversed ? 1.0 - share : share);
    }
  }
  const double least = kSnap * sizes_.of_edge(parts.a.edge, {}) / std::max(lengths[0], lengths[1]);
  bool added = false;
  for (int side = 0; side < 2; ++side) {
    const FacingPart& other = *sides[1 - side];
    for (const double share : shares[side]) {
      const auto is_near = [&](double there) { return std::abs(there - share) < least; };
      if (std::any_of(shares[1 - side].begin(), shares[1 - side].end(), is_near)) continue;
      if (given_[other.edge.index()] != 0) continue;
      const double there = side == 0 && parts.reversed ? 1.0 - share : share;
      add_joint(joints[other.edge.index()],
                evaluator_.edge_parameter(other.edge, other.t_begin, there * lengths[1 - side]));
      added = true;
    }
  }
  return added;
}

}  // namespace advlayers
