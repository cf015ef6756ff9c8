// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/solver/forces.hpp"
#include "leonhard/solver/linear_solver.hpp"
#include "leonhard/solver/problem.hpp"

namespace leonhard {

enum class LimiterKind { none, venkatakrishnan, barth_jespersen };

enum class Marching {
  implicit_ptc,  ///< pseudo-transient continuation, Newton-Krylov at the end: the default, needs no tuning
  explicit_multistage,  ///< three-stage Runge-Kutta with local time steps
};

/// How to march. The defaults are meant to work for every case from Mach 0.1 to 3.
struct SteadyOptions {
  Marching marching = Marching::implicit_ptc;
  LimiterKind limiter = LimiterKind::venkatakrishnan;
  double venkatakrishnan_k = 3.0;   ///< >= 0; larger limits less; see limiter.hpp for the scale
  int order = 2;                    ///< 1: states constant in a cell; 2: linear reconstruction
  double entropy_fix = 0.05;        ///< Harten's delta as a fraction of |Vn| + c, in [0, 1]
  std::optional<double> cfl_start;  ///< none: chosen by the marching kind
  std::optional<double> cfl_max;
  double residual_drop_orders = 8;  ///< converged once log10(|R0| / |R|) reaches this
  double settle_tolerance =
      1e-6;  ///< settled once cl, cd, cm move less than this over settle_window iterations ...
  /// ... while the residual has stopped falling; none: 40 implicit, 1000 explicit; 0: never
  std::optional<int> settle_window;
  int max_iterations = 0;  ///< 0: 500 implicit, 50,000 explicit
  int threads = 1;         ///< >= 1; the result is the same to the bit for any value
  /// The parts over which the residual and the Jacobian are threaded: one number a vertex, each below `parts` (a part
  /// may be empty). Empty: parts of the solver's own making. The result is the same to the bit for any parts.
  std::vector<std::uint32_t> part_of;
  std::uint32_t parts = 0;
  /// Start from here in place of the free stream; one state a vertex, or empty.
  PerId<VertexId, State> initial;
};

/// One line of the history. Iteration 0 is the start.
struct Iteration {
  int number{};
  double residual_drop_orders{};  ///< log10 of the first residual norm over this one (norm: see Residual)
  double cl{}, cd{}, cm{};
  double cfl{};
  int linear_iterations{};  ///< since the previous line
  double seconds{};         ///< wall time since the start of solve_steady
};

enum class Verdict {
  converged,  ///< the residual fell by residual_drop_orders
  settled,    ///< the residual hangs, the coefficients stand still within settle_tolerance
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
struct BadVertex {
  VertexId vertex;
  Point2 at;
  State state;
  std::optional<Marker> nearest_marker;  ///< of the boundary edge nearest to it
};

struct SteadyResult {
  Verdict verdict{};
  std::string words;  ///< the verdict in a sentence, with its figures
  PerId<VertexId, State> state;
  Forces forces;  ///< over all walls
  std::map<Marker, Forces> forces_by_marker;
  std::vector<SurfaceLine> surface;
  std::vector<Iteration> history;       ///< one entry an iteration, the start included
  std::optional<BadVertex> bad_vertex;  ///< only when diverged
  int rejected_steps{};                 ///< steps rolled back and repeated with a smaller time step
  std::string sweep;                    ///< which build of the inner loops ran: "avx2" or "baseline"
};

namespace solver {

/// March the Euler equations to a steady state.
///
/// problem  mesh, gas, boundary conditions; vertices best numbered by reverse Cuthill-McKee, any numbering is
/// right options  see SteadyOptions monitor  called after each iteration, from this thread; may be empty stop
/// asked at each iteration and inside linear solves; obeyed within 0.1 s on meshes up to some 10^6 vertices
/// returns  state, forces and a verdict; never throws for a flow that does not converge
/// throws   InputError for a bad problem or option, before any work
/// Needs a PetscSession alive for implicit marching (linear_solver.hpp).
[[nodiscard]] SteadyResult solve_steady(const EulerProblem& problem, const SteadyOptions& options = {},
                                        const std::function<void(const Iteration&)>& monitor = {},
                                        std::stop_token stop = {});

}  // namespace solver
}  // namespace leonhard
