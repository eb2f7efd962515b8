// Stretches that face each other across a narrow face or a gap: cut alike, so that rows of quads
// run from side to side.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "boundary/facing_parts.h"
#include "boundary/stretch.h"
#include "geometry/four_sides.h"

namespace advlayers {

class FacingStretches {
 public:
  // Joins those that hang together over a chain of strips and parts. Stretches must have been cut,
  // each by itself; long ones of very different numbers of segments stay as they are.
  FacingStretches(const RunContext& context, const std::vector<FourSides>& strips,
                  const std::vector<FacingParts>& parts, Stretches& stretches);

  // Cuts the chosen stretches anew, and those that face them along a strip at the same shares of
  // their lengths, so finely that no segment is longer than any of them asks for; as one whose
  // segments are given, where there is one.
  void cut(const std::vector<char>& chosen);
  // Gives the ends of each strip as many segments. Returns whether any took more.
  bool even_out_ends();
  // Whether another has a say in how it is cut.
  bool is_grouped(std::size_t stretch) const { return groups_[group_of_[stretch]].size() > 1; }

 private:
  struct Member {
    std::size_t stretch;
    bool reversed;  // against the first member
  };
  struct Pair {
    Member a, b;
    double unlikeness = 1.0;  // of the numbers of segments, 1 and more
  };

  // How unlike two may be that are still cut alike: ratios of segments and of lengths.
  struct Likeness {
    double most_unlike, most_longer;
  };
  struct Ends {
    std::vector<Member> a, b;
  };

  void add_pairs(const FourSides& strip, std::vector<Pair>& pairs) const;
  void add_pairs(const FacingParts& parts, std::vector<Pair>& pairs) const;
  void add_pair(const Member& a, const Member& b, const Likeness& least,
                std::vector<Pair>& pairs) const;
  std::vector<Member> within(const FacingPart& part, bool reversed) const;
  bool has_given(const std::vector<Member>& group) const;
  int segments_on(const std::vector<Member>& side) const;
  std::vector<Member> along(const std::vector<CoEdge>& side) const;
  void join(const Pair& pair);
  void cut_group(const std::vector<Member>& group);
  std::vector<double> given_shares(const std::vector<Member>& group);
  std::vector<double> even_shares(const std::vector<Member>& group) const;

  const RunContext& context_;
  Stretches& stretches_;
  std::vector<std::vector<Member>> groups_;
  std::vector<std::size_t> group_of_;  // by stretch
  std::vector<char> reversed_;         // within its group
  std::vector<Ends> ends_;
};

}  // namespace advlayers
