// SPDX-License-Identifier: MIT
#include "leonhard/solver/residual.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/median_dual.hpp"
#include "leonhard/solver/forces.hpp"
#include "tests/solver/meshes.hpp"

namespace {

using namespace leonhard;
using solver::FlowResidual;
using solver::SpatialOptions;

FlowProblem<2> all_far_field(const TriangleMesh& mesh, double mach, double alpha_rad) {
  return {mesh::build_dual(mesh),
          {},
          {mach, alpha_rad},
          {{test::south, BoundaryKind::far_field},
           {test::east, BoundaryKind::far_field},
           {test::north, BoundaryKind::far_field},
           {test::west, BoundaryKind::far_field}},
          {},
          true,
          {0.25, 0},
          {}};
}

FlowProblem<2> about_airfoil(const TriangleMesh& mesh) {
  return {mesh::build_dual(mesh),        {},
          {0.8, 0.02}, {{test::south, BoundaryKind::slip_wall}, {test::north, BoundaryKind::far_field}},
          {},          true,
          {0.25, 0},   {}};
}

PerId<VertexId, State<2>> rough_states(const TriangleMesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-0.2, 0.2);
  PerId<VertexId, State<2>> state;
  for (const Point2 p : mesh.points)
    state.push_back(
        {1 + 0.1 * std::sin(3 * p.x) + any(random), 0.7 + any(random), 0.1 + any(random), 0.7 + any(random)});
  return state;
}

TEST_CASE("free_stream_is_kept_to_rounding_on_shaken_meshes") {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const TriangleMesh mesh = test::shaken_square(15, 0.3, seed);
    for (const double mach : {0.3, 0.9, 2.5}) {
      const FlowProblem<2> problem = all_far_field(mesh, mach, 0.4);
      FlowResidual<2> residual(problem, {});
      std::vector<double> out;
      residual.evaluate(
          PerId<VertexId, State<2>>(mesh.vertex_count(), solver::free_stream_state<2>({}, {mach, 0.4})), out);
      for (std::size_t i = 0; i < 4 * mesh.vertex_count(); ++i) CHECK(std::abs(out[i]) < 1e-12);
    }
  }
}

TEST_CASE("free_stream_passes_supersonic_boundaries_and_walls_along_it") {
  const TriangleMesh mesh = test::shaken_square(10, 0.3, 9);
  FlowProblem<2> problem = all_far_field(mesh, 2, 0);
  problem.boundary = {{test::south, BoundaryKind::slip_wall},
                      {test::east, BoundaryKind::supersonic_outflow},
                      {test::north, BoundaryKind::symmetry},
                      {test::west, BoundaryKind::supersonic_inflow}};
  FlowResidual<2> residual(problem, {});
  std::vector<double> out;
  residual.evaluate(PerId<VertexId, State<2>>(mesh.vertex_count(), solver::free_stream_state<2>({}, {2, 0})), out);
  for (std::size_t i = 0; i < 4 * mesh.vertex_count(); ++i) CHECK(std::abs(out[i]) < 1e-12);
}

TEST_CASE("residual_has_the_same_bits_for_any_flux_and_kernel_build") {
  const TriangleMesh mesh = test::o_mesh(40, 30, 10, 0.02, test::naca0012);
  const FlowProblem<2> problem = about_airfoil(mesh);
  const auto state = rough_states(mesh, 12);
  const auto numbers = static_cast<std::ptrdiff_t>(4 * mesh.vertex_count());
  std::vector<double> one, other, roe;
  FlowResidual<2>(problem, {.flux = FluxKind::roe}).evaluate(state, roe);
  for (const FluxKind flux :
       {FluxKind::roe_low_mach, FluxKind::hllc, FluxKind::hllc_low_mach, FluxKind::ausm_plus_up,
        FluxKind::rusanov, FluxKind::van_leer, FluxKind::kep_scalar, FluxKind::kep_matrix}) {
    CAPTURE(to_string(flux));
    SpatialOptions options;
    options.flux = flux;
    FlowResidual<2> baseline(problem, options, solver::SweepBuilds<2>::baseline),
        best(problem, options, solver::best_sweep<2>());
    baseline.evaluate(state, one);
    best.evaluate(state, other);
    CHECK(std::equal(one.begin(), one.begin() + numbers, other.begin()));
    CHECK_FALSE(std::equal(one.begin(), one.begin() + numbers, roe.begin()));  // the choice arrives
    const std::size_t blocks = 16 * baseline.plan().block_count();
    one.resize(blocks);
    other.resize(one.size());
    baseline.jacobian(state, one);
    best.jacobian(state, other);
    CHECK(std::equal(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(blocks), other.begin()));
  }
}

TEST_CASE("residual_has_the_same_bits_for_any_thread_count_and_kernel_build") {
  const TriangleMesh mesh = test::o_mesh(120, 80, 10, 0.01, test::naca0012);
  const FlowProblem<2> problem = about_airfoil(mesh);
  const auto state = rough_states(mesh, 11);
  std::vector<double> one, other, jacobian_one, jacobian_other;
  FlowResidual<2> reference(problem, {}, solver::SweepBuilds<2>::baseline);
  REQUIRE(reference.plan().parts.size() > 3);
  reference.evaluate(state, one);
  jacobian_one.resize(16 * reference.plan().block_count());
  reference.jacobian(state, jacobian_one);
  const std::size_t numbers = 4 * mesh.vertex_count(), blocks = 16 * reference.plan().block_count();
  for (const int threads : {1, 2, 3})
    for (const auto* kernels : {&solver::SweepBuilds<2>::baseline, &solver::best_sweep<2>()}) {
      SpatialOptions options;
      options.threads = threads;
      FlowResidual<2> residual(problem, options, *kernels);
      residual.evaluate(state, other);
      jacobian_other.resize(jacobian_one.size());
      residual.jacobian(state, jacobian_other);
      CHECK(std::equal(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(numbers), other.begin()));
      CHECK(std::equal(jacobian_one.begin(), jacobian_one.begin() + static_cast<std::ptrdiff_t>(blocks),
                       jacobian_other.begin()));
    }
}

// ---- The scheme written again, plainly: from the triangles, one dual face segment after another. ----

struct Gradient {
  double x[4], y[4];
};

std::map<std::size_t, std::set<std::size_t>> neighbours_of(const TriangleMesh& mesh) {
  std::map<std::size_t, std::set<std::size_t>> neighbours;
  for (const auto& t : mesh.corners)
    for (const VertexId a : t)
      for (const VertexId b : t)
        if (a != b) neighbours[a.index()].insert(b.index());
  return neighbours;
}

double venkatakrishnan(double room, double step, double e) {
  if (step == 0) return 1;
  return std::min(1.0, ((room * room + e) * step + 2 * step * step * room) /
                           (step * (room * room + 2 * step * step + room * step + e)));
}

/// The extent of the walls along x.
double chord_of(const FlowProblem<2>& problem) {
  double low = 1e300, high = -1e300;
  for (const DualFacet<2>& edge : problem.dual.boundary)
    if (problem.boundary.at(edge.marker).kind == BoundaryKind::slip_wall) {
      low = std::min(low, problem.dual.points[edge.corners[0]].x);
      high = std::max(high, problem.dual.points[edge.corners[0]].x);
    }
  return high - low;
}

/// How much of a fall by `part` of the own value is left of density and pressure.
double positive_share(double part) {
  if (part <= 0.5) return 1;
  const double beyond = part - 0.5;
  return (0.5 + 0.3 * beyond / (0.3 + beyond)) / part;
}

std::vector<Gradient> plain_gradients(const TriangleMesh& mesh, const PerId<VertexId, State<2>>& state,
                                      const std::vector<double>& area, double k_per_extent) {
  std::vector<Gradient> gradients(mesh.vertex_count());
  for (const auto& [v, around] : neighbours_of(mesh)) {
    const Point2 here = mesh.points.flat()[v];
    const auto value = [&](std::size_t at, int i) { return (&state.flat()[at].rho)[i]; };
    double xx = 0, xy = 0, yy = 0;
    for (const std::size_t n : around) {
      const Vec2 d = mesh.points.flat()[n] - here;
      xx += d.x * d.x / dot(d, d), xy += d.x * d.y / dot(d, d), yy += d.y * d.y / dot(d, d);
    }
    const State<2>& own = state.flat()[v];
    const double c = std::sqrt(1.4 * own.p / own.rho);
    const double size[4] = {own.rho, c, c, 1.4 * own.p};
    for (int i = 0; i < 4; ++i) {
      double bx = 0, by = 0, up = 0, down = 0;
      for (const std::size_t n : around) {
        const Vec2 d = mesh.points.flat()[n] - here;
        const double du = value(n, i) - value(v, i);
        bx += d.x * du / dot(d, d), by += d.y * du / dot(d, d);
        up = std::max(up, du), down = std::min(down, du);
      }
      const double gx = (yy * bx - xy * by) / (xx * yy - xy * xy),
                   gy = (xx * by - xy * bx) / (xx * yy - xy * xy);
      const double e = std::pow(k_per_extent * std::sqrt(area[v]), 3) * size[i] * size[i];
      double share = 1, fall = 0;
      for (const std::size_t n : around) {
        const double step = 0.5 * dot({gx, gy}, mesh.points.flat()[n] - here);
        share = std::min(share, venkatakrishnan(step > 0 ? up : down, step, e));
        fall = std::max(fall, -step);
      }
      if (i == 0 || i == 3) share *= positive_share(share * fall / value(v, i));
      gradients[v].x[i] = share * gx, gradients[v].y[i] = share * gy;
    }
  }
  return gradients;
}

/// Roe's flux by its three waves, with Harten's fix.
std::array<double, 4> plain_roe(const State<2>& a, const State<2>& b, double nx, double ny, double fix) {
  const double sa = std::sqrt(a.rho), sb = std::sqrt(b.rho);
  const auto head = [](const State<2>& w) { return 3.5 * w.p / w.rho + 0.5 * (w.u * w.u + w.v * w.v); };
  const double u = (sa * a.u + sb * b.u) / (sa + sb), v = (sa * a.v + sb * b.v) / (sa + sb);
  const double h = (sa * head(a) + sb * head(b)) / (sa + sb),
               c = std::sqrt(0.4 * (h - 0.5 * (u * u + v * v)));
  const double rho = sa * sb, vn = u * nx + v * ny, dp = b.p - a.p, drho = b.rho - a.rho;
  const double dvn = (b.u - a.u) * nx + (b.v - a.v) * ny;
  const auto size = [&](double x) {
    const double delta = fix * (std::abs(vn) + c);
    return std::abs(x) < delta ? 0.5 * (x * x / delta + delta) : std::abs(x);
  };
  const double minus = size(vn - c) * (dp - rho * c * dvn) / (2 * c * c);
  const double plus = size(vn + c) * (dp + rho * c * dvn) / (2 * c * c);
  const double entropy = size(vn) * (drho - dp / (c * c)), shear = size(vn) * rho;
  const double du = b.u - a.u - dvn * nx, dv = b.v - a.v - dvn * ny;
  const std::array<double, 4> waves = {minus + entropy + plus,
                                       minus * (u - c * nx) + entropy * u + shear * du + plus * (u + c * nx),
                                       minus * (v - c * ny) + entropy * v + shear * dv + plus * (v + c * ny),
                                       minus * (h - c * vn) + entropy * 0.5 * (u * u + v * v) +
                                           shear * (u * du + v * dv) + plus * (h + c * vn)};
  const auto physical = [&](const State<2>& w) {
    const double m = w.rho * (w.u * nx + w.v * ny);
    return std::array<double, 4>{m, m * w.u + w.p * nx, m * w.v + w.p * ny, m * head(w)};
  };
  const auto fa = physical(a), fb = physical(b);
  std::array<double, 4> f{};
  for (std::size_t i = 0; i < 4; ++i) f[i] = 0.5 * (fa[i] + fb[i] - waves[i]);
  return f;
}

std::map<std::pair<std::size_t, std::size_t>, Vec2> plain_dual_normals(const TriangleMesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, Vec2> normals;
  for (const auto& t : mesh.corners) {
    const Point2 p[3] = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    const Point2 centre{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = p[k], b = p[(k + 1) % 3];
      const Vec2 way = centre - Point2{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
      const Vec2 normal{way.y, -way.x};  // from corner k to the next
      const std::size_t from = t[k].index(), to = t[(k + 1) % 3].index();
      Vec2& sum = normals[{std::min(from, to), std::max(from, to)}];
      sum = sum + (from < to ? 1.0 : -1.0) * normal;
    }
  }
  return normals;
}

State<2> moved(const State<2>& w, const Gradient& g, Vec2 by) {
  return {w.rho + g.x[0] * by.x + g.y[0] * by.y, w.u + g.x[1] * by.x + g.y[1] * by.y,
          w.v + g.x[2] * by.x + g.y[2] * by.y, w.p + g.x[3] * by.x + g.y[3] * by.y};
}

std::vector<double> plain_residual(const TriangleMesh& mesh, const FlowProblem<2>& problem,
                                   const PerId<VertexId, State<2>>& state, double k, double fix) {
  std::vector<double> area(mesh.vertex_count()), out(4 * mesh.vertex_count());
  for (const auto& t : mesh.corners)
    for (const VertexId v : t)
      area[v.index()] +=
          cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]) / 6;
  const auto gradients = plain_gradients(mesh, state, area, k / chord_of(problem));
  for (const auto& [ends, normal] : plain_dual_normals(mesh)) {
    const auto [a, b] = ends;
    const Vec2 half = 0.5 * (mesh.points.flat()[b] - mesh.points.flat()[a]);
    const double length = norm(normal);
    const auto f =
        plain_roe(moved(state.flat()[a], gradients[a], half), moved(state.flat()[b], gradients[b], -half),
                  normal.x / length, normal.y / length, fix);
    for (std::size_t i = 0; i < 4; ++i) out[4 * a + i] += length * f[i], out[4 * b + i] -= length * f[i];
  }
  const double cl = solver::total(solver::wall_forces(problem, state)).cl;
  for (const MarkedEdge& edge : mesh.boundary) {
    const Vec2 along = mesh.points[edge.to] - mesh.points[edge.from];
    const double length = norm(along), nx = along.y / length, ny = -along.x / length;
    std::array<double, 4> f[2];
    const VertexId ends[2] = {edge.from, edge.to};
    for (int e = 0; e < 2; ++e) {
      const State<2>& w = state[ends[e]];
      const Vec2 extra =
          cl * solver::vortex_velocity(problem.free_stream, problem.vortex_centre, 1, mesh.points[ends[e]]);
      f[e] =
          problem.boundary.at(edge.marker).kind == BoundaryKind::slip_wall
              ? std::array<double, 4>{0, w.p * nx, w.p * ny, 0}
              : plain_roe(w, solver::isentropic_state(problem.gas, problem.free_stream, extra), nx, ny, fix);
    }
    for (int e = 0; e < 2; ++e)
      for (std::size_t i = 0; i < 4; ++i)
        out[4 * ends[e].index() + i] += 0.5 * length * (5 * f[e][i] + f[1 - e][i]) / 6;
  }
  return out;
}

TEST_CASE("vectorised_residual_equals_a_plain_one_written_independently") {
  const TriangleMesh mesh = test::o_mesh(61, 40, 8, 0.02, test::naca0012);
  const FlowProblem<2> problem = about_airfoil(mesh);
  const auto state = rough_states(mesh, 21);
  SpatialOptions options;
  options.flux = FluxKind::roe;
  options.limiter = LimiterKind::venkatakrishnan;
  options.limiter_k = 2;
  std::vector<double> out;
  FlowResidual<2>(problem, options).evaluate(state, out);
  const auto plain = plain_residual(mesh, problem, state, 2, options.entropy_fix);
  double scale = 0, worst = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    scale = std::max(scale, std::abs(plain[i]));
    worst = std::max(worst, std::abs(out[i] - plain[i]));
  }
  CHECK(scale > 0.1);
  CHECK(worst < 1e-13 * scale * 10);
}

TEST_CASE("residual_scales_with_the_unit_of_the_mesh_to_the_bit") {
  const TriangleMesh mesh = test::o_mesh(61, 40, 8, 0.02, test::naca0012);
  TriangleMesh larger = mesh;  // a power of two, whatever the reference length: nothing rounds differently
  for (Point2& p : larger.points) p = {1024 * p.x, 1024 * p.y};
  FlowProblem<2> problem = about_airfoil(mesh), larger_problem = about_airfoil(larger);
  problem.vortex_correction = larger_problem.vortex_correction = false;
  const auto state = rough_states(mesh, 22);
  std::vector<double> out, larger_out;
  FlowResidual<2>(problem, {}).evaluate(state, out);
  FlowResidual<2>(larger_problem, {}).evaluate(state, larger_out);
  std::size_t other = 0;
  for (std::size_t i = 0; i < 4 * mesh.vertex_count(); ++i) other += larger_out[i] == 1024 * out[i] ? 0 : 1;
  CHECK(other == 0);
}

TEST_CASE("first_order_jacobian_is_the_residuals_derivative_at_a_uniform_state") {
  const TriangleMesh mesh = test::shaken_square(8, 0.25, 31);
  FlowProblem<2> problem = all_far_field(mesh, 0.7, 0.3);
  problem.boundary[test::south] = BoundaryKind::slip_wall;
  problem.boundary[test::east] = BoundaryKind::supersonic_outflow;
  problem.vortex_correction = false;
  FlowResidual<2> residual(problem, {.flux = FluxKind::roe});
  const auto& plan = residual.plan();
  const std::size_t n = mesh.vertex_count();
  const State<2> uniform = solver::free_stream_state<2>(problem.gas, problem.free_stream);
  PerId<VertexId, State<2>> state(n, uniform), up(n), down(n);
  std::vector<double> blocks, high, low;
  blocks.resize(16 * residual.plan().block_count());
  residual.jacobian(state, blocks);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<double> x(4 * n), product(4 * n, 0.0);
  for (double& value : x) value = any(random);
  const double e = 1e-6;
  const auto q = solver::conserved_of(problem.gas, uniform);
  for (const VertexId v : state.ids()) {
    const double* d = x.data() + 4 * v.index();
    up[v] =
        solver::state_of(problem.gas, solver::Conserved<2>{q[0] + e * d[0], q[1] + e * d[1], q[2] + e * d[2], q[3] + e * d[3]});
    down[v] =
        solver::state_of(problem.gas, solver::Conserved<2>{q[0] - e * d[0], q[1] - e * d[1], q[2] - e * d[2], q[3] - e * d[3]});
  }
  residual.evaluate_first_order(up, high);
  residual.evaluate_first_order(down, low);
  const auto add = [&](std::uint32_t row, std::uint32_t column, std::uint32_t block) {
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i)
        product[4 * row + i] += blocks[16 * std::size_t{block} + 4 * j + i] * x[4 * column + j];
  };
  for (std::uint32_t v = 0; v < n; ++v) {
    add(v, v, plan.diagonal_block(v));
    for (std::uint32_t s = plan.neighbours.offsets()[v]; s < plan.neighbours.offsets()[v + 1]; ++s)
      add(v, plan.neighbours.links()[s], plan.neighbour_block(v, s));
  }
  for (std::size_t i = 0; i < 4 * n; ++i) CHECK(std::abs((high[i] - low[i]) / (2 * e) - product[i]) < 1e-7);
}

TEST_CASE("interior_fluxes_cancel_so_that_the_sum_of_residuals_is_the_boundary_flux") {
  const TriangleMesh mesh = test::shaken_square(40, 0.2, 41);
  FlowProblem<2> problem = all_far_field(mesh, 0.5, 0);
  for (auto& [marker, kind] : problem.boundary) kind = BoundaryKind::slip_wall;
  FlowResidual<2> residual(problem, {});
  std::vector<double> out;
  residual.evaluate(rough_states(mesh, 5), out);
  double mass = 0, energy = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) mass += out[4 * v], energy += out[4 * v + 3];
  CHECK(std::abs(mass) < 1e-12);
  CHECK(std::abs(energy) < 1e-12);
}

TEST_CASE("vortex_velocity_has_the_circulation_of_its_lift") {
  const FreeStream free{0.5, 0.1};
  double circulation = 0;
  const int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.5) / steps, r = 12;
    const Vec2 w = solver::vortex_velocity(free, {0.25, 0}, 2.0, {0.25 + r * std::cos(t), r * std::sin(t)});
    circulation += (-std::sin(t) * w.x + std::cos(t) * w.y) * r * 2 * std::numbers::pi / steps;
  }
  // Kutta and Joukowski: lift = cl length |V|^2 / 2 = |V| |circulation|, clockwise for positive lift.
  CHECK(circulation == doctest::Approx(-0.5 * 2.0 * 0.5).epsilon(1e-10));
}

/// The wave speeds that a control volume's faces see, added up face by face from the median dual's metrics.
std::vector<double> plain_wave_speeds(const TriangleMesh& mesh, const PerId<VertexId, State<2>>& state) {
  const EdgeStructure edges = mesh::build_edges(mesh);
  const DualMetrics<2> dual = mesh::median_dual(mesh, edges);
  std::vector<double> sums(mesh.vertex_count());
  for (const EdgeId e : dual.normal.ids()) {
    const VertexId a = edges.ends[e][0], b = edges.ends[e][1];
    const Vec2 n = dual.normal[e];
    const double length = std::hypot(n.x, n.y);
    const State<2> mean{0.5 * (state[a].rho + state[b].rho), 0.5 * (state[a].u + state[b].u),
                     0.5 * (state[a].v + state[b].v), 0.5 * (state[a].p + state[b].p)};
    const double speed =
        std::abs(mean.u * n.x + mean.v * n.y) + std::sqrt(1.4 * mean.p / mean.rho) * length;
    sums[a.index()] += speed;
    sums[b.index()] += speed;
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    for (const VertexId v : {mesh.boundary[i].from, mesh.boundary[i].to}) {
      const Vec2 n = dual.boundary_normal[i];
      sums[v.index()] += 0.5 * (std::abs(state[v].u * n.x + state[v].v * n.y) +
                                std::sqrt(1.4 * state[v].p / state[v].rho) * std::hypot(n.x, n.y));
    }
  return sums;
}

TEST_CASE("wave_speed_sums_are_those_of_the_faces_one_by_one") {
  const TriangleMesh mesh = test::shaken_square(12, 0.3, 7);
  const FlowProblem<2> problem = all_far_field(mesh, 0.7, 0.2);
  FlowResidual<2> residual(problem, {});
  std::vector<double> sums;
  residual.wave_speed_sums(PerId<VertexId, State<2>>(mesh.vertex_count(), {1.2, 0.6, -0.3, 0.9}), sums);
  const std::vector<double> plain =
      plain_wave_speeds(mesh, PerId<VertexId, State<2>>(mesh.vertex_count(), {1.2, 0.6, -0.3, 0.9}));
  for (std::size_t v = 0; v < plain.size(); ++v) CHECK(sums[v] == doctest::Approx(plain[v]).epsilon(1e-12));
  const auto rough = rough_states(mesh, 3);
  residual.wave_speed_sums(rough, sums);
  const std::vector<double> rough_plain = plain_wave_speeds(mesh, rough);
  for (std::size_t v = 0; v < rough_plain.size(); ++v)  // how the two ends are averaged is the scheme's choice
    CHECK(sums[v] == doctest::Approx(rough_plain[v]).epsilon(0.05));
}

}  // namespace
