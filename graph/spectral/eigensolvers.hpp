// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/graph/fiedler_options.hpp"
#include "leonhard/graph/mesh_graph.hpp"

/// The two iterations behind fiedler(); not for callers outside this room.
namespace leonhard::graph::detail {

struct EigenIterate {
  FiedlerOutcome outcome{};
  std::vector<double> vector;  ///< norm 1, orthogonal to the constant vector
  std::uint32_t iterations{};
};

/// Below this a residual is rounding.
[[nodiscard]] double residual_floor(const CsrGraph& graph);

/// Davidson's method with the multilevel cycle for preconditioner and thick restart. The subspace starts
/// from three smoothed random vectors and keeps four Ritz vectors at a restart, so that close eigenvalues do
/// not slow it.
///
/// graph  connected, more than 32 vertices
[[nodiscard]] EigenIterate davidson(const CsrGraph& graph, const FiedlerOptions& options);

/// Lanczos' method with full reorthogonalisation, no restart.
///
/// graph  connected, at least 2 vertices
[[nodiscard]] EigenIterate lanczos(const CsrGraph& graph, const FiedlerOptions& options);

}  // namespace leonhard::graph::detail
