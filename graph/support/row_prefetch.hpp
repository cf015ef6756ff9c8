// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "leonhard/graph/mesh_graph.hpp"

namespace leonhard::graph::detail {

/// For a breadth-first search: rows lie anywhere in memory, but the queue tells which come next, so they are fetched
/// while others are looked at. On 10^6 vertices in random sequence a search takes half the time.
///
/// queue       of vertices, of which place `at` is looked at now
/// of_a_neighbour  called with vertices that will soon be looked at from a row, to fetch what is kept of them
template <class Fetch>
[[gnu::always_inline]] inline void prefetch_rows(const CsrGraph& graph, std::span<const std::uint32_t> queue,
                                                 std::size_t at, const Fetch& of_a_neighbour) {
  constexpr std::size_t ahead = 4;
  const auto start = graph.rows().offsets();
  if (at + 4 * ahead < queue.size()) __builtin_prefetch(&start[queue[at + 4 * ahead]]);
  if (at + 2 * ahead < queue.size())
    __builtin_prefetch(graph.rows().links().data() + start[queue[at + 2 * ahead]]);
  if (at + ahead < queue.size())
    for (const std::uint32_t w : neighbours(graph, queue[at + ahead])) of_a_neighbour(w);
}

}  // namespace leonhard::graph::detail
