// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/solver/axes.hpp"
#include "leonhard/solver/flux/roe.hpp"
#include "leonhard/solver/flux/viscous.hpp"
#include "leonhard/solver/support/dual_number.hpp"

namespace leonhard::solver {
namespace {

constexpr double jump_weight = 4;  ///< of the jump to the outside in the gradient; below 1 the gradient inside could outweigh it

template <int dim, class T>
Vector<dim, T> vector_of_axes(const Axes<dim>& a) {
  Vector<dim, T> v;
  for (std::size_t i = 0; i < dim; ++i) v.e[i] = T(a[i]);
  return v;
}

template <int dim, class T>
Primitive<dim, T> primitive(const State<dim>& w) {
  return {T(w.rho), vector_of_axes<dim, T>(velocity(w)), T(w.p)};
}

template <int dim, class T>
Components<dim, T> pressure_alone(const Primitive<dim, T>& w, const Vector<dim, T>& n) {
  Components<dim, T> f;
  f.e[0] = f.e[dim + 1] = T(0.0);
  for (int i = 0; i < dim; ++i) f.e[1 + i] = w.p * n.e[i];
  return f;
}

/// Where total pressure, total temperature and direction are given, the outgoing wave tells the rest: with the velocity V along
/// the direction, cosine the inward part of the direction, the outside solves
///   2 c / (gamma - 1) - cosine V = J, the inside's,   c^2 + (gamma - 1) / 2 V^2 = c0^2
/// (J.-R. Carlson, NASA TM 2011-217181, section 2.7): a quadratic for c.
template <int dim, class T>
Primitive<dim, T> inflow_state(const BoundaryConstants& k, const BoundaryCondition<dim>& condition, const Primitive<dim, T>& w,
                               const Axes<dim>& normal) {
  const double gamma = k.gas.gamma, g = gamma - 1, head = 1 + 0.5 * g * k.free_stream.mach * k.free_stream.mach;
  const double c02 = head * condition.total_temperature;
  const double p0 = std::pow(head, gamma / g) / gamma * condition.total_pressure;
  Axes<dim> along = normal;
  for (double& component : along) component = -component;
  if (condition.direction) along = axes((1 / norm(*condition.direction)) * *condition.direction);
  const double cosine = -dot(along, normal), q = cosine * cosine;
  const T wave = 2.0 / g * sound_speed(gamma, w) + dot(w.velocity, vector_of_axes<dim, T>(normal));
  const double a = 2 * q / g + 4 / (g * g);
  const T b = (-4.0 / g) * wave, c = wave * wave - 2.0 * q * c02 / g;
  const T speed_of_sound = (root(larger<T>(b * b - 4.0 * a * c, T(1e-300))) - b) / (2.0 * a);
  const T c2 = speed_of_sound * speed_of_sound, speed = (2.0 / g * speed_of_sound - wave) / cosine;
  Primitive<dim, T> outside;
  outside.p = p0 * power(T(c2 / c02), gamma / g);
  outside.rho = gamma * outside.p / c2;
  for (int i = 0; i < dim; ++i) outside.velocity.e[i] = along[static_cast<std::size_t>(i)] * speed;
  return outside;
}

/// The pressure is given, entropy, tangential velocity and the outgoing wave come from inside; all of it where the flow leaves
/// faster than sound.
template <int dim, class T>
Primitive<dim, T> outflow_state(const BoundaryConstants& k, double pressure, const Primitive<dim, T>& w,
                                const Vector<dim, T>& n) {
  const double gamma = k.gas.gamma;
  const T c = sound_speed(gamma, w), vn = dot(w.velocity, n);
  if (vn > c) return w;
  Primitive<dim, T> outside;
  outside.p = T(pressure / gamma);
  outside.rho = w.rho * power(T(outside.p / w.p), 1 / gamma);
  const T change = 2.0 / (gamma - 1) * (c - sound_speed(gamma, outside));
  for (int i = 0; i < dim; ++i) outside.velocity.e[i] = w.velocity.e[i] + change * n.e[i];
  return outside;
}

/// The flux, for any number type.
template <int dim, class T>
Components<dim, T> flux_out(const BoundaryConstants& k, const BoundaryCondition<dim>& condition, const BoundaryCorner<dim>& corner,
                            const Primitive<dim, T>& w) {
  const Vector<dim, T> n = vector_of_axes<dim, T>(corner.n);
  switch (condition.kind) {
    case BoundaryKind::slip_wall:
    case BoundaryKind::no_slip_wall:
    case BoundaryKind::symmetry:
    case BoundaryKind::periodic:  // never comes here: joined sides are no boundary
      break;
    case BoundaryKind::far_field:
      return flux_roe({k.gas.gamma, k.entropy_fix, k.free_stream.mach}, w, primitive<dim, T>(corner.outer), n);
    case BoundaryKind::supersonic_inflow:
      return euler_flux(k.gas.gamma, primitive<dim, T>(corner.outer), n);
    case BoundaryKind::supersonic_outflow:
      return euler_flux(k.gas.gamma, w, n);
    case BoundaryKind::subsonic_inflow:
      return euler_flux(k.gas.gamma, inflow_state<dim, T>(k, condition, w, corner.n), n);
    case BoundaryKind::pressure_outflow:
      return euler_flux(k.gas.gamma, outflow_state(k, condition.pressure, w, n), n);
  }
  return pressure_alone(w, n);
}

/// The viscous flux, for any number type.
template <int dim, class T>
Components<dim, T> viscous_flux_out(const ViscousConstants& k, BoundaryKind kind, const BoundaryCorner<dim>& corner,
                                    const Primitive<dim, T>& w, ViscousGradient<dim, T> gradient) {
  const Vector<dim, T> n = vector_of_axes<dim, T>(corner.n);
  if (kind == BoundaryKind::far_field || kind == BoundaryKind::supersonic_inflow) {
    const Primitive<dim, T> outer = primitive<dim, T>(corner.outer);
    const T share = T(jump_weight / corner.height);
    const Vector<dim, T> none = vector_of_axes<dim, T>({});
    correct_along_normal(difference(outer.velocity, w.velocity), T(temperature(k.gamma, outer) - temperature(k.gamma, w)), none,
                         n, share, gradient);
  }
  Components<dim, T> f = viscous_flux(k, w, gradient, n);
  if (kind != BoundaryKind::slip_wall && kind != BoundaryKind::symmetry && kind != BoundaryKind::no_slip_wall) return f;
  T along = T(0.0);
  for (int i = 0; i < dim; ++i) along += f.e[1 + i] * n.e[i];
  if (kind == BoundaryKind::no_slip_wall) along = T(0.0);
  for (int i = 0; i < dim; ++i) f.e[1 + i] = along * n.e[i];
  f.e[dim + 1] = T(0.0);
  return f;
}

template <int dim>
BoundaryFacet<dim> make_facet(const FlowProblem<dim>& problem, const DualFacet<dim>& from, bool vortex) {
  BoundaryFacet<dim> facet;
  const BoundaryCondition<dim>& given = problem.boundary.at(from.marker);
  facet.condition = given;
  facet.condition.vary = nullptr;
  facet.corner_count = static_cast<int>(from.corners.size());
  facet.own_share = corner_share(from);
  for (std::size_t i = 0; i < from.corners.size(); ++i) {
    BoundaryCorner<dim>& corner = facet.corner[i];
    corner.vertex = from.corners[i];
    corner.size = norm(from.shares[i]);
    corner.n = axes((1 / corner.size) * from.shares[i]);
    const auto at = problem.dual.points[corner.vertex];
    if (given.vary) facet.varied.push_back(given.at(at));
    const std::optional<State<dim>>& beyond = facet.condition_at(i).outer;
    corner.outer = beyond                ? *beyond
                   : problem.outer_state ? problem.outer_state(at)
                                         : free_stream_state<dim>(problem.gas, problem.free_stream);
    if constexpr (dim == 2)
      if (vortex && !beyond && facet.condition.kind == BoundaryKind::far_field)
        corner.vortex = axes(vortex_velocity(problem.free_stream, problem.vortex_centre, problem.reference.length, at));
  }
  return facet;
}

}  // namespace

template <int dim>
bool follows_lift(const FlowProblem<dim>& problem) {
  if (dim == 3) return false;
  const auto any = [&](const auto& condition) {
    return std::ranges::any_of(problem.boundary, [&](const auto& entry) { return condition(entry.second.kind); });
  };
  return any([](BoundaryKind kind) { return kind == BoundaryKind::far_field; }) && any(is_wall) && problem.vortex_correction &&
         !problem.outer_state && problem.free_stream.mach < 1;
}

Vec2 vortex_velocity(FreeStream free, Point2 centre, double length, Point2 at) {
  const Vec2 arm = at - centre;
  const double r2 = std::max(dot(arm, arm), 1e-300), r = std::sqrt(r2);
  const double sine = cross(vector_of(direction<2>(free)), arm) / r;
  const double m2 = free.mach * free.mach;
  const double circulation = 0.5 * length * free.mach;
  const double speed = circulation * std::sqrt(1 - m2) / (2 * std::numbers::pi * r * (1 - m2 * sine * sine));
  return {speed * arm.y / r, -speed * arm.x / r};
}

State<2> isentropic_state(Gas gas, FreeStream free, Vec2 extra) {
  const State<2> far = free_stream_state<2>(gas, free);
  const double u = far.u + extra.x, v = far.v + extra.y, g = gas.gamma - 1;
  const double c2 = std::max(1 + 0.5 * g * (free.mach * free.mach - u * u - v * v), 1e-3);
  const double rho = std::pow(c2, 1 / g);
  return {rho, u, v, rho * c2 / gas.gamma};
}

template <int dim>
std::vector<BoundaryFacet<dim>> make_boundary(const FlowProblem<dim>& problem) {
  const bool vortex = follows_lift(problem);
  std::vector<BoundaryFacet<dim>> facets;
  facets.reserve(problem.dual.boundary.size());
  for (const DualFacet<dim>& facet : problem.dual.boundary) facets.push_back(make_facet(problem, facet, vortex));
  PerId<VertexId, double> size(problem.dual.vertex_count(), 0.0);
  for (const BoundaryFacet<dim>& facet : facets)
    for (const BoundaryCorner<dim>& corner : facet.corners()) size[corner.vertex] += corner.size;
  for (BoundaryFacet<dim>& facet : facets)
    for (int c = 0; c < facet.corner_count; ++c) {
      BoundaryCorner<dim>& corner = facet.corner[static_cast<std::size_t>(c)];
      corner.height = problem.dual.volume[corner.vertex] / size[corner.vertex];
    }
  return facets;
}

template <int dim>
void set_far_field_lift(const FlowProblem<dim>& problem, double cl, std::span<BoundaryFacet<dim>> facets) {
  if constexpr (dim == 2)
    for (BoundaryFacet<2>& facet : facets)
      if (facet.condition.kind == BoundaryKind::far_field)
        for (std::size_t c = 0; c < facet.corners().size(); ++c)
          if (BoundaryCorner<2>& corner = facet.corner[c]; !facet.condition_at(c).outer)
            corner.outer = isentropic_state(problem.gas, problem.free_stream, cl * vector_of(corner.vortex));
}

template <int dim>
Conserved<dim> boundary_flux(const BoundaryConstants& constants, const BoundaryCondition<dim>& condition,
                             const BoundaryCorner<dim>& corner, const State<dim>& w) {
  const Components<dim, double> f = flux_out(constants, condition, corner, primitive<dim, double>(w));
  Conserved<dim> out;
  std::copy_n(f.e, dim + 2, out.begin());
  return out;
}

template <int dim>
Conserved<dim> viscous_boundary_flux(const ViscousConstants& constants, BoundaryKind kind, const BoundaryCorner<dim>& corner,
                                     const State<dim>& w, const double* gradient) {
  const Primitive<dim, double> inside = primitive<dim, double>(w);
  ViscousGradient<dim, double> g{};
  for (int j = 0; gradient && j < dim; ++j) {
    const double* by = gradient + j * (dim + 2);
    for (int i = 0; i < dim; ++i) g.velocity[i].e[j] = by[1 + i];
    g.temperature.e[j] = constants.gamma * (by[dim + 1] - w.p / w.rho * by[0]) / w.rho;
  }
  const Components<dim, double> f = viscous_flux_out(constants, kind, corner, inside, g);
  Conserved<dim> out;
  std::copy_n(f.e, dim + 2, out.begin());
  return out;
}

template <int dim>
void add_boundary_jacobian(const BoundaryConstants& constants, const ViscousConstants& viscous,
                           const BoundaryCondition<dim>& condition, const BoundaryCorner<dim>& corner, const State<dim>& w,
                           double factor, double* block) {
  constexpr int n = dim + 2;
  using Number = DualNumber<n>;
  const Conserved<dim> q = conserved_of(constants.gas, w);
  const Number rho = Number::variable(q[0], 0);
  Primitive<dim, Number> inside;
  inside.rho = rho;
  for (int i = 0; i < dim; ++i)
    inside.velocity.e[i] = Number::variable(q[static_cast<std::size_t>(1 + i)], 1 + i) / rho;
  inside.p = (constants.gas.gamma - 1) *
             (Number::variable(q[dim + 1], dim + 1) - 0.5 * rho * dot(inside.velocity, inside.velocity));
  Components<dim, Number> f = flux_out(constants, condition, corner, inside);
  if (viscous.viscosity > 0) {
    const Components<dim, Number> friction =
        viscous_flux_out(viscous, condition.kind, corner, inside, ViscousGradient<dim, Number>{});
    for (int i = 0; i < n; ++i) f.e[i] += friction.e[i];
  }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) block[n * j + i] += factor * f.e[i].by[j];
}

#define LEONHARD_BOUNDARY(dim)                                                                                       \
  template bool follows_lift(const FlowProblem<dim>&);                                                               \
  template std::vector<BoundaryFacet<dim>> make_boundary(const FlowProblem<dim>&);                                   \
  template void set_far_field_lift(const FlowProblem<dim>&, double, std::span<BoundaryFacet<dim>>);                  \
  template Conserved<dim> boundary_flux(const BoundaryConstants&, const BoundaryCondition<dim>&,                     \
                                        const BoundaryCorner<dim>&, const State<dim>&);                              \
  template Conserved<dim> viscous_boundary_flux(const ViscousConstants&, BoundaryKind, const BoundaryCorner<dim>&,    \
                                                const State<dim>&, const double*);                                   \
  template void add_boundary_jacobian(const BoundaryConstants&, const ViscousConstants&,                             \
                                      const BoundaryCondition<dim>&, const BoundaryCorner<dim>&, const State<dim>&, double,   \
                                      double*);
LEONHARD_BOUNDARY(2)
LEONHARD_BOUNDARY(3)
#undef LEONHARD_BOUNDARY

}  // namespace leonhard::solver
