// SPDX-License-Identifier: MIT
#include "leonhard/solver/forces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace leonhard::solver {
namespace {

/// Wall edges joined end to end, in the order and direction of the boundary (mesh to the left).
std::vector<std::vector<std::size_t>> wall_runs(const EulerProblem& problem) {
  const auto& boundary = problem.dual.boundary;
  std::map<VertexId, std::size_t> starting_at;
  std::map<VertexId, std::size_t> ending_at;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (problem.boundary.at(boundary[k].marker) != BoundaryKind::slip_wall) continue;
    starting_at.emplace(boundary[k].corners[0], k);
    ending_at.emplace(boundary[k].corners[1], k);
  }
  std::vector<bool> used(boundary.size(), false);
  std::vector<std::vector<std::size_t>> runs;
  const auto follow = [&](std::size_t k) {
    std::vector<std::size_t> run;
    for (auto next = starting_at.find(boundary[k].corners[0]); next != starting_at.end() && !used[next->second];
         next = starting_at.find(boundary[next->second].corners[1])) {
      used[next->second] = true;
      run.push_back(next->second);
    }
    runs.push_back(std::move(run));
  };
  for (const bool open_ones : {true, false})
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      const auto found = starting_at.find(boundary[k].corners[0]);
      if (found == starting_at.end() || found->second != k || used[k]) continue;
      if (!open_ones || !ending_at.contains(boundary[k].corners[0])) follow(k);
    }
  return runs;
}

/// A closed run turned so that it starts at the vertex with the largest x.
void start_at_trailing_edge(const MeshDual<2>& dual, std::vector<std::size_t>& run) {
  const auto x_of = [&](std::size_t k) { return dual.points[dual.boundary[k].corners[0]].x; };
  const auto start =
      std::max_element(run.begin(), run.end(), [&](auto i, auto j) { return x_of(i) < x_of(j); });
  std::rotate(run.begin(), start, run.end());
}

}  // namespace

std::map<Marker, Forces> wall_forces(const EulerProblem& problem, const PerId<VertexId, State>& state) {
  const double far_pressure = 1.0 / problem.gas.gamma, mach = problem.free_stream.mach,
               length = problem.reference.length;
  const double scale = 1.0 / (0.5 * mach * mach * length);
  const double cosine = std::cos(problem.free_stream.alpha_rad),
               sine = std::sin(problem.free_stream.alpha_rad);
  std::map<Marker, Forces> forces;
  for (const DualFacet<2>& edge : problem.dual.boundary) {
    if (problem.boundary.at(edge.marker) != BoundaryKind::slip_wall) continue;
    const auto [from, to] = std::pair(edge.corners[0], edge.corners[1]);
    const Point2 a = problem.dual.points[from], b = problem.dual.points[to];
    const double push = 0.5 * (state[from].p + state[to].p) - far_pressure;
    const Vec2 force = push * Vec2{b.y - a.y, a.x - b.x};  // the outward normal: from the flow into the wall
    const Vec2 arm = 0.5 * ((a - problem.reference.moment_centre) + (b - problem.reference.moment_centre));
    Forces& sum = forces[edge.marker];
    sum.cl += scale * (cosine * force.y - sine * force.x);
    sum.cd += scale * (cosine * force.x + sine * force.y);
    sum.cm -= scale / length * cross(arm, force);
  }
  return forces;
}

Forces total(const std::map<Marker, Forces>& by_marker) {
  Forces sum;
  for (const auto& [marker, forces] : by_marker)
    sum.cl += forces.cl, sum.cd += forces.cd, sum.cm += forces.cm;
  return sum;
}

std::vector<SurfaceLine> surface_lines(const EulerProblem& problem, const PerId<VertexId, State>& state) {
  const MeshDual<2>& dual = problem.dual;
  std::vector<SurfaceLine> lines;
  for (std::vector<std::size_t>& run : wall_runs(problem)) {
    SurfaceLine line;
    line.closed = dual.boundary[run.back()].corners[1] == dual.boundary[run.front()].corners[0];
    if (line.closed) start_at_trailing_edge(dual, run);
    line.marker = dual.boundary[run.front()].marker;
    std::vector<VertexId> vertices;
    for (const std::size_t k : run) vertices.push_back(dual.boundary[k].corners[0]);
    if (!line.closed) vertices.push_back(dual.boundary[run.back()].corners[1]);
    double arc = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const VertexId v = vertices[i];
      if (i > 0) arc += distance(dual.points[vertices[i - 1]], dual.points[v]);
      line.points.push_back({v, dual.points[v], arc,
                             pressure_coefficient(problem.gas, problem.free_stream, state[v].p),
                             mach_number(problem.gas, state[v])});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace leonhard::solver
