// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/graph/ordering.hpp"

/// Boost.Graph's own orderings, for those who compare; not for callers outside this room. Component by component, by
/// smallest vertex: Boost's Sloan takes connected graphs only, and the others clear marks of the whole graph for each
/// component. Stages "boost-cuthill-mckee", "boost-king", "boost-sloan" and "boost-minimum-degree".
namespace leonhard::graph::detail {

/// cuthill_mckee_ordering, reversed as in Boost's example. Cost O(m log d).
OrderResult boost_cuthill_mckee(const CsrGraph& graph, const Progress& progress);

/// king_ordering, reversed as in Boost's example. Cost O(m^2 log d) at worst.
OrderResult boost_king(const CsrGraph& graph, const Progress& progress);

/// sloan_ordering between the ends that Boost's find_starting_node and pseudo_peripheral_pair find: the search of its own,
/// sloan_start_end_vertices, writes beyond an array where a vertex of largest degree lies in a last level. Sorts a list at
/// every step: hours for 10^6 vertices.
OrderResult boost_sloan(const CsrGraph& graph, const Progress& progress);

/// minimum_degree_ordering, Liu's multiple minimum degree (delta = 0), of a copy as an adjacency_list. The copy has one
/// vertex more, without edges: Boost's lists by degree end one short of what is read of them in complete graphs.
OrderResult boost_minimum_degree(const CsrGraph& graph, const Progress& progress);

}  // namespace leonhard::graph::detail
