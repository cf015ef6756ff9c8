// SPDX-License-Identifier: MIT
// The door partition(): every method keeps its promises, and the multilevel one finds what is known to be best.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

CsrGraph without_edges(std::uint32_t n) { return graph_from_edges(n, {}).graph; }

CsrGraph two_cliques_joined_by_an_edge(std::uint32_t n) {
  Edges edges{{0, n}};
  for (std::uint32_t first : {0U, n})
    for (std::uint32_t v = 0; v < n; ++v)
      for (std::uint32_t w = v + 1; w < n; ++w) edges.push_back({first + v, first + w});
  return graph_from_edges(2 * n, edges).graph;
}

std::vector<Point2> random_points(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point2> points;
  for (std::uint32_t v = 0; v < n; ++v)
    points.push_back({static_cast<double>(random() % 1000), static_cast<double>(random() % 100)});
  return points;
}

constexpr PartitionMethod all_methods[] = {
    PartitionMethod::coordinate,           PartitionMethod::inertial, PartitionMethod::cuthill_mckee,
    PartitionMethod::cuthill_mckee_levels, PartitionMethod::spectral, PartitionMethod::multilevel};

std::vector<std::uint64_t> weights_of(const Partition& partition, std::span<const std::uint32_t> weights) {
  std::vector<std::uint64_t> sums(partition.parts, 0);
  for (std::size_t v = 0; v < partition.part_of.size(); ++v)
    sums.at(partition.part_of[v]) += weights.empty() ? 1 : weights[v];
  return sums;
}

std::size_t cut_of(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options = {}) {
  return partition_cost(graph, partition(graph, parts, options)).cut;
}

}  // namespace

TEST_CASE("every_method_keeps_the_bound_leaves_no_part_empty_and_repeats_itself") {
  std::uint64_t seed = 0;
  for (const CsrGraph& graph :
       {random_mesh_graph(14, 9, 3), random_graph(150, 4, 1), random_graph(90, 40, 2), star(60), path(77),
        without_edges(40), complete(25), disjoint_union({grid(6, 6), path(1), path(1), cycle(9)})}) {
    const std::uint32_t n = vertex_count(graph);
    const std::vector<Point2> points = random_points(n, ++seed);
    for (const PartitionMethod method : all_methods)
      for (const std::uint32_t parts : {1U, 2U, 3U, 7U, 16U, n - 1, n})
        for (const double imbalance : {0.0, 0.03, 0.5}) {
          PartitionOptions options;
          options.method = method;
          options.imbalance = imbalance;
          options.effort = Effort::low;
          options.coordinates = std::span<const Point2>(points);
          CAPTURE(n);
          CAPTURE(parts);
          CAPTURE(static_cast<int>(method));
          const Partition found = partition(graph, parts, options);
          CHECK(found.outcome == PartitionOutcome::done);
          CHECK(found.parts == parts);
          REQUIRE(found.part_of.size() == n);
          const auto sizes = weights_of(found, {});
          CHECK(std::ranges::max(sizes) <= static_cast<std::uint64_t>(heaviest_allowed(n, parts, imbalance)));
          CHECK(std::ranges::min(sizes) > 0);
          CHECK(partition(graph, parts, options).part_of == found.part_of);
        }
  }
}

TEST_CASE("the_heaviest_part_allowed_is_the_mean_and_the_imbalance_or_what_division_leaves") {
  CHECK(heaviest_allowed(100, 4, 0.03) == 25);
  CHECK(heaviest_allowed(100, 4, 0.04) == 26);
  CHECK(heaviest_allowed(101, 4, 0) == 26);
  CHECK(heaviest_allowed(10, 2, 5) == 10);
  CHECK(heaviest_allowed(0, 3, 0.1) == 0);
  CHECK_THROWS_AS(static_cast<void>(heaviest_allowed(10, 0, 0.1)), InputError);
}

TEST_CASE("a_grid_is_halved_along_a_row") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto halved = [&](std::uint32_t n, double imbalance, Effort effort) {
      PartitionOptions options;
      options.imbalance = imbalance;
      options.seed = seed;
      options.effort = effort;
      return cut_of(renamed(grid(n, n), random_order(n * n, seed)), 2, options);
    };
    CHECK(halved(8, 0, Effort::normal) == 8);
    CHECK(halved(12, 0, Effort::high) == 12);
    CHECK(halved(40, 0.03, Effort::normal) <= 42);
    CHECK(halved(40, 0, Effort::normal) <= 46);
  }
}

TEST_CASE("a_path_is_cut_between_its_parts_only") {
  for (const std::uint32_t parts : {2U, 3U, 5U, 8U})
    CHECK(cut_of(renamed(path(240), random_order(240, parts)), parts) == parts - 1);
}

TEST_CASE("two_cliques_are_parted_at_the_edge_that_joins_them") {
  CHECK(cut_of(two_cliques_joined_by_an_edge(30), 2) == 1);
}

TEST_CASE("components_that_fit_are_not_cut") {
  const CsrGraph graph = disjoint_union({grid(10, 10), grid(20, 5), cycle(100), path(100)});
  CHECK(cut_of(graph, 4) == 0);
  CHECK(cut_of(graph, 2) == 0);
}

TEST_CASE("a_star_loses_as_few_leaves_as_balance_allows") {
  PartitionOptions options;
  options.imbalance = 0;
  CHECK(cut_of(star(100), 2, options) == 50);
  CHECK(cut_of(star(100), 4, options) == 75);
}

TEST_CASE("the_multilevel_method_cuts_less_than_the_spectral_one") {
  const CsrGraph graph = random_mesh_graph(60, 40, 8);
  PartitionOptions options;
  options.method = PartitionMethod::spectral;
  const std::size_t spectral = cut_of(graph, 12, options);
  options.method = PartitionMethod::multilevel;
  for (const Effort effort : {Effort::low, Effort::normal}) {
    options.effort = effort;
    CHECK(cut_of(graph, 12, options) < 0.95 * static_cast<double>(spectral));
  }
}

TEST_CASE("spectral_bisection_cuts_as_with_eigenvectors_of_a_dense_solver") {
  struct Reference {
    CsrGraph graph;
    double lambda2;
    std::array<std::size_t, 6>
        cuts;  // 2, 4, ... 64 parts: LAPACK's dsyev, split at the median, nothing refined
  };
  for (const Reference& reference :
       {Reference{random_mesh_graph(31, 19, 1), 0.0169777944349, {39, 103, 183, 308, 462, 693}},
        Reference{random_mesh_graph(39, 15, 2), 0.0107614853038, {31, 96, 176, 304, 461, 697}}}) {
    CHECK(fiedler(reference.graph, {.tolerance = 1e-7}).value ==
          doctest::Approx(reference.lambda2).epsilon(1e-11).scale(0));
    for (std::uint32_t level = 0; level < 6; ++level) {
      const PartitionCost cost =
          partition_cost(reference.graph, recursive_spectral_bisection(reference.graph, 2U << level));
      CHECK(cost.cut == reference.cuts[level]);
      CHECK(cost.largest == cost.smallest);
    }
  }
}

TEST_CASE("vertex_weights_are_balanced_whatever_the_method") {
  const CsrGraph graph = random_mesh_graph(20, 14, 5);
  const std::uint32_t n = vertex_count(graph);
  std::vector<std::uint32_t> weights(n);
  std::mt19937_64 random(3);
  for (std::uint32_t& w : weights) w = 1 + static_cast<std::uint32_t>(random() % 20);
  const auto total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
  const std::vector<Point2> points = random_points(n, 4);
  for (const PartitionMethod method : all_methods)
    for (const std::uint32_t parts : {2U, 5U, 9U}) {
      PartitionOptions options;
      options.method = method;
      options.imbalance = 0.05;
      options.vertex_weights = weights;
      options.coordinates = std::span<const Point2>(points);
      CAPTURE(static_cast<int>(method));
      const Partition found = partition(graph, parts, options);
      CHECK(found.outcome == PartitionOutcome::done);
      CHECK(std::ranges::max(weights_of(found, weights)) <=
            static_cast<std::uint64_t>(heaviest_allowed(total, parts, 0.05)));
    }
}

TEST_CASE("weights_that_cannot_be_balanced_are_told") {
  const std::vector<std::uint32_t> weights{100, 1, 1, 1, 1, 1};
  PartitionOptions options;
  options.vertex_weights = weights;
  const Partition found = partition(path(6), 3, options);
  CHECK(found.outcome == PartitionOutcome::unbalanced);
  CHECK(std::ranges::max(weights_of(found, weights)) < 105);
}

TEST_CASE("heavy_edges_are_not_cut") {
  // A grid whose every third column of edges is light: the cut goes there.
  const CsrGraph graph = grid(12, 6);
  std::vector<std::uint32_t> weights;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      weights.push_back(std::min(v, w) % 12 % 3 == 2 && v / 12 == w / 12 ? 1 : 50);
  PartitionOptions options;
  options.edge_weights = weights;
  const PartitionCost cost = partition_cost(graph, partition(graph, 4, options), {}, weights);
  CHECK(cost.cut_weight == 18);
  CHECK(cost.cut == 18);
}

TEST_CASE("connected_parts_are_connected_and_balanced") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const CsrGraph graph = random_mesh_graph(24, 18, seed);
    const std::vector<Point2> points =
        random_points(vertex_count(graph), seed);  // nothing to do with the graph
    PartitionOptions options;
    options.connected = true;
    options.seed = seed;
    options.imbalance = 0.1;
    for (const std::uint32_t parts : {2U, 6U, 13U}) {
      for (const PartitionMethod method : {PartitionMethod::multilevel, PartitionMethod::cuthill_mckee}) {
        options.method = method;
        const Partition found = partition(graph, parts, options);
        const PartitionCost cost = partition_cost(graph, found);
        CHECK(found.outcome == PartitionOutcome::done);
        CHECK(cost.max_components == 1);
        CHECK(cost.largest <= heaviest_allowed(vertex_count(graph), parts, 0.1));
      }
      options.method = PartitionMethod::coordinate;
      options.coordinates = std::span<const Point2>(points);
      const Partition scattered = partition(graph, parts, options);
      const PartitionCost cost = partition_cost(graph, scattered);
      CHECK((cost.max_components == 1) == (scattered.outcome == PartitionOutcome::done));
      CHECK(cost.largest <= heaviest_allowed(vertex_count(graph), parts, 0.1));
    }
  }
}

namespace {

/// A partition by coordinate bisection of points on a line, then made connected.
Partition connected_along_a_line(const CsrGraph& graph, std::uint32_t parts,
                                 const std::vector<double>& places, double imbalance,
                                 const std::vector<std::uint32_t>& weights = {}) {
  std::vector<Point2> points;
  for (const double x : places) points.push_back({x, 0});
  PartitionOptions options;
  options.method = PartitionMethod::coordinate;
  options.connected = true;
  options.imbalance = imbalance;
  options.coordinates = std::span<const Point2>(points);
  options.vertex_weights = weights;
  return partition(graph, parts, options);
}

}  // namespace

TEST_CASE("the_heaviest_piece_of_a_part_stays_and_loose_ones_go_where_most_edges_lead") {
  using Parts = std::vector<std::uint32_t>;
  // A path whose last vertex lies among the first ones: it goes to its neighbour's part.
  const std::vector<double> places{0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 5};
  const Partition path_parts = connected_along_a_line(path(12), 2, places, 0.5);
  CHECK(path_parts.outcome == PartitionOutcome::done);
  CHECK(path_parts.part_of == Parts{0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1});
  // Perfect balance: the other part hands a vertex back across their border.
  const Partition balanced = connected_along_a_line(path(12), 2, places, 0);
  CHECK(balanced.outcome == PartitionOutcome::done);
  CHECK(balanced.part_of == Parts{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
  // Vertex 4 is loose, with one edge to the second part and two to the third.
  const CsrGraph three = graph_from_edges(15, Edges{{0, 1},
                                                    {1, 2},
                                                    {2, 3},
                                                    {3, 5},
                                                    {5, 6},
                                                    {6, 7},
                                                    {7, 8},
                                                    {8, 9},
                                                    {9, 10},
                                                    {10, 11},
                                                    {11, 12},
                                                    {12, 13},
                                                    {13, 14},
                                                    {4, 9},
                                                    {4, 12},
                                                    {4, 14}})
                             .graph;
  const Partition joined =
      connected_along_a_line(three, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}, 0.5);
  CHECK(joined.part_of == Parts{0, 0, 0, 0, 2, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2});
}

TEST_CASE("a_vertex_too_heavy_for_the_part_beside_is_not_handed_on") {
  const Partition found = connected_along_a_line(path(4), 2, {0, 2, 3, 1}, 0, {5, 3, 3, 1});
  CHECK(found.outcome == PartitionOutcome::disconnected);
  CHECK(found.part_of == std::vector<std::uint32_t>{0, 1, 1, 0});
}

TEST_CASE("a_way_that_does_not_help_is_undone_before_the_next_is_tried") {
  // A path 0 ... 4 and a vertex 5 beside 2, loose in the last part. The middle part then is too heavy: vertex 1 is too
  // heavy for the first part, vertex 3 is not for the last.
  const CsrGraph graph = graph_from_edges(6, Edges{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {2, 5}}).graph;
  const Partition found = connected_along_a_line(graph, 3, {0, 1, 2, 3, 5, 4}, 0, {5, 3, 2, 1, 5, 1});
  CHECK(found.outcome == PartitionOutcome::done);
  CHECK(found.part_of == std::vector<std::uint32_t>{0, 1, 1, 2, 2, 1});
}

TEST_CASE("connected_parts_of_too_many_components_are_told") {
  PartitionOptions options;
  options.connected = true;
  CHECK(partition(without_edges(6), 3, options).outcome == PartitionOutcome::disconnected);
}

TEST_CASE("a_stopped_partition_is_balanced_and_says_so") {
  std::stop_source stop;
  stop.request_stop();
  PartitionOptions options;
  options.progress.stop = stop.get_token();
  const CsrGraph graph = random_mesh_graph(50, 50, 1);
  for (const PartitionMethod method : {PartitionMethod::multilevel, PartitionMethod::cuthill_mckee}) {
    options.method = method;
    const Partition found = partition(graph, 9, options);
    CHECK(found.outcome == PartitionOutcome::stopped);
    CHECK(std::ranges::max(weights_of(found, {})) <=
          static_cast<std::uint64_t>(heaviest_allowed(vertex_count(graph), 9, 0.03)));
  }
}

TEST_CASE("the_multilevel_method_reports_progress_between_0_and_1") {
  PartitionOptions options;
  double last = 0;
  int reports = 0;
  options.progress.report = [&](std::string_view, double fraction) {
    CHECK(fraction >= last);
    CHECK(fraction <= 1);
    last = fraction;
    ++reports;
  };
  static_cast<void>(partition(random_mesh_graph(40, 40, 1), 4, options));
  CHECK(reports > 1);
}

TEST_CASE("inertial_bisection_cuts_across_the_longest_extent_in_any_direction") {
  std::vector<Point2> points;
  std::vector<Point3> in_space;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 3; ++j) {  // a strip along the diagonal, on which a box sees no longer side
      points.push_back({i + 0.5 * j, i - 0.5 * j});
      in_space.push_back({i + 0.5 * j, i - 0.5 * j, 2.0 * i});
    }
  const Partition halves = recursive_inertial_bisection(points, 2);
  for (std::size_t k = 0; k < points.size(); ++k) CHECK(halves.part_of[k] == k / 30);
  CHECK(recursive_inertial_bisection(in_space, 2).part_of == halves.part_of);
}

TEST_CASE("inertial_bisection_counts_along_the_axis_whatever_its_direction") {
  for (int turn = 0; turn < 16; ++turn) {
    const double angle = 0.1 + turn * std::numbers::pi / 8;
    std::vector<Point2> points;
    for (int i = 0; i < 10; ++i) points.push_back({i * std::cos(angle), i * std::sin(angle)});
    const bool forwards =
        std::abs(std::cos(angle)) > std::abs(std::sin(angle)) ? std::cos(angle) > 0 : std::sin(angle) > 0;
    const Partition halves = recursive_inertial_bisection(points, 2);
    CHECK(halves.part_of.front() == (forwards ? 0 : 1));
    CHECK(halves.part_of.back() == (forwards ? 1 : 0));
  }
  std::mt19937_64 random(1);
  for (int turn = 0; turn < 200; ++turn) {
    std::array<double, 3> axis{0, 0.25, 0.5};  // no two of one size
    for (double& x : axis) x += static_cast<double>(random() % 2001) - 1000;
    std::vector<Point3> points;
    for (int i = 0; i < 10; ++i) points.push_back({i * axis[0], i * axis[1], i * axis[2]});
    const double largest = *std::ranges::max_element(axis, {}, [](double x) { return std::abs(x); });
    CHECK(recursive_inertial_bisection(points, 2).part_of.front() == (largest > 0 ? 0 : 1));
  }
}

TEST_CASE("inertial_bisection_finds_the_axis_of_the_largest_finite_coordinates") {
  const double large = std::numeric_limits<double>::max();
  const std::array<Point2, 4> upright{{{-0.1 * large, large},
                                       {0.1 * large, 0.9 * large},
                                       {0.1 * large, -large},
                                       {-0.1 * large, -0.9 * large}}};
  std::array<std::size_t, 4> sequence{0, 1, 2, 3};
  do {
    std::vector<Point2> points;
    for (const std::size_t i : sequence) points.push_back(upright[i]);
    const Partition halves = recursive_inertial_bisection(points, 2);
    for (std::size_t i = 0; i < 4; ++i) CHECK(halves.part_of[i] == (points[i].y < 0 ? 0 : 1));
  } while (std::ranges::next_permutation(sequence).found);
}

TEST_CASE("inertial_bisection_takes_the_largest_finite_coordinates") {
  const double huge = std::numeric_limits<double>::max();
  const std::vector<Point2> points{{huge, -huge}, {-huge, huge}, {0.9 * huge, -huge}, {-0.9 * huge, huge}};
  const Partition halves = recursive_inertial_bisection(points, 2);
  CHECK(halves.part_of[0] == halves.part_of[2]);
  CHECK(halves.part_of[1] == halves.part_of[3]);
  CHECK(halves.part_of[0] != halves.part_of[1]);
}

TEST_CASE("coordinate_bisection_in_space_cuts_the_longest_side") {
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 4; ++j) points.push_back({0.1 * j, 0.2 * j, 1.0 * i});
  const Partition halves = recursive_coordinate_bisection(points, 2);
  for (std::size_t k = 0; k < points.size(); ++k) CHECK(halves.part_of[k] == k / 16);
}

TEST_CASE("cuthill_mckee_bisection_at_level_sets_cuts_a_grid_along_a_level") {
  // A path of five rows: levels are its columns or diagonals, the median falls within one.
  const CsrGraph graph = renamed(grid(33, 5), random_order(165, 2));
  const PartitionCost median =
      partition_cost(graph, recursive_cuthill_mckee_bisection(graph, 2, CuthillMcKeeCut::median));
  const PartitionCost levels =
      partition_cost(graph, recursive_cuthill_mckee_bisection(graph, 2, CuthillMcKeeCut::level_set));
  CHECK(median.largest - median.smallest == 1);
  CHECK(levels.largest - levels.smallest <= 5);
  CHECK(levels.cut <= median.cut);
  CHECK(levels.max_components == 1);
}

TEST_CASE("level_sets_leave_a_vertex_for_every_part_and_keep_both_sides_within_the_bound") {
  CuthillMcKeeOptions anything;
  anything.imbalance = 100;
  const Partition full = recursive_cuthill_mckee_bisection(star(9), 8, CuthillMcKeeCut::level_set, anything);
  CHECK(partition_cost(star(9), full).smallest > 0);
  // A path of 40 to a hub of 59 leaves: no level but one ends near the median, and that leaves too much behind.
  for (const bool leaves_first : {true, false}) {
    Edges edges;
    for (std::uint32_t v = 1; v < 41; ++v) edges.push_back({v - 1, v});
    for (std::uint32_t leaf = 41; leaf < 100; ++leaf) edges.push_back({40, leaf});
    std::vector<std::uint32_t> name(100);
    for (std::uint32_t v = 0; v < 100; ++v) name[v] = leaves_first ? 99 - v : v;
    const CsrGraph broom = renamed(graph_from_edges(100, edges).graph, name);
    CuthillMcKeeOptions options;
    options.imbalance = 0.1;
    const Partition halves = recursive_cuthill_mckee_bisection(broom, 2, CuthillMcKeeCut::level_set, options);
    CHECK(partition_cost(broom, halves).largest <= 55);
  }
}

TEST_CASE("level_sets_keep_the_imbalance_over_all_halvings_together") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const CsrGraph graph = random_mesh_graph(60, 25, seed);
    for (const double imbalance : {0.05, 0.2, 0.5})
      for (const std::uint32_t parts : {4U, 8U, 16U}) {
        CuthillMcKeeOptions options;
        options.imbalance = imbalance;
        const Partition found =
            recursive_cuthill_mckee_bisection(graph, parts, CuthillMcKeeCut::level_set, options);
        CHECK(partition_cost(graph, found).largest <=
              heaviest_allowed(vertex_count(graph), parts, imbalance) + 1);
      }
  }
}

TEST_CASE("cuthill_mckee_level_sets_give_fewer_pieces_than_the_median") {
  std::size_t at_median = 0, at_levels = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const CsrGraph dual = dual_graph(random_triangulation(30, 20, seed));
    for (const std::uint32_t parts : {4U, 8U, 16U}) {
      const auto pieces = [&](CuthillMcKeeCut where) {
        const auto found = recursive_cuthill_mckee_bisection(dual, parts, where);
        const std::vector<std::uint32_t> components = partition_cost(dual, found).components;
        return std::accumulate(components.begin(), components.end(), std::size_t{0});
      };
      at_median += pieces(CuthillMcKeeCut::median);
      at_levels += pieces(CuthillMcKeeCut::level_set);
    }
  }
  CHECK(at_levels < at_median);
}

TEST_CASE("partitions_that_make_no_sense_are_refused") {
  const CsrGraph graph = path(5);
  const auto refused = [&](std::uint32_t parts, const PartitionOptions& options, const char* why) {
    CHECK_THROWS_WITH_AS(static_cast<void>(partition(graph, parts, options)), doctest::Contains(why),
                         InputError);
  };
  refused(0, {}, "0 parts");
  refused(6, {}, "6 parts of 5 vertices");
  PartitionOptions negative;
  negative.imbalance = -0.1;
  refused(2, negative, "imbalance");
  PartitionOptions no_number;
  no_number.imbalance = std::nan("");
  refused(2, no_number, "imbalance");
  PartitionOptions no_points;
  no_points.method = PartitionMethod::inertial;
  refused(2, no_points, "0 points for 5 vertices");
  PartitionOptions weighted;
  const std::vector<std::uint32_t> few{1, 2}, zero{1, 1, 0, 1, 1}, large(5, 1U << 30);
  weighted.vertex_weights = few;
  refused(2, weighted, "2 weights for 5 vertices");
  weighted.vertex_weights = zero;
  refused(2, weighted, "weight 2 is 0");
  weighted.vertex_weights = large;
  refused(2, weighted, "scale them down");
  PartitionOptions lopsided;
  const std::vector<std::uint32_t> edge_weights{1, 1, 2, 2, 3, 3, 4, 5};
  lopsided.edge_weights = edge_weights;
  refused(2, lopsided, "edge 3-4 weighs 4 one way and 5 the other");
}

TEST_CASE("the_empty_graph_and_one_part_are_trivial") {
  CHECK(partition(path(0), 1).part_of.empty());
  CHECK_THROWS_AS(static_cast<void>(partition(path(0), 2)), InputError);
  for (const PartitionMethod method : {PartitionMethod::multilevel, PartitionMethod::spectral}) {
    PartitionOptions options;
    options.method = method;
    CHECK(partition(path(3), 1, options).part_of == std::vector<std::uint32_t>(3, 0));
  }
}

TEST_CASE("weighted_costs_count_weights") {
  const CsrGraph graph = path(4);
  const Partition halves{2, {0, 0, 1, 1}, PartitionOutcome::done};
  const std::vector<std::uint32_t> vertex_weights{1, 2, 3, 4}, edge_weights{5, 5, 7, 7, 9, 9};
  const PartitionCost cost = partition_cost(graph, halves, vertex_weights, edge_weights);
  CHECK(cost.cut == 1);
  CHECK(cost.cut_weight == 7);
  CHECK(cost.weights == std::vector<std::uint64_t>{3, 7});
  CHECK(cost.imbalance == doctest::Approx(0.4));
  CHECK_THROWS_AS(static_cast<void>(partition_cost(graph, halves, edge_weights)), InputError);
}
