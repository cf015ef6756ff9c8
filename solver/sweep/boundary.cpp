// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/solver/flux/jacobian.hpp"

namespace leonhard::solver {
namespace {

Primitive<2, double> primitive(const State& w) { return {w.rho, {{w.u, w.v}}, w.p}; }
Vector<2, double> normal(const BoundaryEdge& edge) { return {{edge.nx, edge.ny}}; }
Conserved conserved_flux(const Components<2, double>& f) { return {f.e[0], f.e[1], f.e[2], f.e[3]}; }

}  // namespace

bool follows_lift(const EulerProblem& problem) {
  const bool far = std::any_of(problem.boundary.begin(), problem.boundary.end(),
                               [](const auto& entry) { return entry.second == BoundaryKind::far_field; });
  const bool wall = std::any_of(problem.boundary.begin(), problem.boundary.end(),
                                [](const auto& entry) { return entry.second == BoundaryKind::slip_wall; });
  return far && wall && problem.vortex_correction && !problem.outer_state && problem.free_stream.mach < 1;
}

Vec2 vortex_velocity(FreeStream free, Point2 centre, double length, Point2 at) {
  const Vec2 arm = at - centre;
  const double r2 = std::max(dot(arm, arm), 1e-300), r = std::sqrt(r2);
  const double sine = cross(Vec2{std::cos(free.alpha_rad), std::sin(free.alpha_rad)}, arm) / r;
  const double m2 = free.mach * free.mach;
  const double circulation = 0.5 * length * free.mach;
  const double speed = circulation * std::sqrt(1 - m2) / (2 * std::numbers::pi * r * (1 - m2 * sine * sine));
  return {speed * arm.y / r, -speed * arm.x / r};
}

State isentropic_state(Gas gas, FreeStream free, Vec2 extra) {
  const State far = free_stream_state(gas, free);
  const double u = far.u + extra.x, v = far.v + extra.y, g = gas.gamma - 1;
  const double c2 = std::max(1 + 0.5 * g * (free.mach * free.mach - u * u - v * v), 1e-3);
  const double rho = std::pow(c2, 1 / g);
  return {rho, u, v, rho * c2 / gas.gamma};
}

std::vector<BoundaryEdge> make_boundary(const EulerProblem& problem) {
  const bool vortex = follows_lift(problem);
  std::vector<BoundaryEdge> edges;
  edges.reserve(problem.dual.boundary.size());
  for (const DualFacet<2>& facet : problem.dual.boundary) {
    BoundaryEdge edge;
    edge.kind = problem.boundary.at(facet.marker);
    edge.end[0] = facet.corners[0], edge.end[1] = facet.corners[1];
    edge.own_share = facet.cell == CellKind::triangle ? 5.0 / 6.0 : 1.0;
    const Point2 at[2] = {problem.dual.points[edge.end[0]], problem.dual.points[edge.end[1]]};
    const Vec2 along = at[1] - at[0];
    const double length = norm(along);
    edge.nx = along.y / length, edge.ny = -along.x / length, edge.half_length = 0.5 * length;
    for (int i = 0; i < 2; ++i) {
      edge.outer[i] = problem.outer_state ? problem.outer_state(at[i])
                                          : free_stream_state(problem.gas, problem.free_stream);
      if (vortex && edge.kind == BoundaryKind::far_field)
        edge.vortex[i] =
            vortex_velocity(problem.free_stream, problem.vortex_centre, problem.reference.length, at[i]);
    }
    edges.push_back(edge);
  }
  return edges;
}

void set_far_field_lift(const EulerProblem& problem, double cl, std::span<BoundaryEdge> edges) {
  for (BoundaryEdge& edge : edges) {
    if (edge.kind != BoundaryKind::far_field) continue;
    for (int i = 0; i < 2; ++i)
      edge.outer[i] = isentropic_state(problem.gas, problem.free_stream, cl * edge.vortex[i]);
  }
}

Conserved boundary_flux(Gas gas, double entropy_fix, const BoundaryEdge& edge, int end, const State& w) {
  switch (edge.kind) {
    case BoundaryKind::slip_wall:
    case BoundaryKind::symmetry:
      return {0, w.p * edge.nx, w.p * edge.ny, 0};
    case BoundaryKind::far_field:
      return conserved_flux(
          flux_roe({gas.gamma, entropy_fix}, primitive(w), primitive(edge.outer[end]), normal(edge)));
    case BoundaryKind::supersonic_inflow:
    case BoundaryKind::supersonic_outflow:
      break;
  }
  const State& outside = edge.kind == BoundaryKind::supersonic_inflow ? edge.outer[end] : w;
  return conserved_flux(euler_flux(gas.gamma, primitive(outside), normal(edge)));
}

void add_boundary_jacobian(Gas gas, double entropy_fix, const BoundaryEdge& edge, int end, const State& w,
                           double factor, double* block) {
  Block<2, double> by_w{}, by_outer{};
  const Primitive<2, double> inside = primitive(w);
  switch (edge.kind) {
    case BoundaryKind::slip_wall:
    case BoundaryKind::symmetry: {
      const Components<2, double> by_p = pressure_gradient(gas.gamma, inside.velocity);
      for (int j = 0; j < 4; ++j) by_w.m[1][j] = by_p.e[j] * edge.nx, by_w.m[2][j] = by_p.e[j] * edge.ny;
      break;
    }
    case BoundaryKind::far_field:
      flux_roe_jacobians({gas.gamma, entropy_fix}, inside, primitive(edge.outer[end]), normal(edge), by_w,
                         by_outer);
      break;
    case BoundaryKind::supersonic_inflow:
      return;
    case BoundaryKind::supersonic_outflow:
      euler_jacobian(gas.gamma, inside, normal(edge)).add_to(by_w, 1.0);
      break;
  }
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) block[4 * j + i] += factor * by_w.m[i][j];
}

}  // namespace leonhard::solver
