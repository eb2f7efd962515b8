#include "boundary/facing_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace advlayers {
namespace {

// Long sides of which one would be cut into more than so many times the segments of the other stay
// as they are: either would be far too fine.
constexpr double kMostUnlike = 2.0;
// Nor may they be so unlike in length: grading would refine one for the other without end.
constexpr double kMostLonger = 1.4;
// Parts that face each other across a gap end in the open: none pulls the next one along. But they
// are many, and all of them together are not to cost many elements.
constexpr double kMostUnlikeParts = 1.5;
constexpr double kMostLongerParts = 1.7;
constexpr double kSameShare = 1e-9;

// The finest of several spacings, each over its own length, as shares of it from 0 to 1.
class FinestSpacing {
 public:
  void add(std::vector<SpacingSample> wanted, bool reversed) {
    const double length = wanted.back().s;
    for (SpacingSample& sample : wanted) sample = {sample.s / length, sample.spacing / length};
    if (reversed) {
      std::reverse(wanted.begin(), wanted.end());
      for (SpacingSample& sample : wanted) sample.s = 1.0 - sample.s;
    }
    for (const SpacingSample& sample : wanted) shares_.push_back(sample.s);
    profiles_.push_back(std::move(wanted));
  }

  std::vector<SpacingSample> samples() {
    std::sort(shares_.begin(), shares_.end());
    std::vector<std::size_t> reached(profiles_.size(), 1);
    std::vector<SpacingSample> finest;
    for (const double share : shares_) {
      if (!finest.empty() && share - finest.back().s < kSameShare) continue;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t p = 0; p < profiles_.size(); ++p) {
        least = std::min(least, spacing_at(share, profiles_[p], reached[p]));
      }
      finest.push_back({share, least});
    }
    finest.back().s = 1.0;
    return finest;
  }

 private:
  // `reached` only goes on from one share to the next.
  static double spacing_at(double share, const std::vector<SpacingSample>& profile,
                           std::size_t& reached) {
    while (reached + 1 < profile.size() && profile[reached].s < share) ++reached;
    const SpacingSample &a = profile[reached - 1], &b = profile[reached];
    const double part = std::clamp((share - a.s) / (b.s - a.s), 0.0, 1.0);
    return a.spacing + part * (b.spacing - a.spacing);
  }

  std::vector<double> shares_;
  std::vector<std::vector<SpacingSample>> profiles_;
};

}  // namespace

FacingStretches::FacingStretches(const RunContext& context, const std::vector<FourSides>& strips,
                                 const std::vector<FacingParts>& parts, Stretches& stretches)
    : context_(context),
      stretches_(stretches),
      groups_(stretches.all.size()),
      group_of_(stretches.all.size()),
      reversed_(stretches.all.size(), 0) {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    groups_[i] = {{i, false}};
    group_of_[i] = i;
  }
  std::vector<Pair> pairs;
  for (const FourSides& strip : strips) {
    context_.check();
    add_pairs(strip, pairs);
    ends_.push_back({along(strip.sides[1]), along(strip.sides[3])});
  }
  for (const FacingParts& facing : parts) add_pairs(facing, pairs);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.unlikeness < b.unlikeness; });
  for (const Pair& pair : pairs) {
    context_.check();
    join(pair);
  }
}

std::vector<FacingStretches::Member> FacingStretches::along(const std::vector<CoEdge>& side) const {
  std::vector<Member> members;
  for (const CoEdge& coedge : side) {
    const auto& of_edge = stretches_.of(coedge.edge);
    for (std::size_t k = 0; k < of_edge.size(); ++k) {
      const std::size_t i = of_edge[coedge.forward ? k : of_edge.size() - 1 - k];
      members.push_back({i, !coedge.forward});
    }
  }
  return members;
}

// Of the long sides; none where they are not divided into as many stretches.
void FacingStretches::add_pairs(const FourSides& strip, std::vector<Pair>& pairs) const {
  const std::vector<Member> a = along(strip.sides[0]);
  std::vector<Member> b = along(strip.sides[2]);
  if (a.size() != b.size()) return;
  std::reverse(b.begin(), b.end());  // the loop comes back along it
  for (std::size_t k = 0; k < a.size(); ++k) {
    add_pair(a[k], {b[k].stretch, !b[k].reversed}, {kMostUnlike, kMostLonger}, pairs);
  }
}

void FacingStretches::add_pairs(const FacingParts& parts, std::vector<Pair>& pairs) const {
  const std::vector<Member> a = within(parts.a, false), b = within(parts.b, parts.reversed);
  if (a.size() != b.size()) return;
  for (std::size_t k = 0; k < a.size(); ++k)
    add_pair(a[k], b[k], {kMostUnlikeParts, kMostLongerParts}, pairs);
}

void FacingStretches::add_pair(const Member& a, const Member& b, const Likeness& least,
                               std::vector<Pair>& pairs) const {
  const EdgeSpacing &there = stretches_[a.stretch].spacing, &back = stretches_[b.stretch].spacing;
  const auto unlikeness = [](double x, double y) { return std::max(x / y, y / x); };
  const double unlike = unlikeness(there.count(), back.count());
  if (unlike > least.most_unlike) return;
  if (unlikeness(there.length(), back.length()) > least.most_longer) return;
  pairs.push_back({a, b, unlike});
}

// In the order in which they follow each other along the part.
std::vector<FacingStretches::Member> FacingStretches::within(const FacingPart& part,
                                                             bool reversed) const {
  std::vector<Member> members;
  for (const std::size_t i : stretches_.of(part.edge)) {
    const Stretch& stretch = stretches_[i];
    if (stretch.t_begin < part.t_begin || stretch.t_end > part.t_end) continue;
    members.push_back({i, reversed});
  }
  if (reversed) std::reverse(members.begin(), members.end());
  return members;
}

bool FacingStretches::has_given(const std::vector<Member>& group) const {
  return std::any_of(group.begin(), group.end(), [this](const Member& member) {
    return stretches_[member.stretch].spacing.fixed();
  });
}

void FacingStretches::join(const Pair& pair) {
  const std::size_t a = group_of_[pair.a.stretch], b = group_of_[pair.b.stretch];
  if (a == b) return;
  if (has_given(groups_[a]) && has_given(groups_[b])) return;
  const bool turned = (pair.a.reversed != pair.b.reversed) !=
                      ((reversed_[pair.a.stretch] != 0) != (reversed_[pair.b.stretch] != 0));
  for (Member member : groups_[b]) {
    member.reversed = member.reversed != turned;
    group_of_[member.stretch] = a;
    reversed_[member.stretch] = member.reversed ? 1 : 0;
    groups_[a].push_back(member);
  }
  groups_[b].clear();
}

void FacingStretches::cut_group(const std::vector<Member>& group) {
  context_.check();
  if (group.size() == 1) {
    stretches_[group.front().stretch].spacing.cut();
    return;
  }
  const std::vector<double> shares = has_given(group) ? given_shares(group) : even_shares(group);
  std::vector<double> from_end;
  for (auto share = shares.rbegin(); share != shares.rend(); ++share) {
    from_end.push_back(1.0 - *share);
  }
  for (const Member& member : group) {
    stretches_[member.stretch].spacing.cut_at(member.reversed ? from_end : shares);
  }
}

// Of the one member whose segments are given.
std::vector<double> FacingStretches::given_shares(const std::vector<Member>& group) {
  const Member& given = *std::find_if(group.begin(), group.end(), [this](const Member& member) {
    return stretches_[member.stretch].spacing.fixed();
  });
  EdgeSpacing& spacing = stretches_[given.stretch].spacing;
  spacing.cut();
  std::vector<double> shares;
  for (const double cut : spacing.cuts()) shares.push_back(cut / spacing.length());
  if (!given.reversed) return shares;
  std::reverse(shares.begin(), shares.end());
  for (double& share : shares) share = 1.0 - share;
  return shares;
}

std::vector<double> FacingStretches::even_shares(const std::vector<Member>& group) const {
  FinestSpacing finest;
  int required = 1;
  for (const Member& member : group) {
    const EdgeSpacing& spacing = stretches_[member.stretch].spacing;
    finest.add(spacing.wanted(), member.reversed);
    required = std::max(required, spacing.required());
  }
  return divide_by_spacing(finest.samples(), required, stretches_[group.front().stretch].edge);
}

void FacingStretches::cut(const std::vector<char>& chosen) {
  std::vector<char> done(groups_.size(), 0);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!chosen[i] || done[group_of_[i]]) continue;
    done[group_of_[i]] = 1;
    cut_group(groups_[group_of_[i]]);
  }
}

int FacingStretches::segments_on(const std::vector<Member>& side) const {
  int segments = 0;
  for (const Member& member : side) segments += stretches_[member.stretch].spacing.count();
  return segments;
}

// The longest stretch of the end that has fewer takes what is missing.
bool FacingStretches::even_out_ends() {
  std::vector<char> raised(stretches_.all.size(), 0);
  for (const Ends& ends : ends_) {
    const int missing = segments_on(ends.a) - segments_on(ends.b);
    if (missing == 0) continue;
    const std::vector<Member>& fewer = missing < 0 ? ends.a : ends.b;
    const Member& longest =
        *std::max_element(fewer.begin(), fewer.end(), [this](const Member& m, const Member& n) {
          return stretches_[m.stretch].spacing.length() < stretches_[n.stretch].spacing.length();
        });
    EdgeSpacing& spacing = stretches_[longest.stretch].spacing;
    spacing.require(spacing.count() + std::abs(missing));
    raised[longest.stretch] = 1;
  }
  cut(raised);
  return std::find(raised.begin(), raised.end(), 1) != raised.end();
}

}  // namespace advlayers
