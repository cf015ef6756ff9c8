// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "leonhard/graph/partition.hpp"

/// What the methods that halve again and again have in common; not for callers outside this room.
namespace leonhard::graph::detail {

using Indices = std::span<std::uint32_t>;

/// One halving: the lower parts / 2 parts get the first vertices of an arrangement.
struct Halving {
  std::uint32_t parts{};     ///< at least 2
  std::size_t in_front{};    ///< vertices of the lower parts where all weigh the same; otherwise undefined
  bool whole_order = false;  ///< vertices differ in weight: all of them have to be put in order
};

/// Splits recursively, k parts as floor(k/2) and the rest.
///
/// weights  one a vertex; empty: all the same, and the parts then differ by one vertex at most
/// arrange  arrange(vertices, halving) puts the vertices in order, or only those that shall be in front into front
///          unless whole_order; returns how many are in front (used unless whole_order)
template <class Arrange>
class RecursiveBisection {
 public:
  RecursiveBisection(std::span<const std::uint32_t> weights, Arrange arrange)
      : weights_(weights), arrange_(arrange) {}

  Partition operator()(std::size_t n, std::uint32_t parts) {
    result_.parts = parts;
    result_.part_of.resize(n);
    if (parts > n) result_.outcome = PartitionOutcome::empty_parts;
    std::vector<std::uint32_t> vertices(n);
    std::iota(vertices.begin(), vertices.end(), 0U);
    split(vertices, 0, parts);
    return std::move(result_);
  }

 private:
  void split(Indices vertices, std::uint32_t first, std::uint32_t parts) {
    if (vertices.empty()) return;
    if (parts == 1) {
      for (const std::uint32_t v : vertices) result_.part_of[v] = first;
      return;
    }
    const std::size_t in_front = halve(vertices, parts);
    split(vertices.first(in_front), first, parts / 2);
    split(vertices.subspan(in_front), first + parts / 2, parts - parts / 2);
  }

  std::size_t halve(Indices vertices, std::uint32_t parts) {
    const std::size_t n = vertices.size();
    const std::uint32_t lower = parts / 2;
    // Each part n / parts vertices, the first n mod parts one more.
    const Halving halving{parts, n / parts * lower + std::min<std::size_t>(lower, n % parts),
                          !weights_.empty()};
    if (halving.in_front == 0 || halving.in_front == n) return halving.in_front;
    const std::size_t in_front = arrange_(vertices, halving);
    return weights_.empty() ? in_front : by_weight(vertices, parts);
  }

  /// The length whose weight is nearest to the lower parts' share, with a vertex left for every part if there are as
  /// many.
  [[nodiscard]] std::size_t by_weight(std::span<const std::uint32_t> vertices, std::uint32_t parts) const {
    std::uint64_t total = 0;
    for (const std::uint32_t v : vertices) total += weights_[v];
    const double share = static_cast<double>(total) * (parts / 2) / parts;
    std::size_t length = 0;
    double sum = 0;
    while (length < vertices.size() && sum + weights_[vertices[length]] / 2.0 < share)
      sum += weights_[vertices[length++]];
    const std::size_t n = vertices.size();
    return n < parts ? length : std::clamp<std::size_t>(length, parts / 2, n - (parts - parts / 2));
  }

  std::span<const std::uint32_t> weights_;
  Arrange arrange_;
  Partition result_;
};

}  // namespace leonhard::graph::detail
