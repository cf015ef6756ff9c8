// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/graph/fiedler_options.hpp"
#include "leonhard/graph/mesh_graph.hpp"

namespace leonhard::graph {

/// The second smallest eigenpair of a graph's Laplacian D - A.
struct [[nodiscard]] Fiedler {
  FiedlerOutcome outcome{};
  double value{};  ///< lambda_2, the algebraic connectivity; 0 exactly if the graph is not connected
  std::vector<double> vector;  ///< one entry a vertex; Euclidean norm 1, orthogonal to the constant vector
  double residual{};           ///< norm of (L - value) * vector
  std::uint32_t iterations{};  ///< products with the Laplacian
};

/// The Fiedler vector, whose median or sign splits a graph across few edges (Barth's notes 2.3; Fiedler 1973;
/// Pothen, Simon and Liou 1990).
///
/// A graph of several components has lambda_2 = 0; the vector returned is then constant on the first
/// component and constant on all others. Where lambda_2 is a multiple eigenvalue the vector is one of its
/// eigenvectors, the same for the same graph and seed. The sign is such that the first entry of at least half
/// the largest size is positive.
///
/// A residual below 1e-14 times the largest degree is rounding and counts as converged at any tolerance.
///
/// throws  InputError if the graph has fewer than two vertices, or tolerance or iterations are not positive
/// Method, multilevel: Davidson (1975), Morgan and Scott (1986), with thick restart; preconditioner: smoothed
/// aggregation, Vanek, Mandel and Brezina (1996).
/// Method, lanczos: Paige (1971), Simon (1984).
/// Cost, multilevel on meshes: O(n + m) memory and a time almost proportional to it.
Fiedler fiedler(const CsrGraph& graph, const FiedlerOptions& options = {});

/// The product of the Laplacian D - A with x, one entry a vertex.
///
/// throws  InputError if x has not one entry a vertex
[[nodiscard]] std::vector<double> laplacian_product(const CsrGraph& graph, const std::vector<double>& x);

}  // namespace leonhard::graph
