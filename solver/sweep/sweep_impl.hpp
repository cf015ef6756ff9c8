// SPDX-License-Identifier: MIT
// The loops declared in sweep.hpp. Included once by each sweep_*.cpp, which sets LEONHARD_SWEEP_NAME and the
// instruction set. Everything has internal linkage.

#include "leonhard/solver/flux/flux.hpp"
#include "leonhard/solver/flux/jacobian.hpp"
#include "leonhard/solver/sweep/limiter.hpp"
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {
namespace {

/// Room and steps of the four variables about one vertex, one variable a lane.
struct Stencil {
  Lanes gradient_x, gradient_y;
  Lanes room_up, room_down;  ///< greatest and least neighbour less own value: >= 0 and <= 0
  Lanes step_up,
      step_down;  ///< greatest and least change from the vertex to an edge's midpoint: >= 0 and <= 0
};

[[gnu::always_inline]] inline Stencil look_around(const SweepMesh& mesh, std::uint32_t v,
                                                  const double* state) {
  const Lanes zero = constant<Lanes>(0), own = load(state + 4 * std::size_t{v});
  Stencil s{zero, zero, zero, zero, zero, zero};
  const std::uint32_t first = mesh.offset[v], last = mesh.offset[v + 1];
  for (std::uint32_t i = first; i < last; ++i) {
    const Lanes difference = load(state + 4 * std::size_t{mesh.neighbour[i]}) - own;
    s.gradient_x += mesh.slot[i].weight_x * difference;
    s.gradient_y += mesh.slot[i].weight_y * difference;
    s.room_up = larger<Lanes>(s.room_up, difference);
    s.room_down = smaller<Lanes>(s.room_down, difference);
  }
  for (std::uint32_t i = first; i < last; ++i) {
    const Lanes step = mesh.slot[i].half_x * s.gradient_x + mesh.slot[i].half_y * s.gradient_y;
    s.step_up = larger<Lanes>(s.step_up, step);
    s.step_down = smaller<Lanes>(s.step_down, step);
  }
  return s;
}

/// What counts as a large variation of each variable about a state: the squares of density, speed of sound (twice) and
/// gamma times pressure, all 1 in the free stream.
[[gnu::always_inline]] inline Lanes squared_size(const Lanes& own, double gamma) {
  const double stiffness = gamma * own[3], c2 = stiffness / own[0];
  return Lanes{own[0] * own[0], c2, c2, stiffness * stiffness};
}

/// How much of a step down density and pressure may take: all of one to half their value, and never more than four fifths.
/// Its slope is continuous, so that near vacuum Newton's method finds no kink.
[[gnu::always_inline]] inline Lanes keep_positive(const Lanes& step_down, const Lanes& own) {
  const Lanes part{-step_down[0] / own[0], 0, 0, -step_down[3] / own[3]};
  const Lanes beyond = larger<Lanes>(part - 0.5, constant<Lanes>(0));
  return select(part > constant<Lanes>(0.5), Lanes((0.5 + 0.3 * beyond / (0.3 + beyond)) / part), constant<Lanes>(1));
}

void limited_gradients(const SweepMesh& mesh, const PartRange& part, const SweepSettings& settings,
                       const double* state, double* gradient) {
  for (std::uint32_t k = part.vertex_begin; k < part.vertex_end; ++k) {
    const std::uint32_t v = mesh.part_vertices[k];
    const Stencil s = look_around(mesh, v, state);
    const Lanes own = load(state + 4 * std::size_t{v});
    Lanes share = constant<Lanes>(1);
    if (settings.limiter == LimiterKind::venkatakrishnan) {
      const Lanes scale2 = settings.limiter_scale2[v] * squared_size(own, settings.gamma);
      share = smaller<Lanes>(limit_venkatakrishnan<Lanes>(s.room_up, s.step_up, scale2),
                             limit_venkatakrishnan<Lanes>(s.room_down, s.step_down, scale2));
    } else if (settings.limiter == LimiterKind::barth_jespersen) {
      share = smaller<Lanes>(limit_barth_jespersen<Lanes>(s.room_up, s.step_up),
                             limit_barth_jespersen<Lanes>(s.room_down, s.step_down));
    }
    share *= keep_positive(share * s.step_down, own);
    store(gradient + 8 * std::size_t{v}, share * s.gradient_x);
    store(gradient + 8 * std::size_t{v} + 4, share * s.gradient_y);
  }
}

/// The states of four vertices, one vertex a lane.
[[gnu::always_inline]] inline Primitive<2, Lanes> gather(const double* state, const std::uint32_t (&v)[4]) {
  Lanes r[4];
  for (int i = 0; i < 4; ++i) r[i] = load(state + 4 * std::size_t{v[i]});
  transpose(r[0], r[1], r[2], r[3]);
  return {r[0], {r[1], r[2]}, r[3]};
}

/// Likewise after `sign` times half an edge along the gradient, which leaves density and pressure positive.
[[gnu::always_inline]] inline Primitive<2, Lanes> gather_linear(const double* state, const double* gradient,
                                                                const EdgeMetric& m, double sign,
                                                                const std::uint32_t (&v)[4]) {
  Lanes r[4];
  for (int i = 0; i < 4; ++i) {
    const double* g = gradient + 8 * std::size_t{v[i]};
    r[i] = load(state + 4 * std::size_t{v[i]}) + ((sign * m.half_x[i]) * load(g) + (sign * m.half_y[i]) * load(g + 4));
  }
  transpose(r[0], r[1], r[2], r[3]);
  return {r[0], {r[1], r[2]}, r[3]};
}

struct Batch {
  std::uint32_t a[4], b[4];
};

[[gnu::always_inline]] inline Batch batch_of(const EdgeEnds* e) {
  return {{e[0].a, e[1].a, e[2].a, e[3].a}, {e[0].b, e[1].b, e[2].b, e[3].b}};
}

[[gnu::always_inline]] inline Vector<2, Lanes> normal_of(const EdgeMetric& m) {
  return {{load(m.nx), load(m.ny)}};
}

[[gnu::always_inline]] inline FluxConstants constants_of(const SweepSettings& settings) {
  return {settings.gamma, settings.entropy_fix, settings.mach};
}

template <FluxKind kind, bool linear>
void flux_loop(const SweepMesh& mesh, const PartRange& part, const SweepSettings& settings,
               const double* state, const double* gradient, double* residual) {
  const FluxConstants constants = constants_of(settings);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric& m = mesh.metric[e / 4];
    const Batch at = batch_of(ends);
    Primitive<2, Lanes> a, b;
    if constexpr (linear) {
      a = gather_linear(state, gradient, m, 1.0, at.a);
      b = gather_linear(state, gradient, m, -1.0, at.b);
    } else {
      a = gather(state, at.a);
      b = gather(state, at.b);
    }
    Components<2, Lanes> f = flux<kind>(constants, a, b, normal_of(m));
    const Lanes length = load(m.length);
    for (Lanes& component : f.e) component *= length;
    transpose(f.e[0], f.e[1], f.e[2], f.e[3]);
    for (int i = 0; i < 4; ++i) {
      double* into_a = residual + 4 * std::size_t{ends[i].into_a};
      double* into_b = residual + 4 * std::size_t{ends[i].into_b};
      store(into_a, load(into_a) + f.e[i]);
      store(into_b, load(into_b) - f.e[i]);
    }
  }
}

void fluxes(const SweepMesh& mesh, const PartRange& part, const SweepSettings& settings, const double* state,
            const double* gradient, double* residual) {
  with_flux(settings.flux, [&]<FluxKind kind>() {
    if (gradient)
      flux_loop<kind, true>(mesh, part, settings, state, gradient, residual);
    else
      flux_loop<kind, false>(mesh, part, settings, state, nullptr, residual);
  });
}

void wave_speeds(const SweepMesh& mesh, const PartRange& part, const SweepSettings& settings,
                 const double* state, double* sum) {
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric& m = mesh.metric[e / 4];
    const Batch at = batch_of(ends);
    const Primitive<2, Lanes> a = gather(state, at.a), b = gather(state, at.b);
    const Vector<2, Lanes>&va = a.velocity, &vb = b.velocity;
    const Lanes vn = 0.5 * ((va.e[0] + vb.e[0]) * load(m.nx) + (va.e[1] + vb.e[1]) * load(m.ny));
    const Lanes c = root(Lanes(settings.gamma * (a.p + b.p) / (a.rho + b.rho)));
    const Lanes speed = (magnitude<Lanes>(vn) + c) * load(m.length);
    for (int i = 0; i < 4; ++i) {
      sum[ends[i].into_a] += speed[i];
      sum[ends[i].into_b] += speed[i];
    }
  }
}

/// Four edges' blocks, one edge a lane, to one block an edge, column by column.
[[gnu::always_inline]] inline void columns_by_edge(const Block<2, Lanes>& block, const Lanes& length,
                                                   Lanes (&out)[4][4]) {
  for (int j = 0; j < 4; ++j) {
    Lanes r[4];
    for (int i = 0; i < 4; ++i) r[i] = block.m[i][j] * length;
    transpose(r[0], r[1], r[2], r[3]);
    for (int edge = 0; edge < 4; ++edge) out[edge][j] = r[edge];
  }
}

template <FluxKind kind>
void jacobian_loop(const SweepMesh& mesh, const PartRange& part, const SweepSettings& settings,
                   const double* state, double* blocks) {
  const FluxConstants constants = constants_of(settings);
  for (std::uint32_t e = part.edge_begin; e < part.edge_end; e += 4) {
    const EdgeEnds* ends = mesh.ends + e;
    const EdgeMetric& m = mesh.metric[e / 4];
    const Batch at = batch_of(ends);
    Block<2, Lanes> by_a, by_b;
    flux_jacobians<kind>(constants, gather(state, at.a), gather(state, at.b), normal_of(m), by_a, by_b);
    Lanes edge_a[4][4], edge_b[4][4];
    columns_by_edge(by_a, load(m.length), edge_a);
    columns_by_edge(by_b, load(m.length), edge_b);
    for (int i = 0; i < 4; ++i) {
      double* aa = blocks + 16 * std::size_t{ends[i].block_aa};
      double* ab = blocks + 16 * std::size_t{ends[i].block_ab};
      double* bb = blocks + 16 * std::size_t{ends[i].block_bb};
      double* ba = blocks + 16 * std::size_t{ends[i].block_ba};
      for (int j = 0; j < 4; ++j) {
        store(aa + 4 * j, load(aa + 4 * j) + edge_a[i][j]);
        store(ab + 4 * j, edge_b[i][j]);
        store(bb + 4 * j, load(bb + 4 * j) - edge_b[i][j]);
        store(ba + 4 * j, -edge_a[i][j]);
      }
    }
  }
}

void jacobian(const SweepMesh& mesh, const PartRange& part, const SweepSettings& settings,
              const double* state, double* blocks) {
  with_jacobian(settings.flux,
                [&]<FluxKind kind>() { jacobian_loop<kind>(mesh, part, settings, state, blocks); });
}

}  // namespace

const SweepKernels LEONHARD_SWEEP_NAME = {LEONHARD_SWEEP_LABEL, limited_gradients, fluxes, wave_speeds,
                                          jacobian};

}  // namespace leonhard::solver
