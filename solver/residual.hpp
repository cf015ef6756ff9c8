// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/solver/steady_options.hpp"
#include "leonhard/solver/support/parallel.hpp"
#include "leonhard/solver/sweep/boundary.hpp"
#include "leonhard/solver/sweep/edge_plan.hpp"
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {

struct SpatialOptions {
  int order = 2;  ///< 1 or 2
  FluxKind flux = SteadyOptions{}.flux;
  LimiterKind limiter = LimiterKind::venkatakrishnan;
  double venkatakrishnan_k = SteadyOptions{}.venkatakrishnan_k;
  double entropy_fix = 0.05;
  int threads = 1;
  std::vector<std::uint32_t> part_of{};  ///< one a vertex, below parts; empty: see EdgePlan
  std::uint32_t parts = 0;
};

/// The scheme's spatial operator: a numerical flux between linearly reconstructed primitive variables through the faces of
/// the median dual, weak boundary conditions. A pure function of the state: the far field's vortex takes its
/// circulation from the state's own lift. An object serves one caller at a time (it owns scratch).
class EulerResidual {
 public:
  /// problem  checked (check_problem); must outlive this
  EulerResidual(const EulerProblem& problem, const SpatialOptions& options,
                const SweepKernels& kernels = best_sweep());

  /// Net flux out of every control volume, 4 a vertex (mass, x and y momentum, energy); `residual` is resized, its
  /// entries beyond 4 * vertices are rubbish. The same bits for any thread count and kernel build.
  void evaluate(const PerId<VertexId, State>& state, std::vector<double>& residual);

  /// As evaluate, with states constant in a cell.
  void evaluate_first_order(const PerId<VertexId, State>& state, std::vector<double>& residual);

  /// Sum of (|Vn| + c) times length over each control volume's boundary; a time step of CFL number k at vertex v
  /// is k area / sum. One a vertex, then rubbish.
  void wave_speed_sums(const PerId<VertexId, State>& state, std::vector<double>& sums);

  /// Jacobian by conservative variables of the residual with states constant in a cell, the dissipation (near the flux's:
  /// flux_jacobians) and the far field held fixed. Blocks of 16, column by column, in the order of EdgePlan::neighbour_block; then rubbish.
  void jacobian(const PerId<VertexId, State>& state, std::vector<double>& blocks);

  [[nodiscard]] const EdgePlan& plan() const { return plan_; }
  [[nodiscard]] const EulerProblem& problem() const { return problem_; }
  [[nodiscard]] const SweepKernels& kernels() const { return kernels_; }

 private:
  void evaluate_with(const double* gradient, const PerId<VertexId, State>& state,
                     std::vector<double>& residual);
  void add_boundary_fluxes(std::size_t part, const PerId<VertexId, State>& state,
                           std::vector<double>& residual) const;
  void follow_lift(const PerId<VertexId, State>& state);

  const EulerProblem& problem_;
  SpatialOptions options_;
  const SweepKernels& kernels_;
  EdgePlan plan_;
  PartRunner run_;
  std::vector<BoundaryEdge> boundary_;
  bool follows_lift_;
  std::vector<double> limiter_scale2_;
  std::vector<double> gradient_;
  SweepSettings settings_;
};

/// Root mean square over the vertices of the residual vector (all four components, net flux out of a control volume,
/// not divided by its area).
[[nodiscard]] double residual_norm(const std::vector<double>& residual, std::size_t vertex_count);

}  // namespace leonhard::solver
