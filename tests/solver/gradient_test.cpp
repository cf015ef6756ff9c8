// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>

#include "leonhard/solver/gas.hpp"
#include "leonhard/solver/sweep/edge_plan.hpp"
#include "leonhard/solver/sweep/limiter.hpp"
#include "tests/solver/meshes.hpp"

namespace {

using namespace leonhard;
using solver::EdgePlan;

std::vector<double> gradients(const EdgePlan<2>& plan, const PerId<VertexId, State<2>>& state,
                              LimiterKind limiter) {
  std::vector<double> gradient(8 * plan.vertex_count), scale2(plan.vertex_count, 1e-12);
  const solver::SweepSettings settings{.limiter = limiter, .limiter_scale2 = scale2.data(), .limiter_scale3 = scale2.data()};
  for (const solver::PartRange& part : plan.parts)
    solver::best_sweep<2>().limited_gradients(plan.view(), part, settings, &state.flat().front().rho,
                                           gradient.data(), nullptr);
  return gradient;
}

TEST_CASE("gradients_of_both_kinds_are_exact_for_linear_functions_on_triangles") {
  const TriangleMesh mesh = test::shaken_square(12, 0.3, 3);
  PerId<VertexId, State<2>> state, bent;
  for (const Point2 p : mesh.points) {
    state.push_back({2 + 2 * p.x - p.y, 3 * p.y, -p.x + 0.5 * p.y, 7 - p.x});
    bent.push_back({1 + p.x * p.x, p.x * p.y, p.y * p.y, 1});
  }
  const double by_x[4] = {2, 0, -1, -1}, by_y[4] = {-1, 3, 0.5, 0};
  std::vector<std::vector<double>> of_bent;
  for (const GradientKind kind : {GradientKind::least_squares, GradientKind::green_gauss}) {
    const EdgePlan<2> plan = solver::make_edge_plan<2>(mesh::build_dual(mesh), {}, 0, kind);
    const auto g = gradients(plan, state, LimiterKind::none);
    of_bent.push_back(gradients(plan, bent, LimiterKind::none));
    for (std::size_t v = 0; v < plan.vertex_count; ++v)
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(std::abs(g[8 * v + i] - by_x[i]) < 1e-12);
        CHECK(std::abs(g[8 * v + 4 + i] - by_y[i]) < 1e-12);
      }
  }
  CHECK(std::abs(of_bent[0][8 * 84] - of_bent[1][8 * 84]) > 1e-6);  // in the middle; at the corner both are least squares
  CHECK(of_bent[0][0] == of_bent[1][0]);
}

TEST_CASE("barth_jespersen_keeps_values_at_edge_midpoints_within_the_range_of_the_neighbours") {
  const TriangleMesh mesh = test::shaken_square(12, 0.3, 4);
  const EdgePlan<2> plan = solver::make_edge_plan<2>(mesh::build_dual(mesh));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0.5, 1.5);
  PerId<VertexId, State<2>> state;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
    state.push_back({any(random), any(random), any(random), any(random)});
  const auto free = gradients(plan, state, LimiterKind::none);
  const auto limited = gradients(plan, state, LimiterKind::barth_jespersen);
  const auto value = [&](std::size_t v, std::size_t i) { return (&state.flat()[v].rho)[i]; };
  std::size_t overshoots = 0;
  for (std::size_t v = 0; v < plan.vertex_count; ++v)
    for (std::size_t i = 0; i < 4; ++i) {
      double low = value(v, i), high = low;
      for (const std::uint32_t w : plan.neighbours[v]) {
        low = std::min(low, value(w, i));
        high = std::max(high, value(w, i));
      }
      for (std::uint32_t s = plan.neighbours.offsets()[v]; s < plan.neighbours.offsets()[v + 1]; ++s) {
        const auto at_face = [&](const std::vector<double>& g) {
          return value(v, i) + plan.slot[s].half[0] * g[8 * v + i] + plan.slot[s].half[1] * g[8 * v + 4 + i];
        };
        CHECK(at_face(limited) >= low - 1e-12);
        CHECK(at_face(limited) <= high + 1e-12);
        if (at_face(free) < low || at_face(free) > high) ++overshoots;
      }
    }
  CHECK(overshoots > 100);  // without the limiter they leave it
}

TEST_CASE("near_vacuum_density_and_pressure_stay_positive_at_edge_midpoints_whatever_the_limiter") {
  const TriangleMesh mesh = test::shaken_square(12, 0.3, 4);
  const EdgePlan<2> plan = solver::make_edge_plan<2>(mesh::build_dual(mesh));
  std::mt19937 random(6);
  std::uniform_real_distribution<double> decades(-6, 1);
  PerId<VertexId, State<2>> state;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
    state.push_back({std::pow(10, decades(random)), decades(random), decades(random), std::pow(10, decades(random))});
  for (const auto limiter :
       {LimiterKind::none, LimiterKind::venkatakrishnan, LimiterKind::barth_jespersen, LimiterKind::nishikawa_r3}) {
    const auto g = gradients(plan, state, limiter);
    for (std::size_t v = 0; v < plan.vertex_count; ++v)
      for (const std::size_t i : {0, 3})
        for (std::uint32_t s = plan.neighbours.offsets()[v]; s < plan.neighbours.offsets()[v + 1]; ++s) {
          const double own = (&state.flat()[v].rho)[i];
          CHECK(own + plan.slot[s].half[0] * g[8 * v + i] + plan.slot[s].half[1] * g[8 * v + 4 + i] > 0.19 * own);
        }
  }
}

TEST_CASE("limiters_leave_linear_functions_alone_inside") {
  const TriangleMesh mesh = test::mapped_grid(10, 10, false, [](double s, double t) { return Point2{s, t}; });
  const EdgePlan<2> plan = solver::make_edge_plan<2>(mesh::build_dual(mesh));
  PerId<VertexId, State<2>> state;
  for (const Point2 p : mesh.points) state.push_back({1 + p.x, p.y, p.x + p.y, 2 - p.x});
  for (const auto limiter : {LimiterKind::venkatakrishnan, LimiterKind::barth_jespersen, LimiterKind::nishikawa_r3}) {
    const auto g = gradients(plan, state, limiter);
    for (const VertexId v : mesh.points.ids()) {
      const Point2 p = mesh.points[v];
      if (p.x > 0.05 && p.x < 0.95 && p.y > 0.05 && p.y < 0.95)
        CHECK(g[8 * v.index()] == doctest::Approx(1).epsilon(1e-9));
    }
  }
}

TEST_CASE("limiter_formulas_do_not_increase_with_the_step") {
  for (const double room : {0.0, 0.3, 1.0, -0.7})
    for (const double scale2 : {1e-12, 1e-2}) {
      double venkatakrishnan = 1, barth_jespersen = 1, r3 = 1;
      for (int k = 0; k <= 200; ++k) {
        const double step = (room < 0 ? -0.02 : 0.02) * k;
        const double a = solver::limit_venkatakrishnan<double>(room, step, scale2);
        const double b = solver::limit_barth_jespersen<double>(room, step);
        CHECK(a <= venkatakrishnan + 1e-15);
        CHECK(b <= barth_jespersen + 1e-15);
        const double c = solver::limit_nishikawa_r3<double>(room, step, scale2);
        CHECK(c <= r3 + 1e-15);
        if (std::abs(step) <= 0.5 * std::abs(room)) CHECK(c == 1);  // half the room may be taken whole
        CHECK(std::abs(b * step) <= std::abs(room) + 1e-15);
        venkatakrishnan = a, barth_jespersen = b, r3 = c;
      }
      CHECK(barth_jespersen < 1);
    }
}

}  // namespace
