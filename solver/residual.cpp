// SPDX-License-Identifier: MIT
#include "leonhard/solver/residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/solver/forces.hpp"

namespace leonhard::solver {
namespace {

static_assert(sizeof(State) == 4 * sizeof(double));
const double* numbers(const PerId<VertexId, State>& state) { return &state.flat().front().rho; }

/// The larger extent of the slip walls, or of the mesh where there are none: what a variation's length is measured by,
/// so that the answer does not depend on the unit of the coordinates.
double extent_of(const EulerProblem& problem) {
  double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double high[2] = {-low[0], -low[1]};
  const auto include = [&](Point2 p) {
    low[0] = std::min(low[0], p.x), high[0] = std::max(high[0], p.x);
    low[1] = std::min(low[1], p.y), high[1] = std::max(high[1], p.y);
  };
  for (const DualFacet<2>& edge : problem.dual.boundary)
    if (problem.boundary.at(edge.marker) == BoundaryKind::slip_wall)
      for (const VertexId v : edge.corners) include(problem.dual.points[v]);
  if (low[0] > high[0])
    for (const Point2& p : problem.dual.points) include(p);
  return std::max(high[0] - low[0], high[1] - low[1]);
}

std::vector<double> limiter_scales(const EulerProblem& problem, double k, const std::vector<double>& area) {
  const double extent = extent_of(problem);
  std::vector<double> scale2(area.size());
  for (std::size_t v = 0; v < area.size(); ++v) {
    const double h = k * std::sqrt(area[v]) / extent;
    scale2[v] = std::max(h * h * h, 1e-30);
  }
  return scale2;
}

}  // namespace

EulerResidual::EulerResidual(const EulerProblem& problem, const SpatialOptions& options,
                             const SweepKernels& kernels)
    : problem_(problem),
      options_(options),
      kernels_(kernels),
      plan_(make_edge_plan(problem.dual, options.part_of, options.parts)),
      run_(options.threads),
      boundary_(make_boundary(problem)),
      follows_lift_(leonhard::solver::follows_lift(problem)),
      limiter_scale2_(limiter_scales(problem, options.venkatakrishnan_k, plan_.area)),
      gradient_(options.order == 2 ? 8 * plan_.vertex_count : 0),
      settings_{problem.gas.gamma, options.entropy_fix, problem.free_stream.mach,
                options.flux,      options.limiter,     limiter_scale2_.data()} {}

void EulerResidual::follow_lift(const PerId<VertexId, State>& state) {
  if (follows_lift_) set_far_field_lift(problem_, total(wall_forces(problem_, state)).cl, boundary_);
}

void EulerResidual::evaluate(const PerId<VertexId, State>& state, std::vector<double>& residual) {
  if (options_.order == 1) return evaluate_first_order(state, residual);
  const SweepMesh mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    kernels_.limited_gradients(mesh, plan_.parts[part], settings_, numbers(state), gradient_.data());
  });
  evaluate_with(gradient_.data(), state, residual);
}

void EulerResidual::evaluate_first_order(const PerId<VertexId, State>& state, std::vector<double>& residual) {
  evaluate_with(nullptr, state, residual);
}

void EulerResidual::evaluate_with(const double* gradient, const PerId<VertexId, State>& state,
                                  std::vector<double>& residual) {
  follow_lift(state);
  residual.resize(4 * plan_.padded_count());
  const SweepMesh mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    const PartRange& range = plan_.parts[part];
    for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k)
      std::fill_n(residual.begin() + 4 * std::size_t{plan_.part_vertices[k]}, 4, 0.0);
    kernels_.fluxes(mesh, range, settings_, numbers(state), gradient, residual.data());
    add_boundary_fluxes(part, state, residual);
  });
}

void EulerResidual::add_boundary_fluxes(std::size_t part, const PerId<VertexId, State>& state,
                                        std::vector<double>& residual) const {
  const PartRange& range = plan_.parts[part];
  for (std::uint32_t k = range.boundary_begin; k < range.boundary_end; ++k) {
    const BoundaryEdge& edge = boundary_[plan_.part_boundary[k]];
    Conserved flux[2];
    for (int end = 0; end < 2; ++end)
      flux[end] = boundary_flux(problem_.gas, options_.entropy_fix, edge, end, state[edge.end[end]]);
    for (int end = 0; end < 2; ++end) {
      const std::size_t v = edge.end[end].index();
      if (plan_.part_of[v] != part) continue;
      for (std::size_t i = 0; i < 4; ++i)
        residual[4 * v + i] += edge.half_length * (edge.own_share * flux[end][i] + (1 - edge.own_share) * flux[1 - end][i]);
    }
  }
}

void EulerResidual::wave_speed_sums(const PerId<VertexId, State>& state, std::vector<double>& sums) {
  sums.resize(plan_.padded_count());
  const SweepMesh mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    const PartRange& range = plan_.parts[part];
    for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k) sums[plan_.part_vertices[k]] = 0;
    kernels_.wave_speeds(mesh, range, settings_, numbers(state), sums.data());
    for (std::uint32_t k = range.boundary_begin; k < range.boundary_end; ++k) {
      const BoundaryEdge& edge = boundary_[plan_.part_boundary[k]];
      for (const VertexId v : edge.end) {
        if (plan_.part_of[v.index()] != part) continue;
        const State& w = state[v];
        sums[v.index()] +=
            edge.half_length * (std::abs(w.u * edge.nx + w.v * edge.ny) + sound_speed(problem_.gas, w));
      }
    }
  });
}

void EulerResidual::jacobian(const PerId<VertexId, State>& state, std::vector<double>& blocks) {
  follow_lift(state);
  blocks.resize(16 * (plan_.block_count() + plan_.parts.size()));
  const SweepMesh mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    const PartRange& range = plan_.parts[part];
    for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k)
      std::fill_n(blocks.begin() + 16 * std::size_t{plan_.diagonal_block(plan_.part_vertices[k])}, 16, 0.0);
    kernels_.jacobian(mesh, range, settings_, numbers(state), blocks.data());
    for (std::uint32_t k = range.boundary_begin; k < range.boundary_end; ++k) {
      const BoundaryEdge& edge = boundary_[plan_.part_boundary[k]];
      for (int end = 0; end < 2; ++end) {
        const auto v = static_cast<std::uint32_t>(edge.end[end].index());
        if (plan_.part_of[v] != part) continue;
        const auto other = static_cast<std::uint32_t>(edge.end[1 - end].index());
        const auto add = [&](int at, double share, std::uint32_t block) {
          add_boundary_jacobian(problem_.gas, options_.entropy_fix, edge, at, state[edge.end[at]],
                                share * edge.half_length, blocks.data() + 16 * std::size_t{block});
        };
        add(end, edge.own_share, plan_.diagonal_block(v));
        add(1 - end, 1 - edge.own_share, plan_.neighbour_block(v, plan_.slot_to(v, other)));
      }
    }
  });
}

double residual_norm(const std::vector<double>& residual, std::size_t vertex_count) {
  double sum = 0;
  for (std::size_t i = 0; i < 4 * vertex_count; ++i) sum += residual[i] * residual[i];
  return std::sqrt(sum / static_cast<double>(vertex_count));
}

}  // namespace leonhard::solver
