// SPDX-License-Identifier: MIT
// Location and nearest vertices against brute force; single queries against batches.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::DynamicTriangulation;
using delaunay::PointLocation;
using Kind = PointLocation::Kind;

/// States to ask: every family, some of it removed again, and what spans no triangle.
std::vector<DynamicTriangulation> states() {
  std::vector<DynamicTriangulation> all(1);
  all.emplace_back(std::vector<Point2>{{0.5, 0.25}});
  all.emplace_back(std::vector<Point2>{{0, 0}, {1, 2}, {-3, -6}, {8, 16}, {4, 8}});
  all.emplace_back(std::vector<Point2>{{0, 3}, {0, 1}});
  for (const shapes::NamedPoints& family : shapes::families()) {
    all.emplace_back(family.points);
    DynamicTriangulation thinned(family.points);
    for (unsigned v = 0; v < thinned.id_bound(); v += 3) thinned.remove(VertexId{v});
    all.push_back(thinned);
  }
  return all;
}

/// Vertices, midpoints of edges, centres, and points all around.
std::vector<Point2> queries(const DynamicTriangulation& sites, std::uint64_t seed) {
  std::vector<Point2> points{{0, 0}, {0.5, 0.5}, {1e308, -1e308}, {-5e-324, 5e-324},
                             {4, 8}, {5, 10},    {16, 32}};
  const auto half = [](Point2 a, Point2 b) { return Point2{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}; };
  for (const VertexId v : sites.vertices()) points.push_back(sites.point(v));
  for (const auto& [a, b] : sites.edges()) points.push_back(half(sites.point(a), sites.point(b)));
  std::mt19937_64 random(seed);
  for (std::size_t i = points.size(); i-- > 7;) {
    const Point2 p = half(points[random() % points.size()], points[random() % points.size()]);
    points.push_back(p);
    points.push_back({2 * p.x - points[i].x / 2, 2 * p.y - points[i].y / 2});
  }
  points.erase(std::remove_if(points.begin(), points.end(), [](Point2 p) { return !is_finite(p); }),
               points.end());
  points = shapes::shuffled(points, seed);
  points.resize(std::min<std::size_t>(points.size(), 60));
  return points;
}

bool between(Point2 a, Point2 p, Point2 b) {
  return (a < p) == (p < b) && a != p && p != b && kernel::exact::orient2d(a, b, p) == Sign::zero;
}

/// The only right answer, from a look at every vertex, edge and triangle in rational arithmetic.
PointLocation brute_location(const DynamicTriangulation& sites, Point2 p) {
  for (const VertexId v : sites.vertices())
    if (sites.point(v) == p) return {Kind::on_vertex, {v}};
  for (const auto& [a, b] : sites.edges())
    if (between(sites.point(a), p, sites.point(b))) return {Kind::on_edge, {std::min(a, b), std::max(a, b)}};
  for (auto corners : sites.triangles()) {
    const auto left = [&](std::size_t i) {
      return kernel::exact::orient2d(sites.point(corners[i]), sites.point(corners[(i + 1) % 3]), p) ==
             Sign::positive;
    };
    if (!left(0) || !left(1) || !left(2)) continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return {Kind::in_triangle, {corners[0], corners[1], corners[2]}};
  }
  return {};
}

MaybeId<VertexId> brute_nearest(const DynamicTriangulation& sites, Point2 p) {
  const auto distance2 = [&](VertexId v) {
    const mpq_class dx = mpq_class(sites.point(v).x) - mpq_class(p.x);
    const mpq_class dy = mpq_class(sites.point(v).y) - mpq_class(p.y);
    return mpq_class(dx * dx + dy * dy);
  };
  MaybeId<VertexId> best;
  mpq_class least;
  for (const VertexId v : sites.vertices()) {
    const mpq_class d = distance2(v);
    if (best && (d > least || (d == least && sites.point(*best) < sites.point(v)))) continue;
    best = v;
    least = d;
  }
  return best;
}

MaybeId<VertexId> any_hint(const DynamicTriangulation& sites, std::mt19937_64& random) {
  if (sites.id_bound() == 0 || random() % 4 == 0) return {};
  return VertexId::from(random() % (sites.id_bound() + 2));  // some are removed or have never been
}

TEST_CASE("location_is_that_of_brute_force_from_any_hint") {
  std::mt19937_64 random(4);
  for (const DynamicTriangulation& sites : states()) {
    CAPTURE(sites.size());
    for (const Point2 p : queries(sites, 1)) {
      const PointLocation expected = brute_location(sites, p);
      CHECK(sites.locate(p) == expected);
      CHECK(sites.locate(p, any_hint(sites, random)) == expected);
    }
  }
}

TEST_CASE("nearest_vertices_are_those_of_brute_force_ties_to_the_lexicographically_first") {
  std::mt19937_64 random(5);
  for (const DynamicTriangulation& sites : states()) {
    CAPTURE(sites.size());
    for (const Point2 p : queries(sites, 2)) {
      const MaybeId<VertexId> expected = brute_nearest(sites, p);
      CHECK(sites.nearest_vertex(p) == expected);
      CHECK(sites.nearest_vertex(p, any_hint(sites, random)) == expected);
    }
  }
}

TEST_CASE("the_centre_of_a_circle_of_vertices_is_nearest_to_the_leftmost") {
  std::vector<Point2> circle = shapes::cocircular();
  const DynamicTriangulation sites(std::span<const Point2>(circle).subspan(1));  // without the centre
  const MaybeId<VertexId> nearest = sites.nearest_vertex({0, 0});
  REQUIRE(nearest.has_value());
  CHECK(sites.point(*nearest) == *std::min_element(circle.begin(), circle.end()));
}

/// The number of points at which a batch's answer is not the single query's, to the bit.
std::size_t count_differences(const DynamicTriangulation& sites, const std::vector<Point2>& points,
                              unsigned threads) {
  std::vector<double> values;
  for (std::size_t i = 0; i < sites.id_bound(); ++i) values.push_back(static_cast<double>(i % 17) / 3);
  const auto same = [](const delaunay::Interpolated& a, const delaunay::Interpolated& b) {
    return a.where == b.where && (a.value == b.value || !a.inside());
  };
  const std::vector<PointLocation> located = sites.locate(points, threads);
  const std::vector<MaybeId<VertexId>> nearest = sites.nearest_vertices(points, threads);
  const auto linear = sites.interpolate_linear(points, values, threads);
  const auto natural = sites.interpolate_natural_neighbour(points, values, threads);
  std::size_t differences = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 p = points[i];
    if (located.at(i) != sites.locate(p) || nearest.at(i) != sites.nearest_vertex(p) ||
        !same(linear.at(i), sites.interpolate_linear(p, values)) ||
        !same(natural.at(i), sites.interpolate_natural_neighbour(p, values)))
      ++differences;
  }
  return differences;
}

TEST_CASE("batches_answer_as_single_queries_for_any_number_of_threads") {
  for (const unsigned threads : {0U, 1U, 2U}) {
    for (const DynamicTriangulation& sites : states()) {
      CAPTURE(sites.size());
      CHECK(count_differences(sites, queries(sites, 3), threads) == 0);
    }
    const DynamicTriangulation many(shapes::uniform(5000, 8));
    const std::vector<Point2> blocks = shapes::transformed(shapes::uniform(4000, 6), 1.2, -0.1);
    CHECK(count_differences(many, blocks, threads) == 0);
  }
}

TEST_CASE("batches_refuse_what_single_queries_refuse") {
  const DynamicTriangulation sites(shapes::grid(4));
  const std::vector<Point2> points{{0, 0}, {0, std::numeric_limits<double>::quiet_NaN()}};
  const std::vector<double> values(16), too_few(15);
  CHECK_THROWS_AS((void)sites.locate(points), InputError);
  CHECK_THROWS_AS((void)sites.nearest_vertices(points), InputError);
  CHECK_THROWS_AS((void)sites.interpolate_linear(points, values), InputError);
  CHECK_THROWS_AS((void)sites.interpolate_linear(points[0], too_few), InputError);
  CHECK_THROWS_AS(
      (void)sites.interpolate_natural_neighbour(std::span<const Point2>(points).first(1), too_few),
      InputError);
  CHECK(sites.locate(std::vector<Point2>{}).empty());
}

}  // namespace
}  // namespace leonhard
