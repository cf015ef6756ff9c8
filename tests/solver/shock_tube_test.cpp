// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "leonhard/solver/residual.hpp"
#include "tests/solver/meshes.hpp"

// Shock tubes as strips of the plane, marched in time by the residual: Sod's (Journal of Computational Physics 27, 1978)
// and two gases that part (B. Einfeldt et al., Journal of Computational Physics 92, 1991: "1-2-3").

namespace {

using namespace leonhard;
using solver::Conserved;

constexpr double gamma = 1.4;

/// The exact solution of the Riemann problem between two gases, by Newton's method on the pressure between the
/// waves; E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, chapter 4.
class RiemannSolution {
 public:
  RiemannSolution(const State<2>& left, const State<2>& right) : left_(left), right_(right) {
    p_ = 0.5 * (left.p + right.p);
    for (int i = 0; i < 50; ++i) {
      const double step = 1e-7 * p_;
      const double value = excess(p_), slope = (excess(p_ + step) - value) / step;
      p_ = std::max(1e-8, p_ - value / slope);
    }
    u_ = 0.5 * (left_.u + right_.u + wave(right_, p_) - wave(left_, p_));
  }

  /// The state at x / t.
  [[nodiscard]] State<2> at(double speed) const { return speed < u_ ? left_of(speed) : mirrored(speed); }
  [[nodiscard]] double pressure() const { return p_; }
  [[nodiscard]] double velocity() const { return u_; }

 private:
  static double sound(const State<2>& w) { return std::sqrt(gamma * w.p / w.rho); }
  /// The change of velocity across the wave from `w` to pressure p.
  static double wave(const State<2>& w, double p) {
    if (p > w.p) return (p - w.p) * std::sqrt(2 / ((gamma + 1) * w.rho) / (p + (gamma - 1) / (gamma + 1) * w.p));
    return 2 * sound(w) / (gamma - 1) * (std::pow(p / w.p, (gamma - 1) / (2 * gamma)) - 1);
  }
  [[nodiscard]] double excess(double p) const {
    return wave(left_, p) + wave(right_, p) + right_.u - left_.u;
  }

  /// The side whose wave runs to the left, as one sees it who moves with the gas ahead of the wave.
  [[nodiscard]] State<2> side(const State<2>& w, double u, double speed) const {
    const double c = sound(w);
    if (p_ > w.p) {  // a shock
      const double ratio = p_ / w.p, g = (gamma - 1) / (gamma + 1);
      const double shock = -c * std::sqrt((gamma + 1) / (2 * gamma) * ratio + (gamma - 1) / (2 * gamma));
      if (speed < shock) return w;
      return {w.rho * (ratio + g) / (g * ratio + 1), u, 0, p_};
    }
    const double c_star = c * std::pow(p_ / w.p, (gamma - 1) / (2 * gamma));
    if (speed < -c) return w;
    if (speed > u - c_star) return {w.rho * std::pow(p_ / w.p, 1 / gamma), u, 0, p_};
    const double c_fan = 2 / (gamma + 1) * (c - (gamma - 1) / 2 * speed), ratio = c_fan / c;
    return {w.rho * std::pow(ratio, 2 / (gamma - 1)), 2 / (gamma + 1) * (c + speed), 0,
            w.p * std::pow(ratio, 2 * gamma / (gamma - 1))};
  }
  static State<2> resting(const State<2>& w) { return {w.rho, 0, 0, w.p}; }
  static State<2> moving(const State<2>& w, double sign, double by) { return {w.rho, sign * w.u + by, w.v, w.p}; }
  [[nodiscard]] State<2> left_of(double speed) const {
    return moving(side(resting(left_), u_ - left_.u, speed - left_.u), 1, left_.u);
  }
  [[nodiscard]] State<2> mirrored(double speed) const {
    return moving(side(resting(right_), right_.u - u_, right_.u - speed), -1, right_.u);
  }

  State<2> left_, right_;
  double p_{}, u_{};
};

const State<2> driver{1, 0, 0, 1}, driven{0.125, 0, 0, 0.1};

/// Two gases, to the left and right of x = 0.5 at first.
struct Gases {
  State<2> left, right;
  BoundaryKind ends;
  double end_time, largest_speed;  ///< of the waves
};
const Gases sod{driver, driven, BoundaryKind::slip_wall, 0.2, 2.2};
const Gases parting{{1, -2, 0, 0.4}, {1, 2, 0, 0.4}, BoundaryKind::supersonic_outflow, 0.15, 2.8};

struct Tube {
  TriangleMesh mesh;
  PerId<VertexId, State<2>> state;
  Conserved<2> before{}, after{};  ///< totals of mass, momentum and energy
};

Conserved<2> totals(const solver::EdgePlan<2>& plan, const PerId<VertexId, State<2>>& state) {
  Conserved<2> sum{};
  for (const VertexId v : state.ids()) {
    const Conserved<2> q = solver::conserved_of({gamma}, state[v]);
    for (std::size_t i = 0; i < 4; ++i) sum[i] += plan.volume[v.index()] * q[i];
  }
  return sum;
}

/// Marches to the end by Heun's method at half the stable time step.
Tube run_tube(std::size_t cells, int order, FluxKind flux = FluxKind::roe, const Gases& gases = sod) {
  const double height = 2.0 / static_cast<double>(cells);
  Tube tube{test::mapped_grid(cells, 2, false, [&](double s, double t) { return Point2{s, height * t}; }), {}, {}, {}};
  FlowProblem<2> problem{mesh::build_dual(tube.mesh), {gamma}, {0.5, 0}, {}, {}, false, {}, {}};
  for (const Marker side : {test::south, test::east, test::north, test::west})
    problem.boundary[side] = side == test::east || side == test::west ? gases.ends : BoundaryKind::slip_wall;
  solver::SpatialOptions options;
  options.order = order;
  options.flux = flux;
  options.limiter = LimiterKind::barth_jespersen;
  solver::FlowResidual<2> residual(problem, options);
  for (const Point2 p : tube.mesh.points) tube.state.push_back(p.x < 0.5 ? gases.left : gases.right);
  tube.before = totals(residual.plan(), tube.state);
  const int steps =
      static_cast<int>(std::ceil(gases.end_time * gases.largest_speed * 4 * static_cast<double>(cells)));
  const double dt = gases.end_time / steps;
  std::vector<double> rate;
  const auto euler_step = [&](const PerId<VertexId, State<2>>& from, PerId<VertexId, State<2>>& to) {
    residual.evaluate(from, rate);
    for (const VertexId v : from.ids()) {
      Conserved<2> q = solver::conserved_of({gamma}, from[v]);
      for (std::size_t i = 0; i < 4; ++i) q[i] -= dt / residual.plan().volume[v.index()] * rate[4 * v.index() + i];
      to[v] = solver::state_of(Gas{gamma}, q);
    }
  };
  PerId<VertexId, State<2>> once = tube.state, twice = tube.state;
  for (int step = 0; step < steps; ++step) {
    euler_step(tube.state, once);
    euler_step(once, twice);
    for (const VertexId v : tube.state.ids()) {
      Conserved<2> q = solver::conserved_of({gamma}, tube.state[v]);
      const Conserved<2> other = solver::conserved_of({gamma}, twice[v]);
      for (std::size_t i = 0; i < 4; ++i) q[i] = 0.5 * (q[i] + other[i]);
      tube.state[v] = solver::state_of(Gas{gamma}, q);
    }
  }
  tube.after = totals(residual.plan(), tube.state);
  return tube;
}

double mean_density_error(const Tube& tube, const Gases& gases = sod) {
  const RiemannSolution exact(gases.left, gases.right);
  double sum = 0;
  for (const VertexId v : tube.state.ids())
    sum += std::abs(tube.state[v].rho - exact.at((tube.mesh.points[v].x - 0.5) / gases.end_time).rho);
  return sum / static_cast<double>(tube.state.size());
}

TEST_CASE("the_exact_riemann_solution_has_the_published_pressure_and_velocity") {
  const RiemannSolution exact(driver, driven);  // Toro, table 4.2, test 1
  CHECK(exact.pressure() == doctest::Approx(0.30313).epsilon(1e-5));
  CHECK(exact.velocity() == doctest::Approx(0.92745).epsilon(1e-5));
  CHECK(exact.at(exact.velocity() - 1e-9).rho == doctest::Approx(0.42632).epsilon(1e-5));
  CHECK(exact.at(exact.velocity() + 1e-9).rho == doctest::Approx(0.26557).epsilon(1e-5));
  const RiemannSolution thin(parting.left, parting.right);  // test 2
  CHECK(thin.pressure() == doctest::Approx(0.00189).epsilon(5e-3));
  CHECK(std::abs(thin.velocity()) < 1e-9);
  CHECK(thin.at(1e-6).rho == doctest::Approx(0.02185).epsilon(5e-4));
  CHECK(thin.at(-2.8).u == -2);
}

TEST_CASE("sods_shock_tube_as_a_strip_converges_to_the_exact_solution_and_conserves") {
  const Tube coarse = run_tube(50, 2), fine = run_tube(100, 2);
  for (const std::size_t i : {0u, 3u})  // mass and energy; momentum is the walls' business
    CHECK(fine.after[i] == doctest::Approx(fine.before[i]).epsilon(1e-12));
  const double coarse_error = mean_density_error(coarse), fine_error = mean_density_error(fine);
  MESSAGE("mean density errors " << coarse_error << " " << fine_error);
  CHECK(fine_error < 0.6 * coarse_error);  // first order at a shock
  CHECK(fine_error < 0.008);
  CHECK(mean_density_error(run_tube(100, 1)) > 1.5 * fine_error);
  // No new extremes: the density stays between the driver's and the driven gas' shocked and unshocked ones.
  for (const State<2>& w : fine.state) {
    CHECK(w.rho < 1.01);
    CHECK(w.rho > 0.12);
  }
}

TEST_CASE("sods_shock_tube_converges_with_every_flux") {
  for (const FluxKind flux :
       {FluxKind::roe_low_mach, FluxKind::hllc, FluxKind::hllc_low_mach, FluxKind::ausm_plus_up,
        FluxKind::rusanov, FluxKind::van_leer, FluxKind::kep_scalar, FluxKind::kep_matrix}) {
    CAPTURE(to_string(flux));
    const double coarse_error = mean_density_error(run_tube(50, 2, flux)),
                 fine_error = mean_density_error(run_tube(100, 2, flux));
    MESSAGE("mean density errors " << coarse_error << " " << fine_error);
    CHECK(fine_error < 0.65 * coarse_error);
    CHECK(fine_error < 0.01);
  }
}

TEST_CASE("gases_that_part_nearly_to_a_vacuum_stay_physical_with_rusanov_and_hllc") {
  for (const FluxKind flux : {FluxKind::rusanov, FluxKind::hllc}) {
    CAPTURE(to_string(flux));
    const Tube coarse = run_tube(50, 1, flux, parting), fine = run_tube(100, 1, flux, parting);
    for (const State<2>& w : fine.state) REQUIRE(solver::is_physical(w));
    const double coarse_error = mean_density_error(coarse, parting),
                 fine_error = mean_density_error(fine, parting);
    MESSAGE("mean density errors " << coarse_error << " " << fine_error);
    CHECK(fine_error < 0.8 * coarse_error);
    CHECK(fine_error < 0.05);
  }
}

TEST_CASE("a_strip_of_the_plane_keeps_a_flow_along_it_one_dimensional") {
  const Tube tube = run_tube(50, 2);
  double across = 0;
  for (const State<2>& w : tube.state) across = std::max(across, std::abs(w.v));
  CHECK(across < 0.02);  // the diagonals are not symmetric about the middle
}

}  // namespace
