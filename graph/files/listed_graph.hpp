// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/graph/graph_file.hpp"

/// What the readers of graph files share; not for callers outside the room.
namespace leonhard::graph::detail {

/// One entry of a file: the edge's ends from 0 and where it stands.
struct ListedEdge {
  std::uint32_t from, to;
  std::uint32_t line;
};

/// A file's entries as they stand.
struct ListedGraph {
  std::string source;
  std::uint32_t vertices{};
  std::vector<ListedEdge> entries;
  std::vector<std::int64_t> weights;  ///< one an entry, or empty
  bool both_directions = false;       ///< every edge must be listed at both ends
  std::string remedy;                 ///< for an edge that is not
};

/// Sorts, drops self-loops and repetitions, checks symmetry and counts components. Fills graph, edge_weights,
/// self_loops, parallel_edges and components of the file.
///
/// throws  InputError naming the line of an edge that one end lists only, or whose ends give it two weights
void assemble(ListedGraph&& listed, GraphFile& file);

}  // namespace leonhard::graph::detail
