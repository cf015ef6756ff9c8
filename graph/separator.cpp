// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "leonhard/graph/separator_graph.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using detail::SeparatorGraph;
using Sides = std::vector<std::uint8_t>;

constexpr std::uint8_t middle = VertexSeparator::separator;

/// How good a separator is: first the excess of a side over the limit, then its weight, then the sides' difference.
struct Quality {
  std::uint32_t excess, weight, difference;
  friend auto operator<=>(const Quality&, const Quality&) = default;
};

/// Moves vertices out of the separator. A vertex that goes to one side pulls its neighbours on the other side into the
/// separator; its gain is its weight less theirs. A pass moves each vertex once at most, worse moves included, and is
/// taken back to its best moment.
class SeparatorRefiner {
 public:
  SeparatorRefiner(const SeparatorGraph& graph, std::uint32_t limit)
      : graph_(graph),
        limit_(limit),
        gain_{Gains(graph.size()), Gains(graph.size())},
        moved_in_(graph.size(), 0) {}

  Quality refine(Sides& side) {
    side_ = &side;
    weight_ = {0, 0, 0};
    for (std::uint32_t v = 0; v < side.size(); ++v) weight_[side[v]] += graph_.weight[v];
    constexpr int passes = 8;
    for (int pass = 0; pass < passes && improve(); ++pass) {
    }
    return quality();
  }

 private:
  using Gains = std::vector<std::int64_t>;
  struct Candidate {
    std::int64_t gain;
    std::uint32_t time, vertex;
    friend auto operator<=>(const Candidate&, const Candidate&) = default;
  };
  struct Change {
    std::uint32_t vertex;
    std::uint8_t from;
  };

  [[nodiscard]] std::uint8_t& side(std::uint32_t v) { return (*side_)[v]; }
  [[nodiscard]] Quality quality() const {
    const std::uint32_t larger = std::max(weight_[0], weight_[1]), smaller = std::min(weight_[0], weight_[1]);
    return {larger > limit_ ? larger - limit_ : 0, weight_[middle], larger - smaller};
  }

  void put(std::uint32_t v, std::uint8_t to) {
    weight_[side(v)] -= graph_.weight[v];
    weight_[to] += graph_.weight[v];
    side(v) = to;
  }

  /// The gain of v, in the separator, if it goes to a side.
  void file(std::uint32_t v) {
    for (const std::uint8_t to : {std::uint8_t{0}, std::uint8_t{1}}) {
      std::int64_t gain = graph_.weight[v];
      for (const auto& [w, unused] : graph_.row(v))
        if (side(w) == 1 - to) gain -= graph_.weight[w];
      gain_[to][v] = gain;
      queue_[to].push({gain, ++clock_, v});
    }
  }
  void change_gain(std::uint32_t v, std::uint8_t to, std::int64_t by) {
    gain_[to][v] += by;
    if (moved_in_[v] != pass_) queue_[to].push({gain_[to][v], ++clock_, v});
  }

  /// Entries that were overtaken are dropped from the front.
  [[nodiscard]] bool has_candidate(std::uint8_t to) {
    auto& queue = queue_[to];
    while (!queue.empty()) {
      const Candidate& top = queue.top();
      if (side(top.vertex) == middle && moved_in_[top.vertex] != pass_ && gain_[to][top.vertex] == top.gain)
        return true;
      queue.pop();
    }
    return false;
  }

  /// The side to move to next: where the gain is larger, if there is room; or none.
  [[nodiscard]] int next_side() {
    std::array<bool, 2> possible{};
    for (const std::uint8_t to : {std::uint8_t{0}, std::uint8_t{1}})
      possible[to] = has_candidate(to) && (weight_[to] + graph_.weight[queue_[to].top().vertex] <= limit_ ||
                                           weight_[to] < weight_[1 - to]);
    if (!possible[0] || !possible[1]) return possible[0] ? 0 : possible[1] ? 1 : -1;
    const std::int64_t first = queue_[0].top().gain, second = queue_[1].top().gain;
    if (first != second) return first > second ? 0 : 1;
    return weight_[0] <= weight_[1] ? 0 : 1;
  }

  void move(std::uint8_t to) {
    const std::uint32_t v = queue_[to].top().vertex;
    queue_[to].pop();
    moved_in_[v] = pass_;
    changes_.push_back({v, middle});
    put(v, to);
    const auto other = static_cast<std::uint8_t>(1 - to);
    for (const auto& [w, unused] : graph_.row(v))
      if (side(w) == middle) change_gain(w, other, -std::int64_t{graph_.weight[v]});
    for (const auto& [w, unused] : graph_.row(v)) {
      if (side(w) != other) continue;
      changes_.push_back({w, other});
      put(w, middle);
      for (const auto& [x, unused_too] : graph_.row(w))
        if (side(x) == middle && x != w) change_gain(x, to, graph_.weight[w]);
      file(w);
    }
  }

  bool improve() {
    ++pass_;
    queue_ = {};
    changes_.clear();
    for (std::uint32_t v = 0; v < side_->size(); ++v)
      if (side(v) == middle) file(v);
    const Quality before = quality();
    Quality best = before;
    std::size_t best_at = 0;
    const std::size_t patience = 50 + side_->size() / 50;
    for (std::size_t fruitless = 0; fruitless < patience; ++fruitless) {
      const int to = next_side();
      if (to < 0) break;
      move(static_cast<std::uint8_t>(to));
      if (quality() < best) {
        best = quality();
        best_at = changes_.size();
        fruitless = 0;
      }
    }
    for (; changes_.size() > best_at; changes_.pop_back()) put(changes_.back().vertex, changes_.back().from);
    return best < before;
  }

  const SeparatorGraph& graph_;
  std::uint32_t limit_;
  Sides* side_ = nullptr;
  std::array<std::uint32_t, 3> weight_{};  ///< of the sides and the separator
  std::array<Gains, 2> gain_;              ///< of the separator's vertices, by the side they would go to
  std::array<std::priority_queue<Candidate>, 2> queue_;
  std::vector<std::uint32_t> moved_in_;  ///< the last pass that moved a vertex out of the separator
  std::vector<Change> changes_;
  std::uint32_t pass_ = 0, clock_ = 0;
};

/// A side grown breadth first from a vertex until it weighs half, what is next to it as separator.
Sides grow(const SeparatorGraph& graph, std::uint32_t root) {
  Sides side(graph.size(), 1);
  std::vector<char> seen(graph.size(), 0);
  std::uint32_t weight = 0;
  std::deque<std::uint32_t> queue;
  std::uint32_t next_root = root;
  for (std::uint32_t count = 0; count < graph.size() && 2 * weight < graph.total; ++count) {
    while (queue.empty()) {  // another component
      if (seen[next_root] == 0) queue.push_back(next_root);
      seen[next_root] = 1;
      next_root = (next_root + 1) % graph.size();
    }
    const std::uint32_t v = queue.front();
    queue.pop_front();
    side[v] = 0;
    weight += graph.weight[v];
    for (const auto& [w, unused] : graph.row(v))
      if (std::exchange(seen[w], char{1}) == 0) queue.push_back(w);
  }
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    if (side[v] == 1 && std::ranges::any_of(graph.row(v), [&](const auto& arc) { return side[arc.to] == 0; }))
      side[v] = middle;
  return side;
}

struct Found {
  Sides side;
  Quality quality{};
};

Found best_grown(const SeparatorGraph& graph, std::uint32_t limit, std::mt19937_64& random) {
  SeparatorRefiner refiner(graph, limit);
  Found best;
  constexpr int tries = 8;
  for (int k = 0; k < tries; ++k) {
    Sides side = grow(graph, static_cast<std::uint32_t>(random() % graph.size()));
    const Quality quality = refiner.refine(side);
    if (k == 0 || quality < best.quality) best = {std::move(side), quality};
  }
  return best;
}

/// A graph coarsened step by step to about a given size, and separators carried back.
class Hierarchy {
 public:
  Hierarchy(const SeparatorGraph& finest, std::uint32_t size, std::mt19937_64& random) : finest_(finest) {
    const std::uint32_t largest = std::max(1U, finest.total / 30);
    while (coarsest().size() > size) {
      detail::Coarsening next = detail::coarsen(coarsest(), largest, random);
      if (next.graph.size() * 20ULL > coarsest().size() * 19ULL) break;  // hubs: it shrinks no longer
      levels_.push_back(std::move(next));
    }
  }
  [[nodiscard]] const SeparatorGraph& coarsest() const {
    return levels_.empty() ? finest_ : levels_.back().graph;
  }

  /// The separator of the coarsest graph, refined on every finer one.
  void carry_back(Found& found, std::uint32_t limit) const {
    for (std::size_t depth = levels_.size(); depth-- > 0;) {
      const SeparatorGraph& graph = depth == 0 ? finest_ : levels_[depth - 1].graph;
      Sides finer(graph.size());
      for (std::uint32_t v = 0; v < finer.size(); ++v) finer[v] = found.side[levels_[depth].coarse_of[v]];
      found.side = std::move(finer);
      found.quality = SeparatorRefiner(graph, limit).refine(found.side);
    }
  }

 private:
  const SeparatorGraph& finest_;
  std::deque<detail::Coarsening> levels_;
};

Found multilevel_separator(const SeparatorGraph& graph, std::uint32_t limit, std::mt19937_64& random) {
  constexpr std::uint32_t size = 40;
  const Hierarchy levels(graph, size, random);
  Found found = best_grown(levels.coarsest(), limit, random);
  levels.carry_back(found, limit);
  return found;
}

/// Large graphs are coarsened some times only, to a size at which many tries cost little.
Found best_separator(const SeparatorGraph& graph, std::uint32_t limit, const SeparatorOptions& options) {
  constexpr std::uint32_t size = 3000;
  const std::uint32_t trunks = graph.size() <= size ? 1 : std::clamp(options.tries / 2, 1U, 4U);
  std::mt19937_64 random(options.seed);
  Found best;
  for (std::uint32_t t = 0; t < trunks; ++t) {
    const Hierarchy trunk(graph, size, random);
    Found of_trunk;
    for (std::uint32_t k = t; k < options.tries; k += trunks) {
      if (k > 0 && options.stop.stop_requested()) break;
      Found found = multilevel_separator(trunk.coarsest(), limit, random);
      if (k == t || found.quality < of_trunk.quality) of_trunk = std::move(found);
    }
    if (of_trunk.side.empty()) break;  // stopped
    trunk.carry_back(of_trunk, limit);
    if (t == 0 || of_trunk.quality < best.quality) best = std::move(of_trunk);
  }
  return best;
}

}  // namespace

VertexSeparator vertex_separator(const CsrGraph& graph, const SeparatorOptions& options) {
  if (!(options.largest_side > 0.5) || options.largest_side > 1 || options.tries == 0)
    throw InputError("options",
                     "largest side " + std::to_string(options.largest_side) + ", " +
                         std::to_string(options.tries) + " tries",
                     "give a side in (1/2, 1] and at least one try");
  VertexSeparator result;
  if (vertex_count(graph) == 0) return result;
  const SeparatorGraph finest = detail::separator_graph(graph);
  const auto limit = static_cast<std::uint32_t>(options.largest_side * finest.total);
  Found best = best_separator(finest, std::max(1U, limit), options);
  result.side_of = std::move(best.side);
  result.size = best.quality.weight;
  return result;
}

}  // namespace leonhard::graph
