// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/solver/forces.hpp"
#include "leonhard/solver/gas.hpp"

namespace leonhard {

/// One line of the history. Iteration 0 is the start.
struct Iteration {
  int number{};
  double residual_drop_orders{};  ///< log10 of the first residual norm over this one (root mean square of the net fluxes out of the control volumes)
  double cl{}, cd{}, cm{};
  double cfl{};
  int linear_iterations{};  ///< since the previous line
  double seconds{};         ///< wall time since the start of solve_steady
  double cy{};              ///< space only
  std::vector<double> monitored{};  ///< see FlowProblem::monitored
};

enum class Verdict {
  converged,  ///< the residual fell by residual_drop_orders, or to its rounding errors
  settled,    ///< the residual hangs, coefficients and monitored quantities stand still within settle_tolerance
  stalled,    ///< the residual hangs, and the coefficients still move or the time step has shrunk to nothing
  diverged,   ///< no step could be taken from an unphysical state; `bad_vertex` names the first one
  iteration_limit,
  stopped,  ///< the stop token asked
};

/// The word used in reports, e.g. "iteration_limit".
[[nodiscard]] constexpr std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::converged:
      return "converged";
    case Verdict::settled:
      return "settled";
    case Verdict::stalled:
      return "stalled";
    case Verdict::diverged:
      return "diverged";
    case Verdict::iteration_limit:
      return "iteration_limit";
    case Verdict::stopped:
      return "stopped";
  }
  return "";
}

/// Where a run broke down.
template <int dim>
struct BadVertex {
  VertexId vertex;
  typename Simplex<dim>::Point at;
  State<dim> state;
  std::optional<Marker> nearest_marker;  ///< of the boundary facet nearest to it
};

/// A vertex that carries much of what is left of the residual.
template <int dim>
struct ResidualShare {
  VertexId vertex;
  typename Simplex<dim>::Point at;
  State<dim> state;
  double share{};                        ///< of the sum of squares
  std::optional<Marker> nearest_marker;  ///< of the boundary facet nearest to it
};

template <int dim>
struct SteadyResult {
  Verdict verdict{};
  std::string words;  ///< the verdict in a sentence, with its figures
  bool at_rounding = false;  ///< the residual consists of rounding errors: it cannot fall further
  /// What leaves through each marker of the boundary in a unit of time, in units of rho_inf c_inf times a facet's size, by the
  /// scheme's own fluxes: in a steady state, and without sources, they add up to 0.
  std::map<Marker, double> mass_flow;
  PerId<VertexId, State<dim>> state;
  Forces forces;  ///< over all walls
  std::map<Marker, Forces> forces_by_marker;
  std::vector<SurfaceLine> surface;                ///< plane only
  std::vector<solver::WallStress<dim>> stresses;  ///< one a vertex on a no-slip wall
  std::vector<Iteration> history;       ///< one entry an iteration, the start included
  std::optional<BadVertex<dim>> bad_vertex;  ///< only when diverged
  /// The up to ten vertices that carry most of the residual, the first one most; empty where it converged or diverged.
  std::vector<ResidualShare<dim>> worst;
  int rejected_steps{};                 ///< steps rolled back and repeated with a smaller time step
  std::string sweep;                    ///< which build of the inner loops ran: "avx2" or "baseline"
};

}  // namespace leonhard
