// SPDX-License-Identifier: MIT
#include "leonhard/graph/fiedler.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <span>

#include "leonhard/graph/spectral/linear_algebra.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

double path_value(double n) { return 2 - 2 * std::cos(std::numbers::pi / n); }

/// What is promised of every converged pair.
void check_pair(const CsrGraph& graph, const Fiedler& pair, double tolerance) {
  CHECK(pair.outcome == FiedlerOutcome::converged);
  REQUIRE(pair.vector.size() == vertex_count(graph));
  const double norm2 = std::inner_product(pair.vector.begin(), pair.vector.end(), pair.vector.begin(), 0.0);
  const double sum = std::accumulate(pair.vector.begin(), pair.vector.end(), 0.0);
  CHECK(norm2 == doctest::Approx(1).epsilon(1e-12));
  CHECK(std::abs(sum) < 1e-9);
  std::vector<double> image = laplacian_product(graph, pair.vector);
  double residual2 = 0;
  for (std::size_t i = 0; i < image.size(); ++i)
    residual2 += std::pow(image[i] - pair.value * pair.vector[i], 2);
  CHECK(std::sqrt(residual2) == doctest::Approx(pair.residual).epsilon(1e-6).scale(0));
  CHECK(pair.residual <= 1.01 * std::max(tolerance * pair.value, 1e-13));
}

}  // namespace

TEST_CASE("lambda2_of_paths_cycles_grids_and_complete_graphs_is_the_closed_form") {
  for (const FiedlerMethod method : {FiedlerMethod::multilevel, FiedlerMethod::lanczos}) {
    FiedlerOptions options;
    options.method = method;
    CAPTURE(static_cast<int>(method));
    for (const std::uint32_t n : {2U, 3U, 20U, 33U, 150U}) {
      const Fiedler pair = fiedler(path(n), options);
      CHECK(pair.value == doctest::Approx(path_value(n)).epsilon(1e-9).scale(0));
      check_pair(path(n), pair, options.tolerance);
    }
    const Fiedler ring = fiedler(cycle(101), options);
    CHECK(ring.value == doctest::Approx(2 - 2 * std::cos(2 * std::numbers::pi / 101)).epsilon(1e-9));
    const Fiedler rectangle = fiedler(grid(37, 20), options);
    CHECK(rectangle.value == doctest::Approx(path_value(37)).epsilon(1e-9).scale(0));
    check_pair(grid(37, 20), rectangle, options.tolerance);
    const Fiedler square = fiedler(grid(24, 24), options);  // a double eigenvalue
    CHECK(square.value == doctest::Approx(path_value(24)).epsilon(1e-9).scale(0));
    check_pair(grid(24, 24), square, options.tolerance);
    CHECK(fiedler(complete(40), options).value == doctest::Approx(40).epsilon(1e-9));
  }
}

TEST_CASE("multilevel_converges_in_tens_of_iterations_whatever_the_size") {
  for (const std::uint32_t n : {20U, 60U, 180U}) {
    const Fiedler pair = fiedler(grid(n + 3, n));
    CHECK(pair.outcome == FiedlerOutcome::converged);
    CHECK(pair.value == doctest::Approx(path_value(n + 3)).epsilon(1e-8).scale(0));
    CHECK(pair.iterations < 60);
  }
  const Fiedler chain = fiedler(path(20000));
  CHECK(chain.outcome == FiedlerOutcome::converged);
  CHECK(chain.value == doctest::Approx(path_value(20000)).epsilon(1e-6).scale(0));
}

TEST_CASE("multilevel_and_lanczos_find_the_same_pair") {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const CsrGraph graph = random_mesh_graph(31, 19, seed);
    FiedlerOptions options;
    const Fiedler multilevel = fiedler(graph, options);
    options.method = FiedlerMethod::lanczos;
    options.seed = 99;
    const Fiedler lanczos = fiedler(graph, options);
    CHECK(multilevel.value == doctest::Approx(lanczos.value).epsilon(1e-9).scale(0));
    for (std::size_t i = 0; i < multilevel.vector.size(); ++i)
      CHECK(std::abs(multilevel.vector[i] - lanczos.vector[i]) < 1e-5);
  }
}

TEST_CASE("fiedler_of_a_graph_in_pieces_is_zero_and_tells_the_first_piece_from_the_rest") {
  const CsrGraph graph = disjoint_union({path(3), cycle(5), path(1)});
  const Fiedler pair = fiedler(graph);
  CHECK(pair.value == 0);
  CHECK(pair.residual == 0);
  CHECK(pair.outcome == FiedlerOutcome::converged);
  for (std::size_t i = 0; i < 9; ++i) CHECK((pair.vector[i] > 0) == (i < 3));
  CHECK(std::accumulate(pair.vector.begin(), pair.vector.end(), 0.0) == doctest::Approx(0));
  CHECK(std::inner_product(pair.vector.begin(), pair.vector.end(), pair.vector.begin(), 0.0) ==
        doctest::Approx(1));
  for (const double entry : laplacian_product(graph, pair.vector)) CHECK(entry == doctest::Approx(0));
}

TEST_CASE("what_is_nearly_in_a_subspace_becomes_orthogonal_to_it_to_rounding") {
  std::mt19937_64 random(4);
  std::vector<std::vector<double>> basis;
  for (int k = 0; k < 3; ++k) {
    basis.push_back(graph::detail::random_vector(200, random));
    REQUIRE(graph::detail::orthonormalise(basis.back(), std::span(basis).first(basis.size() - 1)));
  }
  std::vector<double> x = graph::detail::random_vector(200, random);
  graph::detail::scale(x, 1e-9);
  for (const std::vector<double>& v : basis) graph::detail::add_scaled(x, 3, v);
  CHECK(graph::detail::orthonormalise(x, basis));
  for (const std::vector<double>& v : basis) CHECK(std::abs(graph::detail::dot(x, v)) < 1e-14);
  CHECK(graph::detail::norm(x) == doctest::Approx(1).epsilon(1e-14));
  std::vector<double> within = basis[1];
  CHECK_FALSE(graph::detail::orthonormalise(within, basis));
}

TEST_CASE("hubs_and_trees_do_not_break_the_cycle") {
  Edges star, broom;
  for (std::uint32_t v = 1; v < 900; ++v) star.push_back({0, v});
  for (std::uint32_t v = 1; v < 900; ++v) broom.push_back({v < 450 ? v - 1 : 449, v});
  CHECK(fiedler(graph_from_edges(900, star).graph).value == doctest::Approx(1).epsilon(1e-9));
  const CsrGraph tree = graph_from_edges(900, broom).graph;
  check_pair(tree, fiedler(tree), 1e-6);
}

TEST_CASE("fiedler_is_the_same_for_the_same_seed") {
  const CsrGraph graph = random_mesh_graph(20, 20, 7);
  CHECK(fiedler(graph).vector == fiedler(graph).vector);
}

TEST_CASE("fiedler_tells_when_it_ran_out_of_iterations_or_was_stopped") {
  FiedlerOptions options;
  options.max_iterations = 4;
  for (const FiedlerMethod method : {FiedlerMethod::multilevel, FiedlerMethod::lanczos}) {
    options.method = method;
    const Fiedler pair = fiedler(grid(40, 30), options);
    CHECK(pair.outcome == FiedlerOutcome::iteration_limit);
    CHECK(pair.vector.size() == 1200);
  }
  std::stop_source stop;
  stop.request_stop();
  FiedlerOptions stopped;
  stopped.stop = stop.get_token();
  for (const FiedlerMethod method : {FiedlerMethod::multilevel, FiedlerMethod::lanczos}) {
    stopped.method = method;
    CHECK(fiedler(grid(40, 30), stopped).outcome == FiedlerOutcome::stopped);
  }
}

TEST_CASE("fiedler_refuses_a_single_vertex_and_a_tolerance_of_zero") {
  CHECK_THROWS_AS(static_cast<void>(fiedler(path(1))), InputError);
  FiedlerOptions options;
  options.tolerance = 0;
  CHECK_THROWS_AS(static_cast<void>(fiedler(path(3), options)), InputError);
  options.tolerance = std::nan("");
  CHECK_THROWS_AS(static_cast<void>(fiedler(path(3), options)), InputError);
  CHECK_THROWS_AS(static_cast<void>(laplacian_product(path(3), {1, 2})), InputError);
}
