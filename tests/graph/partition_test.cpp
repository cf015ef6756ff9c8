// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "leonhard/graph/fiedler.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

std::vector<Point2> centroids(const TriangleMesh& mesh) {
  std::vector<Point2> result;
  for (const auto& c : mesh.corners) {
    const Point2 a = mesh.points[c[0]], b = mesh.points[c[1]], d = mesh.points[c[2]];
    result.push_back({(a.x + b.x + d.x) / 3, (a.y + b.y + d.y) / 3});
  }
  return result;
}

std::size_t difference_of_sizes(const Partition& partition) {
  std::vector<std::size_t> sizes(partition.parts, 0);
  for (const std::uint32_t part : partition.part_of) ++sizes.at(part);
  return *std::ranges::max_element(sizes) - *std::ranges::min_element(sizes);
}

}  // namespace

TEST_CASE("bisections_into_any_number_of_parts_are_balanced_within_one") {
  const TriangleMesh mesh = random_triangulation(13, 11, 4);
  const CsrGraph dual = dual_graph(mesh);
  const std::vector<Point2> points = centroids(mesh);
  for (const std::uint32_t parts : {1U, 2U, 3U, 5U, 7U, 8U, 16U, 31U, 100U, 286U}) {
    CAPTURE(parts);
    CHECK(difference_of_sizes(recursive_coordinate_bisection(points, parts)) <= 1);
    const Partition spectral = recursive_spectral_bisection(dual, parts);
    CHECK(difference_of_sizes(spectral) <= 1);
    CHECK(spectral.outcome == PartitionOutcome::done);
  }
}

TEST_CASE("coordinate_bisection_cuts_the_longer_side_and_counts_from_the_left") {
  std::vector<Point2> points;  // 6 by 2 points
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 2; ++j) points.push_back({i + 0.0, j + 0.0});
  const Partition three = recursive_coordinate_bisection(points, 3);
  for (std::size_t k = 0; k < points.size(); ++k) CHECK(three.part_of[k] == k / 4);
  for (Point2& p : points) std::swap(p.x, p.y);
  CHECK(recursive_coordinate_bisection(points, 3).part_of == three.part_of);
}

TEST_CASE("coordinate_bisection_does_not_depend_on_the_sequence_of_distinct_points") {
  std::vector<Point2> points = centroids(random_triangulation(9, 8, 6));
  for (int i = 0; i < 9; ++i)  // and many with one coordinate in common
    for (int j = 0; j < 9; ++j) points.push_back({i + 0.0, j + 0.0});
  const Partition plain = recursive_coordinate_bisection(points, 6);
  const auto order = random_order(static_cast<std::uint32_t>(points.size()), 6);
  std::vector<Point2> shuffled;
  for (const std::uint32_t old : order) shuffled.push_back(points[old]);
  const Partition other = recursive_coordinate_bisection(shuffled, 6);
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(other.part_of[i] == plain.part_of[order[i]]);
}

TEST_CASE("coordinate_bisection_breaks_ties_of_coincident_points_by_index") {
  const std::vector<Point2> points(10, Point2{1, 1});
  const Partition halves = recursive_coordinate_bisection(points, 2);
  for (std::size_t i = 0; i < 10; ++i) CHECK(halves.part_of[i] == i / 5);
}

TEST_CASE("coordinate_bisection_finds_the_longer_side_of_the_largest_finite_box") {
  const double huge = std::numeric_limits<double>::max();  // both sides overflow
  const std::vector<Point2> points{{0.6 * huge, -huge}, {-0.6 * huge, huge}, {0.1, 1}, {0.2, -1}};
  CHECK(recursive_coordinate_bisection(points, 2).part_of == std::vector<std::uint32_t>{0, 1, 1, 0});
}

TEST_CASE("coordinate_bisection_breaks_ties_by_the_other_coordinate") {
  const std::vector<Point2> points{{0, 0}, {1, 1}, {1, 0}, {3, 0}};
  CHECK(recursive_coordinate_bisection(points, 2).part_of == std::vector<std::uint32_t>{0, 1, 0, 1});
}

TEST_CASE("weights_are_halved_at_the_point_nearest_to_the_share") {
  const auto part_of = [](std::vector<std::uint32_t> weights, std::uint32_t parts) {
    std::vector<Point2> points;
    for (std::size_t i = 0; i < weights.size(); ++i) points.push_back({static_cast<double>(i), 0});
    return recursive_coordinate_bisection(points, parts, weights).part_of;
  };
  using Parts = std::vector<std::uint32_t>;
  CHECK(part_of({3, 1, 1, 1, 1, 1, 1, 3}, 2) == Parts{0, 0, 0, 0, 1, 1, 1, 1});
  CHECK(part_of({3, 3, 3, 1}, 2) == Parts{0, 0, 1, 1});        // 6 and 4 rather than 3 and 7
  CHECK(part_of({2, 2, 2, 9, 3}, 3) == Parts{0, 0, 0, 1, 2});  // a third is 6
}

TEST_CASE("spectral_bisection_cuts_a_long_grid_across") {
  const CsrGraph graph = renamed(grid(40, 7), random_order(280, 3));
  const PartitionCost halves = partition_cost(graph, recursive_spectral_bisection(graph, 2));
  CHECK(halves.cut == 7);
  CHECK(halves.max_components == 1);
  CHECK(partition_cost(graph, recursive_spectral_bisection(graph, 4)).cut == 21);
}

TEST_CASE("spectral_bisection_beats_coordinate_bisection_on_a_bent_strip") {
  Edges edges;  // a strip 4 wide bent into a spiral of two sides: coordinates see a square, the graph a strip
  std::vector<Point2> points;
  for (std::uint32_t i = 0; i < 60; ++i)
    for (std::uint32_t j = 0; j < 4; ++j) {
      const std::uint32_t v = 4 * i + j;
      if (i > 0) edges.push_back({v - 4, v});
      if (j > 0) edges.push_back({v - 1, v});
      const double angle = 0.09 * i, radius = 10 + j;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  const CsrGraph graph = graph_from_edges(240, edges).graph;
  const std::size_t spectral = partition_cost(graph, recursive_spectral_bisection(graph, 2)).cut;
  CHECK(spectral == 4);
  CHECK(spectral < partition_cost(graph, recursive_coordinate_bisection(points, 2)).cut);
}

TEST_CASE("spectral_bisection_is_the_same_every_time") {
  const CsrGraph dual = dual_graph(random_triangulation(20, 20, 5));
  CHECK(recursive_spectral_bisection(dual, 7).part_of == recursive_spectral_bisection(dual, 7).part_of);
}

TEST_CASE("the_seed_of_spectral_bisection_reaches_the_eigensolver") {
  const CsrGraph square = grid(24, 24);  // a double eigenvalue: the start decides which vector is found
  CHECK(recursive_spectral_bisection(square, 2, 3).part_of !=
        recursive_spectral_bisection(square, 2, 4).part_of);
}

TEST_CASE("spectral_bisection_deals_out_whole_components") {
  const CsrGraph graph = disjoint_union({grid(5, 4), cycle(10), path(10), path(12), path(8)});
  const PartitionCost cost = partition_cost(graph, recursive_spectral_bisection(graph, 2));
  CHECK(cost.cut == 0);
  CHECK(cost.sizes == std::vector<std::uint32_t>{30, 30});
}

TEST_CASE("spectral_bisection_splits_one_component_where_it_must") {
  const CsrGraph graph = disjoint_union({grid(20, 3), path(2), path(1), path(1)});
  const PartitionCost cost = partition_cost(graph, recursive_spectral_bisection(graph, 2));
  CHECK(cost.sizes == std::vector<std::uint32_t>{32, 32});
  CHECK(cost.cut <= 5);
  CHECK(cost.cut >= 3);
}

TEST_CASE("more_parts_than_vertices_leaves_the_rest_empty_and_says_so") {
  const Partition spectral = recursive_spectral_bisection(path(5), 9);
  const Partition coordinate = recursive_coordinate_bisection(std::vector<Point2>(5), 9);
  for (const Partition& partition : {spectral, coordinate}) {
    CHECK(partition.outcome == PartitionOutcome::empty_parts);
    CHECK(std::set<std::uint32_t>(partition.part_of.begin(), partition.part_of.end()).size() == 5);
  }
  CHECK(recursive_coordinate_bisection(std::vector<Point2>(5), 6).outcome == PartitionOutcome::empty_parts);
  CHECK(recursive_coordinate_bisection(std::vector<Point2>(5), 5).outcome == PartitionOutcome::done);
  const PartitionCost cost = partition_cost(path(5), spectral);
  CHECK(cost.smallest == 0);
  CHECK(std::ranges::count(cost.components, 0U) == 4);
  CHECK(recursive_spectral_bisection(path(0), 3).part_of.empty());
}

TEST_CASE("a_stopped_spectral_bisection_is_still_balanced_and_says_so") {
  std::stop_source stop;
  Progress progress;
  progress.stop = stop.get_token();
  int reports = 0;
  progress.report = [&](std::string_view, double fraction) {
    CHECK(fraction >= 0);
    CHECK(fraction <= 1);
    if (++reports == 2) stop.request_stop();
  };
  const Partition partition = recursive_spectral_bisection(grid(20, 20), 8, 1, progress);
  CHECK(partition.outcome == PartitionOutcome::stopped);
  CHECK(difference_of_sizes(partition) == 0);
}

TEST_CASE("four_times_the_cut_is_the_1_norm_of_the_laplacian_times_the_sides") {  // Barth's notes (2.3.6)
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const CsrGraph graph = random_mesh_graph(12, 8, seed);
    Partition partition{2, {}, PartitionOutcome::done};
    std::mt19937_64 random(seed);
    std::vector<double> side;
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v) {
      partition.part_of.push_back(static_cast<std::uint32_t>(random() >> 63));
      side.push_back(partition.part_of.back() == 0 ? -1 : 1);
    }
    double norm1 = 0;
    for (const double entry : laplacian_product(graph, side)) norm1 += std::abs(entry);
    CHECK(norm1 == 4.0 * static_cast<double>(partition_cost(graph, partition).cut));
  }
}

TEST_CASE("partition_cost_agrees_with_its_definition") {
  const CsrGraph graph = random_mesh_graph(9, 7, 2);
  Partition partition{5, {}, PartitionOutcome::done};
  std::mt19937_64 random(1);
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    partition.part_of.push_back(static_cast<std::uint32_t>(random() % 5));
  std::size_t cut = 0;
  std::map<std::uint32_t, std::set<std::uint32_t>> halo, neighbours_of;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v)) {
      const std::uint32_t a = partition.part_of[v], b = partition.part_of[w];
      if (a == b) continue;
      cut += v < w ? 1 : 0;
      halo[a].insert(w);
      neighbours_of[a].insert(b);
    }
  const PartitionCost cost = partition_cost(graph, partition);
  CHECK(cost.cut == cut);
  std::size_t total = 0;
  for (std::uint32_t part = 0; part < 5; ++part) {
    CHECK(cost.sizes[part] == std::ranges::count(partition.part_of, part));
    CHECK(cost.halo[part] == halo[part].size());
    CHECK(cost.neighbours[part] == neighbours_of[part].size());
    std::vector<std::uint32_t> members;
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      if (partition.part_of[v] == part) members.push_back(v);
    CHECK(cost.components[part] == components(SubgraphExtractor(graph)(members)).count());
    total += halo[part].size();
  }
  CHECK(cost.total_halo == total);
  CHECK(cost.imbalance == doctest::Approx(cost.largest / (vertex_count(graph) / 5.0) - 1));
}

TEST_CASE("a_vertex_goes_to_the_part_of_most_of_its_triangles") {
  const TriangleMesh mesh = random_triangulation(10, 8, 9);
  for (const std::uint32_t parts : {1U, 2U, 3U, 6U}) {
    const auto triangles = partition_of<TriangleId>(recursive_spectral_bisection(dual_graph(mesh), parts));
    const VertexPartition vertices = vertex_partition_from_dual(mesh, triangles);
    REQUIRE(vertices.part_of.size() == mesh.vertex_count());
    std::vector<std::vector<std::uint32_t>> votes(mesh.vertex_count(), std::vector<std::uint32_t>(parts, 0));
    for (const TriangleId t : mesh.corners.ids())
      for (const VertexId v : mesh.corners[t]) ++votes[v.index()][triangles.part_of[t]];
    for (const VertexId v : mesh.points.ids()) {
      const auto& here = votes[v.index()];
      const auto winner = std::ranges::max_element(here) - here.begin();  // the first of the largest
      CHECK(vertices.part_of[v] == winner);
    }
  }
}

TEST_CASE("partitions_of_the_wrong_size_or_with_wrong_parts_are_refused") {
  CHECK_THROWS_AS(static_cast<void>(recursive_spectral_bisection(path(4), 0)), InputError);
  CHECK_THROWS_AS(static_cast<void>(recursive_coordinate_bisection(std::vector<Point2>(4), 0)), InputError);
  const std::vector<Point2> bad{{0, 0}, {std::nan(""), 1}};
  CHECK_THROWS_WITH_AS(static_cast<void>(recursive_coordinate_bisection(bad, 2)),
                       doctest::Contains("point 1"), InputError);
  const Partition short_one{2, {0, 1}, PartitionOutcome::done};
  CHECK_THROWS_AS(static_cast<void>(partition_cost(path(3), short_one)), InputError);
  const Partition wild{2, {0, 1, 2}, PartitionOutcome::done};
  CHECK_THROWS_WITH_AS(static_cast<void>(partition_cost(path(3), wild)),
                       doctest::Contains("entry 2 names part 2"), InputError);
  CHECK_THROWS_AS(static_cast<void>(vertex_partition_from_dual(random_triangulation(2, 2, 1),
                                                               partition_of<TriangleId>(short_one))),
                  InputError);
}

TEST_CASE("a_mesh_is_cut_in_one_call_as_its_graph_is_in_two") {
  const TriangleMesh mesh = random_triangulation(9, 7, 4);
  const TrianglePartition triangles = partition_triangles(mesh, 5);
  CHECK(triangles.part_of.flat() == partition(dual_graph(mesh), 5).part_of);
  const VertexPartition vertices = partition_vertices(mesh, 5);
  CHECK(vertices.part_of.flat() == partition(vertex_graph(mesh, mesh::build_edges(mesh)), 5).part_of);
  CHECK(partition_cost(dual_graph(mesh), triangles).cut ==
        partition_cost(dual_graph(mesh), Partition{5, triangles.part_of.flat()}).cut);
  static_assert(!std::is_convertible_v<VertexPartition, TrianglePartition>);
  static_assert(!std::is_convertible_v<Partition, TrianglePartition>);
}

TEST_CASE("geometric_methods_cut_a_mesh_by_its_own_points") {
  const TriangleMesh mesh = random_triangulation(9, 7, 4);
  const PartitionOptions options{.method = PartitionMethod::coordinate};
  CHECK(partition_vertices(mesh, 4, options).part_of.flat() ==
        recursive_coordinate_bisection(mesh.points.flat(), 4).part_of);
  const TrianglePartition triangles = partition_triangles(mesh, 2, options);
  for (const TriangleId t : mesh.corners.ids()) {  // 9 wide: the cut runs near x = 4.5
    double x = 0;
    for (const VertexId v : mesh.corners[t]) x += mesh.points[v].x / 3;
    if (x < 4) CHECK(triangles.part_of[t] == 0);
    if (x > 5) CHECK(triangles.part_of[t] == 1);
  }
}
