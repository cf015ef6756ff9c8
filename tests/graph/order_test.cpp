// SPDX-License-Identifier: MIT
// The orderings behind one door, and what each is for.
#include "leonhard/graph/order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <stop_token>
#include <string>

#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/minimum_degree.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

std::vector<Point3> some_points(std::uint32_t n) {
  std::vector<Point3> points;
  for (const std::uint32_t v : random_order(n, 5)) points.push_back({double(v % 17), double(v / 17), 0});
  return points;
}

bool is_permutation_of_all(const CsrGraph& graph, std::vector<std::uint32_t> order) {
  std::ranges::sort(order);
  return order == natural_order(graph);
}

std::vector<CsrGraph> shelf() {
  return {path(0),
          path(1),
          path(2),
          path(40),
          cycle(11),
          star(30),
          wheel(12),
          complete(8),
          grid(7, 9),
          random_graph(40, 30, 1),
          random_graph(40, 4, 2),
          renamed(random_mesh_graph(9, 14, 4), random_order(150, 3)),
          disjoint_union({path(1), star(6), path(1), grid(3, 5), complete(4), path(2)})};
}

/// A mesh's graph under names that tell nothing.
CsrGraph shuffled_mesh(std::uint32_t width, std::uint32_t height) {
  return renamed(random_mesh_graph(width, height, 8), random_order((width + 1) * (height + 1), 8));
}

std::uint64_t envelope(const CsrGraph& graph, const std::vector<std::uint32_t>& order) {
  return ordering_cost(graph, order).envelope;
}

}  // namespace

TEST_CASE("every_method_gives_a_permutation_and_twice_the_same") {
  for (const CsrGraph& graph : shelf())
    for (const auto& [name, method] : named_order_methods) {
      CAPTURE(std::string(name));
      CAPTURE(vertex_count(graph));
      const auto points = some_points(vertex_count(graph));
      OrderOptions options;
      options.method = method;
      options.coordinates = points;
      const OrderResult first = order(graph, options);
      CHECK(first.outcome == OrderOutcome::done);
      CHECK(is_permutation_of_all(graph, first.order));
      CHECK(order(graph, options).order == first.order);
      CHECK(order_method_named(name) == method);
    }
  CHECK_FALSE(order_method_named("no-such-method"));
}

TEST_CASE("methods_for_small_envelopes_number_a_path_from_end_to_end") {
  const CsrGraph graph = renamed(path(50), random_order(50, 3));
  for (const OrderMethod method :
       {OrderMethod::cuthill_mckee, OrderMethod::reverse_cuthill_mckee, OrderMethod::gibbs_poole_stockmeyer,
        OrderMethod::king, OrderMethod::sloan, OrderMethod::spectral}) {
    OrderOptions options;
    options.method = method;
    CAPTURE(static_cast<int>(method));
    CHECK(envelope(graph, order(graph, options).order) == 49);
  }
}

TEST_CASE("a_grid_gets_its_width_as_bandwidth") {  // the optimum, Chvatalova 1975
  const CsrGraph graph = renamed(grid(6, 40), random_order(240, 9));
  CHECK(ordering_cost(graph, gibbs_poole_stockmeyer(graph)).bandwidth == 6);
  CHECK(ordering_cost(graph, cuthill_mckee(graph)).bandwidth == 6);
}

TEST_CASE("a_star_has_the_least_fill_with_its_hub_last") {
  const CsrGraph graph = star(20);
  CHECK(cholesky_fill(graph, minimum_degree(graph)).fill == 0);
  CHECK(cholesky_fill(graph, natural_order(graph)).fill == 19 * 18 / 2);
}

TEST_CASE("sloan_and_the_fiedler_vector_have_smaller_envelopes_than_reverse_cuthill_mckee") {
  const CsrGraph graph = shuffled_mesh(12, 60);
  const std::uint64_t rcm = envelope(graph, reverse_cuthill_mckee(graph));
  CHECK(envelope(graph, sloan(graph)) < rcm);
  CHECK(envelope(graph, spectral_order(graph).order) < rcm);
  CHECK(envelope(graph, natural_order(graph)) > 5 * rcm);
}

TEST_CASE("minimum_degree_fills_less_than_any_envelope_method") {
  const CsrGraph graph = shuffled_mesh(30, 30);
  const auto fill = cholesky_fill(graph, minimum_degree(graph)).fill;
  CHECK(2 * fill < cholesky_fill(graph, reverse_cuthill_mckee(graph)).fill);
  CHECK(2 * fill < cholesky_fill(graph, sloan(graph)).fill);
}

TEST_CASE("rosen_never_enlarges_the_bandwidth_and_finds_that_of_a_shuffled_path") {
  for (const CsrGraph& graph : shelf()) {
    const RosenResult result = rosen(graph, natural_order(graph));
    CHECK(ordering_cost(graph, result.order).bandwidth <=
          ordering_cost(graph, natural_order(graph)).bandwidth);
  }
  const CsrGraph mesh = shuffled_mesh(10, 10);
  const auto before = ordering_cost(mesh, natural_order(mesh)).bandwidth;
  const RosenResult improved = rosen(mesh, natural_order(mesh));
  CHECK(2 * ordering_cost(mesh, improved.order).bandwidth < before);
  CHECK(improved.exchanges > 0);
}

TEST_CASE("rosen_takes_the_order_it_is_to_improve") {
  const CsrGraph mesh = shuffled_mesh(10, 40);
  const auto spectral = ordering_cost(mesh, spectral_order(mesh).order);
  OrderOptions options{.method = OrderMethod::rosen, .start = OrderMethod::spectral};
  const auto improved = ordering_cost(mesh, order(mesh, options).order);
  CHECK(improved.bandwidth < spectral.bandwidth);
  CHECK(double(improved.envelope) < 1.1 * double(spectral.envelope));
  options.start = OrderMethod::rosen;
  CHECK_THROWS_AS(static_cast<void>(order(mesh, options)), InputError);
  CHECK_THROWS_AS(static_cast<void>(rosen(mesh, std::vector<std::uint32_t>{0, 1})), InputError);
}

TEST_CASE("a_stop_request_ends_orderings_with_a_permutation") {
  std::stop_source source;
  source.request_stop();
  const CsrGraph mesh = shuffled_mesh(30, 30);
  for (const OrderMethod method : {OrderMethod::rosen, OrderMethod::spectral}) {
    OrderOptions options;
    options.method = method;
    options.progress.stop = source.get_token();
    const OrderResult result = order(mesh, options);
    CHECK(result.outcome == OrderOutcome::stopped);
    CHECK(is_permutation_of_all(mesh, result.order));
  }
}

TEST_CASE("hilbert_wants_one_finite_point_a_vertex_and_follows_them") {
  OrderOptions options;
  options.method = OrderMethod::hilbert;
  CHECK_THROWS_WITH_AS(static_cast<void>(order(path(3), options)), doctest::Contains("0 points for 3"),
                       InputError);
  std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  options.coordinates = points;
  CHECK(order(path(3), options).order == std::vector<std::uint32_t>{0, 2, 1});
  points[1].z = 1;
  CHECK(is_permutation_of_all(path(3), order(path(3), options).order));
  points[1].x = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(static_cast<void>(order(path(3), options)), InputError);
}

TEST_CASE("sloan_takes_the_best_of_the_weights_it_is_given") {
  const CsrGraph mesh = shuffled_mesh(14, 25);
  const std::vector<SloanWeights> one{{1, 2}}, other{{16, 1}};
  CHECK(envelope(mesh, sloan(mesh)) ==
        std::min(envelope(mesh, sloan(mesh, one)), envelope(mesh, sloan(mesh, other))));
  CHECK_THROWS_AS(static_cast<void>(sloan(mesh, std::vector<SloanWeights>{})), InputError);
}
