// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/flux_roe.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "leonhard/solver/gas.hpp"

namespace {

using namespace leonhard;
using solver::Block;
using solver::Four;
using solver::Lanes;
using Side = solver::Primitive<double>;

constexpr solver::RoeConstants roe{1.4, 0.05};

class Sampler {
 public:
  Side state() { return {0.2 + 2 * unit(), 3 * unit() - 1.5, 3 * unit() - 1.5, 0.2 + unit()}; }
  double angle() { return 6.3 * unit(); }
  double unit() { return spread_(random_); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> spread_{0, 1};
};

Side turned(const Side& w, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {w.rho, c * w.u - s * w.v, s * w.u + c * w.v, w.p};
}

Side from_conserved(const solver::Conserved& q) {
  const State w = solver::state_of({1.4}, q);
  return {w.rho, w.u, w.v, w.p};
}

solver::Conserved to_conserved(const Side& w) { return solver::conserved_of({1.4}, {w.rho, w.u, w.v, w.p}); }

TEST_CASE("roe_flux_of_equal_states_is_the_physical_flux") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const Side w = sample.state();
    const double a = sample.angle(), nx = std::cos(a), ny = std::sin(a);
    const auto roe_flux = solver::flux_roe<double>(roe, w, w, nx, ny),
               exact = solver::euler_flux<double>(1.4, w, nx, ny);
    for (int k = 0; k < 4; ++k) CHECK(roe_flux.e[k] == doctest::Approx(exact.e[k]).epsilon(1e-14));
  }
}

TEST_CASE("roe_flux_turns_with_the_plane") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const Side a = sample.state(), b = sample.state();
    const double at = sample.angle(), by = sample.angle();
    const auto f = solver::flux_roe<double>(roe, a, b, std::cos(at), std::sin(at));
    const auto g =
        solver::flux_roe<double>(roe, turned(a, by), turned(b, by), std::cos(at + by), std::sin(at + by));
    const double c = std::cos(by), s = std::sin(by);
    CHECK(std::abs(g.e[0] - f.e[0]) < 1e-13);
    CHECK(std::abs(g.e[1] - (c * f.e[1] - s * f.e[2])) < 1e-13);
    CHECK(std::abs(g.e[2] - (s * f.e[1] + c * f.e[2])) < 1e-13);
    CHECK(std::abs(g.e[3] - f.e[3]) < 1e-13);
  }
}

TEST_CASE("roe_flux_seen_from_the_other_side_is_its_negative") {
  Sampler sample;
  for (int i = 0; i < 50; ++i) {
    const Side a = sample.state(), b = sample.state();
    const double at = sample.angle(), nx = std::cos(at), ny = std::sin(at);
    const auto f = solver::flux_roe<double>(roe, a, b, nx, ny),
               g = solver::flux_roe<double>(roe, b, a, -nx, -ny);
    for (int k = 0; k < 4; ++k) CHECK(std::abs(f.e[k] + g.e[k]) < 1e-13);
  }
}

TEST_CASE("roe_flux_is_upwind_in_supersonic_flow") {
  const Side a{1, 2.5, 0.1, 0.7}, b{1.1, 2.4, 0, 0.75};
  const auto f = solver::flux_roe<double>({1.4, 0}, a, b, 1, 0),
             exact = solver::euler_flux<double>(1.4, a, 1, 0);
  for (int k = 0; k < 4; ++k) CHECK(f.e[k] == doctest::Approx(exact.e[k]).epsilon(1e-13));
}

TEST_CASE("roe_flux_keeps_a_stationary_shock") {
  // Rankine-Hugoniot at Mach 2 (references: NACA report 1135): Roe's matrix recognises it, without the entropy fix.
  const Side ahead{1, 2, 0, 1 / 1.4};
  const double ratio_p = 4.5, ratio_rho = 2.6666666666666667;
  const Side behind{ratio_rho, 2 / ratio_rho, 0, ratio_p / 1.4};
  const auto f = solver::flux_roe<double>({1.4, 0}, ahead, behind, 1, 0),
             exact = solver::euler_flux<double>(1.4, ahead, 1, 0);
  for (int k = 0; k < 4; ++k) CHECK(std::abs(f.e[k] - exact.e[k]) < 1e-13);
}

TEST_CASE("euler_jacobian_is_the_derivative_of_the_flux") {
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const Side w = sample.state();
    const double at = sample.angle(), nx = std::cos(at), ny = std::sin(at);
    Block<double> exact{};
    solver::euler_jacobian<double>(1.4, w, nx, ny).add_to(exact, 1.0);
    for (std::size_t j = 0; j < 4; ++j) {
      auto up = to_conserved(w), down = up;
      up[j] += 1e-6, down[j] -= 1e-6;
      const auto f = solver::euler_flux<double>(1.4, from_conserved(up), nx, ny);
      const auto g = solver::euler_flux<double>(1.4, from_conserved(down), nx, ny);
      for (int k = 0; k < 4; ++k) CHECK(std::abs((f.e[k] - g.e[k]) / 2e-6 - exact.m[k][j]) < 1e-6);
    }
  }
}

TEST_CASE("roe_jacobians_are_derivatives_of_the_flux_where_the_states_agree") {
  // Roe's matrix is held fixed in them; at equal states its derivative is multiplied by zero.
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const Side w = sample.state();
    const double at = sample.angle(), nx = std::cos(at), ny = std::sin(at);
    Block<double> by_a, by_b;
    solver::flux_roe_jacobians<double>(roe, w, w, nx, ny, by_a, by_b);
    for (std::size_t j = 0; j < 4; ++j) {
      auto up = to_conserved(w), down = up;
      up[j] += 1e-6, down[j] -= 1e-6;
      const Side high = from_conserved(up), low = from_conserved(down);
      const auto fa = solver::flux_roe<double>(roe, high, w, nx, ny),
                 ga = solver::flux_roe<double>(roe, low, w, nx, ny);
      const auto fb = solver::flux_roe<double>(roe, w, high, nx, ny),
                 gb = solver::flux_roe<double>(roe, w, low, nx, ny);
      for (int k = 0; k < 4; ++k) {
        CHECK(std::abs((fa.e[k] - ga.e[k]) / 2e-6 - by_a.m[k][j]) < 1e-6);
        CHECK(std::abs((fb.e[k] - gb.e[k]) / 2e-6 - by_b.m[k][j]) < 1e-6);
      }
    }
  }
}

TEST_CASE("four_fluxes_at_once_are_the_single_ones_to_the_bit") {
  Sampler sample;
  Side a[4], b[4];
  Lanes nx{}, ny{};
  solver::Primitive<Lanes> va{}, vb{};
  for (int l = 0; l < 4; ++l) {
    a[l] = sample.state(), b[l] = sample.state();
    const double at = sample.angle();
    nx[l] = std::cos(at), ny[l] = std::sin(at);
    va.rho[l] = a[l].rho, va.u[l] = a[l].u, va.v[l] = a[l].v, va.p[l] = a[l].p;
    vb.rho[l] = b[l].rho, vb.u[l] = b[l].u, vb.v[l] = b[l].v, vb.p[l] = b[l].p;
  }
  const Four<Lanes> f = solver::flux_roe<Lanes>(roe, va, vb, nx, ny);
  for (int l = 0; l < 4; ++l) {
    const double x = nx[l], y = ny[l];
    const auto single = solver::flux_roe<double>(roe, a[l], b[l], x, y);
    for (int k = 0; k < 4; ++k) CHECK(f.e[k][l] == single.e[k]);
  }
}

}  // namespace
