// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>

#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/partition/recursive_bisection.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using detail::Halving;
using detail::Indices;

/// Splits vertices of one graph by Fiedler vectors of the pieces.
class SpectralArrangement {
 public:
  SpectralArrangement(const CsrGraph& graph, std::uint64_t seed, const Progress& progress,
                      std::uint32_t parts)
      : extract_(graph), seed_(seed), progress_(progress), splits_(std::min(parts, vertex_count(graph))) {}

  std::size_t operator()(Indices vertices, const Halving& halving) {
    progress_("spectral bisection", static_cast<double>(done_++) / splits_);
    if (progress_.stop_requested()) stopped_ = true;
    if (stopped_) return halving.in_front;  // the vertices stay as they lie: a valid split, not a good one
    std::ranges::sort(vertices);            // the piece, not the way to it, decides
    const CsrGraph piece = extract_(vertices);
    const Components pieces = components(piece);
    if (pieces.count() == 1)
      order_by_fiedler(piece, vertices);
    else
      deal_components(pieces, vertices, halving);
    return halving.in_front;
  }

  [[nodiscard]] bool was_stopped() const { return stopped_; }

 private:
  void order_by_fiedler(const CsrGraph& piece, Indices vertices) {
    FiedlerOptions options;
    options.tolerance = 1e-4;  // on meshes 1e-7 yields the same cuts
    options.seed = seed_;
    options.stop = progress_.stop;
    const Fiedler pair = fiedler(piece, options);
    if (pair.outcome == FiedlerOutcome::stopped) stopped_ = true;
    std::vector<std::pair<double, std::uint32_t>> keyed;
    keyed.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) keyed.emplace_back(pair.vector[i], vertices[i]);
    std::ranges::sort(keyed);
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = keyed[i].second;
  }

  /// Largest component first, each whole to the side that has room; one that fits neither side fills up the
  /// front. Where the whole order counts, the components follow one another, each in its own order.
  void deal_components(const Components& pieces, Indices vertices, const Halving& halving) {
    const std::size_t in_front = halving.whole_order ? vertices.size() : halving.in_front;
    std::vector<std::vector<std::uint32_t>> members(pieces.count());
    for (std::size_t i = 0; i < vertices.size(); ++i) members[pieces.component_of[i]].push_back(vertices[i]);
    std::ranges::stable_sort(members, std::ranges::greater{}, &std::vector<std::uint32_t>::size);
    std::vector<std::uint32_t> front, back;
    for (std::vector<std::uint32_t>& component : members) {
      std::size_t to_front = 0;
      if (halving.whole_order && component.size() > 2) order_by_fiedler(extract_(component), component);
      if (front.size() + component.size() <= in_front)
        to_front = component.size();
      else if (back.size() + component.size() > vertices.size() - in_front) {
        to_front = in_front - front.size();
        order_by_fiedler(extract_(component), component);
      }
      const auto cut = component.begin() + static_cast<std::ptrdiff_t>(to_front);
      front.insert(front.end(), component.begin(), cut);
      back.insert(back.end(), cut, component.end());
    }
    std::ranges::copy(back, std::ranges::copy(front, vertices.begin()).out);
  }

  SubgraphExtractor extract_;
  std::uint64_t seed_;
  const Progress& progress_;
  std::uint32_t splits_;
  std::uint32_t done_ = 0;
  bool stopped_ = false;
};

}  // namespace

Partition recursive_spectral_bisection(const CsrGraph& graph, std::uint32_t parts, std::uint64_t seed,
                                       const Progress& progress, std::span<const std::uint32_t> weights) {
  if (parts == 0) throw InputError("parts", "a partition into 0 parts", "ask for at least 1");
  if (!weights.empty() && weights.size() != vertex_count(graph))
    throw InputError(
        "weights",
        std::to_string(weights.size()) + " weights for " + std::to_string(vertex_count(graph)) + " vertices",
        "give one each, or none");
  SpectralArrangement arrangement(graph, seed, progress, parts);
  const auto arrange = [&](Indices vertices, const Halving& halving) {
    return arrangement(vertices, halving);
  };
  Partition result = detail::RecursiveBisection(weights, arrange)(vertex_count(graph), parts);
  if (arrangement.was_stopped()) result.outcome = PartitionOutcome::stopped;
  return result;
}

}  // namespace leonhard::graph
