// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <vector>

#include "leonhard/solver/march/monitor.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady_options.hpp"

namespace leonhard::solver {

/// What both ways of marching share: the state, its residual, and the book of iterations.
template <int dim>
struct March {
  static constexpr std::size_t n = dim + 2;

  March(const FlowProblem<dim>& problem, const SteadyOptions& options, ConvergenceMonitor& book,
        std::stop_token stop);

  const FlowProblem<dim>& problem;
  const SteadyOptions& options;
  ConvergenceMonitor& book;
  std::stop_token stop;

  FlowResidual<dim> spatial;
  PerId<VertexId, State<dim>> state;
  std::vector<double> residual;  ///< of state
  double first_norm = 0, norm = 0;
  double rounding = 0;  ///< a norm below which the residual consists of rounding errors
  double cfl = 0;
  int linear_iterations = 0;  ///< since the last record
  int rejected = 0;
  std::optional<BadVertex<dim>> bad_vertex;
  std::vector<WallStress<dim>> stresses;  ///< of the last record
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();

  /// Evaluate the residual of the start and take it down as iteration 0; diverged where it is not finite.
  [[nodiscard]] std::optional<Verdict> start();
  /// Take down the current state, whose residual was the last that `spatial` evaluated, as iteration `number`.
  [[nodiscard]] std::optional<Verdict> record(int number);
};

/// The conservative variables of every vertex, dim + 2 a vertex, and back.
template <int dim>
void to_conserved(Gas gas, const PerId<VertexId, State<dim>>& state, std::vector<double>& conserved);
/// returns  whether every state is physical
template <int dim>
[[nodiscard]] bool to_states(Gas gas, const std::vector<double>& conserved, PerId<VertexId, State<dim>>& state);

/// Pseudo-transient continuation; see steady_implicit.cpp.
template <int dim>
[[nodiscard]] Verdict march_implicit(March<dim>& march);
/// Multi-stage with local time steps; see steady_explicit.cpp.
template <int dim>
[[nodiscard]] Verdict march_explicit(March<dim>& march);

}  // namespace leonhard::solver
