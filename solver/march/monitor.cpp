// SPDX-License-Identifier: MIT
#include "leonhard/solver/march/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "leonhard/solver/axes.hpp"

namespace leonhard::solver {

ConvergenceMonitor::ConvergenceMonitor(const SteadyOptions& options, int window, int max_iterations,
                                       std::function<void(const Iteration&)> report, std::stop_token stop)
    : drop_orders_(options.residual_drop_orders),
      settle_tolerance_(options.settle_tolerance),
      window_(static_cast<std::size_t>(window)),
      max_iterations_(max_iterations),
      report_(std::move(report)),
      stop_(std::move(stop)) {}

bool ConvergenceMonitor::coefficients_stand_still(std::size_t window) const {
  for (const auto coefficient : {&Iteration::cl, &Iteration::cd, &Iteration::cm, &Iteration::cy}) {
    const auto by = [&](const Iteration& a, const Iteration& b) { return a.*coefficient < b.*coefficient; };
    const auto [low, high] =
        std::minmax_element(history_.end() - static_cast<std::ptrdiff_t>(window), history_.end(), by);
    if ((*high).*coefficient - (*low).*coefficient > settle_tolerance_) return false;
  }
  for (std::size_t k = 0; k < history_.back().monitored.size(); ++k) {
    const auto by = [&](const Iteration& a, const Iteration& b) { return a.monitored[k] < b.monitored[k]; };
    const auto [low, high] =
        std::minmax_element(history_.end() - static_cast<std::ptrdiff_t>(window), history_.end(), by);
    const double size = std::max(1.0, std::abs(high->monitored[k]));
    if (!(high->monitored[k] - low->monitored[k] <= settle_tolerance_ * size)) return false;
  }
  return true;
}

std::optional<Verdict> ConvergenceMonitor::record(const Iteration& iteration, double over_rounding) {
  best_so_far_.push_back(history_.size() == window_begin_
                             ? iteration.residual_drop_orders
                             : std::max(best_so_far_.back(), iteration.residual_drop_orders));
  history_.push_back(iteration);
  if (report_) report_(iteration);
  const std::size_t count = history_.size();
  const auto hangs_for = [&](std::size_t span) {
    return count > window_begin_ + span && best_so_far_.back() - best_so_far_[count - 1 - span] < falling;
  };
  at_rounding_ = over_rounding <= 1 || (over_rounding <= near_rounding && hangs_for(rounding_window));
  if (at_rounding_ || iteration.residual_drop_orders >= drop_orders_) return Verdict::converged;
  if (stop_.stop_requested()) return Verdict::stopped;
  if (window_ > 0 && hangs_for(window_) && coefficients_stand_still(window_)) return Verdict::settled;
  if (window_ > 0 && hangs_for(3 * window_)) return Verdict::stalled;
  if (iteration.number >= max_iterations_) return Verdict::iteration_limit;
  return std::nullopt;
}

namespace {

/// Squared distance from p to the segment between a and b.
template <int dim>
double distance2(const Axes<dim>& p, const Axes<dim>& a, const Axes<dim>& b) {
  Axes<dim> along, from;
  for (std::size_t i = 0; i < dim; ++i) along[i] = b[i] - a[i], from[i] = p[i] - a[i];
  const double t = std::clamp(dot(from, along) / dot(along, along), 0.0, 1.0);
  for (std::size_t i = 0; i < dim; ++i) from[i] -= t * along[i];
  return dot(from, from);
}

/// The marker of the facet whose outline is nearest.
template <int dim>
std::optional<Marker> nearest_marker(const MeshDual<dim>& dual, const typename Simplex<dim>::Point& p) {
  std::optional<Marker> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const DualFacet<dim>& facet : dual.boundary)
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      const VertexId a = facet.corners[i], b = facet.corners[(i + 1) % facet.corners.size()];
      const double d = distance2<dim>(axes(p), axes(dual.points[a]), axes(dual.points[b]));
      if (d < least) least = d, nearest = facet.marker;
    }
  return nearest;
}

template <int dim>
std::string name_of(const MeshDual<dim>& dual, Marker marker) {
  const auto found = dual.marker_names.find(marker);
  return found == dual.marker_names.end() ? "marker " + std::to_string(marker) : "\"" + found->second + "\"";
}

template <int dim>
void describe_bad_vertex(std::ostream& out, const BadVertex<dim>& bad, const MeshDual<dim>& dual) {
  constexpr const char* component[] = {"u", "v", "w"};
  out << " at vertex " << bad.vertex.raw << " " << bad.at << ", rho " << bad.state.rho;
  const Axes<dim> v = velocity(bad.state);
  for (std::size_t i = 0; i < dim; ++i) out << ", " << component[i] << " " << v[i];
  out << ", p " << bad.state.p;
  if (bad.nearest_marker) out << ", nearest boundary " << name_of(dual, *bad.nearest_marker);
}

}  // namespace

template <int dim>
std::optional<BadVertex<dim>> find_bad_vertex(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state,
                                              const std::vector<double>& residual) {
  constexpr std::size_t n = dim + 2;
  const auto finite_residual = [&](VertexId v) {
    if (residual.size() < n * state.size()) return true;
    const auto first = residual.begin() + static_cast<std::ptrdiff_t>(n * v.index());
    return std::all_of(first, first + n, [](double x) { return std::isfinite(x); });
  };
  const auto report = [&](VertexId v) {
    const auto& at = problem.dual.points[v];
    return BadVertex<dim>{v, at, state[v], nearest_marker(problem.dual, at)};
  };
  for (const VertexId v : state.ids())
    if (!is_physical(state[v])) return report(v);
  for (const VertexId v : state.ids())
    if (!finite_residual(v)) return report(v);
  return std::nullopt;
}

template <int dim>
std::vector<ResidualShare<dim>> worst_vertices(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state,
                                               const std::vector<double>& residual, std::size_t count) {
  constexpr std::size_t n = dim + 2;
  PerId<VertexId, double> square(state.size(), 0.0);
  double sum = 0;
  std::vector<VertexId> order;
  for (const VertexId v : state.ids()) {
    order.push_back(v);
    for (std::size_t i = 0; i < n; ++i) square[v] += residual[n * v.index() + i] * residual[n * v.index() + i];
    sum += square[v];
  }
  count = std::min(count, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](VertexId a, VertexId b) { return square[a] != square[b] ? square[a] > square[b] : a < b; });
  std::vector<ResidualShare<dim>> worst;
  for (std::size_t k = 0; k < count && sum > 0; ++k) {
    const VertexId v = order[k];
    const auto& at = problem.dual.points[v];
    worst.push_back({v, at, state[v], square[v] / sum, nearest_marker(problem.dual, at)});
  }
  return worst;
}

template <int dim>
std::string describe(const std::vector<ResidualShare<dim>>& worst, const MeshDual<dim>& dual) {
  if (worst.empty()) return "";
  double sum = 0;
  for (const ResidualShare<dim>& part : worst) sum += part.share;
  std::ostringstream out;
  out.precision(2);
  out << "; " << 100 * sum << " % of its square at " << worst.size() << " vertices, first vertex " << worst.front().vertex.raw;
  out.precision(4);
  out << " " << worst.front().at;
  if (worst.front().nearest_marker) out << ", nearest boundary " << name_of(dual, *worst.front().nearest_marker);
  return out.str();
}

template <int dim>
std::string describe(Verdict verdict, bool at_rounding, const std::vector<Iteration>& history,
                     const std::optional<BadVertex<dim>>& bad, const MeshDual<dim>& dual) {
  std::ostringstream out;
  out.precision(4);
  out << to_string(verdict);
  if (history.empty())
    out << " at the start";
  else
    out << " after " << history.back().number << " iterations, residual down "
        << history.back().residual_drop_orders << " orders";
  if (at_rounding) out << " to its rounding errors, below which there is nothing to solve";
  switch (verdict) {
    case Verdict::settled:
      out << "; it hangs there, but the coefficients and all that is monitored stand still";
      break;
    case Verdict::stalled:
      out << "; it hangs there, and the coefficients do not stand still or the time step has shrunk to nothing";
      break;
    case Verdict::diverged:
      if (!history.empty()) out << "; no time step was small enough";
      if (bad) describe_bad_vertex(out, *bad, dual);
      break;
    case Verdict::converged:
    case Verdict::iteration_limit:
    case Verdict::stopped:
      break;
  }
  return out.str();
}

#define LEONHARD_MONITOR(dim)                                                                                              \
  template std::optional<BadVertex<dim>> find_bad_vertex(const FlowProblem<dim>&, const PerId<VertexId, State<dim>>&,     \
                                                         const std::vector<double>&);                                     \
  template std::vector<ResidualShare<dim>> worst_vertices(const FlowProblem<dim>&, const PerId<VertexId, State<dim>>&,    \
                                                          const std::vector<double>&, std::size_t);                       \
  template std::string describe(const std::vector<ResidualShare<dim>>&, const MeshDual<dim>&);                           \
  template std::string describe(Verdict, bool, const std::vector<Iteration>&, const std::optional<BadVertex<dim>>&,             \
                                const MeshDual<dim>&);
LEONHARD_MONITOR(2)
LEONHARD_MONITOR(3)
#undef LEONHARD_MONITOR

}  // namespace leonhard::solver
