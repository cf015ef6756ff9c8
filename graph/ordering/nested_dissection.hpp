// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "leonhard/graph/ordering.hpp"

namespace leonhard::graph {

struct NestedDissectionOptions {
  std::uint32_t leaf = 60;     ///< pieces of no more vertices are not divided
  double largest_side = 0.67;  ///< of a piece's vertices
  std::uint32_t tries = 2;     ///< separators of each piece, of which the smallest is taken
  std::uint64_t seed = 1;
  Progress progress{};  ///< stages "nested dissection", "minimum degree"
};

/// The nested dissection ordering: a separator is numbered last, the two sides before it in the same way. Within
/// pieces and separators the sequence is that of minimum degree, which sees the separators around.
///
/// returns  stopped: within what is divided so far, vertices keep their sequence
/// throws   InputError if leaf or tries is 0, or largest_side not in (1/2, 1]
/// Cost on meshes O(n log n).
/// Method: George, SIAM J. Numer. Anal. 10 (1973) 345-363; vertex_separator; constrained minimum degree.
OrderResult nested_dissection(const CsrGraph& graph, const NestedDissectionOptions& options = {});

}  // namespace leonhard::graph
