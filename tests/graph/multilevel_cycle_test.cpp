// SPDX-License-Identifier: MIT
#include "leonhard/graph/spectral/multilevel_cycle.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::detail;
using namespace leonhard::graph::test;

namespace {

std::vector<double> random_mean_free(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> x = random_vector(n, random);
  remove_mean(x);
  return x;
}

std::vector<double> applied(MultilevelCycle& cycle, const std::vector<double>& r) {
  std::vector<double> z(r.size());
  cycle.apply(r, z);
  remove_mean(z);
  return z;
}

}  // namespace

TEST_CASE("multilevel_cycle_is_symmetric_and_positive") {
  for (const CsrGraph& graph : {random_mesh_graph(25, 40, 1), grid(60, 30), path(1500), complete(300)}) {
    MultilevelCycle cycle(graph);
    const std::size_t n = vertex_count(graph);
    const auto x = random_mean_free(n, 1), y = random_mean_free(n, 2);
    const auto mx = applied(cycle, x), my = applied(cycle, y);
    CHECK(dot(x, my) == doctest::Approx(dot(y, mx)).epsilon(1e-8));
    CHECK(dot(x, mx) > 0);
  }
}

TEST_CASE("multilevel_cycle_reduces_the_error_by_a_third_or_better_at_any_size") {
  for (const std::uint32_t n : {15U, 30U, 60U, 120U}) {
    const CsrGraph graph = random_mesh_graph(n, n, n);
    MultilevelCycle cycle(graph);
    std::vector<double> error = random_mean_free(vertex_count(graph), 5), image(error.size());
    double factor = 1;
    for (int step = 0; step < 12; ++step) {  // error := error - M L error, as solving L e = 0 does
      multiply(cycle.matrix(), error, image);
      const double before = std::sqrt(dot(error, image));  // the energy norm
      add_scaled(error, -1, applied(cycle, image));
      multiply(cycle.matrix(), error, image);
      factor = std::sqrt(dot(error, image)) / before;
    }
    CAPTURE(n);
    CHECK(factor < 2.0 / 3);
  }
}

TEST_CASE("small_graphs_are_solved_exactly") {
  const CsrGraph graph = grid(10, 12);
  MultilevelCycle cycle(graph);
  const auto x = random_mean_free(120, 3);
  std::vector<double> image(120);
  multiply(cycle.matrix(), x, image);
  const auto back = applied(cycle, image);
  for (std::size_t i = 0; i < 120; ++i) CHECK(back[i] == doctest::Approx(x[i]).epsilon(1e-9));
}
