// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

/// The graphs of the multilevel separator; not for callers outside this room.
namespace leonhard::graph::detail {

/// An undirected graph with weights, both directions of each edge stored.
struct SeparatorGraph {
  struct Arc {
    std::uint32_t to;
    std::uint32_t weight;  ///< edges of the finest level
  };
  std::vector<std::uint32_t> start{0};
  std::vector<Arc> arcs;
  std::vector<std::uint32_t> weight;  ///< vertices of the finest level
  std::uint32_t total{};              ///< of the weights

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(weight.size()); }
  [[nodiscard]] std::span<const Arc> row(std::uint32_t v) const {
    return std::span(arcs).subspan(start[v], start[v + std::size_t{1}] - start[v]);
  }
};

[[nodiscard]] SeparatorGraph separator_graph(const CsrGraph& graph);

/// A graph with a half to two thirds of the vertices: pairs of neighbours become one.
struct Coarsening {
  SeparatorGraph graph;
  std::vector<std::uint32_t> coarse_of;  ///< one a vertex of the finer graph
};

/// Heavy-edge matching in random sequence; vertices that find no partner among their neighbours take one that has a
/// neighbour in common with them.
///
/// largest  no pair weighs more
[[nodiscard]] Coarsening coarsen(const SeparatorGraph& graph, std::uint32_t largest, std::mt19937_64& random);

}  // namespace leonhard::graph::detail
