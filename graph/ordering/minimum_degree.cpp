// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/minimum_degree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace leonhard::graph {
namespace {

using Vertex = std::uint32_t;
using Vertices = std::vector<Vertex>;

constexpr Vertex none = std::numeric_limits<Vertex>::max();

/// Vertices by degree in doubly linked lists, the last one added first.
class DegreeLists {
 public:
  explicit DegreeLists(std::uint32_t vertices)
      : head_(vertices + std::size_t{1}, none), next_(vertices, none), previous_(vertices, none) {}

  void add(Vertex v, std::uint32_t degree) {
    next_[v] = head_[degree];
    previous_[v] = none;
    if (head_[degree] != none) previous_[head_[degree]] = v;
    head_[degree] = v;
    least_ = std::min(least_, degree);
  }
  void remove(Vertex v, std::uint32_t degree) {
    if (next_[v] != none) previous_[next_[v]] = previous_[v];
    if (previous_[v] != none)
      next_[previous_[v]] = next_[v];
    else
      head_[degree] = next_[v];
  }
  /// A vertex of least degree; there must be one.
  Vertex take() {
    while (head_[least_] == none) ++least_;
    const Vertex v = head_[least_];
    remove(v, least_);
    return v;
  }

 private:
  std::vector<Vertex> head_;  ///< by degree
  Vertices next_, previous_;
  std::uint32_t least_ = 0;
};

/// The matrix in mid-elimination as a quotient graph: what is left of a vertex's neighbours is some vertices, and some
/// elements, which are eliminated vertices that stand for the clique of their remaining neighbours. A vertex with the
/// same neighbours as another is merged into it and counts in its weight.
class QuotientGraph {
 public:
  QuotientGraph(const CsrGraph& graph, std::span<const std::uint32_t> set_of)
      : set_of_(set_of),
        start_(vertex_count(graph)),
        elements_(vertex_count(graph), 0),
        length_(vertex_count(graph)),
        weight_(vertex_count(graph), 1),
        degree_(vertex_count(graph)),
        clique_(vertex_count(graph)),
        clique_weight_(vertex_count(graph), 0),
        outside_(vertex_count(graph), 0),
        stamp_(vertex_count(graph), 0),
        mark_(vertex_count(graph), 0),
        followers_(vertex_count(graph)),
        lists_(vertex_count(graph)),
        left_(vertex_count(graph)),
        row_mark_(vertex_count(graph), 0) {
    row_.reserve(2 * edge_count(graph));
    for (Vertex v = 0; v < vertex_count(graph); ++v) {
      start_[v] = row_.size();
      const auto list = neighbours(graph, v);
      row_.insert(row_.end(), list.begin(), list.end());
      length_[v] = degree_[v] = graph::degree(graph, v);
    }
  }

  /// Eliminates a set and appends its sequence to the order; stopped, the set and all that follow stay incomplete.
  void eliminate_set(std::span<const Vertex> set, Vertices& order, detail::StepCounter& steps) {
    if (set.empty()) return;
    current_set_ = set_of_[set.front()];
    const std::size_t end = order.size() + set.size();
    for (std::size_t k = set.size(); k-- > 0;)
      if (is_alive(set[k])) lists_.add(set[k], degree_[set[k]]);
    while (order.size() < end && steps.step()) {
      const Vertex pivot = lists_.take();
      eliminate(pivot);
      append_with_followers(pivot, order);
    }
  }

 private:
  [[nodiscard]] bool is_current(Vertex v) const { return set_of_[v] == current_set_; }
  [[nodiscard]] bool is_alive(Vertex v) const { return weight_[v] > 0; }
  Vertex* row(Vertex v) { return row_.data() + start_[v]; }

  void eliminate(Vertex pivot) {
    ++round_;
    const std::uint32_t pivot_weight = weight_[pivot];
    Vertices clique = clique_of(pivot);
    weight_[pivot] = 0;
    left_ -= pivot_weight;
    measure_outside(clique);
    std::uint32_t weight = 0;
    for (const Vertex v : clique) weight += weight_[v];
    for (const Vertex v : clique) {
      if (is_current(v)) lists_.remove(v, degree_[v]);
      update(v, pivot, weight);
    }
    merge_indistinguishable(clique);
    std::erase_if(clique, [&](Vertex v) { return !is_alive(v); });
    for (const Vertex v : clique) {
      degree_[v] = std::min(degree_[v], left_ - weight_[v]);
      if (is_current(v)) lists_.add(v, degree_[v]);
      clique_weight_[pivot] += weight_[v];
    }
    clique_[pivot] = std::move(clique);
  }

  /// The pivot's remaining neighbours, marked with the round; its elements become part of the new one.
  Vertices clique_of(Vertex pivot) {
    Vertices clique;
    mark_[pivot] = round_;
    const auto take = [&](Vertex v) {
      if (!is_alive(v) || mark_[v] == round_) return;
      mark_[v] = round_;
      clique.push_back(v);
    };
    for (std::uint32_t k = 0; k < elements_[pivot]; ++k) {
      const Vertex element = row(pivot)[k];
      for (const Vertex v : clique_[element]) take(v);
      absorb(element);
    }
    for (std::uint32_t k = elements_[pivot]; k < length_[pivot]; ++k) take(row(pivot)[k]);
    return clique;
  }

  void absorb(Vertex element) {
    clique_weight_[element] = 0;
    Vertices().swap(clique_[element]);
  }

  /// To each element beside the clique the weight of its vertices outside the clique.
  void measure_outside(const Vertices& clique) {
    for (const Vertex v : clique)
      for (std::uint32_t k = 0; k < elements_[v]; ++k) {
        const Vertex element = row(v)[k];
        if (clique_weight_[element] == 0) continue;
        if (stamp_[element] != round_) {
          stamp_[element] = round_;
          outside_[element] = clique_weight_[element];
        }
        outside_[element] -= weight_[v];
      }
  }

  /// Takes out of v's row what the new element covers and puts the element in front. Sets degree_[v].
  void update(Vertex v, Vertex pivot, std::uint32_t clique_weight) {
    Vertex* const list = row(v);
    std::uint32_t kept = 0;
    std::uint64_t degree = clique_weight - weight_[v];
    for (std::uint32_t k = 0; k < elements_[v]; ++k) {
      const Vertex element = list[k];
      if (clique_weight_[element] == 0) continue;
      if (outside_[element] == 0) {
        absorb(element);
        continue;
      }
      degree += outside_[element];
      scratch_.push_back(element);
    }
    const std::uint32_t elements = static_cast<std::uint32_t>(scratch_.size());
    for (std::uint32_t k = elements_[v]; k < length_[v]; ++k) {
      const Vertex w = list[k];
      if (!is_alive(w) || mark_[w] == round_) continue;
      degree += weight_[w];
      scratch_.push_back(w);
    }
    list[kept++] = pivot;
    for (const Vertex entry : scratch_) list[kept++] = entry;
    scratch_.clear();
    elements_[v] = elements + 1;
    length_[v] = kept;
    const std::uint64_t by_growth = std::uint64_t{degree_[v]} + (clique_weight - weight_[v]);
    degree_[v] = static_cast<std::uint32_t>(std::min(degree, by_growth));
    if (kept == 1 && is_current(v)) follow(pivot, v);  // nothing beside the clique: eliminated with the pivot
  }

  /// v is eliminated together with the pivot.
  void follow(Vertex pivot, Vertex v) {
    followers_[pivot].push_back(v);
    left_ -= weight_[v];
    weight_[v] = 0;
  }

  /// Vertices of the clique with the same rows become one.
  void merge_indistinguishable(const Vertices& clique) {
    hashed_.clear();
    for (const Vertex v : clique) {
      if (!is_alive(v)) continue;
      std::uint64_t hash = (std::uint64_t{length_[v]} << 32) + elements_[v] + set_of_[v];
      for (std::uint32_t k = 1; k < length_[v]; ++k)
        hash += (row(v)[k] + 1) * std::uint64_t{0x9E3779B97F4A7C15};
      hashed_.emplace_back(hash, v);
    }
    std::sort(hashed_.begin(), hashed_.end());
    for (std::size_t i = 0; i < hashed_.size(); ++i) {
      const Vertex v = hashed_[i].second;
      if (!is_alive(v)) continue;
      bool marked = false;
      for (std::size_t j = i + 1; j < hashed_.size() && hashed_[j].first == hashed_[i].first; ++j) {
        const Vertex w = hashed_[j].second;
        if (!is_alive(w)) continue;
        if (!std::exchange(marked, true)) mark_row(v);
        if (has_marked_row(w, v)) merge(v, w);
      }
    }
  }

  void mark_row(Vertex v) {
    ++row_round_;
    for (std::uint32_t k = 0; k < length_[v]; ++k) row_mark_[row(v)[k]] = row_round_;
  }
  bool has_marked_row(Vertex w, Vertex v) {
    return set_of_[w] == set_of_[v] && elements_[w] == elements_[v] && length_[w] == length_[v] &&
           std::all_of(row(w), row(w) + length_[w],
                       [&](Vertex entry) { return row_mark_[entry] == row_round_; });
  }

  void merge(Vertex v, Vertex w) {
    degree_[v] -= std::min(degree_[v], weight_[w]);
    weight_[v] += weight_[w];
    weight_[w] = 0;
    followers_[v].push_back(w);
  }

  void append_with_followers(Vertex leader, Vertices& order) {
    Vertices stack{leader};
    while (!stack.empty()) {
      const Vertex v = stack.back();
      stack.pop_back();
      order.push_back(v);
      for (std::size_t k = followers_[v].size(); k-- > 0;) stack.push_back(followers_[v][k]);
    }
  }

  std::span<const std::uint32_t> set_of_;
  std::uint32_t current_set_ = 0;
  std::vector<std::size_t> start_;
  Vertices row_;                                  ///< of each vertex left: its elements, then vertices
  std::vector<std::uint32_t> elements_, length_;  ///< how many of a row are elements, and all
  std::vector<std::uint32_t> weight_;             ///< vertices merged into this one, itself included; 0: gone
  std::vector<std::uint32_t> degree_;             ///< a bound on the weight of its neighbours
  std::vector<Vertices> clique_;                  ///< of an element
  std::vector<std::uint32_t> clique_weight_;      ///< 0: no element, or absorbed
  std::vector<std::uint32_t> outside_;
  std::vector<std::uint32_t> stamp_,
      mark_;  ///< the round in which outside_ was set, in which a vertex was in the clique
  std::vector<Vertices> followers_;
  DegreeLists lists_;
  std::uint32_t round_ = 0;
  std::uint32_t left_;  ///< vertices not eliminated
  std::uint64_t row_round_ = 0;
  std::vector<std::uint64_t> row_mark_;  ///< the last row that named this vertex or element
  Vertices scratch_;
  std::vector<std::pair<std::uint64_t, Vertex>> hashed_;
};

}  // namespace

std::vector<std::uint32_t> minimum_degree(const CsrGraph& graph) {
  return minimum_degree(graph, Progress{}).order;
}

OrderResult minimum_degree(const CsrGraph& graph, const Progress& progress) {
  detail::StepCounter steps(progress, "minimum degree", vertex_count(graph));
  OrderResult result;
  result.order = detail::constrained_minimum_degree(graph, Vertices(vertex_count(graph), 0), steps);
  if (steps.stopped()) result.outcome = OrderOutcome::stopped;
  return result;
}

std::vector<std::uint32_t> detail::constrained_minimum_degree(const CsrGraph& graph,
                                                              std::span<const std::uint32_t> set_of) {
  const Progress none_wanted;
  StepCounter steps(none_wanted, "", vertex_count(graph));
  return constrained_minimum_degree(graph, set_of, steps);
}

std::vector<std::uint32_t> detail::constrained_minimum_degree(const CsrGraph& graph,
                                                              std::span<const std::uint32_t> set_of,
                                                              StepCounter& steps) {
  const std::uint32_t sets = set_of.empty() ? 0 : std::ranges::max(set_of) + 1;
  std::vector<std::uint32_t> start(sets + std::size_t{1}, 0);
  for (const std::uint32_t set : set_of) ++start[set + std::size_t{1}];
  for (std::uint32_t set = 0; set < sets; ++set) start[set + std::size_t{1}] += start[set];
  Vertices members(set_of.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (Vertex v = 0; v < set_of.size(); ++v) members[next[set_of[v]]++] = v;

  QuotientGraph quotient(graph, set_of);
  Vertices order;
  order.reserve(members.size());
  for (std::uint32_t set = 0; set < sets && steps.goes_on(); ++set)
    quotient.eliminate_set(std::span(members).subspan(start[set], start[set + 1] - start[set]), order, steps);
  append_missing(order, members);
  return order;
}

}  // namespace leonhard::graph
