// SPDX-License-Identifier: MIT
#include "leonhard/solver/march/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

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
  for (const auto coefficient : {&Iteration::cl, &Iteration::cd, &Iteration::cm}) {
    const auto by = [&](const Iteration& a, const Iteration& b) { return a.*coefficient < b.*coefficient; };
    const auto [low, high] =
        std::minmax_element(history_.end() - static_cast<std::ptrdiff_t>(window), history_.end(), by);
    if ((*high).*coefficient - (*low).*coefficient > settle_tolerance_) return false;
  }
  return true;
}

std::optional<Verdict> ConvergenceMonitor::record(const Iteration& iteration, bool at_rounding) {
  best_so_far_.push_back(history_.size() == window_begin_
                             ? iteration.residual_drop_orders
                             : std::max(best_so_far_.back(), iteration.residual_drop_orders));
  history_.push_back(iteration);
  if (report_) report_(iteration);
  if (at_rounding || iteration.residual_drop_orders >= drop_orders_) return Verdict::converged;
  if (stop_.stop_requested()) return Verdict::stopped;
  const std::size_t count = history_.size();
  const auto hangs_for = [&](std::size_t span) {
    return count > window_begin_ + span && best_so_far_.back() - best_so_far_[count - 1 - span] < falling;
  };
  if (window_ > 0 && hangs_for(window_) && coefficients_stand_still(window_)) return Verdict::settled;
  if (window_ > 0 && hangs_for(3 * window_)) return Verdict::stalled;
  if (iteration.number >= max_iterations_) return Verdict::iteration_limit;
  return std::nullopt;
}

namespace {

double distance_to_edge(Point2 p, Point2 a, Point2 b) {
  const Vec2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return distance(p, a + t * along);
}

std::optional<Marker> nearest_marker(const MeshDual<2>& dual, Point2 p) {
  std::optional<Marker> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const DualFacet<2>& edge : dual.boundary) {
    const double d = distance_to_edge(p, dual.points[edge.corners[0]], dual.points[edge.corners[1]]);
    if (d < least) least = d, nearest = edge.marker;
  }
  return nearest;
}

std::string name_of(const MeshDual<2>& dual, Marker marker) {
  const auto found = dual.marker_names.find(marker);
  return found == dual.marker_names.end() ? "marker " + std::to_string(marker) : "\"" + found->second + "\"";
}

void describe_bad_vertex(std::ostream& out, const BadVertex& bad, const MeshDual<2>& dual) {
  out << " at vertex " << bad.vertex.raw << " (" << bad.at.x << ", " << bad.at.y << "), rho " << bad.state.rho
      << ", u " << bad.state.u << ", v " << bad.state.v << ", p " << bad.state.p;
  if (bad.nearest_marker) out << ", nearest boundary " << name_of(dual, *bad.nearest_marker);
}

}  // namespace

std::optional<BadVertex> find_bad_vertex(const EulerProblem& problem, const PerId<VertexId, State>& state,
                                         const std::vector<double>& residual) {
  const auto finite_residual = [&](VertexId v) {
    if (residual.size() < 4 * state.size()) return true;
    const auto first = residual.begin() + static_cast<std::ptrdiff_t>(4 * v.index());
    return std::all_of(first, first + 4, [](double x) { return std::isfinite(x); });
  };
  const auto report = [&](VertexId v) {
    const Point2 at = problem.dual.points[v];
    return BadVertex{v, at, state[v], nearest_marker(problem.dual, at)};
  };
  for (const VertexId v : state.ids())
    if (!is_physical(state[v])) return report(v);
  for (const VertexId v : state.ids())
    if (!finite_residual(v)) return report(v);
  return std::nullopt;
}

std::string describe(Verdict verdict, const std::vector<Iteration>& history,
                     const std::optional<BadVertex>& bad, const MeshDual<2>& dual) {
  std::ostringstream out;
  out.precision(4);
  out << to_string(verdict);
  if (history.empty())
    out << " at the start";
  else
    out << " after " << history.back().number << " iterations, residual down "
        << history.back().residual_drop_orders << " orders";
  switch (verdict) {
    case Verdict::settled:
      out << "; it hangs there, but the coefficients stand still";
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

}  // namespace leonhard::solver
