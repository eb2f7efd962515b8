// The middle of every mesh edge on the border of a patch, on the exact curve: one for all patches
// that share the edge.
#pragma once

#include <vector>

#include "boundary/discretization.h"

namespace advlayers {

struct BoundaryMid {
  EdgeId edge;
  NodeId from, to;
  Vec3 curve, chord;  // halfway along the curve between the ends, and between them in space
  int eased = 0;      // steps of kEasings back from the curve to the chord

  static constexpr int kEasings = 4;  // steps from the curve to the chord
  Vec3 at() const { return curve + (eased / double(kEasings)) * (chord - curve); }
};

class BoundaryMids {
 public:
  BoundaryMids(Evaluator& evaluator, const Discretization& boundary);

  // Which of all() lies between two neighbouring nodes of an edge; -1 where they are none.
  int find(EdgeId edge, NodeId a, NodeId b) const;

  const std::vector<BoundaryMid>& all() const { return mids_; }
  BoundaryMid& operator[](int index) { return mids_[static_cast<std::size_t>(index)]; }
  const BoundaryMid& operator[](int index) const { return mids_[static_cast<std::size_t>(index)]; }

 private:
  struct Key {
    EdgeId edge;
    NodeId low, high;
    int index = -1;
    bool operator<(const Key& o) const;
  };
  std::vector<BoundaryMid> mids_;  // edge by edge, along each
  std::vector<Key> keys_;          // sorted
};

}  // namespace advlayers
