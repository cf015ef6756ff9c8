// SPDX-License-Identifier: MIT
// Pseudo-transient continuation (Kelley and Keyes, SIAM Journal on Numerical Analysis 35, 1998). Each iteration solves
//   (S / cfl + J) dq = -R(q),   S = sum of wave speeds times lengths about each vertex,
// in two phases. The start-up marches the scheme whose states are constant in a cell, with its own Jacobian: cheap steps
// that carry shocks and expansions to about where they belong. Then the scheme itself: products J x by a difference of
// residuals (Newton-Krylov), preconditioned with the incomplete factors of the first phase's matrix.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "leonhard/solver/linear_solver.hpp"
#include "leonhard/solver/march/march.hpp"

namespace leonhard::solver {
namespace {

constexpr double default_cfl = 10, default_cfl_max = 1e6;
constexpr double least_cfl = 1e-3;  ///< or this share of the first one: below it the march is given up
constexpr double cfl_growth = 3, greatest_growth = 5;  ///< an iteration, at an even residual and at a falling one

/// Orders of its own residual after which the start-up ends. In subsonic streams the lift builds up slowly, which costs least here.
constexpr double start_up_drop_subsonic = 3, start_up_drop_supersonic = 1.5;
constexpr int start_up_iterations = 200;  ///< likewise
constexpr double start_up_change = 1;    ///< of density and pressure at a vertex in a step; see relative_change
constexpr double clipped_cfl = 20;  ///< the CFL number falls to this while vertices are held back by start_up_change
constexpr LinearOptions start_up_linear{0.05, 60};

constexpr double newton_cfl = 200;     ///< at most, where Newton's method takes over
constexpr double newton_change = 0.4;  ///< of density and pressure at any vertex in a step
// The lift hides in the linear residual's last hundredth: looser solutions leave it to build up over hundreds of steps.
constexpr LinearOptions newton_linear{0.02, 120};
constexpr double difference_step = 1e-7;  ///< root mean square change of q in a difference of residuals

constexpr double least_share = 0.03;       ///< of a step: below it the step is given up
constexpr double residual_may_grow = 1.5;  ///< by this factor in a step, unless it goes round in circles
constexpr int patience = 8;  ///< iterations without a better residual after which it may not grow at all

/// The neighbours of each vertex and itself, ascending.
template <int dim>
BlockPattern block_pattern(const EdgePlan<dim>& plan) {
  BlockPattern pattern;
  pattern.reserve(plan.vertex_count, plan.block_count());
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
    const auto row = plan.neighbours[v];
    const auto behind = std::ranges::lower_bound(row, v);
    for (auto w = row.begin(); w != behind; ++w) pattern.add_link(static_cast<std::int32_t>(*w));
    pattern.add_link(static_cast<std::int32_t>(v));
    for (auto w = behind; w != row.end(); ++w) pattern.add_link(static_cast<std::int32_t>(*w));
    pattern.end_row();
  }
  return pattern;
}

double norm_of(std::span<const double> x) {
  return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
}

/// A relative change as the march weighs it: a fall counts for more than a rise, and one of 1 would leave a fifth.
double weigh(double change) { return change > 0 ? change : -1.25 * change; }

template <int dim>
class ImplicitMarch {
 public:
  static constexpr std::size_t n = dim + 2;
  /// Of the incomplete factors: one level pays in the plane. In space it would double the memory of the whole march, for two fifths
  /// fewer linear iterations: there the factors take the matrix's place, and the start-up, too, takes products by differences.
  static constexpr int fill_levels = dim == 2 ? 1 : 0;

  explicit ImplicitMarch(March<dim>& march)
      : march_(march),
        system_(block_pattern(march.spatial.plan()), static_cast<int>(n), fill_levels),
        starting_(march.problem.initial.empty() || march.problem.rough_initial),
        start_up_drop_(march.problem.free_stream.mach < 1 ? start_up_drop_subsonic : start_up_drop_supersonic) {
    to_conserved(march.problem.gas, march.state, q_);
    step_.resize(q_.size());
    march.cfl = std::min(march.options.cfl_start.value_or(default_cfl), cfl_max());
    least_cfl_ = least_cfl * std::min(march.cfl, 1.0);
    take_residual();
  }

  Verdict run() {
    for (int number = 1;; ++number) {
      if (starting_ && (std::log10(first_norm_ / norm_) >= start_up_drop_ || number > start_up_iterations))
        take_over();
      while (!advance()) {
        if (march_.stop.stop_requested()) return Verdict::stopped;
        ++march_.rejected;
        march_.cfl *= 0.2;
        if (march_.cfl >= least_cfl_) continue;
        return march_.bad_vertex ? Verdict::diverged : Verdict::stalled;
      }
      if (starting_) {
        march_.spatial.evaluate(march_.state, march_.residual);
        march_.norm = residual_norm(march_.residual, march_.state.size(), n);
        march_.book.restart_window();
      } else {
        march_.residual = residual_;
        march_.norm = norm_;
        keep_improving();
      }
      if (const auto verdict = march_.record(number)) return *verdict;
      if (march_.cfl < least_cfl_) return Verdict::stalled;  // coefficients stand still because time does
    }
  }

 private:
  [[nodiscard]] double cfl_max() const { return march_.options.cfl_max.value_or(default_cfl_max); }

  /// The residual that this phase brings down.
  void evaluate(const PerId<VertexId, State<dim>>& state, std::vector<double>& residual) {
    if (starting_)
      march_.spatial.evaluate_first_order(state, residual);
    else
      march_.spatial.evaluate(state, residual);
  }

  void take_residual() {
    evaluate(march_.state, residual_);
    norm_ = first_norm_ = residual_norm(residual_, march_.state.size(), n);
  }

  void take_over() {
    starting_ = false;
    take_residual();
    march_.cfl = std::min(march_.cfl, newton_cfl);
  }

  /// One step: assemble, solve, hold the step back where it changes too much, halve it while the residual grows too
  /// much. False: nothing changed.
  bool advance() {
    march_.bad_vertex.reset();
    if (!assemble()) return false;
    linear_ = solve();
    march_.linear_iterations += linear_.iterations;
    if (linear_.outcome == LinearOutcome::stopped || linear_.outcome == LinearOutcome::breakdown) return false;
    clipped_ = starting_ ? clip_step() : 0;
    const double bound = starting_ ? 1 : safe_share();
    double share = bound;
    for (int cuts = 0; share >= least_share; ++cuts, share *= 0.5) {
      if (!try_share(share)) continue;
      const double before = norm_;
      accept();
      adapt_cfl(before / norm_, bound, cuts);
      return true;
    }
    return false;
  }

  bool assemble() {
    const std::span<double> blocks = system_.blocks();
    march_.spatial.jacobian(march_.state, blocks);
    march_.spatial.wave_speed_sums(march_.state, speeds_);
    const EdgePlan<dim>& plan = march_.spatial.plan();
    for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
      speeds_[v] /= march_.cfl;
      double* block = blocks.data() + n * n * plan.diagonal_block(v);
      for (std::size_t i = 0; i < n; ++i) block[(n + 1) * i] += speeds_[v];
    }
    return system_.factor();
  }

  LinearReport solve() {
    right_.resize(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) right_[i] = -residual_[i];
    if (starting_ && fill_levels > 0) return system_.solve(right_, step_, start_up_linear, {}, march_.stop);
    return system_.solve(
        right_, step_, starting_ ? start_up_linear : newton_linear,
        [this](std::span<const double> x, std::span<double> y) { multiply(x, y); }, march_.stop);
  }

  /// y = (S / cfl + dR/dq) x, the derivative by a one-sided difference.
  void multiply(std::span<const double> x, std::span<double> y) {
    const double size = norm_of(x);
    const double e =
        size > 0 ? difference_step * std::sqrt(static_cast<double>(march_.state.size())) / size : 1;
    trial_.resize(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) trial_[i] = q_[i] + e * x[i];
    (void)to_states(march_.problem.gas, trial_, trial_state_);
    evaluate(trial_state_, trial_residual_);
    for (std::size_t i = 0; i < q_.size(); ++i)
      y[i] = (trial_residual_[i] - residual_[i]) / e + speeds_[i / n] * x[i];
  }

  /// The greater relative change of density and pressure that the step brings to a vertex, weighed.
  [[nodiscard]] double relative_change(VertexId v) const {
    const double g = march_.problem.gas.gamma - 1;
    const State<dim>& w = march_.state[v];
    const Axes<dim> velocity_here = velocity(w);
    const double* d = step_.data() + n * v.index();
    double change_p = 0.5 * dot(velocity_here, velocity_here) * d[0] + d[n - 1];
    for (std::size_t i = 0; i < dim; ++i) change_p -= velocity_here[i] * d[1 + i];
    change_p *= g;
    return std::max(weigh(d[0] / w.rho), weigh(change_p / w.p));
  }

  /// The share of the step that changes no density or pressure by more than newton_change.
  [[nodiscard]] double safe_share() const {
    double worst = newton_change;
    for (const VertexId v : march_.state.ids()) worst = std::max(worst, relative_change(v));
    return newton_change / worst;
  }

  /// Shorten the step at each vertex where it changes density or pressure by more than start_up_change: a shock on its
  /// way holds up its own neighbourhood only.
  /// returns  at how many vertices
  std::size_t clip_step() {
    std::size_t clipped = 0;
    for (const VertexId v : march_.state.ids()) {
      const double change = relative_change(v);
      if (!(change > start_up_change)) continue;
      ++clipped;
      for (std::size_t i = 0; i < n; ++i) step_[n * v.index() + i] *= start_up_change / change;
    }
    return clipped;
  }

  bool try_share(double share) {
    trial_.resize(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) trial_[i] = q_[i] + share * step_[i];
    if (!to_states(march_.problem.gas, trial_, trial_state_)) {
      march_.bad_vertex = find_bad_vertex<dim>(march_.problem, trial_state_, {});
      return false;
    }
    evaluate(trial_state_, trial_residual_);
    trial_norm_ = residual_norm(trial_residual_, march_.state.size(), n);
    if (!std::isfinite(trial_norm_)) {
      march_.bad_vertex = find_bad_vertex(march_.problem, trial_state_, trial_residual_);
      return false;
    }
    // A clipped step does not solve the linear system, so its unsteady residual says nothing.
    const double reached = clipped_ > 0 ? trial_norm_ : unsteady_norm(share);
    return reached <= (strict_ ? 1.0 : residual_may_grow) * norm_;
  }

  /// Of S / cfl dq + R(q + dq), which an exact step in time brings to nothing, however much R grows.
  [[nodiscard]] double unsteady_norm(double share) const {
    double sum = 0;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      const double r = trial_residual_[i] + share * speeds_[i / n] * step_[i];
      sum += r * r;
    }
    return std::sqrt(sum / static_cast<double>(march_.state.size()));
  }

  void accept() {
    q_.swap(trial_);
    march_.state.flat().swap(trial_state_.flat());
    residual_.swap(trial_residual_);
    norm_ = trial_norm_;
  }

  /// Switched evolution relaxation: the time step follows the residual, faster up than down, held by what went wrong.
  void adapt_cfl(double reduction, double bound, int cuts) {
    double factor = std::clamp(cfl_growth * std::sqrt(reduction), 0.5, greatest_growth);
    if (clipped_ > 0) factor = march_.cfl > clipped_cfl ? 0.7 : 1;
    if (bound < 0.9) factor = std::min(factor, 1.0);
    if (bound < 0.3) factor = std::min(factor, 0.7);
    if (linear_.outcome == LinearOutcome::iteration_limit)
      factor = std::min(factor, linear_.relative_residual > 0.3 ? 0.5 : linear_.relative_residual > 0.1 ? 1.0 : 2.0);
    if (cuts > 0) factor = std::min(factor, std::pow(0.5, cuts));
    march_.cfl = std::min(march_.cfl * factor, cfl_max());
  }

  /// A march can end in a cycle over the limiter's kinks: smaller time steps, and none that lets the residual grow,
  /// leave it.
  void keep_improving() {
    if (norm_ < 0.8 * best_norm_) {
      best_norm_ = norm_;
      waited_ = 0;
      strict_ = false;
    } else if (++waited_ >= patience) {
      march_.cfl = std::max(0.1 * march_.cfl, std::min(march_.cfl, default_cfl));
      strict_ = true;
      waited_ = 0;
    }
  }

  March<dim>& march_;
  BlockSystem system_;
  bool starting_;  ///< in the start-up
  double start_up_drop_;
  double least_cfl_;
  LinearReport linear_{};
  std::size_t clipped_ = 0;  ///< vertices that the start-up held back in this step
  std::vector<double> q_, residual_, step_, right_, speeds_;
  std::vector<double> trial_, trial_residual_;
  PerId<VertexId, State<dim>> trial_state_;
  double first_norm_ = 0, norm_ = 0, trial_norm_ = 0;  ///< of this phase's residual
  double best_norm_ = 1e300;
  int waited_ = 0;
  bool strict_ = false;  ///< the residual may not grow
};

}  // namespace

template <int dim>
Verdict march_implicit(March<dim>& march) {
  return ImplicitMarch<dim>(march).run();
}

template Verdict march_implicit(March<2>&);
template Verdict march_implicit(March<3>&);

}  // namespace leonhard::solver
