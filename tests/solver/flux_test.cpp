// SPDX-License-Identifier: MIT
#include "leonhard/solver/flux/flux.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

// What every flux must have, and what some of them are chosen for.

namespace {

using namespace leonhard;
using solver::Components;
using solver::FluxConstants;
using solver::Lanes;
using solver::Primitive;
using solver::Vector;

constexpr FluxConstants usual{1.4, 0.05, 0.3}, unfixed{1.4, 0, 0.3};
constexpr FluxKind every_flux[] = {FluxKind::roe,           FluxKind::roe_low_mach, FluxKind::hllc,
                                   FluxKind::hllc_low_mach, FluxKind::ausm_plus_up, FluxKind::rusanov,
                                   FluxKind::van_leer,      FluxKind::kep_scalar,   FluxKind::kep_matrix};

template <int dim, class T = double>
Components<dim, T> flux_of(FluxKind kind, const FluxConstants& k, const Primitive<dim, T>& a,
                           const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  Components<dim, T> f{};
  solver::with_flux(kind, [&]<FluxKind chosen>() { f = solver::flux<chosen>(k, a, b, n); });
  return f;
}

class Sampler {
 public:
  double in(double low, double high) { return low + (high - low) * spread_(random_); }
  template <int dim>
  Primitive<dim, double> state(double fastest = 1.5) {
    Primitive<dim, double> w{in(0.2, 2.2), {}, in(0.2, 1.2)};
    for (double& speed : w.velocity.e) speed = in(-fastest, fastest);
    return w;
  }
  /// Density and pressure over several powers of ten, Mach numbers up to 10.
  Primitive<2, double> extreme_state() {
    Primitive<2, double> w{std::pow(10, in(-2, 2)), {}, std::pow(10, in(-2, 2))};
    const double c = solver::sound_speed(1.4, w);
    for (double& speed : w.velocity.e) speed = in(-10, 10) * c;
    return w;
  }
  Vector<2, double> normal2() {
    const double angle = in(0, 6.3);
    return {{std::cos(angle), std::sin(angle)}};
  }
  Vector<3, double> normal3() {
    const double z = in(-1, 1), angle = in(0, 6.3), r = std::sqrt(1 - z * z);
    return {{r * std::cos(angle), r * std::sin(angle), z}};
  }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> spread_{0, 1};
};

/// Turned about an axis of space by an angle.
Vector<3, double> turned(const Vector<3, double>& v, std::size_t axis, double angle) {
  Vector<3, double> t = v;
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  t.e[i] = std::cos(angle) * v.e[i] - std::sin(angle) * v.e[j];
  t.e[j] = std::sin(angle) * v.e[i] + std::cos(angle) * v.e[j];
  return t;
}

TEST_CASE("a_flux_between_equal_states_is_the_physical_one") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const auto w = sample.state<3>();
    const auto n = sample.normal3();
    const auto exact = solver::euler_flux(1.4, w, n);
    for (const FluxKind kind : every_flux) {
      CAPTURE(to_string(kind));
      const auto f = flux_of(kind, usual, w, w, n);
      for (int j = 0; j < 5; ++j) CHECK(std::abs(f.e[j] - exact.e[j]) < 1e-13);
    }
  }
}

TEST_CASE("fluxes_turn_with_space") {
  Sampler sample;
  for (int i = 0; i < 60; ++i) {
    const auto a = sample.state<3>(), b = sample.state<3>();
    const auto n = sample.normal3();
    const auto axis = static_cast<std::size_t>(i % 3);
    const double angle = sample.in(0, 6.3);
    auto a_turned = a, b_turned = b;
    a_turned.velocity = turned(a.velocity, axis, angle), b_turned.velocity = turned(b.velocity, axis, angle);
    for (const FluxKind kind : every_flux) {
      CAPTURE(to_string(kind));
      const auto f = flux_of(kind, usual, a, b, n),
                 g = flux_of(kind, usual, a_turned, b_turned, turned(n, axis, angle));
      const Vector<3, double> momentum = turned({{f.e[1], f.e[2], f.e[3]}}, axis, angle);
      CHECK(std::abs(g.e[0] - f.e[0]) < 2e-13);
      for (int j = 0; j < 3; ++j) CHECK(std::abs(g.e[1 + j] - momentum.e[j]) < 2e-13);
      CHECK(std::abs(g.e[4] - f.e[4]) < 1e-12);
    }
  }
}

TEST_CASE("a_flux_seen_from_the_other_side_is_its_negative") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const auto a = sample.state<2>(3), b = sample.state<2>(3);
    const auto n = sample.normal2();
    for (const FluxKind kind : every_flux) {
      CAPTURE(to_string(kind));
      const auto f = flux_of(kind, usual, a, b, n), g = flux_of(kind, usual, b, a, {{-n.e[0], -n.e[1]}});
      for (int j = 0; j < 4; ++j) CHECK(std::abs(f.e[j] + g.e[j]) < 1e-12);
    }
  }
}

TEST_CASE("a_flux_of_the_plane_is_that_of_space_without_the_third_axis") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const auto a = sample.state<2>(3), b = sample.state<2>(3);
    const auto n = sample.normal2();
    const auto lifted = [](const Vector<2, double>& v) { return Vector<3, double>{{v.e[0], v.e[1], 0}}; };
    for (const FluxKind kind : every_flux) {
      CAPTURE(to_string(kind));
      const auto f = flux_of(kind, usual, a, b, n);
      const auto g = flux_of<3>(kind, usual, {a.rho, lifted(a.velocity), a.p},
                                {b.rho, lifted(b.velocity), b.p}, lifted(n));
      for (int j = 0; j < 3; ++j) CHECK(f.e[j] == g.e[j]);
      CHECK(g.e[3] == 0);
      CHECK(f.e[3] == g.e[4]);
    }
  }
}

TEST_CASE("four_fluxes_at_once_are_the_single_ones_to_the_bit") {
  Sampler sample;
  for (int i = 0; i < 25; ++i) {
    Primitive<2, double> a[4], b[4];
    Vector<2, double> n[4];
    Primitive<2, Lanes> va{}, vb{};
    Vector<2, Lanes> vn{};
    for (int l = 0; l < 4; ++l) {
      a[l] = sample.state<2>(3), b[l] = sample.state<2>(3), n[l] = sample.normal2();
      va.rho[l] = a[l].rho, va.p[l] = a[l].p, vb.rho[l] = b[l].rho, vb.p[l] = b[l].p;
      for (int j = 0; j < 2; ++j) {
        va.velocity.e[j][l] = a[l].velocity.e[j], vb.velocity.e[j][l] = b[l].velocity.e[j];
        vn.e[j][l] = n[l].e[j];
      }
    }
    for (const FluxKind kind : every_flux) {
      CAPTURE(to_string(kind));
      Components<2, Lanes> f{};
      solver::with_flux(kind, [&]<FluxKind chosen>() { f = solver::flux<chosen>(usual, va, vb, vn); });
      for (int l = 0; l < 4; ++l) {
        const auto single = flux_of(kind, usual, a[l], b[l], n[l]);
        for (int j = 0; j < 4; ++j) {
          const double lane = f.e[j][l];
          CHECK(lane == single.e[j]);
        }
      }
    }
  }
}

TEST_CASE("a_contact_at_rest_is_kept_by_the_fluxes_that_know_contacts_and_smeared_by_the_others") {
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const auto n = sample.normal2();
    const Primitive<2, double> a{1.3, {{0, 0}}, 0.7}, b{0.4, {{0, 0}}, 0.7};
    for (const FluxKind kind : {FluxKind::roe, FluxKind::roe_low_mach, FluxKind::hllc,
                                FluxKind::hllc_low_mach, FluxKind::ausm_plus_up, FluxKind::kep_matrix}) {
      CAPTURE(to_string(kind));
      const auto f = flux_of(kind, unfixed, a, b, n);
      CHECK(std::abs(f.e[0]) < 1e-15);
      for (int j = 0; j < 2; ++j) CHECK(std::abs(f.e[1 + j] - 0.7 * n.e[j]) < 1e-15);
      CHECK(std::abs(f.e[3]) < 1e-15);
    }
    for (const FluxKind kind : {FluxKind::rusanov, FluxKind::van_leer, FluxKind::kep_scalar})
      CHECK(std::abs(flux_of(kind, unfixed, a, b, n).e[0]) > 0.1);
  }
}

TEST_CASE("a_shear_layer_with_a_jump_of_density_is_kept_likewise") {
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const auto n = sample.normal2();
    const Primitive<2, double> a{1.3, {{-n.e[1], n.e[0]}}, 0.7}, b{0.4, {{0.5 * n.e[1], -0.5 * n.e[0]}}, 0.7};
    for (const FluxKind kind : {FluxKind::roe, FluxKind::roe_low_mach, FluxKind::hllc,
                                FluxKind::hllc_low_mach, FluxKind::ausm_plus_up}) {
      CAPTURE(to_string(kind));
      const auto f = flux_of(kind, unfixed, a, b, n);
      CHECK(std::abs(f.e[0]) < 1e-15);
      for (int j = 0; j < 2; ++j) CHECK(std::abs(f.e[1 + j] - 0.7 * n.e[j]) < 1e-15);
    }
  }
}

TEST_CASE("supersonic_flow_is_upwind_and_a_shock_at_rest_stays") {
  const Primitive<2, double> fast{1, {{2.5, 0.1}}, 0.7}, faster{1.1, {{2.8, 0}}, 0.75};
  for (const FluxKind kind :
       {FluxKind::roe, FluxKind::roe_low_mach, FluxKind::hllc, FluxKind::ausm_plus_up, FluxKind::van_leer}) {
    CAPTURE(to_string(kind));
    const auto f = flux_of(kind, unfixed, fast, faster, {{1, 0}}),
               exact = solver::euler_flux(1.4, fast, {{1, 0}});
    for (int j = 0; j < 4; ++j) CHECK(std::abs(f.e[j] - exact.e[j]) < 1e-13);
  }
  // Rankine-Hugoniot at Mach 2 (NACA report 1135): pressures as 1 to 4.5, densities as 3 to 8.
  const Primitive<2, double> ahead{1, {{2, 0}}, 1 / 1.4}, behind{8.0 / 3, {{0.75, 0}}, 4.5 / 1.4};
  for (const FluxKind kind :
       {FluxKind::roe, FluxKind::roe_low_mach, FluxKind::hllc, FluxKind::hllc_low_mach}) {
    CAPTURE(to_string(kind));
    const auto f = flux_of(kind, unfixed, ahead, behind, {{1, 0}}),
               exact = solver::euler_flux(1.4, ahead, {{1, 0}});
    for (int j = 0; j < 4; ++j) CHECK(std::abs(f.e[j] - exact.e[j]) < 1e-13);
  }
}

/// The least of density and pressure in the middle of three cells after the longest stable step of first order.
double least_after_step(FluxKind kind, const Primitive<2, double>& left, const Primitive<2, double>& middle,
                        const Primitive<2, double>& right) {
  const Vector<2, double> n{{1, 0}};
  double speed = 0;
  for (const auto& w : {left, middle, right})
    speed = std::max(speed, std::abs(w.velocity.e[0]) + solver::sound_speed(1.4, w));
  for (const auto* pair : {&left, &right}) {
    const auto mean = solver::roe_waves(usual, *pair, middle, n, 1.0);
    speed = std::max(speed, std::abs(mean.normal_speed) + 1 / mean.inverse_c);
  }
  const auto in = flux_of(kind, usual, left, middle, n), out = flux_of(kind, usual, middle, right, n);
  auto q = solver::conserved(1.4, middle);
  for (int j = 0; j < 4; ++j) q.e[j] -= 0.5 / speed * (out.e[j] - in.e[j]);
  return std::min(q.e[0], 0.4 * (q.e[3] - 0.5 * (q.e[1] * q.e[1] + q.e[2] * q.e[2]) / q.e[0]));
}

TEST_CASE("density_and_pressure_stay_positive_in_a_first_order_step_with_rusanov_and_hllc") {
  Sampler sample;
  // The "1-2-3" problem of B. Einfeldt et al., Journal of Computational Physics 92, 1991: two gases that part.
  const Primitive<2, double> left{1, {{-2, 0}}, 0.4}, right{1, {{2, 0}}, 0.4};
  for (const FluxKind kind : {FluxKind::rusanov, FluxKind::hllc}) {
    CAPTURE(to_string(kind));
    CHECK(least_after_step(kind, left, left, right) > 0);
    CHECK(least_after_step(kind, left, right, right) > 0);
    for (int i = 0; i < 5000; ++i) {
      const auto a = sample.extreme_state(), b = sample.extreme_state(), c = sample.extreme_state();
      CHECK(least_after_step(kind, a, b, c) > 0);
    }
  }
}

/// The derivatives of -rho s / (gamma - 1) by the conservative variables.
Components<2, double> entropy_variables(const Primitive<2, double>& w) {
  const double beta = w.rho / (2 * w.p), s = std::log(w.p) - 1.4 * std::log(w.rho);
  return {{(1.4 - s) / 0.4 - beta * solver::dot(w.velocity, w.velocity), 2 * beta * w.velocity.e[0],
           2 * beta * w.velocity.e[1], -2 * beta}};
}

/// (v_b - v_a) F - (psi_b - psi_a), v the entropy variables, psi = rho Vn: not positive where the flux makes entropy
/// (E. Tadmor, Mathematics of Computation 49, 1987).
double entropy_lost(const Components<2, double>& f, const Primitive<2, double>& a,
                    const Primitive<2, double>& b, const Vector<2, double>& n) {
  double sum = 0;
  for (const auto& [w, sign] : {std::pair{b, 1.0}, std::pair{a, -1.0}}) {
    const Components<2, double> v = entropy_variables(w);
    for (int j = 0; j < 4; ++j) sum += sign * v.e[j] * f.e[j];
    sum -= sign * w.rho * solver::dot(w.velocity, n);
  }
  return sum;
}

TEST_CASE("the_central_flux_keeps_entropy_and_the_dissipations_make_it") {
  Sampler sample;
  for (int i = 0; i < 2000; ++i) {
    const auto a = sample.state<2>(3), b = sample.state<2>(3);
    const auto n = sample.normal2();
    const auto central = solver::kep_central(1.4, solver::kep_means(a, b), n);
    CHECK(std::abs(entropy_lost(central, a, b, n)) < 1e-12);
    for (const FluxKind kind : {FluxKind::kep_scalar, FluxKind::kep_matrix, FluxKind::rusanov}) {
      CAPTURE(to_string(kind));
      CHECK(entropy_lost(flux_of(kind, unfixed, a, b, n), a, b, n) < 1e-12);
    }
  }
}

TEST_CASE("the_jump_before_the_dissipation_is_a_symmetric_matrix_times_the_jump_of_the_entropy_variables") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const auto a = sample.state<2>(3), b = sample.state<2>(3);
    const solver::KepMeans<2, double> m = solver::kep_means(a, b);
    // Derivatives of the conservative variables by the entropy variables: T. J. Barth, Lecture Notes in Computational
    // Science and Engineering 5, 1999, for the mean state of density rho_log and pressure rho_log / (2 beta_log).
    const double rho = m.rho_log, p = rho / (2 * m.beta_log), u = m.velocity.e[0], v = m.velocity.e[1];
    const double energy = p / 0.4 + 0.5 * rho * (u * u + v * v), h = (energy + p) / rho;
    const double matrix[4][4] = {{rho, rho * u, rho * v, energy},
                                 {rho * u, rho * u * u + p, rho * u * v, rho * h * u},
                                 {rho * v, rho * u * v, rho * v * v + p, rho * h * v},
                                 {energy, rho * h * u, rho * h * v, rho * h * h - 1.4 * p / rho * p / 0.4}};
    const auto va = entropy_variables(a), vb = entropy_variables(b);
    const auto n = sample.normal2();
    const solver::KepJump<2, double> jump = solver::kep_jump(1.4, m, n);
    double expected[4] = {};
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) expected[r] += matrix[r][c] * (vb.e[c] - va.e[c]);
    for (int r = 0; r < 4; ++r) CHECK(jump.conserved.e[r] == doctest::Approx(expected[r]).epsilon(1e-10));
    const double* e = expected;
    CHECK(jump.n == doctest::Approx((e[1] - u * e[0]) * n.e[0] + (e[2] - v * e[0]) * n.e[1]).epsilon(1e-10));
    CHECK(jump.p ==
          doctest::Approx(0.4 * (e[3] - u * e[1] - v * e[2] + 0.5 * (u * u + v * v) * e[0])).epsilon(1e-10));
  }
}

TEST_CASE("the_central_flux_carries_momentum_at_the_mean_velocity_as_a_flux_that_keeps_kinetic_energy_must") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const auto a = sample.state<2>(), b = sample.state<2>();
    const auto n = sample.normal2();
    const auto f = solver::kep_central(1.4, solver::kep_means(a, b), n);
    // What is left of the momentum is a pressure, along the normal.
    const double rest[2] = {f.e[1] - 0.5 * f.e[0] * (a.velocity.e[0] + b.velocity.e[0]),
                            f.e[2] - 0.5 * f.e[0] * (a.velocity.e[1] + b.velocity.e[1])};
    CHECK(std::abs(rest[0] * n.e[1] - rest[1] * n.e[0]) < 1e-15);
    CHECK(rest[0] * n.e[0] + rest[1] * n.e[1] >= std::min(a.p, b.p) * (1 - 1e-15));
  }
}

TEST_CASE("ausm_plus_up_lets_a_pressure_drive_gas_at_rest_as_published") {
  // Liou 2006: mass flux = K_p / f_a times the pressure's jump over the critical speed of sound.
  const FluxConstants k{1.4, 0, 0.1};
  const auto f = flux_of<2>(FluxKind::ausm_plus_up, k, {1, {{0, 0}}, 0.7}, {1, {{0, 0}}, 0.71}, {{1, 0}});
  const double c = std::sqrt(2.8 / 2.4 * 0.7), f_a = 0.1 * (2 - 0.1);
  CHECK(f.e[0] == doctest::Approx(-0.25 / f_a * 0.01 / c).epsilon(1e-12));
}

TEST_CASE("logarithmic_mean_is_that_of_the_logarithm") {
  for (const double ratio : {1 + 1e-3, 1.5, 7.0, 100.0, 1000.0}) {
    const long double exact =
        (static_cast<long double>(ratio) - 1) / std::log(static_cast<long double>(ratio));
    CHECK(solver::logarithmic_mean(3 * ratio, 3.0) ==
          doctest::Approx(static_cast<double>(3 * exact)).epsilon(1e-14));
    CHECK(solver::logarithmic_mean(3.0, 3 * ratio) ==
          doctest::Approx(static_cast<double>(3 * exact)).epsilon(1e-14));
  }
  CHECK(solver::logarithmic_mean(0.7, 0.7) == 0.7);
  CHECK(solver::logarithmic_mean(1e6, 1.0) == doctest::Approx(999999 / std::log(1e6)).epsilon(1e-9));
}

/// How much a jump of the normal velocity by the Mach number itself moves the pressure, over rho |V|^2.
double pressure_error(FluxKind kind, double mach) {
  const FluxConstants k{1.4, 0.05, mach};
  const Primitive<2, double> a{1, {{0.5 * mach, mach}}, 1 / 1.4}, b{1, {{1.5 * mach, mach}}, 1 / 1.4};
  const auto f = flux_of(kind, k, a, b, {{1, 0}}), fa = solver::euler_flux(1.4, a, {{1, 0}}),
             fb = solver::euler_flux(1.4, b, {{1, 0}});
  return std::abs(f.e[1] - 0.5 * (fa.e[1] + fb.e[1])) / (mach * mach);
}

TEST_CASE("low_mach_fluxes_have_an_error_of_pressure_that_does_not_grow_as_the_flow_slows_down") {
  for (const FluxKind kind : {FluxKind::roe_low_mach, FluxKind::hllc_low_mach, FluxKind::ausm_plus_up}) {
    CAPTURE(to_string(kind));
    for (const double mach : {1e-1, 1e-2, 1e-3}) CHECK(pressure_error(kind, mach) < 3);
  }
  for (const FluxKind kind : {FluxKind::roe, FluxKind::hllc})
    CHECK(pressure_error(kind, 1e-3) > 50 * pressure_error(kind, 1e-1));
}

TEST_CASE("a_supersonic_free_stream_leaves_the_low_mach_fluxes_as_the_plain_ones") {
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const auto a = sample.state<2>(), b = sample.state<2>();
    const auto n = sample.normal2();
    const FluxConstants k{1.4, 0.05, 1};
    const auto roe = flux_of(FluxKind::roe, k, a, b, n), other = flux_of(FluxKind::roe_low_mach, k, a, b, n);
    for (int j = 0; j < 4; ++j) CHECK(roe.e[j] == other.e[j]);
  }
}

}  // namespace
