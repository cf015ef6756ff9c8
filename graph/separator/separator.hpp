// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/separator/vertex_separator.hpp"

namespace leonhard::graph {

struct SeparatorOptions {
  double largest_side = 0.67;  ///< of the vertices, above 1/2; missed only where no separator keeps it
  std::uint32_t tries = 4;     ///< the smallest separator of so many independent ones is kept
  std::uint64_t seed = 1;
  std::stop_token stop{};  ///< when it is requested the best separator so far is returned
};

/// A small set of vertices that divides a graph into two sides of about the same size.
///
/// throws  InputError if largest_side is not in (1/2, 1] or tries is 0, or the graph has 2^31 vertices or 2^30 edges
/// Cost O(n + m) a try on meshes.
/// Method: multilevel with heavy-edge matching (Karypis and Kumar, SIAM J. Sci. Comput. 20 (1998) 359-392); on every
/// level the separator is refined by moves of its vertices (Ashcraft and Liu 1998; Hendrickson and Rothberg, SIAM J.
/// Sci. Comput. 20 (1998) 468-489), then by a maximum flow through a strip around it (Sanders and Schulz, Advanced
/// Multilevel Node Separator Algorithms, 2016).
[[nodiscard]] VertexSeparator vertex_separator(const CsrGraph& graph, const SeparatorOptions& options = {});

}  // namespace leonhard::graph
