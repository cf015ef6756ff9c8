// SPDX-License-Identifier: MIT
#include "leonhard/solver/flux/jacobian.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <type_traits>

#include "leonhard/solver/flux/flux.hpp"
#include "leonhard/solver/gas.hpp"

namespace {

using namespace leonhard;
using Block = solver::Block<2, double>;
using Side = solver::Primitive<2, double>;
using Normal = solver::Vector<2, double>;

constexpr solver::FluxConstants constants{1.4, 0.05, 0.3};

class Sampler {
 public:
  Side state() { return {0.2 + 2 * unit(), {{3 * unit() - 1.5, 3 * unit() - 1.5}}, 0.2 + unit()}; }
  Normal normal() {
    const double angle = 6.3 * unit();
    return {{std::cos(angle), std::sin(angle)}};
  }
  double unit() { return spread_(random_); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> spread_{0, 1};
};

Side from_conserved(const solver::Components<2, double>& q) {
  const State<2> w = solver::state_of(Gas{1.4}, solver::Conserved<2>{q.e[0], q.e[1], q.e[2], q.e[3]});
  return {w.rho, {{w.u, w.v}}, w.p};
}

solver::Components<2, double> to_conserved(const Side& w) { return solver::conserved(1.4, w); }

TEST_CASE("euler_jacobian_is_the_derivative_of_the_flux") {
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const Side w = sample.state();
    const Normal n = sample.normal();
    Block exact{};
    solver::euler_jacobian(1.4, w, n).add_to(exact, 1.0);
    for (std::size_t j = 0; j < 4; ++j) {
      auto up = to_conserved(w), down = up;
      up.e[j] += 1e-6, down.e[j] -= 1e-6;
      const auto f = solver::euler_flux(1.4, from_conserved(up), n);
      const auto g = solver::euler_flux(1.4, from_conserved(down), n);
      for (int k = 0; k < 4; ++k) CHECK(std::abs((f.e[k] - g.e[k]) / 2e-6 - exact.m[k][j]) < 2e-6);
    }
  }
}

TEST_CASE_TEMPLATE_DEFINE("jacobians_are_derivatives_of_the_flux_where_the_states_agree", Kind, agreeing) {
  // The dissipation is held fixed in them; at equal states its derivative is multiplied by zero.
  constexpr FluxKind kind = Kind::value;
  Sampler sample;
  for (int i = 0; i < 20; ++i) {
    const Side w = sample.state();
    const Normal n = sample.normal();
    Block by_a, by_b;
    solver::flux_jacobians<kind>(constants, w, w, n, by_a, by_b);
    for (std::size_t j = 0; j < 4; ++j) {
      auto up = to_conserved(w), down = up;
      up.e[j] += 1e-6, down.e[j] -= 1e-6;
      const Side high = from_conserved(up), low = from_conserved(down);
      const auto fa = solver::flux<kind>(constants, high, w, n),
                 ga = solver::flux<kind>(constants, low, w, n);
      const auto fb = solver::flux<kind>(constants, w, high, n),
                 gb = solver::flux<kind>(constants, w, low, n);
      for (int k = 0; k < 4; ++k) {
        CHECK(std::abs((fa.e[k] - ga.e[k]) / 2e-6 - by_a.m[k][j]) < 2e-6);
        CHECK(std::abs((fb.e[k] - gb.e[k]) / 2e-6 - by_b.m[k][j]) < 2e-6);
      }
    }
  }
}
TEST_CASE_TEMPLATE_INVOKE(agreeing, std::integral_constant<FluxKind, FluxKind::roe>,
                          std::integral_constant<FluxKind, FluxKind::rusanov>);

TEST_CASE("low_mach_jacobians_lie_between_those_of_the_low_mach_flux_and_of_roes") {
  // A jump of the normal velocity in slow flow: how strongly the flux of momentum resists it.
  const double mach = 0.01;
  const solver::FluxConstants slow{1.4, 0, mach};
  const Side w{1, {{0, mach}}, 1 / 1.4};
  const auto resists = [&](double momentum_by_a, double momentum_by_b) { return momentum_by_a - momentum_by_b; };
  Block roe_a, roe_b, low_a, low_b;
  solver::flux_jacobians<FluxKind::roe>(slow, w, w, {{1, 0}}, roe_a, roe_b);
  solver::flux_jacobians<FluxKind::roe_low_mach>(slow, w, w, {{1, 0}}, low_a, low_b);
  CHECK(resists(roe_a.m[1][1], roe_b.m[1][1]) == doctest::Approx(1));
  CHECK(resists(low_a.m[1][1], low_b.m[1][1]) == doctest::Approx(std::sqrt(mach)));
}

}  // namespace
