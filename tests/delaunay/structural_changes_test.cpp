// SPDX-License-Identifier: MIT
// How much incremental construction changes in bad and in random orders: Barth's notes 3.3b and 3.3c.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "leonhard/delaunay/delaunay_tree.hpp"
#include "leonhard/delaunay/green_sibson.hpp"
#include "leonhard/delaunay/insertion_order.hpp"
#include "leonhard/delaunay/watson.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::DelaunayTree;
using delaunay::HistoryNodeId;
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

/// One a site: when it came.
std::vector<std::size_t> ranks(const std::vector<std::uint32_t>& order) {
  std::vector<std::size_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  return rank;
}

/// Calls back for each triangle of a history that was Delaunay after some insertion: it was not made and
/// replaced by the same one, that is, its newest corner is not that of its children.
template <class Visit>
void for_each_delaunay_ever(const DelaunayTree& tree, const std::vector<std::size_t>& rank,
                            const Visit& visit) {
  const delaunay::TriangleHistory& history = tree.history();
  const auto newest = [&](HistoryNodeId n) {
    std::size_t latest = 0;
    for (const VertexId v : history.corners(n))
      if (v != delaunay::GhostTriangulation::ghost) latest = std::max(latest, rank[v.index()]);
    return latest;
  };
  for (const HistoryNodeId n : IdRange<HistoryNodeId>(history.node_count()))
    if (history.child_count(n) == 0 || newest(n) != newest(history.child(n, 0))) visit(history.corners(n));
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
      const std::vector<std::uint32_t> order = random_order(n, seed);
      const DelaunayTree tree(set.points, order);
      made += tree.structural_changes();
      for_each_delaunay_ever(tree, ranks(order), [&](const auto&) { ++delaunay_ever; });
    }
    CHECK(delaunay_ever <= draws * 6 * n);
    CHECK(10 * delaunay_ever >= draws * 49 * n);  // 5 n if all sites are on the hull
    CHECK(made <= draws * 9 * n);
  }
}

using Corners = std::array<VertexId, 3>;

/// The number of sites inside the circumcircle, ties broken as everywhere.
std::size_t scope(const std::vector<Point2>& sites, const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  const Sign turn = kernel::orient2d(sites[a.index()], sites[b.index()], sites[c.index()]);
  std::size_t inside = 0;
  for (const Point2 p : sites)
    inside += kernel::incircle_perturbed(sites[a.index()], sites[b.index()], sites[c.index()], p) * turn ==
                      Sign::positive
                  ? 1
                  : 0;
  return inside;
}

/// How many of all triangles of the sites have scope 0, 1, ...
std::vector<double> triangles_of_scope(const std::vector<Point2>& sites) {
  std::vector<double> count(sites.size(), 0);
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        ++count[scope(sites, {VertexId::from(i), VertexId::from(j), VertexId::from(k)})];
  return count;
}

// A triangle of scope j is Delaunay at some time if its corners come before the j sites in its circle: 3! j!
// of the (j + 3)! orders of these do that (Guibas, Knuth and Sharir 1992; Barth's notes 3.3c).
TEST_CASE("triangles_of_scope_j_appear_with_probability_6_j_over_j_plus_3_factorial") {
  const std::vector<Point2> sites = shapes::uniform(40);
  const std::vector<double> existing = triangles_of_scope(sites);
  std::vector<double> sum(sites.size(), 0), sum_of_squares(sites.size(), 0);
  constexpr std::size_t draws = 400;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const std::vector<std::uint32_t> order = random_order(sites.size(), seed);
    std::vector<double> seen(sites.size(), 0);
    for_each_delaunay_ever(DelaunayTree(sites, order), ranks(order), [&](const Corners& triangle) {
      if (triangle[0] != delaunay::GhostTriangulation::ghost) ++seen[scope(sites, triangle)];
    });
    for (std::size_t j = 0; j < seen.size(); ++j) {
      sum[j] += seen[j];
      sum_of_squares[j] += seen[j] * seen[j];
    }
  }
  for (std::size_t j = 0; j < 20; ++j) {
    CAPTURE(j);
    const auto real_j = static_cast<double>(j);
    const double probability = 6 / ((real_j + 1) * (real_j + 2) * (real_j + 3));
    const double expected = probability * existing[j], mean = sum[j] / draws;
    const double deviation = std::sqrt((sum_of_squares[j] / draws - mean * mean) / draws);
    CHECK(std::abs(mean - expected) <= 4 * deviation);
    if (j == 0) CHECK(deviation == 0);
  }
}

}  // namespace
}  // namespace leonhard
