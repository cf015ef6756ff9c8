// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "leonhard/solver/forces.hpp"
#include "leonhard/solver/steady_options.hpp"
#include "leonhard/solver/support/parallel.hpp"
#include "leonhard/solver/sweep/boundary.hpp"
#include "leonhard/solver/sweep/edge_plan.hpp"
#include "leonhard/solver/sweep/strong_walls.hpp"
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {

struct SpatialOptions {
  int order = 2;  ///< 1 or 2
  FluxKind flux = SteadyOptions{}.flux;
  LimiterKind limiter = LimiterKind::nishikawa_r3;
  double limiter_k = SteadyOptions{}.r3_k;  ///< of the limiter chosen
  double entropy_fix = 0.05;
  int threads = 1;
  std::vector<std::uint32_t> part_of{};  ///< one a vertex, below parts; empty: see EdgePlan
  std::uint32_t parts = 0;
  GradientKind gradient = GradientKind::least_squares;
};

/// The scheme's spatial operator: a numerical flux between linearly reconstructed primitive variables through the faces of
/// the median dual, viscous fluxes where the problem has a viscosity, weak boundary conditions but for no-slip walls
/// (StrongWalls). A pure function of the state: the far field's vortex takes its circulation from the state's own lift. An object
/// serves one caller at a time (it owns scratch).
///
/// Rows of n = dim + 2 numbers a vertex: mass, momentum by axis, energy.
template <int dim>
class FlowResidual {
 public:
  static constexpr std::size_t n = dim + 2;

  /// problem  checked (check_problem); must outlive this
  FlowResidual(const FlowProblem<dim>& problem, const SpatialOptions& options,
               const SweepKernels<dim>& kernels = best_sweep<dim>());

  /// Net flux out of every control volume, n a vertex; `residual` is resized, its
  /// entries beyond n * vertices are rubbish. The same bits for any thread count and kernel build.
  void evaluate(const PerId<VertexId, State<dim>>& state, std::vector<double>& residual);

  /// As evaluate, with states constant in a cell, viscous fluxes by the jumps along the edges alone.
  void evaluate_first_order(const PerId<VertexId, State<dim>>& state, std::vector<double>& residual);

  /// Sum of (|Vn| + c) times size over each control volume's boundary, and what diffusion adds; a time step of CFL number k at
  /// vertex v is k volume / sum. One a vertex, then rubbish.
  void wave_speed_sums(const PerId<VertexId, State<dim>>& state, std::vector<double>& sums);

  /// Jacobian by conservative variables of the residual with states constant in a cell, the dissipation (near the flux's:
  /// flux_jacobians) and the viscosity held fixed, boundary conditions exact. Blocks of n x n, column by column, in the order of
  /// EdgePlan::neighbour_block.
  /// blocks  n^2 plan().block_count() numbers at least
  void jacobian(const PerId<VertexId, State<dim>>& state, std::span<double> blocks);

  /// Bring the steps of neighbouring vertices together: an approximate solution, by two sweeps of Jacobi's method, of
  /// (1 + strength times the number of neighbours) s_v - strength times the sum of the neighbours' s = step_v (A. Jameson and T. J.
  /// Baker, AIAA 83-1929, on any cells). No-slip walls keep theirs.
  /// step  n a vertex
  void smooth(double strength, std::vector<double>& step);

  /// What leaves through each marker, as SteadyResult::mass_flow. The far field's lift is that of the last call of evaluate.
  [[nodiscard]] std::map<Marker, double> mass_flow(const PerId<VertexId, State<dim>>& state) const;

  /// What the walls took up in the last call of evaluate or evaluate_first_order.
  [[nodiscard]] std::vector<WallStress<dim>> wall_stresses(const PerId<VertexId, State<dim>>& state) const {
    return solver::wall_stresses(problem_, state, walls_.vertices(), reactions_);
  }

  /// Give vertices on no-slip walls their walls' velocity and temperature: what a march must start from.
  void project(PerId<VertexId, State<dim>>& state) const { walls_.project(state); }

  [[nodiscard]] const EdgePlan<dim>& plan() const { return plan_; }
  [[nodiscard]] const FlowProblem<dim>& problem() const { return problem_; }
  [[nodiscard]] const SweepKernels<dim>& kernels() const { return kernels_; }

 private:
  using States = PerId<VertexId, State<dim>>;

  void evaluate_with(const double* gradient, const double* unlimited, const States& state, std::vector<double>& residual);
  void add_boundary_fluxes(std::size_t part, const double* unlimited, const States& state,
                           std::vector<double>& residual) const;
  void add_boundary_jacobians(std::size_t part, const States& state, std::span<double> blocks) const;
  void follow_lift(const States& state);
  [[nodiscard]] bool viscous() const { return settings_.viscosity > 0; }
  [[nodiscard]] BoundaryConstants constants() const {
    return {problem_.gas, options_.entropy_fix, problem_.free_stream};
  }
  [[nodiscard]] ViscousConstants viscous_constants() const {
    return {settings_.gamma, settings_.viscosity, settings_.sutherland, settings_.inverse_prandtl};
  }

  const FlowProblem<dim>& problem_;
  SpatialOptions options_;
  const SweepKernels<dim>& kernels_;
  EdgePlan<dim> plan_;
  PartRunner run_;
  std::vector<BoundaryFacet<dim>> boundary_;
  StrongWalls<dim> walls_;
  std::vector<WallReaction<dim>> reactions_;
  bool follows_lift_;
  std::vector<double> limiter_scale_;  ///< of the limiter chosen, in its power
  std::vector<double> gradient_, unlimited_;
  std::vector<double> unsmoothed_, smoothed_;  ///< of smooth()
  std::vector<double> source_;  ///< n a vertex, times the control volume; empty where there is none
  SweepSettings settings_;
};

/// Root mean square over the vertices of the residual vector (all n components, net flux out of a control volume,
/// not divided by its volume).
[[nodiscard]] double residual_norm(const std::vector<double>& residual, std::size_t vertex_count, std::size_t n);

}  // namespace leonhard::solver
