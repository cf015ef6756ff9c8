// SPDX-License-Identifier: MIT
// The loops declared in sweep.hpp. Included once by each sweep_*.cpp, which sets LEONHARD_SWEEP_BUILD and the
// instruction set. Everything has internal linkage.

#include "leonhard/solver/flux/flux.hpp"
#include "leonhard/solver/flux/jacobian.hpp"
#include "leonhard/solver/flux/viscous.hpp"
#include "leonhard/solver/sweep/limiter.hpp"
#include "leonhard/solver/sweep/row.hpp"
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {
namespace {

/// Where a vertex's numbers begin in an array of `width` a vertex.
[[gnu::always_inline]] inline std::size_t at(std::uint32_t v, int width) { return std::size_t{v} * static_cast<unsigned>(width); }

/// Room and steps of the variables about one vertex.
template <int dim>
struct Stencil {
  Row<dim + 2> gradient[dim];
  Row<dim + 2> room_up, room_down;  ///< greatest and least neighbour less own value: >= 0 and <= 0
  Row<dim + 2> step_up, step_down;  ///< greatest and least change from the vertex to an edge's midpoint: >= 0 and <= 0
};

template <int dim>
[[gnu::always_inline]] inline Stencil<dim> look_around(const SweepMesh<dim>& mesh, std::uint32_t v,
                                                       const double* state) {
  using Variables = Row<dim + 2>;
  const Variables zero = Variables::same(0), own = Variables::load(state + at(v, dim + 2));
  Stencil<dim> s;
  for (int j = 0; j < dim; ++j) s.gradient[j] = zero;
  s.room_up = s.room_down = s.step_up = s.step_down = zero;
  const std::uint32_t first = mesh.offset[v], last = mesh.offset[v + 1];
  for (std::uint32_t i = first; i < last; ++i) {
    const Variables difference = Variables::load(state + at(mesh.neighbour[i], dim + 2)) - own;
    for (int j = 0; j < dim; ++j) s.gradient[j] = s.gradient[j] + mesh.slot[i].weight[j] * difference;
    s.room_up = larger(s.room_up, difference);
    s.room_down = smaller(s.room_down, difference);
  }
  for (std::uint32_t i = first; i < last; ++i) {
    Variables step = mesh.slot[i].half[0] * s.gradient[0];
    for (int j = 1; j < dim; ++j) step = step + mesh.slot[i].half[j] * s.gradient[j];
    s.step_up = larger(s.step_up, step);
    s.step_down = smaller(s.step_down, step);
  }
  return s;
}

/// What counts as a large variation of each variable about a state: the squares of density, speed of sound (of a velocity) and
/// gamma times pressure, all 1 in the free stream.
[[gnu::always_inline]] inline Row<4> squared_size(const Row<4>& own, double gamma) {
  const double stiffness = gamma * own[3], c2 = stiffness / own[0];
  return {Lanes{own[0] * own[0], c2, c2, stiffness * stiffness}, {}};
}
[[gnu::always_inline]] inline Row<5> squared_size(const Row<5>& own, double gamma) {
  const double stiffness = gamma * own[4], c2 = stiffness / own[0];
  return {Lanes{own[0] * own[0], c2, c2, c2}, {stiffness * stiffness}};
}

/// How much of a step down that takes this part of a value a vertex may take: all up to one half, and never more than to four
/// fifths. Its slope is continuous, so that near vacuum Newton's method finds no kink.
template <class T>
[[gnu::always_inline]] inline T share_kept(const T& part) {
  const T beyond = larger<T>(part - 0.5, constant<T>(0));
  return select(part > constant<T>(0.5), T((0.5 + 0.3 * beyond / (0.3 + beyond)) / part), constant<T>(1));
}

/// That of density and pressure; 1 of the velocity.
[[gnu::always_inline]] inline Row<4> keep_positive(const Row<4>& step_down, const Row<4>& own) {
  return {share_kept<Lanes>(Lanes{-step_down[0] / own[0], 0, 0, -step_down[3] / own[3]}), {}};
}
[[gnu::always_inline]] inline Row<5> keep_positive(const Row<5>& step_down, const Row<5>& own) {
  return {Lanes{share_kept<double>(-step_down[0] / own[0]), 1, 1, 1}, {share_kept<double>(-step_down[4] / own[4])}};
}

template <int n>
[[gnu::always_inline]] inline Row<n> venkatakrishnan(const Row<n>& room, const Row<n>& step, const Row<n>& scale2) {
  Row<n> r;
  r.head = limit_venkatakrishnan<Lanes>(room.head, step.head, scale2.head);
  for (int i = 0; i < Row<n>::rest; ++i)
    r.tail[i] = limit_venkatakrishnan<double>(room.tail[i], step.tail[i], scale2.tail[i]);
  return r;
}
template <int n>
[[gnu::always_inline]] inline Row<n> nishikawa_r3(const Row<n>& room, const Row<n>& step, const Row<n>& scale3) {
  Row<n> r;
  r.head = limit_nishikawa_r3<Lanes>(room.head, step.head, scale3.head);
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = limit_nishikawa_r3<double>(room.tail[i], step.tail[i], scale3.tail[i]);
  return r;
}
template <int n>
[[gnu::always_inline]] inline Row<n> barth_jespersen(const Row<n>& room, const Row<n>& step) {
  Row<n> r;
  r.head = limit_barth_jespersen<Lanes>(room.head, step.head);
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = limit_barth_jespersen<double>(room.tail[i], step.tail[i]);
  return r;
}

template <int dim>
void limited_gradients(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
                       const double* state, double* gradient, double* unlimited) {
  using Variables = Row<dim + 2>;
  for (std::uint32_t k = part.vertex_begin; k < part.vertex_end; ++k) {
    const std::uint32_t v = mesh.part_vertices[k];
    const Stencil<dim> s = look_around<dim>(mesh, v, state);
    const Variables own = Variables::load(state + at(v, dim + 2));
    Variables share = Variables::same(1);
    if (settings.limiter == LimiterKind::venkatakrishnan) {
      const Variables scale2 = settings.limiter_scale2[v] * squared_size(own, settings.gamma);
      share = smaller(venkatakrishnan(s.room_up, s.step_up, scale2), venkatakrishnan(s.room_down, s.step_down, scale2));
    } else if (settings.limiter == LimiterKind::barth_jespersen) {
      share = smaller(barth_jespersen(s.room_up, s.step_up), barth_jespersen(s.room_down, s.step_down));
    } else if (settings.limiter == LimiterKind::nishikawa_r3) {
      const Variables size = root(squared_size(own, settings.gamma));
      const Variables scale3 = settings.limiter_scale3[v] * (size * size * size);
      share = smaller(nishikawa_r3(s.room_up, s.step_up, scale3), nishikawa_r3(s.room_down, s.step_down, scale3));
    }
    share = share * keep_positive(share * s.step_down, own);
    for (int j = 0; j < dim; ++j) {
      const std::size_t to = at(v, dim * (dim + 2)) + static_cast<unsigned>(j * (dim + 2));
      (share * s.gradient[j]).store(gradient + to);
      if (unlimited) s.gradient[j].store(unlimited + to);
    }
  }
}

template <int dim>
[[gnu::always_inline]] inline Primitive<dim, Lanes> primitive_of(const Lanes (&w)[dim + 2]) {
  Primitive<dim, Lanes> p;
  p.rho = w[0];
  for (int j = 0; j < dim; ++j) p.velocity.e[j] = w[1 + j];
  p.p = w[dim + 1];
  return p;
}

/// Numbers of four vertices, one vertex a lane: `width` a vertex, n of them from `first`.
template <int n>
[[gnu::always_inline]] inline void gather_rows(const double* numbers, int width, int first, const std::uint32_t (&v)[4],
                                               Lanes (&out)[n]) {
  Row<n> r[4];
  for (int i = 0; i < 4; ++i) r[i] = Row<n>::load(numbers + at(v[i], width) + first);
  rows_to_lanes(r, out);
}

/// The states of four vertices, one vertex a lane.
template <int dim>
[[gnu::always_inline]] inline Primitive<dim, Lanes> gather(const double* state, const std::uint32_t (&v)[4]) {
  Lanes w[dim + 2];
  gather_rows<dim + 2>(state, dim + 2, 0, v, w);
  return primitive_of<dim>(w);
}

/// Likewise after `sign` times half an edge along the gradient, which leaves density and pressure positive.
template <int dim>
[[gnu::always_inline]] inline Primitive<dim, Lanes> gather_linear(const double* state, const double* gradient,
                                                                  const EdgeMetric<dim>& m, double sign,
                                                                  const std::uint32_t (&v)[4]) {
  constexpr int n = dim + 2;
  Row<n> r[4];
  for (int i = 0; i < 4; ++i) {
    const double* g = gradient + at(v[i], dim * n);
    Row<n> step = (sign * m.half[0][i]) * Row<n>::load(g);
    for (int j = 1; j < dim; ++j) step = step + (sign * m.half[j][i]) * Row<n>::load(g + j * n);
    r[i] = Row<n>::load(state + at(v[i], n)) + step;
  }
  Lanes w[n];
  rows_to_lanes(r, w);
  return primitive_of<dim>(w);
}

struct Batch {
  std::uint32_t a[4], b[4];
};

[[gnu::always_inline]] inline Batch batch_of(const EdgeEnds* e) {
  return {{e[0].a, e[1].a, e[2].a, e[3].a}, {e[0].b, e[1].b, e[2].b, e[3].b}};
}

template <int dim>
[[gnu::always_inline]] inline Vector<dim, Lanes> normal_of(const EdgeMetric<dim>& m) {
  Vector<dim, Lanes> n;
  for (int j = 0; j < dim; ++j) n.e[j] = load(m.n[j]);
  return n;
}

/// The whole edge.
template <int dim>
[[gnu::always_inline]] inline Vector<dim, Lanes> edge_of(const EdgeMetric<dim>& m) {
  Vector<dim, Lanes> d;
  for (int j = 0; j < dim; ++j) d.e[j] = 2.0 * load(m.half[j]);
  return d;
}

/// The edge's length along the normal; of a bent cell whose normal does not point along the edge, the edge's length.
template <int dim>
[[gnu::always_inline]] inline Lanes normal_distance(const Vector<dim, Lanes>& d, const Vector<dim, Lanes>& n) {
  const Lanes along = dot(d, n);
  return select(along > constant<Lanes>(0), along, root(dot(d, d)));
}

[[gnu::always_inline]] inline FluxConstants constants_of(const SweepSettings& settings) {
  return {settings.gamma, settings.entropy_fix, settings.mach};
}

[[gnu::always_inline]] inline ViscousConstants viscous_constants_of(const SweepSettings& settings) {
  return {settings.gamma, settings.viscosity, settings.sutherland, settings.inverse_prandtl};
}

/// Add the fluxes of four faces, times their sizes, to the lines of their ends.
template <int dim>
[[gnu::always_inline]] inline void scatter(Components<dim, Lanes>& f, const Lanes& size, const EdgeEnds* ends,
                                           double* residual) {
  constexpr int n = dim + 2;
  for (Lanes& component : f.e) component *= size;
  Row<n> r[4];
  lanes_to_rows<n>(f.e, r);
  for (int i = 0; i < 4; ++i) {
    double* into_a = residual + at(ends[i].into_a, n);
    double* into_b = residual + at(ends[i].into_b, n);
    (Row<n>::load(into_a) + r[i]).store(into_a);
    (Row<n>::load(into_b) - r[i]).store(into_b);
  }
}

template <int dim, FluxKind kind, bool linear>
void flux_loop(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
               const double* state, const double* gradient, double* residual) {
  const FluxConstants constants = constants_of(settings);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric<dim>& m = mesh.metric[e / 4];
    const Batch v = batch_of(ends);
    Primitive<dim, Lanes> a, b;
    if constexpr (linear) {
      a = gather_linear<dim>(state, gradient, m, 1.0, v.a);
      b = gather_linear<dim>(state, gradient, m, -1.0, v.b);
    } else {
      a = gather<dim>(state, v.a);
      b = gather<dim>(state, v.b);
    }
    Components<dim, Lanes> f = flux<kind>(constants, a, b, normal_of(m));
    scatter<dim>(f, load(m.size), ends, residual);
  }
}

template <int dim>
void fluxes(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings, const double* state,
            const double* gradient, double* residual) {
  with_flux(settings.flux, [&]<FluxKind kind>() {
    if (gradient)
      flux_loop<dim, kind, true>(mesh, part, settings, state, gradient, residual);
    else
      flux_loop<dim, kind, false>(mesh, part, settings, state, nullptr, residual);
  });
}

/// Half the gradients of velocity and temperature of four vertices, added to `sum`.
template <int dim>
[[gnu::always_inline]] inline void add_half_gradient(double gamma, const double* gradient, const std::uint32_t (&v)[4],
                                                     const Primitive<dim, Lanes>& w, ViscousGradient<dim, Lanes>& sum) {
  constexpr int n = dim + 2;
  const Lanes inverse_rho = 1.0 / w.rho, p_over_rho = w.p * inverse_rho;
  for (int j = 0; j < dim; ++j) {
    Lanes g[n];
    gather_rows<n>(gradient, dim * n, j * n, v, g);
    for (int i = 0; i < dim; ++i) sum.velocity[i].e[j] += 0.5 * g[1 + i];
    sum.temperature.e[j] += (0.5 * gamma) * inverse_rho * (g[dim + 1] - p_over_rho * g[0]);
  }
}

template <int dim>
void viscous_fluxes(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
                    const double* state, const double* gradient, double* residual) {
  const ViscousConstants constants = viscous_constants_of(settings);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric<dim>& m = mesh.metric[e / 4];
    const Batch v = batch_of(ends);
    const Primitive<dim, Lanes> a = gather<dim>(state, v.a), b = gather<dim>(state, v.b);
    ViscousGradient<dim, Lanes> mean;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) mean.velocity[i].e[j] = constant<Lanes>(0);
    for (int j = 0; j < dim; ++j) mean.temperature.e[j] = constant<Lanes>(0);
    if (gradient) {
      add_half_gradient<dim>(settings.gamma, gradient, v.a, a, mean);
      add_half_gradient<dim>(settings.gamma, gradient, v.b, b, mean);
    }
    const Lanes jump = temperature(settings.gamma, b) - temperature(settings.gamma, a);
    const Vector<dim, Lanes> n = normal_of(m);
    const Vector<dim, Lanes> d = edge_of(m);
    const Lanes share = 1.0 / normal_distance(d, n);
    correct_along_normal(difference(b.velocity, a.velocity), jump, d, n, share, mean);
    Components<dim, Lanes> f = viscous_flux(constants, mean_state(a, b), mean, n);
    scatter<dim>(f, load(m.size), ends, residual);
  }
}

template <int dim>
void wave_speeds(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
                 const double* state, double* sum) {
  const ViscousConstants viscous = viscous_constants_of(settings);
  const double diffusion = 2 * larger<double>(4.0 / 3.0, settings.gamma * settings.inverse_prandtl);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric<dim>& m = mesh.metric[e / 4];
    const Batch v = batch_of(ends);
    const Primitive<dim, Lanes> mean = mean_state(gather<dim>(state, v.a), gather<dim>(state, v.b));
    const Vector<dim, Lanes> n = normal_of(m);
    const Lanes c = sound_speed(settings.gamma, mean);
    Lanes speed = magnitude<Lanes>(dot(mean.velocity, n)) + c;
    if (settings.viscosity > 0)
      speed += diffusion * viscosity<Lanes>(viscous, temperature(settings.gamma, mean)) / (mean.rho * normal_distance(edge_of(m), n));
    speed *= load(m.size);
    for (int i = 0; i < 4; ++i) {
      sum[ends[i].into_a] += speed[i];
      sum[ends[i].into_b] += speed[i];
    }
  }
}

/// Four edges' blocks, one edge a lane, to one block an edge, column by column.
template <int dim>
[[gnu::always_inline]] inline void columns_by_edge(const Block<dim, Lanes>& block, const Lanes& size,
                                                   Row<dim + 2> (&out)[4][dim + 2]) {
  for (int j = 0; j < dim + 2; ++j) {
    Lanes column[dim + 2];
    for (int i = 0; i < dim + 2; ++i) column[i] = block.m[i][j] * size;
    Row<dim + 2> r[4];
    lanes_to_rows<dim + 2>(column, r);
    for (int edge = 0; edge < 4; ++edge) out[edge][j] = r[edge];
  }
}

/// Add the blocks of four faces, times their sizes, to the diagonal ones of their ends; the others are added too, or set.
template <int dim>
[[gnu::always_inline]] inline void scatter_blocks(const Block<dim, Lanes>& by_a, const Block<dim, Lanes>& by_b,
                                                  const Lanes& size, const EdgeEnds* ends, bool add, double* blocks) {
  constexpr int n = dim + 2;
  using Column = Row<n>;
  Column edge_a[4][n], edge_b[4][n];
  double rubbish[n * n] = {};
  const auto block_at = [&](std::uint32_t block) { return block == no_block ? rubbish : blocks + at(block, n * n); };
  columns_by_edge<dim>(by_a, size, edge_a);
  columns_by_edge<dim>(by_b, size, edge_b);
  for (int i = 0; i < 4; ++i) {
    double* aa = block_at(ends[i].block_aa);
    double* ab = block_at(ends[i].block_ab);
    double* bb = block_at(ends[i].block_bb);
    double* ba = block_at(ends[i].block_ba);
    for (int j = 0; j < n; ++j) {
      (Column::load(aa + n * j) + edge_a[i][j]).store(aa + n * j);
      (add ? Column::load(ab + n * j) + edge_b[i][j] : edge_b[i][j]).store(ab + n * j);
      (Column::load(bb + n * j) - edge_b[i][j]).store(bb + n * j);
      (add ? Column::load(ba + n * j) - edge_a[i][j] : -1.0 * edge_a[i][j]).store(ba + n * j);
    }
  }
}

template <int dim, FluxKind kind>
void flux_jacobian_loop(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
                        const double* state, double* blocks) {
  const FluxConstants constants = constants_of(settings);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric<dim>& m = mesh.metric[e / 4];
    const Batch v = batch_of(ends);
    const Primitive<dim, Lanes> a = gather<dim>(state, v.a), b = gather<dim>(state, v.b);
    Block<dim, Lanes> by_a, by_b;
    flux_jacobians<kind>(constants, a, b, normal_of(m), by_a, by_b);
    scatter_blocks<dim>(by_a, by_b, load(m.size), ends, settings.repeats_edges, blocks);
  }
}

template <int dim>
void add_viscous_jacobian(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
                          const double* state, double* blocks) {
  const ViscousConstants constants = viscous_constants_of(settings);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric<dim>& m = mesh.metric[e / 4];
    const Batch v = batch_of(ends);
    const Primitive<dim, Lanes> a = gather<dim>(state, v.a), b = gather<dim>(state, v.b);
    const Vector<dim, Lanes> n = normal_of(m);
    Block<dim, Lanes> by_a{}, by_b{};
    add_viscous_jacobians(constants, a, b, n, normal_distance(edge_of(m), n), by_a, by_b);
    scatter_blocks<dim>(by_a, by_b, load(m.size), ends, true, blocks);
  }
}

template <int dim>
void jacobian(const SweepMesh<dim>& mesh, const PartRange& part, const SweepSettings& settings,
              const double* state, double* blocks) {
  with_jacobian(settings.flux, [&]<FluxKind kind>() {
    flux_jacobian_loop<dim, kind>(mesh, part, settings, state, blocks);
  });
  if (settings.viscosity > 0) add_viscous_jacobian<dim>(mesh, part, settings, state, blocks);
}

template <int dim>
constexpr SweepKernels<dim> kernels(const char* name) {
  return {name, limited_gradients<dim>, fluxes<dim>, viscous_fluxes<dim>, wave_speeds<dim>, jacobian<dim>};
}

}  // namespace

template <>
const SweepKernels<2> SweepBuilds<2>::LEONHARD_SWEEP_BUILD = kernels<2>(LEONHARD_SWEEP_LABEL);
template <>
const SweepKernels<3> SweepBuilds<3>::LEONHARD_SWEEP_BUILD = kernels<3>(LEONHARD_SWEEP_LABEL);

}  // namespace leonhard::solver
