// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "leonhard/graph/ordering.hpp"

namespace leonhard::graph {

struct NestedDissectionOptions {
  std::uint32_t leaf = 64;  ///< pieces of no more vertices are not divided
  std::uint64_t seed = 1;
  Progress progress;  ///< stage "nested dissection"
};

/// The nested dissection ordering: a separator is numbered last, the two sides before it in the same way. Within
/// pieces and separators the sequence is that of minimum degree, which sees the separators around.
///
/// returns  stopped: what was not yet divided is ordered by minimum degree
/// throws   InputError if leaf is 0
/// Cost on meshes O(n log n).
/// Method: George, SIAM J. Numer. Anal. 10 (1973) 345-363; vertex_separator; constrained minimum degree.
OrderResult nested_dissection(const CsrGraph& graph, const NestedDissectionOptions& options = {});

}  // namespace leonhard::graph
