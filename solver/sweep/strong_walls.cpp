// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/strong_walls.hpp"

#include <algorithm>
#include <cmath>

#include "leonhard/solver/axes.hpp"

namespace leonhard::solver {
namespace {

/// Kinetic and internal energy of a unit of mass at a wall's temperature.
template <int dim>
double energy_at(double gamma, const Axes<dim>& velocity, double temperature) {
  return temperature / (gamma * (gamma - 1)) + 0.5 * dot(velocity, velocity);
}

}  // namespace

template <int dim>
std::vector<StrongVertex<dim>> strong_vertices(const FlowProblem<dim>& problem) {
  std::map<VertexId, StrongVertex<dim>> found;
  std::map<VertexId, double> temperature;
  for (const DualFacet<dim>& facet : problem.dual.boundary) {
    const BoundaryCondition<dim>& given = problem.boundary.at(facet.marker);
    if (given.kind != BoundaryKind::no_slip_wall) continue;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      const BoundaryCondition<dim> condition = given.at(problem.dual.points[facet.corners[i]]);
      const Axes<dim> velocity = axes(condition.wall_velocity);
      const auto [entry, is_new] = found.try_emplace(facet.corners[i]);
      StrongVertex<dim>& strong = entry->second;
      const double area = norm(facet.shares[i]);
      if (is_new || dot(velocity, velocity) < dot(strong.velocity, strong.velocity)) strong.velocity = velocity;
      if (condition.temperature) temperature[facet.corners[i]] = *condition.temperature;
      strong.vertex = facet.corners[i];
      strong.area += area;
      strong.share_of[facet.marker] += area;
    }
  }
  std::vector<StrongVertex<dim>> vertices;
  for (auto& [v, strong] : found) {
    for (auto& [marker, share] : strong.share_of) share /= strong.area;
    if (const auto given = temperature.find(v); given != temperature.end())
      strong.energy = energy_at<dim>(problem.gas.gamma, strong.velocity, given->second);
    vertices.push_back(std::move(strong));
  }
  return vertices;
}

template <int dim>
StrongWalls<dim>::StrongWalls(const FlowProblem<dim>& problem, const EdgePlan<dim>& plan)
    : gamma_(problem.gas.gamma), vertices_(strong_vertices(problem)), of_part_(plan.parts.size()) {
  if (vertices_.empty()) return;
  std::vector<double> surface(plan.vertex_count, 0.0);
  for (const EdgeId e : problem.dual.edges.ends.ids())
    for (const VertexId v : problem.dual.edges.ends[e]) surface[v.index()] += norm(problem.dual.face[e]);
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    surface_.push_back(surface[vertices_[k].vertex.index()]);
    of_part_[plan.part_of[vertices_[k].vertex.index()]].push_back(k);
  }
}

template <int dim>
void StrongWalls<dim>::project(PerId<VertexId, State<dim>>& state) const {
  for (const StrongVertex<dim>& strong : vertices_) {
    const State<dim>& w = state[strong.vertex];
    double p = w.p;
    if (strong.energy)
      p = (gamma_ - 1) * w.rho * (*strong.energy - 0.5 * dot(strong.velocity, strong.velocity));
    state[strong.vertex] = state_with(w.rho, strong.velocity, p);
  }
}

template <int dim>
void StrongWalls<dim>::constrain(std::size_t part, const PerId<VertexId, State<dim>>& state, std::vector<double>& residual,
                                 std::vector<WallReaction<dim>>& reactions) const {
  constexpr std::size_t n = dim + 2;
  for (const std::size_t k : of_part_[part]) {
    const StrongVertex<dim>& strong = vertices_[k];
    double* r = residual.data() + n * strong.vertex.index();
    const Conserved<dim> q = conserved_of(Gas{gamma_}, state[strong.vertex]);
    double work = 0;
    for (std::size_t i = 0; i < dim; ++i) {
      reactions[k].friction[i] = -r[1 + i];
      work -= strong.velocity[i] * r[1 + i];
      r[1 + i] = strong.velocity[i] * r[0] + surface_[k] * (q[1 + i] - strong.velocity[i] * q[0]);
    }
    r[n - 1] += work;
    reactions[k].heat = 0;
    if (!strong.energy) continue;
    reactions[k].heat = -r[n - 1];
    r[n - 1] = *strong.energy * r[0] + surface_[k] * (q[n - 1] - *strong.energy * q[0]);
  }
}

template <int dim>
void StrongWalls<dim>::constrain_jacobian(std::size_t part, const EdgePlan<dim>& plan, std::span<double> blocks) const {
  constexpr std::size_t n = dim + 2;
  for (const std::size_t k : of_part_[part]) {
    const StrongVertex<dim>& strong = vertices_[k];
    const auto v = static_cast<std::uint32_t>(strong.vertex.index());
    const std::size_t first = plan.neighbours.offsets()[v] + v, last = plan.neighbours.offsets()[v + 1] + v + 1;
    for (double* column = blocks.data() + n * n * first; column != blocks.data() + n * n * last; column += n) {
      for (std::size_t i = 0; i < dim; ++i) {
        column[n - 1] -= strong.velocity[i] * column[1 + i];
        column[1 + i] = strong.velocity[i] * column[0];
      }
      if (strong.energy) column[n - 1] = *strong.energy * column[0];
    }
    double* diagonal = blocks.data() + n * n * std::size_t{plan.diagonal_block(v)};
    const auto hold = [&](std::size_t row, double by_density) {
      diagonal[n * row + row] += surface_[k];
      diagonal[row] -= surface_[k] * by_density;
    };
    for (std::size_t i = 0; i < dim; ++i) hold(1 + i, strong.velocity[i]);
    if (strong.energy) hold(n - 1, *strong.energy);
  }
}

template std::vector<StrongVertex<2>> strong_vertices(const FlowProblem<2>&);
template std::vector<StrongVertex<3>> strong_vertices(const FlowProblem<3>&);
template class StrongWalls<2>;
template class StrongWalls<3>;

}  // namespace leonhard::solver
