// SPDX-License-Identifier: MIT
#include <array>
#include <queue>
#include <utility>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/ordering/by_component.hpp"
#include "leonhard/graph/ordering/level_search.hpp"
#include "leonhard/graph/ordering/smallest_envelope.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

/// Sloan's numbering of a connected graph from one end towards the other. Priorities only rise, so that a heap with
/// outdated entries, which are passed over, serves.
class SloanNumbering {
 public:
  SloanNumbering(const CsrGraph& graph, const std::vector<std::uint32_t>& distance_to_end,
                 SloanWeights weights)
      : graph_(graph),
        state_(vertex_count(graph), State::inactive),
        priority_(vertex_count(graph)),
        weights_(weights) {
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      priority_[v] = std::int64_t{weights.distance} * distance_to_end[v] -
                     std::int64_t{weights.degree} * (degree(graph, v) + std::int64_t{1});
    order_.reserve(vertex_count(graph));
  }

  /// The order, cut short by a stop.
  [[nodiscard]] std::vector<std::uint32_t> from(std::uint32_t root, detail::StepCounter& steps) {
    touch(root);
    while (order_.size() < vertex_count(graph_) && steps.step()) number(next());
    return std::move(order_);
  }

 private:
  enum class State : char { inactive, preactive, active, numbered };

  void number(std::uint32_t v) {
    const bool was_preactive = state_[v] == State::preactive;
    state_[v] = State::numbered;
    order_.push_back(v);
    for (const std::uint32_t w : neighbours(graph_, v)) {
      if (state_[w] == State::numbered) continue;
      if (was_preactive) raise(w);
      if (state_[w] == State::preactive || state_[w] == State::inactive) activate(w);
    }
  }

  /// The front reaches w: each of its neighbours adds one row less to the front if it is numbered now.
  void activate(std::uint32_t w) {
    state_[w] = State::active;
    raise(w);
    for (const std::uint32_t x : neighbours(graph_, w))
      if (state_[x] != State::numbered) raise(x);
  }

  void raise(std::uint32_t v) {
    priority_[v] += weights_.degree;
    touch(v);
  }
  void touch(std::uint32_t v) {
    if (state_[v] == State::inactive) state_[v] = State::preactive;
    heap_.push({priority_[v], ~v});
  }
  std::uint32_t next() {
    while (true) {
      const auto [priority, complement] = heap_.top();
      heap_.pop();
      const std::uint32_t v = ~complement;
      if (state_[v] != State::numbered && priority == priority_[v]) return v;
    }
  }

  const CsrGraph& graph_;
  std::vector<State> state_;
  std::vector<std::int64_t> priority_;
  SloanWeights weights_;
  std::priority_queue<std::pair<std::int64_t, std::uint32_t>> heap_;  ///< among equals the smallest vertex
  std::vector<std::uint32_t> order_;
};

std::vector<std::uint32_t> order_connected(const CsrGraph& graph, std::span<const SloanWeights> choices,
                                           detail::StepCounter& steps) {
  detail::LevelSearch search(graph);
  const detail::PseudoDiameter ends =
      detail::pseudo_diameter(graph, search, detail::vertices_by_degree(graph).front(), steps);
  std::vector<std::uint32_t> distance(vertex_count(graph));
  search(ends.to);
  search.write_levels(distance);
  detail::SmallestEnvelope best(graph);
  for (const SloanWeights& weights : choices)
    if (steps.goes_on()) best.offer(SloanNumbering(graph, distance, weights).from(ends.from, steps));
  return best.take();
}

constexpr std::array usual_choices{SloanWeights{1, 2}, SloanWeights{16, 1}};

}  // namespace

OrderResult sloan(const CsrGraph& graph, std::span<const SloanWeights> choices, const Progress& progress) {
  if (choices.empty()) throw InputError("choices", "no weights were given", "give at least one pair");
  detail::StepCounter steps(progress, "sloan", choices.size() * vertex_count(graph));
  return detail::order_by_component(graph, steps,
                                    [&](const CsrGraph& connected, detail::StepCounter& counter) {
                                      return order_connected(connected, choices, counter);
                                    });
}

OrderResult sloan(const CsrGraph& graph, const Progress& progress) {
  return sloan(graph, usual_choices, progress);
}

std::vector<std::uint32_t> sloan(const CsrGraph& graph, std::span<const SloanWeights> choices) {
  return sloan(graph, choices, Progress{}).order;
}

std::vector<std::uint32_t> sloan(const CsrGraph& graph) { return sloan(graph, usual_choices); }

}  // namespace leonhard::graph
