// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

namespace leonhard::graph {

// An ordering is a permutation `order` with order[new] = old: the sequence in which old numbers are visited.

/// A vertex at (nearly) the greatest distance from some other, for a level structure that is deep and narrow.
///
/// start   any vertex; the search stays in its component
/// throws  InputError if start is no vertex
/// Cost O(m) a level structure, usually 3 to 5 of them.
/// Method: George and Liu, "An implementation of a pseudoperipheral node finder", ACM TOMS 5 (1979) 284-295:
/// go to a vertex of least degree in the last level as long as that deepens the level structure. Ties:
/// smallest index.
[[nodiscard]] std::uint32_t pseudo_peripheral_vertex(const CsrGraph& graph, std::uint32_t start);

/// The reverse Cuthill-McKee ordering: small bandwidth and profile for a banded or incomplete factorisation.
///
/// Each component is visited breadth first from a pseudo-peripheral vertex (searched from a vertex of least
/// degree), neighbours by increasing degree, ties by index; then the whole sequence is reversed. Components
/// follow one another by smallest vertex before reversal.
///
/// returns order[new] = old
/// Cost O(n + m log d), d the largest degree.
/// Method: Cuthill and McKee (1969); George (1971) for the reversal; Barth's notes 2.2.
[[nodiscard]] std::vector<std::uint32_t> reverse_cuthill_mckee(const CsrGraph& graph);

/// The inverse permutation: new_of_old[order[i]] = i.
///
/// throws  InputError if order is no permutation, naming the number that is out of range or repeated
[[nodiscard]] std::vector<std::uint32_t> invert(std::span<const std::uint32_t> order);

/// What an ordering costs a symmetric matrix with the graph's pattern and a full diagonal. With first(i) the
/// smallest column of row i up to the diagonal:
struct OrderingCost {
  std::uint32_t bandwidth{};  ///< max of i - first(i): the half bandwidth, 0 for a diagonal matrix
  std::uint64_t envelope{};   ///< sum of i - first(i), also called profile, the diagonal not counted
  double rms_wavefront{};     ///< root mean square over i of the rows active at step i, row i among them
};

/// throws  InputError if order is no permutation of the graph's vertices
/// Cost O(n + m).
[[nodiscard]] OrderingCost ordering_cost(const CsrGraph& graph, std::span<const std::uint32_t> order);

/// The order as it is: 0, 1, ... n-1.
[[nodiscard]] std::vector<std::uint32_t> natural_order(const CsrGraph& graph);

}  // namespace leonhard::graph
