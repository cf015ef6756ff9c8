// SPDX-License-Identifier: MIT
// How much incremental construction changes in bad and in random orders: Barth's notes 3.3b and 3.3c.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "leonhard/delaunay/delaunay_tree.hpp"
#include "leonhard/delaunay/order/insertion_order.hpp"
#include "leonhard/delaunay/plane/green_sibson.hpp"
#include "leonhard/delaunay/plane/watson.hpp"
#include "leonhard/delaunay/scopes.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::DelaunayTree;
using delaunay::random_order;

std::vector<std::uint32_t> as_given(std::size_t n) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

TEST_CASE("sites_added_from_right_to_left_before_a_column_make_quadratically_many_triangles") {
  for (const std::size_t half : {25, 50, 200}) {
    const std::vector<Point2> sites = shapes::column_and_row(half);
    const std::size_t n = sites.size();
    const delaunay::Construction watson = delaunay::insert_watson(sites, as_given(n));
    const delaunay::Construction swapping = delaunay::insert_green_sibson(sites, as_given(n));
    // Each site of the row but the first sees the whole column and its predecessor.
    CHECK(watson.structural_changes >= (half - 1) * (half + 1));
    CHECK(swapping.structural_changes >= (half - 1) * (2 * half - 2));

    std::size_t cavities = 0, swaps = 0;
    constexpr std::size_t draws = 10;
    for (std::uint64_t seed = 1; seed <= draws; ++seed) {
      cavities += delaunay::insert_watson(sites, random_order(n, seed)).structural_changes;
      swaps += DelaunayTree(sites, random_order(n, seed)).structural_changes();
    }
    CHECK(cavities <= draws * 6 * n);
    CHECK(swaps <= draws * 9 * n);
  }
}

// After r insertions the triangulation of the sphere has r + 1 vertices and so 3 r - 3 edges, the ghost the
// degree of the hull: a site drawn at random, the last one inserted, has a degree below 6 on the average.
// That many triangles are Delaunay then and were not before; 2 degree - 3 were made.
TEST_CASE("random_orders_make_fewer_than_6_n_delaunay_triangles_and_9_n_in_all") {
  for (const shapes::NamedPoints& set : {shapes::NamedPoints{"uniform", shapes::uniform(2000)},
                                         shapes::NamedPoints{"parabola", shapes::parabola(2000)},
                                         shapes::NamedPoints{"lines", shapes::line_pair(2000)}}) {
    CAPTURE(set.name);
    const std::size_t n = set.points.size();
    std::size_t delaunay_ever = 0, made = 0;
    constexpr std::size_t draws = 5;
    for (std::uint64_t seed = 1; seed <= draws; ++seed) {
      const DelaunayTree tree(set.points, random_order(n, seed));
      made += tree.structural_changes();
      delaunay::for_each_delaunay_ever(tree, [&](const auto&) { ++delaunay_ever; });
    }
    CHECK(delaunay_ever <= draws * 6 * n);
    CHECK(10 * delaunay_ever >= draws * 49 * n);  // 5 n if all sites are on the hull
    CHECK(made <= draws * 9 * n);
  }
}

TEST_CASE("triangles_of_scope_j_appear_as_often_as_their_corners_come_before_the_sites_inside") {
  const std::vector<Point2> sites = shapes::uniform(40);
  const std::vector<std::size_t> existing = delaunay::triangles_of_scope(sites);
  CHECK(std::accumulate(existing.begin(), existing.end(), std::size_t{0}) == 40 * 39 * 38 / 6);
  std::vector<double> sum(existing.size(), 0), sum_of_squares(existing.size(), 0);
  constexpr std::size_t draws = 400;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    std::vector<double> seen(existing.size(), 0);
    delaunay::for_each_delaunay_ever(DelaunayTree(sites, random_order(sites.size(), seed)),
                                     [&](const delaunay::Corners& corners) {
                                       if (corners[0] != delaunay::GhostTriangulation::ghost)
                                         ++seen[delaunay::scope(sites, corners)];
                                     });
    for (std::size_t j = 0; j < seen.size(); ++j) {
      sum[j] += seen[j];
      sum_of_squares[j] += seen[j] * seen[j];
    }
  }
  for (std::size_t j = 0; j < 20; ++j) {
    CAPTURE(j);
    const double expected = delaunay::appearance_probability(j) * static_cast<double>(existing[j]),
                 mean = sum[j] / draws;
    const double deviation = std::sqrt((sum_of_squares[j] / draws - mean * mean) / draws);
    CHECK(std::abs(mean - expected) <= 4 * deviation);
    if (j == 0) CHECK(deviation == 0);
  }
}

}  // namespace
}  // namespace leonhard
