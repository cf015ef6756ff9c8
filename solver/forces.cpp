// SPDX-License-Identifier: MIT
#include "leonhard/solver/forces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "leonhard/solver/axes.hpp"
#include "leonhard/solver/sweep/boundary.hpp"

namespace leonhard::solver {
namespace {

/// Wall edges joined end to end, in the order and direction of the boundary (mesh to the left).
std::vector<std::vector<std::size_t>> wall_runs(const FlowProblem<2>& problem) {
  const auto& boundary = problem.dual.boundary;
  std::map<VertexId, std::size_t> starting_at;
  std::map<VertexId, std::size_t> ending_at;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (!is_wall(problem.boundary.at(boundary[k].marker).kind)) continue;
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

/// Turns a force at a point into coefficients.
template <int dim>
class Coefficients {
 public:
  explicit Coefficients(const FlowProblem<dim>& problem)
      : downstream_(direction<dim>(problem.free_stream)),
        centre_(problem.reference.moment_centre),
        scale_(2 / (problem.free_stream.mach * problem.free_stream.mach *
                    (dim == 2 ? problem.reference.length : problem.reference.area))),
        length_(problem.reference.length) {
    const double alpha = problem.free_stream.alpha_rad;
    up_[0] = -std::sin(alpha), up_[dim - 1] = std::cos(alpha);
  }

  [[nodiscard]] Forces operator()(const Axes<dim>& force, const typename Simplex<dim>::Point& at) const {
    Forces c;
    c.cl = scale_ * dot(up_, force), c.cd = scale_ * dot(downstream_, force);
    if constexpr (dim == 2) {
      c.cm = -scale_ / length_ * cross(at - centre_, vector_of(force));
    } else {
      const Vec3 moment = scale_ / length_ * cross(at - centre_, vector_of(force));
      c.cy = scale_ * dot(cross(vector_of(up_), vector_of(downstream_)), vector_of(force));
      c.roll = moment.x, c.cm = moment.y, c.yaw = moment.z;
    }
    return c;
  }

 private:
  Axes<dim> downstream_, up_{};
  typename Simplex<dim>::Point centre_;
  double scale_, length_;
};

/// Pressure less that of the free stream, over the facet.
template <int dim>
Axes<dim> pressure_force(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state,
                         const DualFacet<dim>& facet) {
  const double own = corner_share(facet), far = 1 / problem.gas.gamma;
  const std::size_t count = facet.corners.size();
  double sum = 0;
  for (const VertexId v : facet.corners) sum += state[v].p - far;
  typename Simplex<dim>::Vector force{};
  for (std::size_t i = 0; i < count; ++i) {
    const double here = state[facet.corners[i]].p - far;
    force += (own * here + (1 - own) * (sum - here) / static_cast<double>(count - 1)) * facet.shares[i];
  }
  return axes(force);
}

}  // namespace

template <int dim>
std::vector<WallStress<dim>> wall_stresses(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state,
                                           const std::vector<StrongVertex<dim>>& vertices,
                                           const std::vector<WallReaction<dim>>& reactions) {
  const double mach = problem.free_stream.mach;
  std::vector<WallStress<dim>> stresses;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    WallStress<dim> stress{vertices[k], reactions[k].friction, reactions[k].heat / (stress.at.area * mach * mach * mach), 0};
    for (double& component : stress.friction) component /= 0.5 * mach * mach * stress.at.area;
    const State<dim>& w = state[stress.at.vertex];
    const double mu =
        viscosity_at(*problem.viscosity, problem.free_stream, problem.reference.length, problem.gas.gamma * w.p / w.rho);
    const double tau = 0.5 * mach * mach * std::sqrt(dot(stress.friction, stress.friction));
    stress.y_plus = 2 * problem.dual.volume[stress.at.vertex] / stress.at.area * std::sqrt(tau * w.rho) / mu;
    stresses.push_back(std::move(stress));
  }
  return stresses;
}

template <int dim>
std::map<Marker, Forces> wall_forces(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state,
                                     const std::vector<WallStress<dim>>& stresses) {
  const Coefficients<dim> coefficients(problem);
  std::map<Marker, Forces> forces;
  for (const DualFacet<dim>& facet : problem.dual.boundary) {
    if (!is_wall(problem.boundary.at(facet.marker).kind)) continue;
    forces[facet.marker] += coefficients(pressure_force(problem, state, facet), facet.centre);
  }
  const double dynamic = 0.5 * problem.free_stream.mach * problem.free_stream.mach;
  for (const WallStress<dim>& stress : stresses)
    for (const auto& [marker, share] : stress.at.share_of) {
      Axes<dim> force = stress.friction;
      for (double& component : force) component *= dynamic * stress.at.area * share;
      Forces friction = coefficients(force, problem.dual.points[stress.at.vertex]);
      friction.cl_friction = friction.cl, friction.cd_friction = friction.cd;
      forces[marker] += friction;
    }
  return forces;
}

Forces total(const std::map<Marker, Forces>& by_marker) {
  Forces sum;
  for (const auto& [marker, forces] : by_marker) sum += forces;
  return sum;
}

namespace {

SurfaceLine make_line(const FlowProblem<2>& problem, const PerId<VertexId, State<2>>& state, std::vector<std::size_t> run) {
  const MeshDual<2>& dual = problem.dual;
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
    SurfacePoint point{v, dual.points[v], arc, {}, mach_number(problem.gas, state[v]), {}, {}, {}};
    point.cp = pressure_coefficient(problem.gas, problem.free_stream, state[v].p);
    line.points.push_back(point);
  }
  return line;
}

/// Along the wall at point i of a line.
Vec2 tangent(const SurfaceLine& line, std::size_t i) {
  const std::size_t last = line.points.size() - 1;
  const std::size_t before = i > 0 ? i - 1 : line.closed ? last : 0, after = i < last ? i + 1 : line.closed ? 0 : last;
  const Vec2 t = line.points[after].at - line.points[before].at;
  return (1 / norm(t)) * t;
}

}  // namespace

std::vector<SurfaceLine> surface_lines(const FlowProblem<2>& problem, const PerId<VertexId, State<2>>& state,
                                       const std::vector<WallStress<2>>& stresses) {
  std::map<VertexId, const WallStress<2>*> stress_at;
  for (const WallStress<2>& stress : stresses) stress_at[stress.at.vertex] = &stress;
  const Vec2 downstream = vector_of(direction<2>(problem.free_stream));
  std::vector<SurfaceLine> lines;
  for (std::vector<std::size_t>& run : wall_runs(problem)) {
    SurfaceLine line = make_line(problem, state, std::move(run));
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const auto found = stress_at.find(line.points[i].vertex);
      if (found == stress_at.end()) continue;
      const Vec2 along = tangent(line, i);
      line.points[i].cf = dot(vector_of(found->second->friction), dot(along, downstream) < 0 ? -along : along);
      line.points[i].heat = found->second->heat, line.points[i].y_plus = found->second->y_plus;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

#define LEONHARD_FORCES(dim)                                                                                               \
  template std::vector<WallStress<dim>> wall_stresses(const FlowProblem<dim>&, const PerId<VertexId, State<dim>>&,         \
                                                      const std::vector<StrongVertex<dim>>&,                               \
                                                      const std::vector<WallReaction<dim>>&);                              \
  template std::map<Marker, Forces> wall_forces(const FlowProblem<dim>&, const PerId<VertexId, State<dim>>&,               \
                                                const std::vector<WallStress<dim>>&);
LEONHARD_FORCES(2)
LEONHARD_FORCES(3)
#undef LEONHARD_FORCES

}  // namespace leonhard::solver
