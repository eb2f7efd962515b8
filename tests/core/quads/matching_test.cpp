#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "base/error.h"
#include "quads/matching.h"

namespace advlayers {
namespace {

std::vector<PairEdge> random_graph(int nodes, std::mt19937& random) {
  std::vector<PairEdge> edges;
  std::vector<int> degree(static_cast<std::size_t>(nodes), 0);
  std::map<std::pair<int, int>, bool> seen;
  std::uniform_int_distribution<int> pick(0, nodes - 1);
  std::uniform_real_distribution<double> weigh(0.1, 1.0);
  for (int k = 0; k < 6 * nodes; ++k) {
    const int a = pick(random), b = pick(random);
    int& degree_a = degree[static_cast<std::size_t>(a)];
    int& degree_b = degree[static_cast<std::size_t>(b)];
    if (a == b || degree_a == 3 || degree_b == 3 || seen[std::minmax(a, b)]) continue;
    seen[std::minmax(a, b)] = true;
    ++degree_a;
    ++degree_b;
    edges.push_back({a, b, weigh(random)});
  }
  return edges;
}

struct Score {
  int pairs = 0;
  double weight = 0.0;
  friend bool operator<(const Score& x, const Score& y) {
    return x.pairs != y.pairs ? x.pairs < y.pairs : x.weight < y.weight;
  }
};

// The most pairs, and among these the most weight, over all matchings: by subsets of nodes.
Score best_by_enumeration(int nodes, const std::vector<PairEdge>& edges) {
  std::vector<Score> best(std::size_t{1} << nodes);
  for (std::size_t used = 1; used < best.size(); ++used) {
    const std::size_t lowest = used & (~used + 1);
    best[used] = best[used ^ lowest];
    for (const PairEdge& edge : edges) {
      const std::size_t both = std::size_t{1} << edge.a | std::size_t{1} << edge.b;
      if ((used & both) != both || (both & lowest) == 0) continue;
      Score score = best[used ^ both];
      ++score.pairs;
      score.weight += edge.weight;
      best[used] = std::max(best[used], score);
    }
  }
  return best.back();
}

Score score_of(const std::vector<int>& matched, const std::vector<PairEdge>& edges) {
  Score score;
  for (std::size_t node = 0; node < matched.size(); ++node) {
    if (matched[node] < 0) continue;
    const PairEdge& edge = edges[static_cast<std::size_t>(matched[node])];
    EXPECT_EQ(matched[static_cast<std::size_t>(edge.a)], matched[node]);
    EXPECT_EQ(matched[static_cast<std::size_t>(edge.b)], matched[node]);
    if (edge.a != static_cast<int>(node)) continue;
    ++score.pairs;
    score.weight += edge.weight;
  }
  return score;
}

TEST(Matching, PairsAsManyAsPossible) {
  std::mt19937 random(7);
  for (const int nodes : {4, 7, 10, 13}) {
    for (int round = 0; round < 60; ++round) {
      const auto edges = random_graph(nodes, random);
      const Score found = score_of(match_pairs(RunContext(), nodes, edges), edges);
      EXPECT_EQ(found.pairs, best_by_enumeration(nodes, edges).pairs);
    }
  }
}

TEST(Matching, ComesNearTheGreatestWeight) {
  std::mt19937 random(11);
  double found = 0.0, best = 0.0;
  for (int round = 0; round < 200; ++round) {
    const auto edges = random_graph(14, random);
    found += score_of(match_pairs(RunContext(), 14, edges), edges).weight;
    best += best_by_enumeration(14, edges).weight;
  }
  EXPECT_GT(found, 0.99 * best);
}

// A chain of four: the middle pair is the heaviest, but two outer pairs leave nobody alone.
TEST(Matching, PrefersMorePairsToHeavierOnes) {
  const std::vector<PairEdge> edges{{0, 1, 0.2}, {1, 2, 1.0}, {2, 3, 0.2}};
  EXPECT_EQ(match_pairs(RunContext(), 4, edges), (std::vector<int>{0, 0, 2, 2}));
}

TEST(Matching, IsTheSameEveryTime) {
  std::mt19937 random(3);
  const auto edges = random_graph(200, random);
  EXPECT_EQ(match_pairs(RunContext(), 200, edges), match_pairs(RunContext(), 200, edges));
}

TEST(Matching, RefusesMoreThanThreeNeighbours) {
  const std::vector<PairEdge> star{{0, 1, 1.0}, {0, 2, 1.0}, {0, 3, 1.0}, {0, 4, 1.0}};
  EXPECT_THROW(match_pairs(RunContext(), 5, star), InternalError);
}

}  // namespace
}  // namespace advlayers
