// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

namespace leonhard::graph {

/// What the Cholesky factor L of a symmetric positive definite matrix with the graph's pattern would hold.
struct CholeskyFill {
  std::uint64_t nonzeros{};  ///< nnz(L), diagonal included
  std::uint64_t fill{};      ///< nnz(L) less the nonzeros of the matrix's lower triangle
  double flops{};            ///< sum of the squared column counts, the usual measure of the work
  std::vector<std::uint32_t> column_count;  ///< nonzeros of each column of L (new order), with diagonal
};

/// In an elimination tree: the column has no nonzero below the diagonal.
inline constexpr std::uint32_t no_parent = std::numeric_limits<std::uint32_t>::max();

/// The elimination tree of the matrix in the given order: parent[j] is the row of the first nonzero below the
/// diagonal in column j of L (new numbers), or `no_parent` at a root.
///
/// throws  InputError if order is no permutation of the graph's vertices
/// Cost O(m log n), in practice O(m).
/// Method: Liu, ACM TOMS 12 (1986) 127-148, with path compression.
[[nodiscard]] std::vector<std::uint32_t> elimination_tree(const CsrGraph& graph,
                                                          std::span<const std::uint32_t> order);

/// The size of L without forming it.
///
/// order   order[new] = old
/// throws  InputError if order is no permutation of the graph's vertices
/// Cost O(m log n), in practice O(m).
/// Method: Gilbert, Ng and Peyton, "An efficient algorithm to compute row and column counts for sparse
/// Cholesky factorization", SIAM J. Matrix Anal. Appl. 15 (1994) 1075-1091, section 3.
[[nodiscard]] CholeskyFill cholesky_fill(const CsrGraph& graph, std::span<const std::uint32_t> order);

}  // namespace leonhard::graph
