// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

/// Graphs in and out as two arrays `xadj` and `adjncy`, the form of METIS, ParMETIS, Scotch, PETSc and SciPy's
/// csr_matrix: the neighbours of vertex v are adjncy[xadj[v]] .. adjncy[xadj[v + 1] - 1].
namespace leonhard::graph {

/// The graph of two such arrays.
///
/// xadj    one more than there are vertices, from 0, not descending, to adjncy's size
/// adjncy  vertices from 0; every edge stands in both rows, in any sequence. Self-loops and repetitions are dropped and
///         counted, as by graph_from_edges()
/// throws  InputError on offsets that descend or do not fit adjncy, a neighbour that is no vertex, an edge that stands in
///         one row only, 2^32 - 1 vertices or more, or more than 2^31 - 1 edges
/// Cost O(n + m log d), d the largest degree.
[[nodiscard]] EdgeListGraph graph_from_adjacency(std::span<const std::int32_t> xadj,
                                                 std::span<const std::int32_t> adjncy);
[[nodiscard]] EdgeListGraph graph_from_adjacency(std::span<const std::int64_t> xadj,
                                                 std::span<const std::int64_t> adjncy);

/// A graph's own arrays, without a copy; valid as long as the graph is.
struct AdjacencySpans {
  std::span<const std::int32_t> xadj, adjncy;
};

/// throws  InputError if the graph has 2^31 vertices or 2^30 edges or more, so that 32 signed bits do not count them:
///         take adjacency_arrays() then
/// Cost O(1).
[[nodiscard]] AdjacencySpans adjacency_spans(const CsrGraph& graph);

/// A copy with 64-bit numbers.
struct AdjacencyArrays {
  std::vector<std::int64_t> xadj, adjncy;
};

/// Cost O(n + m).
[[nodiscard]] AdjacencyArrays adjacency_arrays(const CsrGraph& graph);

}  // namespace leonhard::graph
