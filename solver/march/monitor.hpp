// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/steady_options.hpp"
#include "leonhard/solver/steady_result.hpp"

namespace leonhard::solver {

/// Keeps the history and says when to stop.
///
/// converged        the residual fell far enough, or to what rounding leaves of it, or hangs near that
/// settled          over the window cl, cd, cm, cy and all monitored quantities moved less than the tolerance while the residual's best value fell by
///                  less than `falling` orders
/// stalled          over three windows the residual's best value fell by less than `falling` orders
/// iteration_limit  as it says
class ConvergenceMonitor {
 public:
  static constexpr double falling = 0.2;
  static constexpr double near_rounding = 30;        ///< times the rounding errors: a residual that hangs below is one of them ...
  static constexpr std::size_t rounding_window = 8;  ///< ... once it has for this many iterations

  ConvergenceMonitor(const SteadyOptions& options, int window, int max_iterations,
                     std::function<void(const Iteration&)> report, std::stop_token stop);

  /// Take one iteration down, report it, and answer whether that ends the march.
  /// over_rounding  the residual over the rounding errors of the fluxes in it
  [[nodiscard]] std::optional<Verdict> record(const Iteration& iteration,
                                              double over_rounding = std::numeric_limits<double>::infinity());

  /// Whether the last residual consists of rounding errors.
  [[nodiscard]] bool at_rounding() const { return at_rounding_; }

  /// Forget how the residual fell so far: the windows begin with the next iteration.
  void restart_window() { window_begin_ = history_.size(); }

  [[nodiscard]] std::vector<Iteration> take_history() { return std::move(history_); }

 private:
  [[nodiscard]] bool coefficients_stand_still(std::size_t window) const;

  double drop_orders_, settle_tolerance_;
  std::size_t window_;
  int max_iterations_;
  std::function<void(const Iteration&)> report_;
  std::stop_token stop_;
  std::vector<Iteration> history_;
  std::vector<double> best_so_far_;  ///< drop since window_begin_, one an iteration
  std::size_t window_begin_ = 0;
  bool at_rounding_ = false;
};

/// The first vertex whose state is unphysical, or else whose residual is not finite, with what lies next to it.
/// residual  dim + 2 a vertex, or empty
template <int dim>
[[nodiscard]] std::optional<BadVertex<dim>> find_bad_vertex(const FlowProblem<dim>& problem,
                                                            const PerId<VertexId, State<dim>>& state,
                                                            const std::vector<double>& residual);

/// The up to `count` vertices with the largest residual, the largest first.
/// residual  dim + 2 a vertex, finite
template <int dim>
[[nodiscard]] std::vector<ResidualShare<dim>> worst_vertices(const FlowProblem<dim>& problem,
                                                             const PerId<VertexId, State<dim>>& state,
                                                             const std::vector<double>& residual, std::size_t count);

/// Where they lie, to be added to the verdict's sentence; "" of none.
template <int dim>
[[nodiscard]] std::string describe(const std::vector<ResidualShare<dim>>& worst, const MeshDual<dim>& dual);

/// The verdict in a sentence with its figures.
template <int dim>
[[nodiscard]] std::string describe(Verdict verdict, bool at_rounding, const std::vector<Iteration>& history,
                                   const std::optional<BadVertex<dim>>& bad, const MeshDual<dim>& dual);

}  // namespace leonhard::solver
