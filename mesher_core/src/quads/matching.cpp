#include "quads/matching.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr int kNone = -1;
// Nodes one search for an augmenting path may reach. Paths are short after the greedy start; the
// bound keeps the searches of nodes that must stay alone from costing the whole graph each.
constexpr std::size_t kSearchLimit = 1500;
// Pairs exchanged at once in the search for weight, and sweeps over all nodes.
constexpr std::size_t kExchangeDepth = 4;
constexpr int kExchangePasses = 2;
constexpr double kLeastGain = 1e-9;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

struct Neighbour {
  int node = kNone;
  int edge = kNone;
};

struct Pairing {
  explicit Pairing(int nodes, const std::vector<PairEdge>& pair_edges);
  double weight(int edge) const { return edges[at(edge)].weight; }
  int mate(int node) const { return mates[at(node)]; }
  void pair(int a, int b, int edge) {
    mates[at(a)] = b;
    mates[at(b)] = a;
    matched[at(a)] = matched[at(b)] = edge;
  }

  const std::vector<PairEdge>& edges;
  std::vector<std::array<Neighbour, 3>> around;
  std::vector<int> mates, matched;  // by node: its partner and the edge to it
};

void add_neighbour(std::array<Neighbour, 3>& slots, Neighbour neighbour) {
  for (Neighbour& slot : slots) {
    if (slot.node != kNone) continue;
    slot = neighbour;
    return;
  }
  throw InternalError("a node of the pair graph has more than three neighbours");
}

Pairing::Pairing(int nodes, const std::vector<PairEdge>& pair_edges) : edges(pair_edges) {
  around.resize(at(nodes));
  mates.assign(at(nodes), kNone);
  matched.assign(at(nodes), kNone);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    add_neighbour(around[at(edges[e].a)], {edges[e].b, static_cast<int>(e)});
    add_neighbour(around[at(edges[e].b)], {edges[e].a, static_cast<int>(e)});
  }
}

void match_greedily(Pairing& p) {
  std::vector<int> order(p.edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&p](int x, int y) {
    return p.weight(x) != p.weight(y) ? p.weight(x) > p.weight(y) : x < y;
  });
  for (const int e : order) {
    const PairEdge& edge = p.edges[at(e)];
    if (p.mate(edge.a) == kNone && p.mate(edge.b) == kNone) p.pair(edge.a, edge.b, e);
  }
}

// Edmonds' search for an augmenting path, breadth first. Odd nodes hold the parent they were
// reached from, as do even nodes inside a contracted blossom.
class AugmentingSearch {
 public:
  explicit AugmentingSearch(Pairing& pairing);
  bool augment(int root);

 private:
  bool scan(int node);
  void set_parent(int node, int parent, int edge);
  void enqueue(int node);
  int common_base(int a, int b);
  void mark_blossom(int node, int base, int child, int edge);
  void contract(int a, int b, int edge);
  void flip_path(int node);
  void forget();

  Pairing& p_;
  int root_ = kNone;
  std::vector<int> parent_, parent_edge_, base_, stamp_;
  std::vector<char> even_, in_blossom_;
  std::vector<int> touched_, queue_;
  int stamp_now_ = 0;
};

AugmentingSearch::AugmentingSearch(Pairing& pairing) : p_(pairing) {
  const std::size_t n = pairing.mates.size();
  parent_.assign(n, kNone);
  parent_edge_.assign(n, kNone);
  base_.resize(n);
  std::iota(base_.begin(), base_.end(), 0);
  stamp_.assign(n, 0);
  even_.assign(n, 0);
  in_blossom_.assign(n, 0);
}

void AugmentingSearch::set_parent(int node, int parent, int edge) {
  parent_[at(node)] = parent;
  parent_edge_[at(node)] = edge;
  touched_.push_back(node);
}

void AugmentingSearch::enqueue(int node) {
  if (even_[at(node)]) return;
  even_[at(node)] = 1;
  touched_.push_back(node);
  queue_.push_back(node);
}

int AugmentingSearch::common_base(int a, int b) {
  ++stamp_now_;
  for (int node = base_[at(a)];; node = base_[at(parent_[at(p_.mate(node))])]) {
    stamp_[at(node)] = stamp_now_;
    if (p_.mate(node) == kNone) break;
  }
  int node = base_[at(b)];
  while (stamp_[at(node)] != stamp_now_) node = base_[at(parent_[at(p_.mate(node))])];
  return node;
}

void AugmentingSearch::mark_blossom(int node, int base, int child, int edge) {
  while (base_[at(node)] != base) {
    const int partner = p_.mate(node);
    in_blossom_[at(base_[at(node)])] = in_blossom_[at(base_[at(partner)])] = 1;
    set_parent(node, child, edge);
    child = partner;
    edge = parent_edge_[at(partner)];
    node = parent_[at(partner)];
  }
}

void AugmentingSearch::contract(int a, int b, int edge) {
  const int base = common_base(a, b);
  mark_blossom(a, base, b, edge);
  mark_blossom(b, base, a, edge);
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    const int node = touched_[i];
    if (!in_blossom_[at(base_[at(node)])]) continue;
    base_[at(node)] = base;
    enqueue(node);
  }
  for (const int node : touched_) in_blossom_[at(node)] = 0;
}

void AugmentingSearch::flip_path(int node) {
  while (node != kNone) {
    const int parent = parent_[at(node)];
    const int beyond = p_.mate(parent);
    p_.pair(node, parent, parent_edge_[at(node)]);
    node = beyond;
  }
}

bool AugmentingSearch::scan(int node) {
  for (const Neighbour& next : p_.around[at(node)]) {
    if (next.node == kNone || base_[at(next.node)] == base_[at(node)]) continue;
    if (p_.mate(node) == next.node) continue;
    const int mate = p_.mate(next.node);
    if (next.node == root_ || (mate != kNone && parent_[at(mate)] != kNone)) {
      contract(node, next.node, next.edge);
    } else if (parent_[at(next.node)] == kNone) {
      set_parent(next.node, node, next.edge);
      if (mate == kNone) {
        flip_path(next.node);
        return true;
      }
      enqueue(mate);
    }
  }
  return false;
}

void AugmentingSearch::forget() {
  for (const int node : touched_) {
    parent_[at(node)] = parent_edge_[at(node)] = kNone;
    base_[at(node)] = node;
    even_[at(node)] = 0;
  }
  touched_.clear();
  queue_.clear();
}

bool AugmentingSearch::augment(int root) {
  root_ = root;
  enqueue(root);
  bool found = false;
  for (std::size_t i = 0; i < queue_.size() && i < kSearchLimit && !found; ++i) {
    found = scan(queue_[i]);
  }
  forget();
  return found;
}

// Exchanges pairs along a short alternating cycle, or a path that ends at a node that was alone,
// where that adds weight. The number of pairs stays.
class WeightExchange {
 public:
  explicit WeightExchange(Pairing& pairing) : p_(pairing) {}
  bool improve(int node);

 private:
  struct Step {
    int from, to, edge;
  };
  bool extend(int exposed, double gain);
  bool on_path(int node) const;
  void apply();

  Pairing& p_;
  int origin_ = kNone;
  std::array<Step, kExchangeDepth> steps_{};
  std::size_t count_ = 0;
};

bool WeightExchange::on_path(int node) const {
  for (std::size_t i = 0; i < count_; ++i) {
    if (steps_[i].from == node || steps_[i].to == node) return true;
  }
  return false;
}

void WeightExchange::apply() {
  const bool cycle = steps_[count_ - 1].to == origin_;
  if (!cycle) p_.mates[at(origin_)] = p_.matched[at(origin_)] = kNone;
  for (std::size_t i = 0; i < count_; ++i) {
    p_.pair(steps_[i].from, steps_[i].to, steps_[i].edge);
  }
}

bool WeightExchange::extend(int exposed, double gain) {
  if (count_ == kExchangeDepth) return false;
  for (const Neighbour& next : p_.around[at(exposed)]) {
    if (next.node == kNone || next.edge == p_.matched[at(exposed)]) continue;
    const int mate = p_.mate(next.node);
    const double sum = gain + p_.weight(next.edge);
    const bool closes = next.node == origin_ || mate == kNone;
    if (!closes && (next.node == exposed || on_path(next.node) || on_path(mate))) continue;
    steps_[count_++] = {exposed, next.node, next.edge};
    if (closes ? sum > kLeastGain : extend(mate, sum - p_.weight(p_.matched[at(next.node)]))) {
      if (closes) apply();
      return true;
    }
    --count_;
  }
  return false;
}

bool WeightExchange::improve(int node) {
  if (p_.mate(node) == kNone) return false;
  origin_ = node;
  count_ = 0;
  return extend(p_.mate(node), -p_.weight(p_.matched[at(node)]));
}

}  // namespace

std::vector<int> match_pairs(const RunContext& context, int nodes,
                             const std::vector<PairEdge>& edges) {
  Pairing pairing(nodes, edges);
  match_greedily(pairing);
  AugmentingSearch search(pairing);
  for (int node = 0; node < nodes; ++node) {
    context.check();
    if (pairing.mate(node) == kNone) search.augment(node);
  }
  WeightExchange exchange(pairing);
  bool improved = true;
  for (int pass = 0; improved && pass < kExchangePasses; ++pass) {
    improved = false;
    for (int node = 0; node < nodes; ++node) {
      context.check();
      improved = exchange.improve(node) || improved;
    }
  }
  return pairing.matched;
}

}  // namespace advlayers
