// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/support/step_counter.hpp"

namespace leonhard::graph {

/// The approximate minimum degree ordering: little fill. (Boost.Graph's multiple minimum degree reads beyond its arrays
/// on small graphs.)
///
/// returns order[new] = old
/// Cost O(n m) at worst, on meshes about proportional to n.
/// Method: Amestoy, Davis and Duff, SIAM J. Matrix Anal. Appl. 17 (1996) 886-905: quotient graph, element absorption,
/// mass elimination, indistinguishable vertices.
[[nodiscard]] std::vector<std::uint32_t> minimum_degree(const CsrGraph& graph);
OrderResult minimum_degree(const CsrGraph& graph, const Progress& progress);

namespace detail {

/// The minimum degree ordering under a constraint: sets of vertices are eliminated one set after another, each by
/// minimum degree, the degrees counting all that is left of the graph.
///
/// set_of  one a vertex: the set's place in the sequence, from 0 without gaps
/// Method: the constraint as in Davis, Direct Methods for Sparse Linear Systems (2006), 7.1; degrees that see beyond
/// the set: Pellegrini, Roman and Amestoy, Concurrency 12 (2000) 69-84.
[[nodiscard]] std::vector<std::uint32_t> constrained_minimum_degree(const CsrGraph& graph,
                                                                    std::span<const std::uint32_t> set_of);

/// steps  one a vertex eliminated, not counting those eliminated with it; once stopped, what is left of each set is
///        numbered by index
[[nodiscard]] std::vector<std::uint32_t> constrained_minimum_degree(const CsrGraph& graph,
                                                                    std::span<const std::uint32_t> set_of,
                                                                    StepCounter& steps);

}  // namespace detail
}  // namespace leonhard::graph
