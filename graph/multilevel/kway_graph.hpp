// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

/// The multilevel partitioner's own graph; not for callers outside this room.
namespace leonhard::graph::detail {

/// A directed half of an edge.
struct Arc {
  std::uint32_t to;
  std::int32_t weight;
};

/// An undirected graph with weights, both directions of every edge stored. The sums of all vertex weights and of all arc
/// weights stay below 2^31, so that every gain fits in 32 bits.
struct KwayGraph {
  CompressedRows<Arc> arcs;  ///< row v: the edges of vertex v
  std::vector<std::int32_t> vertex_weight;
  std::int64_t total_weight{};  ///< of the vertices

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(vertex_weight.size()); }
  [[nodiscard]] std::span<const Arc> row(std::uint32_t v) const { return arcs[v]; }
};

/// vertex_weights  one a vertex; empty: all 1
/// edge_weights    one a directed edge in the graph's sequence, the same in both directions; empty: all 1
/// throws  InputError if the weights are not as many, not positive, not symmetric or too large in sum
[[nodiscard]] KwayGraph weighted_graph(const CsrGraph& graph, std::span<const std::uint32_t> vertex_weights,
                                       std::span<const std::uint32_t> edge_weights);

/// Cuts subgraphs out of one graph; scratch space of one number a vertex.
class KwaySubgraph {
 public:
  explicit KwaySubgraph(const KwayGraph& graph) : graph_(&graph), new_of_old_(graph.size()) {}

  /// The subgraph on the vertices for which side[v] is the given one: vertex i of the result is `vertices[i]`.
  ///
  /// vertices  all of that side
  [[nodiscard]] KwayGraph operator()(std::span<const std::uint32_t> vertices,
                                     std::span<const std::uint32_t> side);

 private:
  const KwayGraph* graph_;
  std::vector<std::uint32_t> new_of_old_;
};

struct KwayComponents {
  std::vector<std::uint32_t> component_of;  ///< one a vertex
  std::uint32_t count{};                    ///< components are 0 ... count-1, by their first vertices
};

[[nodiscard]] KwayComponents components(const KwayGraph& graph);

/// The weight of all edges between different parts.
[[nodiscard]] std::int64_t cut_of(const KwayGraph& graph, std::span<const std::uint32_t> part_of);

/// The weight of each part.
[[nodiscard]] std::vector<std::int64_t> part_weights(const KwayGraph& graph,
                                                     std::span<const std::uint32_t> part_of,
                                                     std::uint32_t parts);

}  // namespace leonhard::graph::detail
