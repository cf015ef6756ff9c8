// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/partition/recursive_bisection.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using detail::Halving;
using detail::Indices;

/// The places of a breadth-first sequence at which a new level begins; a new component begins a level too.
std::vector<std::size_t> level_starts(const CsrGraph& graph, std::span<const std::uint32_t> sequence) {
  constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> level(vertex_count(graph), unseen);
  std::vector<std::size_t> starts;
  std::uint32_t last = unseen;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const std::uint32_t v = sequence[i];
    std::uint32_t nearest = unseen;
    for (const std::uint32_t w : neighbours(graph, v)) nearest = std::min(nearest, level[w]);
    level[v] = nearest == unseen ? 0 : nearest + 1;
    if (level[v] != last || nearest == unseen) starts.push_back(i);
    last = level[v];
  }
  return starts;
}

/// The start of a level nearest to the median, or the median where none leaves vertices for all parts and keeps both
/// sides within the bound.
std::size_t level_boundary(const std::vector<std::size_t>& starts, const Halving& halving, std::size_t n,
                           double imbalance) {
  const std::uint32_t lower = halving.parts / 2, upper = halving.parts - lower;
  const double mean = static_cast<double>(n) / halving.parts;
  std::size_t chosen = halving.in_front, nearest = n;
  for (const std::size_t start : starts) {
    const auto front = static_cast<double>(start), back = static_cast<double>(n - start);
    if (front < lower || back < upper) continue;
    if (front > (1 + imbalance) * mean * lower || back > (1 + imbalance) * mean * upper) continue;
    const std::size_t away = start > halving.in_front ? start - halving.in_front : halving.in_front - start;
    if (away < nearest) {
      nearest = away;
      chosen = start;
    }
  }
  return chosen;
}

}  // namespace

Partition recursive_cuthill_mckee_bisection(const CsrGraph& graph, std::uint32_t parts, CuthillMcKeeCut where,
                                            const CuthillMcKeeOptions& options) {
  if (parts == 0) throw InputError("parts", "a partition into 0 parts", "ask for at least 1");
  if (!(options.imbalance >= 0))
    throw InputError("imbalance", "it is negative or no number", "give 0 or more");
  if (!options.weights.empty() && options.weights.size() != vertex_count(graph))
    throw InputError("weights",
                     std::to_string(options.weights.size()) + " weights for " +
                         std::to_string(vertex_count(graph)) + " vertices",
                     "give one each, or none");
  SubgraphExtractor extract(graph);
  const int depth = static_cast<int>(std::bit_width(parts > 1 ? parts - 1 : 1U));
  const double share =
      std::pow(1 + options.imbalance, 1.0 / depth) - 1;  // of the imbalance, for each halving
  bool stopped = false;
  const auto arrange = [&](Indices vertices, const Halving& halving) {
    stopped = stopped || options.progress.stop_requested();
    if (stopped) return halving.in_front;
    std::ranges::sort(vertices);  // the piece, not the way to it, decides
    const CsrGraph piece = extract(vertices);
    std::vector<std::uint32_t> sequence = reverse_cuthill_mckee(piece);
    std::ranges::reverse(sequence);
    const std::size_t in_front =
        where == CuthillMcKeeCut::median
            ? halving.in_front
            : level_boundary(level_starts(piece, sequence), halving, vertices.size(), share);
    for (std::uint32_t& v : sequence) v = vertices[v];
    std::ranges::copy(sequence, vertices.begin());
    return in_front;
  };
  Partition result = detail::RecursiveBisection(options.weights, arrange)(vertex_count(graph), parts);
  if (stopped) result.outcome = PartitionOutcome::stopped;
  return result;
}

}  // namespace leonhard::graph
