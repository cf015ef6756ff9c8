// SPDX-License-Identifier: MIT
// The orderings behind one door, and what each is for.
#include "leonhard/graph/order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <stop_token>
#include <string>
#include <utility>

#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/ordering/combined_levels.hpp"
#include "leonhard/graph/ordering/king_numbering.hpp"
#include "leonhard/graph/ordering/level_search.hpp"
#include "leonhard/graph/ordering/minimum_degree.hpp"
#include "leonhard/kernel/hilbert.hpp"
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

constexpr OrderMethod stoppable[] = {OrderMethod::rosen,          OrderMethod::gibbs_poole_stockmeyer,
                                     OrderMethod::gibbs_king,     OrderMethod::king,
                                     OrderMethod::sloan,          OrderMethod::spectral,
                                     OrderMethod::minimum_degree, OrderMethod::nested_dissection};

std::uint64_t envelope(const CsrGraph& graph, const std::vector<std::uint32_t>& order) {
  return ordering_cost(graph, order).envelope;
}

}  // namespace

TEST_CASE("every_method_gives_a_permutation_and_twice_the_same") {
  for (const CsrGraph& graph : shelf())
    for (const NamedOrderMethod& named : named_order_methods) {
      CAPTURE(std::string(named.name));
      CAPTURE(vertex_count(graph));
      const auto points = some_points(vertex_count(graph));
      OrderOptions options;
      options.method = named.method;
      options.coordinates = points;
      const OrderResult first = order(graph, options);
      CHECK(first.outcome == OrderOutcome::done);
      CHECK(is_permutation_of_all(graph, first.order));
      CHECK(order(graph, options).order == first.order);
      CHECK(order_method_named(named.name) == named.method);
    }
  CHECK_FALSE(order_method_named("no-such-method"));
}

TEST_CASE("methods_for_small_envelopes_number_a_path_from_end_to_end") {
  const CsrGraph graph = renamed(path(50), random_order(50, 3));
  for (const OrderMethod method :
       {OrderMethod::cuthill_mckee, OrderMethod::reverse_cuthill_mckee, OrderMethod::gibbs_poole_stockmeyer,
        OrderMethod::gibbs_king, OrderMethod::king, OrderMethod::sloan, OrderMethod::spectral}) {
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

namespace {

/// King's rule at every step, by counting: of the front a vertex that brings fewest others to it, the longest there;
/// of the lowest level that is not finished, and where none of it is in the front, its first of least degree.
std::vector<std::uint32_t> king_by_counting(const CsrGraph& graph, std::uint32_t root,
                                            std::vector<std::uint32_t> level_of = {}) {
  const std::uint32_t n = vertex_count(graph);
  if (level_of.empty()) level_of.assign(n, 0);
  std::vector<std::uint32_t> front{root}, order;
  std::vector<char> reached(n, 0), numbered(n, 0);
  reached[root] = 1;
  const auto brought = [&](std::uint32_t v) {
    return std::ranges::count_if(neighbours(graph, v), [&](std::uint32_t w) { return reached[w] == 0; });
  };
  while (order.size() < n) {
    std::uint32_t level = n;
    for (std::uint32_t v = 0; v < n; ++v)
      if (numbered[v] == 0) level = std::min(level, level_of[v]);
    std::vector<std::uint32_t> candidates;
    std::ranges::copy_if(front, std::back_inserter(candidates),
                         [&](std::uint32_t v) { return level_of[v] == level; });
    if (candidates.empty()) {
      const std::vector<std::uint32_t> all = graph::detail::vertices_by_degree(graph);
      candidates.push_back(*std::ranges::find_if(
          all, [&](std::uint32_t v) { return reached[v] == 0 && level_of[v] == level; }));
      reached[candidates.front()] = 1;
      front.push_back(candidates.front());
    }
    order.push_back(*std::ranges::min_element(candidates, {}, brought));
    numbered[order.back()] = 1;
    std::erase(front, order.back());
    for (const std::uint32_t w : neighbours(graph, order.back()))
      if (std::exchange(reached[w], 1) == 0) front.push_back(w);
  }
  return order;
}

/// Sloan's rule at every step, by counting: next comes the vertex of highest priority among those within two edges of
/// what is numbered.
std::vector<std::uint32_t> sloan_by_counting(const CsrGraph& graph, SloanWeights weights) {
  const std::uint32_t n = vertex_count(graph);
  const Progress none;
  graph::detail::StepCounter steps(none, "", 1);
  graph::detail::LevelSearch search(graph);
  const graph::detail::PseudoDiameter ends =
      graph::detail::pseudo_diameter(graph, search, graph::detail::vertices_by_degree(graph).front(), steps);
  std::vector<std::uint32_t> distance(n), order;
  search(ends.to);
  search.write_levels(distance);
  std::vector<char> numbered(n, 0), in_front(n, 0);  // in the front: numbered or beside what is numbered
  while (order.size() < n) {
    std::optional<std::uint32_t> best;
    std::int64_t highest = 0;
    for (std::uint32_t v = 0; v < n; ++v) {
      const auto list = neighbours(graph, v);
      const bool within_reach = in_front[v] != 0 || (order.empty() && v == ends.from) ||
                                std::ranges::any_of(list, [&](std::uint32_t w) { return in_front[w] != 0; });
      if (numbered[v] != 0 || !within_reach) continue;
      const auto rows_added = std::ranges::count_if(list, [&](std::uint32_t w) { return in_front[w] == 0; }) +
                              (in_front[v] == 0 ? 1 : 0);
      const std::int64_t priority =
          std::int64_t{weights.distance} * distance[v] - weights.degree * rows_added;
      if (best && priority <= highest) continue;
      best = v;
      highest = priority;
    }
    order.push_back(*best);
    numbered[*best] = in_front[*best] = 1;
    for (const std::uint32_t w : neighbours(graph, *best)) in_front[w] = 1;
  }
  return graph::detail::better_direction(graph, order);
}

}  // namespace

TEST_CASE("king_follows_his_rule_at_every_step_and_takes_the_better_end") {
  bool first_is_better = false, second_is_better = false;
  for (std::uint64_t seed = 1; seed < 12; ++seed) {
    const CsrGraph graph = renamed(random_mesh_graph(7, 11, seed), random_order(96, seed));
    const Progress none;
    for (const std::uint32_t root : {0U, 17U, 95U}) {
      graph::detail::StepCounter steps(none, "", 1);
      CHECK(graph::detail::king_numbering(graph, root, {}, steps) == king_by_counting(graph, root));
    }
    graph::detail::StepCounter steps(none, "", 1);
    graph::detail::LevelSearch search(graph);
    const graph::detail::PseudoDiameter ends =
        graph::detail::pseudo_diameter(graph, search, graph::detail::vertices_by_degree(graph).front(), steps);
    const auto from = envelope(graph, graph::detail::better_direction(graph, king_by_counting(graph, ends.from)));
    const auto to = envelope(graph, graph::detail::better_direction(graph, king_by_counting(graph, ends.to)));
    CHECK(envelope(graph, king(graph)) == std::min(from, to));
    first_is_better = first_is_better || from < to;
    second_is_better = second_is_better || to < from;
  }
  CHECK(first_is_better);
  CHECK(second_is_better);
}

TEST_CASE("sloan_follows_his_rule_at_every_step") {
  for (std::uint64_t seed = 1; seed < 8; ++seed) {
    const CsrGraph graph = renamed(random_mesh_graph(7, 11, seed), random_order(96, seed));
    for (const SloanWeights weights : {SloanWeights{1, 2}, SloanWeights{16, 1}, SloanWeights{2, 1}})
      CHECK(sloan(graph, std::array{weights}) == sloan_by_counting(graph, weights));
  }
}

TEST_CASE("kings_rule_makes_envelopes_smaller") {
  std::uint64_t rcm = 0, gps = 0, by_levels = 0, free = 0;
  for (const auto& [width, height] : {std::array{12U, 60U}, std::array{40U, 40U}, std::array{20U, 90U}}) {
    const CsrGraph graph = shuffled_mesh(width, height);
    rcm += envelope(graph, reverse_cuthill_mckee(graph));
    gps += envelope(graph, gibbs_poole_stockmeyer(graph));
    by_levels += envelope(graph, gibbs_king(graph));
    free += envelope(graph, king(graph));
  }
  CHECK(double(gps) < 1.1 * double(rcm));
  CHECK(by_levels < gps);
  CHECK(free < by_levels);
}

TEST_CASE("level_methods_number_one_level_after_another") {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const CsrGraph graph = renamed(random_mesh_graph(12, 19, seed), random_order(260, seed));
    const Progress none;
    graph::detail::StepCounter steps(none, "", 1);
    const graph::detail::CombinedLevels levels = graph::detail::combined_levels(graph, steps);
    for (const std::vector<std::uint32_t>& order : {gibbs_poole_stockmeyer(graph), gibbs_king(graph)}) {
      std::vector<std::uint32_t> sequence;
      for (const std::uint32_t v : order) sequence.push_back(levels.level_of[v]);
      if (sequence.front() != 0) std::ranges::reverse(sequence);  // as a whole, for the envelope
      CHECK(std::ranges::is_sorted(sequence));
    }
    CHECK(gibbs_king(graph) ==
          graph::detail::better_direction(graph, king_by_counting(graph, levels.root, levels.level_of)));
  }
}

TEST_CASE("minimum_degree_fills_less_than_any_envelope_method") {
  const CsrGraph graph = shuffled_mesh(30, 30);
  const auto fill = cholesky_fill(graph, minimum_degree(graph)).fill;
  CHECK(2 * fill < cholesky_fill(graph, reverse_cuthill_mckee(graph)).fill);
  CHECK(2 * fill < cholesky_fill(graph, sloan(graph)).fill);
}

TEST_CASE("approximate_degrees_fill_about_as_little_as_exact_ones") {
  std::uint64_t approximate = 0, exact = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const CsrGraph graph = renamed(random_mesh_graph(13, 13, seed), random_order(196, seed));
    approximate += cholesky_fill(graph, minimum_degree(graph)).fill;
    std::vector<std::set<std::uint32_t>> beside(196);
    for (std::uint32_t v = 0; v < 196; ++v)
      for (const std::uint32_t w : neighbours(graph, v)) beside[v].insert(w);
    std::vector<char> gone(196, 0);
    for (int step = 0; step < 196; ++step) {
      std::uint32_t pivot = 196;
      for (std::uint32_t v = 0; v < 196; ++v)
        if (gone[v] == 0 && (pivot == 196 || beside[v].size() < beside[pivot].size())) pivot = v;
      gone[pivot] = 1;
      for (const std::uint32_t v : beside[pivot]) {
        beside[v].erase(pivot);
        for (const std::uint32_t w : beside[pivot])
          if (v != w && beside[v].insert(w).second && v < w) ++exact;
      }
    }
  }
  CHECK(approximate < exact);
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

TEST_CASE("rosen_exchanges_numbers_that_keep_the_bandwidth_where_edges_get_shorter") {
  std::uint32_t sum = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CsrGraph shuffled = renamed(path(20), random_order(20, seed));
    sum += ordering_cost(shuffled, rosen(shuffled, natural_order(shuffled)).order).bandwidth;
  }
  CHECK(sum <= 50);
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
  const CsrGraph mesh = disjoint_union({shuffled_mesh(30, 30), shuffled_mesh(9, 9), path(1)});
  for (const OrderMethod method : stoppable) {
    CAPTURE(static_cast<int>(method));
    OrderOptions options;
    options.method = method;
    options.progress.stop = source.get_token();
    const OrderResult result = order(mesh, options);
    CHECK(result.outcome == OrderOutcome::stopped);
    CHECK(is_permutation_of_all(mesh, result.order));
  }
}

TEST_CASE("a_stop_request_amid_the_work_ends_it_soon") {
  const CsrGraph mesh = shuffled_mesh(180, 180);
  for (const OrderMethod method : {OrderMethod::gibbs_poole_stockmeyer, OrderMethod::gibbs_king,
                                   OrderMethod::king, OrderMethod::sloan, OrderMethod::minimum_degree}) {
    CAPTURE(static_cast<int>(method));
    OrderOptions options;
    options.method = method;
    const auto whole = order(mesh, options).order;
    std::stop_source source;
    options.progress.stop = source.get_token();
    double last = 0;
    options.progress.report = [&](std::string_view, double fraction) {
      CHECK(fraction >= last);
      last = fraction;
      if (fraction > 0.3) source.request_stop();
    };
    const OrderResult result = order(mesh, options);
    CHECK(result.outcome == OrderOutcome::stopped);
    CHECK(last > 0.3);
    CHECK(last < 0.4);
    CHECK(is_permutation_of_all(mesh, result.order));
    CHECK(result.order != whole);
  }
}

TEST_CASE("rosen_is_stopped_whatever_order_it_starts_from") {
  const CsrGraph mesh = shuffled_mesh(60, 60);
  for (const OrderMethod start : {OrderMethod::natural, OrderMethod::sloan}) {
    std::stop_source source;
    OrderOptions options{.method = OrderMethod::rosen, .start = start};
    options.progress.stop = source.get_token();
    options.progress.report = [&](std::string_view, double) { source.request_stop(); };
    if (start == OrderMethod::natural) source.request_stop();
    const OrderResult result = order(mesh, options);
    CHECK(result.outcome == OrderOutcome::stopped);
    CHECK(is_permutation_of_all(mesh, result.order));
  }
}

TEST_CASE("a_stop_between_two_choices_keeps_the_first") {
  const CsrGraph mesh = shuffled_mesh(60, 60);
  const std::vector<SloanWeights> first{{1, 2}}, both{{1, 2}, {16, 1}};
  std::stop_source source;
  Progress progress{[&](std::string_view, double fraction) {
                      if (fraction > 0.5) source.request_stop();
                    },
                    source.get_token()};
  const OrderResult result = sloan(mesh, both, progress);
  CHECK(result.outcome == OrderOutcome::stopped);
  CHECK(result.order == sloan(mesh, first));
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

TEST_CASE("points_are_followed_along_a_curve_of_the_plane_or_of_space") {
  std::mt19937_64 random(1);
  std::vector<Point3> points;
  std::vector<Point2> plane;
  for (int i = 0; i < 170; ++i) {
    plane.push_back({static_cast<double>(random() % 100000), static_cast<double>(random() % 100000)});
    points.push_back({plane.back().x, plane.back().y, 0});
  }
  CHECK(kernel::hilbert_order(points) != kernel::hilbert_order(plane));
  CHECK(order(path(170), {.method = OrderMethod::hilbert, .coordinates = points}).order ==
        kernel::hilbert_order(plane));
  points[7].z = 1;
  CHECK(order(path(170), {.method = OrderMethod::hilbert, .coordinates = points}).order ==
        kernel::hilbert_order(points));
}

TEST_CASE("the_seed_reaches_the_eigensolver") {
  const CsrGraph square = grid(24, 24);  // a double eigenvalue: the start decides which vector is found
  const auto by_seed = [&](std::uint64_t seed) {
    return order(square, {.method = OrderMethod::spectral, .seed = seed}).order;
  };
  CHECK(by_seed(3) == spectral_order(square, 3).order);
  CHECK(by_seed(3) != by_seed(4));
}

TEST_CASE("sloan_takes_the_best_of_the_weights_it_is_given") {
  const std::vector<SloanWeights> one{{1, 2}}, other{{16, 1}};
  const CsrGraph mesh = shuffled_mesh(14, 25);
  for (const CsrGraph& graph : {mesh, shuffled_mesh(40, 40), shuffled_mesh(7, 70), random_graph(200, 4, 3)}) {
    const auto first = envelope(graph, sloan(graph, one)), second = envelope(graph, sloan(graph, other));
    CHECK(envelope(graph, sloan(graph)) == std::min(first, second));
  }
  CHECK_THROWS_AS(static_cast<void>(sloan(mesh, std::vector<SloanWeights>{})), InputError);
}

TEST_CASE("boosts_minimum_degree_is_safe_on_all_small_graphs") {
  // All graphs of up to five vertices; complete ones among them, where Boost alone reads beyond its lists by degree.
  for (std::uint32_t n = 0; n <= 5; ++n) {
    Edges all;
    for (std::uint32_t v = 0; v < n; ++v)
      for (std::uint32_t w = v + 1; w < n; ++w) all.push_back({v, w});
    for (std::uint32_t chosen = 0; chosen < 1U << all.size(); ++chosen) {
      Edges edges;
      for (std::size_t e = 0; e < all.size(); ++e)
        if ((chosen >> e & 1) != 0) edges.push_back(all[e]);
      const CsrGraph graph = graph_from_edges(n, edges).graph;
      CHECK(is_permutation_of_all(graph, order(graph, {.method = OrderMethod::boost_minimum_degree}).order));
    }
  }
}

TEST_CASE("boosts_own_orderings_are_worth_about_what_ours_are") {
  const CsrGraph graph = renamed(random_mesh_graph(20, 15, 3), random_order(336, 8));
  const auto cost = [&](OrderMethod method) {
    return ordering_cost(graph, order(graph, {.method = method}).order);
  };
  const OrderingCost natural = cost(OrderMethod::natural);
  CHECK(cost(OrderMethod::boost_cuthill_mckee).bandwidth < natural.bandwidth / 4);
  CHECK(cost(OrderMethod::boost_cuthill_mckee).envelope < natural.envelope / 4);
  CHECK(cost(OrderMethod::boost_king).envelope < natural.envelope / 4);
  CHECK(cost(OrderMethod::boost_sloan).envelope < natural.envelope / 4);
  const auto fill = [&](OrderMethod method) {
    return static_cast<double>(cholesky_fill(graph, order(graph, {.method = method}).order).nonzeros);
  };
  CHECK(fill(OrderMethod::boost_minimum_degree) < 1.3 * fill(OrderMethod::minimum_degree));
}

TEST_CASE("boosts_own_orderings_stop_when_told_to") {
  const CsrGraph graph = random_mesh_graph(60, 60, 3);
  for (const OrderMethod method : {OrderMethod::boost_cuthill_mckee, OrderMethod::boost_king,
                                   OrderMethod::boost_sloan, OrderMethod::boost_minimum_degree}) {
    std::stop_source stop;
    OrderOptions options{.method = method};
    options.progress.stop = stop.get_token();
    options.progress.report = [&](std::string_view, double fraction) {
      if (fraction > 0) stop.request_stop();
    };
    const OrderResult found = order(graph, options);
    CHECK(found.outcome == OrderOutcome::stopped);
    CHECK(is_permutation_of_all(graph, found.order));
  }
}
