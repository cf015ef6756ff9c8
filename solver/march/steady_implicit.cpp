// SPDX-License-Identifier: MIT
// Pseudo-transient continuation (Kelley and Keyes, SIAM Journal on Numerical Analysis 35, 1998). Each iteration solves
//   (S / cfl + J) dq = -R(q),   S = sum of wave speeds times lengths about each vertex,
// first with the first-order Jacobian for J (robust, cheap), and once the residual has fallen a little with the scheme's
// own: products J x by a difference of residuals (Newton-Krylov), the first-order matrix's ILU(0) preconditioning.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "leonhard/solver/linear_solver.hpp"
#include "leonhard/solver/march/march.hpp"

namespace leonhard::solver {
namespace {

constexpr double default_cfl = 10, default_cfl_max = 1e6, least_cfl = 1e-3;
constexpr double cfl_growth = 3;           ///< at most, an iteration
constexpr double newton_drop = 0.9;        ///< orders after which the scheme's own Jacobian is used ...
constexpr int newton_iteration = 40;       ///< ... or iterations
constexpr double largest_change = 0.25;    ///< of density and pressure in a step, relative: see clip_step
constexpr double many_clipped = 0.02;      ///< vertices of all: then the time step is cut
constexpr double residual_may_grow = 1.5;  ///< by this factor in a step
constexpr int halvings = 5;                ///< of a step whose residual grows more
constexpr int patience = 5;  ///< iterations without a better residual before the time step is cut
// The lift hides in the linear residual's last hundredth: looser solutions leave it to build up over hundreds of steps.
constexpr LinearOptions first_order_linear{0.01, 100};
constexpr LinearOptions newton_linear{0.01, 120};
constexpr double difference_step = 1e-7;  ///< root mean square change of q in a difference of residuals

/// The neighbours of each vertex and itself, ascending.
BlockPattern block_pattern(const EdgePlan& plan) {
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

class ImplicitMarch {
 public:
  explicit ImplicitMarch(March& march) : march_(march), system_(block_pattern(march.spatial.plan())) {
    to_conserved(march.problem.gas, march.state, q_);
    step_.resize(q_.size());
    march.cfl = std::min(march.options.cfl_start.value_or(default_cfl), cfl_max());
  }

  Verdict run() {
    for (int number = 1;; ++number) {
      newton_ = newton_ || drop() >= newton_drop || number > newton_iteration;
      while (!advance()) {
        if (march_.stop.stop_requested()) return Verdict::stopped;
        ++march_.rejected;
        march_.cfl *= 0.2;
        if (march_.cfl >= least_cfl) continue;
        if (march_.bad_vertex) return Verdict::diverged;
        if (!strict_) return Verdict::stalled;
        strict_ = false;  // no step reduces the residual: let it grow a little
        march_.cfl = std::min(default_cfl, cfl_max());
      }
      keep_improving();
      if (const auto verdict = march_.record(number)) return *verdict;
      if (march_.cfl < least_cfl) return Verdict::stalled;  // coefficients stand still because time does
    }
  }

 private:
  [[nodiscard]] double cfl_max() const { return march_.options.cfl_max.value_or(default_cfl_max); }
  [[nodiscard]] double drop() const { return std::log10(march_.first_norm / march_.norm); }

  /// One step: assemble, solve, clip the step before Newton's begin, halve it while the residual grows too much.
  /// False: nothing changed.
  bool advance() {
    march_.bad_vertex.reset();
    if (!assemble()) return false;
    const LinearReport linear = solve();
    march_.linear_iterations += linear.iterations;
    if (linear.outcome == LinearOutcome::stopped || linear.outcome == LinearOutcome::breakdown) return false;
    const double bound = newton_ ? safe_share() : clip_step();
    double share = 1;
    for (int cut = 0; cut <= halvings; ++cut, share *= 0.5) {
      if (!try_share(share)) continue;
      const double before = march_.norm;
      accept();
      adapt_cfl(before / march_.norm, bound, cut);
      return true;
    }
    return false;
  }

  bool assemble() {
    march_.spatial.jacobian(march_.state, blocks_);
    march_.spatial.wave_speed_sums(march_.state, speeds_);
    const EdgePlan& plan = march_.spatial.plan();
    for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
      speeds_[v] /= march_.cfl;
      double* block = blocks_.data() + 16 * std::size_t{plan.diagonal_block(v)};
      for (std::size_t i = 0; i < 4; ++i) block[5 * i] += speeds_[v];
    }
    return system_.factor(blocks_);
  }

  LinearReport solve() {
    right_.resize(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) right_[i] = -march_.residual[i];
    if (!newton_) return system_.solve(right_, step_, first_order_linear, {}, march_.stop);
    return system_.solve(
        right_, step_, newton_linear,
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
    march_.spatial.evaluate(trial_state_, trial_residual_);
    for (std::size_t i = 0; i < q_.size(); ++i)
      y[i] = (trial_residual_[i] - march_.residual[i]) / e + speeds_[i / 4] * x[i];
  }

  /// The greater relative change of density and pressure that the step brings to a vertex.
  [[nodiscard]] double change_at(VertexId v) const {
    const double g = march_.problem.gas.gamma - 1;
    const State& w = march_.state[v];
    const double* d = step_.data() + 4 * v.index();
    const double change_p = g * (0.5 * (w.u * w.u + w.v * w.v) * d[0] - w.u * d[1] - w.v * d[2] + d[3]);
    return std::max(std::abs(d[0]) / w.rho, std::abs(change_p) / w.p);
  }

  /// The share of the step that would change no density or pressure by more than largest_change.
  [[nodiscard]] double safe_share() const {
    double worst = largest_change;
    for (const VertexId v : march_.state.ids()) worst = std::max(worst, change_at(v));
    return largest_change / worst;
  }

  /// Shorten the step at each vertex where it changes density or pressure by more than largest_change: a shock on its
  /// way holds up its own neighbourhood only.
  /// returns  1, or the share that safe_share would have given where many vertices were concerned
  double clip_step() {
    const double share = safe_share();
    std::size_t clipped = 0;
    for (const VertexId v : march_.state.ids()) {
      const double change = change_at(v);
      if (!(change > largest_change)) continue;
      ++clipped;
      for (std::size_t i = 0; i < 4; ++i) step_[4 * v.index() + i] *= largest_change / change;
    }
    return static_cast<double>(clipped) > many_clipped * static_cast<double>(march_.state.size()) ? share : 1;
  }

  bool try_share(double share) {
    trial_.resize(q_.size());
    for (std::size_t i = 0; i < q_.size(); ++i) trial_[i] = q_[i] + share * step_[i];
    if (!to_states(march_.problem.gas, trial_, trial_state_)) {
      march_.bad_vertex = find_bad_vertex(march_.problem, trial_state_, {});
      return false;
    }
    march_.spatial.evaluate(trial_state_, trial_residual_);
    trial_norm_ = residual_norm(trial_residual_, march_.state.size());
    if (!std::isfinite(trial_norm_))
      march_.bad_vertex = find_bad_vertex(march_.problem, trial_state_, trial_residual_);
    return trial_norm_ <= (strict_ ? 1.0 : residual_may_grow) * march_.norm;
  }

  void accept() {
    q_.swap(trial_);
    march_.state.flat().swap(trial_state_.flat());
    march_.residual.swap(trial_residual_);
    march_.norm = trial_norm_;
  }

  /// Switched evolution relaxation: the time step follows the residual, faster up than down.
  void adapt_cfl(double reduction, double bound, int cuts) {
    double factor = std::clamp(cfl_growth * std::sqrt(reduction), 0.5, cfl_growth);
    if (bound < 0.3) factor = std::min(factor, 0.7);
    if (cuts > 0) factor = std::pow(0.5, cuts);
    march_.cfl = std::min(march_.cfl * factor, cfl_max());
  }

  /// A march can end in a cycle over the limiter's kinks: smaller time steps, and none that lets the residual grow,
  /// leave it.
  void keep_improving() {
    if (march_.norm < 0.8 * best_norm_) {
      best_norm_ = march_.norm;
      waited_ = 0;
      strict_ = false;
    } else if (newton_ && ++waited_ >= patience) {
      march_.cfl = std::max(0.1 * march_.cfl, std::min(march_.cfl, default_cfl));
      strict_ = true;
      waited_ = 0;
    }
  }

  March& march_;
  BlockSystem system_;
  bool newton_ = false;
  std::vector<double> q_, step_, right_, blocks_, speeds_;
  std::vector<double> trial_, trial_residual_;
  PerId<VertexId, State> trial_state_;
  double trial_norm_ = 0, best_norm_ = 1e300;
  int waited_ = 0;
  bool strict_ = false;  ///< the residual may not grow
};

}  // namespace

Verdict march_implicit(March& march) { return ImplicitMarch(march).run(); }

}  // namespace leonhard::solver
