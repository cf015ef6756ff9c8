// SPDX-License-Identifier: MIT
#include "leonhard/solver/residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/solver/axes.hpp"

namespace leonhard::solver {
namespace {

static_assert(sizeof(State<2>) == 4 * sizeof(double) && sizeof(State<3>) == 5 * sizeof(double));

template <int dim>
const double* numbers(const PerId<VertexId, State<dim>>& state) {
  return &state.flat().front().rho;
}

/// The greatest extent of the walls, or of the mesh where there are none: what a variation's length is measured by,
/// so that the answer does not depend on the unit of the coordinates.
template <int dim>
double extent_of(const FlowProblem<dim>& problem) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Axes<dim> low, high;
  low.fill(infinity), high.fill(-infinity);
  const auto include = [&](const auto& point) {
    const Axes<dim> p = axes(point);
    for (std::size_t i = 0; i < dim; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  };
  for (const DualFacet<dim>& facet : problem.dual.boundary)
    if (is_wall(problem.boundary.at(facet.marker).kind))
      for (const VertexId v : facet.corners) include(problem.dual.points[v]);
  if (low[0] > high[0])
    for (const auto& p : problem.dual.points) include(p);
  double extent = 0;
  for (std::size_t i = 0; i < dim; ++i) extent = std::max(extent, high[i] - low[i]);
  return extent;
}

template <int dim>
std::vector<double> limiter_scales(const FlowProblem<dim>& problem, const SpatialOptions& options,
                                   const std::vector<double>& volume) {
  const double extent = extent_of(problem);
  std::vector<double> scale(volume.size());
  for (std::size_t v = 0; v < volume.size(); ++v) {
    const double h = options.limiter_k * (dim == 2 ? std::sqrt(volume[v]) : std::cbrt(volume[v])) / extent;
    scale[v] = std::max(h * h * h * (options.limiter == LimiterKind::nishikawa_r3 ? h : 1), 1e-30);
  }
  return scale;
}

template <int dim>
std::vector<double> sources(const FlowProblem<dim>& problem) {
  std::vector<double> values;
  if (!problem.source) return values;
  for (const VertexId v : problem.dual.points.ids())
    for (const double s : problem.source(problem.dual.points[v])) values.push_back(s * problem.dual.volume[v]);
  return values;
}

template <int dim>
SweepSettings settings_of(const FlowProblem<dim>& problem, const SpatialOptions& options, const double* limiter_scale) {
  SweepSettings settings{.gamma = problem.gas.gamma,
                         .entropy_fix = options.entropy_fix,
                         .mach = problem.free_stream.mach,
                         .flux = options.flux,
                         .limiter = options.limiter,
                         .limiter_scale2 = limiter_scale,
                         .limiter_scale3 = limiter_scale};
  if (const auto& viscosity = problem.viscosity) {
    settings.viscosity = viscosity_at(*viscosity, problem.free_stream, problem.reference.length, 1.0);
    settings.sutherland = viscosity->sutherland;
    settings.inverse_prandtl = 1 / viscosity->prandtl;
  }
  return settings;
}

}  // namespace

template <int dim>
FlowResidual<dim>::FlowResidual(const FlowProblem<dim>& problem, const SpatialOptions& options,
                                const SweepKernels<dim>& kernels)
    : problem_(problem),
      options_(options),
      kernels_(kernels),
      plan_(make_edge_plan<dim>(problem.dual, options.part_of, options.parts, options.gradient)),
      run_(options.threads),
      boundary_(make_boundary(problem)),
      walls_(problem, plan_),
      reactions_(walls_.vertices().size()),
      follows_lift_(leonhard::solver::follows_lift(problem)),
      limiter_scale_(limiter_scales(problem, options, plan_.volume)),
      gradient_(options.order == 2 ? dim * n * plan_.vertex_count : 0),
      unlimited_(options.order == 2 && problem.viscosity ? gradient_.size() : 0),
      source_(sources(problem)),
      settings_(settings_of(problem, options, limiter_scale_.data())) {
  settings_.repeats_edges = plan_.repeats_edges;
}

template <int dim>
void FlowResidual<dim>::follow_lift(const States& state) {
  if (follows_lift_) set_far_field_lift<dim>(problem_, total(wall_forces(problem_, state)).cl, boundary_);
}

template <int dim>
void FlowResidual<dim>::evaluate(const States& state, std::vector<double>& residual) {
  if (options_.order == 1) return evaluate_first_order(state, residual);
  const SweepMesh<dim> mesh = plan_.view();
  double* unlimited = viscous() ? unlimited_.data() : nullptr;
  run_(plan_.parts.size(), [&](std::size_t part) {
    kernels_.limited_gradients(mesh, plan_.parts[part], settings_, numbers(state), gradient_.data(), unlimited);
  });
  evaluate_with(gradient_.data(), unlimited, state, residual);
}

template <int dim>
void FlowResidual<dim>::evaluate_first_order(const States& state, std::vector<double>& residual) {
  evaluate_with(nullptr, nullptr, state, residual);
}

template <int dim>
void FlowResidual<dim>::evaluate_with(const double* gradient, const double* unlimited, const States& state,
                                      std::vector<double>& residual) {
  follow_lift(state);
  residual.resize(n * plan_.padded_count());
  const SweepMesh<dim> mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    const PartRange& range = plan_.parts[part];
    for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k) {
      const std::size_t first = n * plan_.part_vertices[k];
      for (std::size_t i = first; i < first + n; ++i) residual[i] = source_.empty() ? 0 : -source_[i];
    }
    kernels_.fluxes(mesh, range, settings_, numbers(state), gradient, residual.data());
    if (viscous()) kernels_.viscous_fluxes(mesh, range, settings_, numbers(state), unlimited, residual.data());
    add_boundary_fluxes(part, unlimited, state, residual);
    walls_.constrain(part, state, residual, reactions_);
  });
}

template <int dim>
void FlowResidual<dim>::add_boundary_fluxes(std::size_t part, const double* unlimited, const States& state,
                                            std::vector<double>& residual) const {
  const PartRange& range = plan_.parts[part];
  for (std::uint32_t k = range.boundary_begin; k < range.boundary_end; ++k) {
    const BoundaryFacet<dim>& facet = boundary_[plan_.part_boundary[k]];
    const auto corners = facet.corners();
    std::array<Conserved<dim>, MixedFacet<dim>::most_corners> flux{};
    Conserved<dim> sum{};
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const VertexId v = corners[c].vertex;
      flux[c] = boundary_flux(constants(), facet.condition_at(c), corners[c], state[v]);
      if (viscous()) {
        const Conserved<dim> friction =
            viscous_boundary_flux(viscous_constants(), facet.condition.kind, corners[c], state[v],
                                  unlimited ? unlimited + dim * n * v.index() : nullptr);
        for (std::size_t i = 0; i < n; ++i) flux[c][i] += friction[i];
      }
      for (std::size_t i = 0; i < n; ++i) sum[i] += flux[c][i];
    }
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::size_t v = corners[c].vertex.index();
      if (plan_.part_of[v] != part) continue;
      for (std::size_t i = 0; i < n; ++i)
        residual[n * v + i] +=
            corners[c].size * (facet.own_share * flux[c][i] + facet.other_share() * (sum[i] - flux[c][i]));
    }
  }
}

template <int dim>
void FlowResidual<dim>::wave_speed_sums(const States& state, std::vector<double>& sums) {
  sums.resize(plan_.padded_count());
  const SweepMesh<dim> mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    const PartRange& range = plan_.parts[part];
    for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k) sums[plan_.part_vertices[k]] = 0;
    kernels_.wave_speeds(mesh, range, settings_, numbers(state), sums.data());
    for (std::uint32_t k = range.boundary_begin; k < range.boundary_end; ++k) {
      const BoundaryFacet<dim>& facet = boundary_[plan_.part_boundary[k]];
      for (const BoundaryCorner<dim>& corner : facet.corners()) {
        if (plan_.part_of[corner.vertex.index()] != part) continue;
        const State<dim>& w = state[corner.vertex];
        sums[corner.vertex.index()] +=
            corner.size * (std::abs(dot(velocity(w), corner.n)) + sound_speed(problem_.gas, w));
      }
    }
  });
}

template <int dim>
void FlowResidual<dim>::jacobian(const States& state, std::span<double> blocks) {
  follow_lift(state);
  const SweepMesh<dim> mesh = plan_.view();
  run_(plan_.parts.size(), [&](std::size_t part) {
    const PartRange& range = plan_.parts[part];
    for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k) {
      const std::uint32_t v = plan_.part_vertices[k];
      if (!plan_.repeats_edges) {
        std::fill_n(blocks.data() + n * n * plan_.diagonal_block(v), n * n, 0.0);
        continue;
      }
      const std::size_t first = plan_.neighbours.offsets()[v] + v, count = plan_.neighbours[v].size() + 1;
      std::fill_n(blocks.data() + n * n * first, n * n * count, 0.0);
    }
    kernels_.jacobian(mesh, range, settings_, numbers(state), blocks.data());
    add_boundary_jacobians(part, state, blocks);
    walls_.constrain_jacobian(part, plan_, blocks);
  });
}

template <int dim>
void FlowResidual<dim>::add_boundary_jacobians(std::size_t part, const States& state, std::span<double> blocks) const {
  const PartRange& range = plan_.parts[part];
  for (std::uint32_t k = range.boundary_begin; k < range.boundary_end; ++k) {
    const BoundaryFacet<dim>& facet = boundary_[plan_.part_boundary[k]];
    const auto corners = facet.corners();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const auto v = static_cast<std::uint32_t>(corners[c].vertex.index());
      if (plan_.part_of[v] != part) continue;
      for (std::size_t of = 0; of < corners.size(); ++of) {
        const double share = of == c ? facet.own_share : facet.other_share();
        if (share == 0) continue;
        const auto w = static_cast<std::uint32_t>(corners[of].vertex.index());
        add_boundary_jacobian(constants(), viscous_constants(), facet.condition_at(of), corners[of], state[corners[of].vertex],
                              share * corners[c].size, blocks.data() + n * n * plan_.block_of(v, w));
      }
    }
  }
}

template <int dim>
void FlowResidual<dim>::smooth(double strength, std::vector<double>& step) {
  constexpr int sweeps = 2;
  unsmoothed_ = step;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    smoothed_ = step;
    run_(plan_.parts.size(), [&](std::size_t part) {
      const PartRange& range = plan_.parts[part];
      for (std::uint32_t k = range.vertex_begin; k < range.vertex_end; ++k) {
        const std::uint32_t v = plan_.part_vertices[k];
        const auto neighbours = plan_.neighbours[v];
        const double share = 1 / (1 + strength * static_cast<double>(neighbours.size()));
        for (std::size_t i = 0; i < n; ++i) {
          double sum = 0;
          for (const std::uint32_t w : neighbours) sum += step[n * w + i];
          smoothed_[n * v + i] = share * (unsmoothed_[n * v + i] + strength * sum);
        }
      }
    });
    for (const StrongVertex<dim>& strong : walls_.vertices())
      std::copy_n(unsmoothed_.begin() + static_cast<std::ptrdiff_t>(n * strong.vertex.index()), n,
                  smoothed_.begin() + static_cast<std::ptrdiff_t>(n * strong.vertex.index()));
    step.swap(smoothed_);
  }
}

template <int dim>
std::map<Marker, double> FlowResidual<dim>::mass_flow(const States& state) const {
  std::map<Marker, double> flow;
  for (std::size_t k = 0; k < boundary_.size(); ++k) {
    const BoundaryFacet<dim>& facet = boundary_[k];
    const auto corners = facet.corners();
    std::array<double, MixedFacet<dim>::most_corners> flux{};
    double sum = 0;
    for (std::size_t c = 0; c < corners.size(); ++c)
      sum += flux[c] = boundary_flux(constants(), facet.condition_at(c), corners[c], state[corners[c].vertex])[0];
    double& out = flow[problem_.dual.boundary[k].marker];
    for (std::size_t c = 0; c < corners.size(); ++c)
      out += corners[c].size * (facet.own_share * flux[c] + facet.other_share() * (sum - flux[c]));
  }
  return flow;
}

template class FlowResidual<2>;
template class FlowResidual<3>;

double residual_norm(const std::vector<double>& residual, std::size_t vertex_count, std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i < n * vertex_count; ++i) sum += residual[i] * residual[i];
  return std::sqrt(sum / static_cast<double>(vertex_count));
}

}  // namespace leonhard::solver
