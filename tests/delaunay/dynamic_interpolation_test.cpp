// SPDX-License-Identifier: MIT
// Weights of natural neighbours and linear interpolation: convex combinations, and areas by clipping.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::DynamicTriangulation;
using delaunay::NaturalNeighbours;
using delaunay::VertexWeight;
using Kind = delaunay::PointLocation::Kind;

struct RationalPoint {
  mpq_class x, y;
};
using Polygon = std::vector<RationalPoint>;

/// The part of a convex polygon that is nearer to a than to b.
Polygon nearer_part(const Polygon& polygon, Point2 a, Point2 b) {
  const auto height = [&](const RationalPoint& p) {  // |p - b|^2 - |p - a|^2, linear in p
    const mpq_class ax = p.x - mpq_class(a.x), ay = p.y - mpq_class(a.y);
    const mpq_class bx = p.x - mpq_class(b.x), by = p.y - mpq_class(b.y);
    return mpq_class(bx * bx + by * by - ax * ax - ay * ay);
  };
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const mpq_class h = height(p), k = height(q);
    if (h >= 0) part.push_back(p);
    if ((h > 0 && k < 0) || (h < 0 && k > 0)) {
      const mpq_class t = h / (h - k);
      part.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return part;
}

mpq_class area2(const Polygon& polygon) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

/// The Voronoi cell of p among others, cut off by a box.
Polygon cell(Point2 p, const std::vector<Point2>& others, double box) {
  const mpq_class r = box;
  Polygon polygon{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
  for (const Point2 q : others)
    if (q != p) polygon = nearer_part(polygon, p, q);
  return polygon;
}

/// Sibson's weights by their definition: cells clipped in rational arithmetic. p's cell must lie in the box.
std::vector<double> weights_by_clipping(const std::vector<Point2>& sites, Point2 p, double box) {
  const Polygon own = cell(p, sites, box);
  const mpq_class total = area2(own);
  std::vector<double> weights;
  for (const Point2 site : sites) {
    Polygon lost = own;
    for (const Point2 other : sites)
      if (other != site) lost = nearer_part(lost, site, other);
    weights.push_back(mpq_class(area2(lost) / total).get_d());
  }
  return weights;
}

TEST_CASE("sibson_weights_are_shares_of_voronoi_cells_clipped_in_rational_arithmetic") {
  const std::vector<shapes::NamedPoints> sets{{"uniform", shapes::uniform(40, 12)},
                                              {"grid", shapes::transformed(shapes::grid(5), 0.25, 0)},
                                              {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  for (const shapes::NamedPoints& set : sets) {
    CAPTURE(set.name);
    const DynamicTriangulation sites(set.points);
    for (const Point2 q : shapes::uniform(20, 13)) {
      const Point2 p{0.25 + 0.5 * q.x, (set.name == "uniform" ? 0.25 : -0.75) + 0.5 * q.y};
      const Point2 inside = set.name == "square" ? Point2{0.25 + 0.5 * q.x, 0.25 + 0.5 * q.y} : p;
      const NaturalNeighbours found = sites.natural_neighbours(inside);
      if (found.where == Kind::outside) continue;
      std::vector<double> weights(set.points.size(), 0);
      for (const auto& [v, weight] : found.weights) weights[v.index()] = weight;
      const std::vector<double> expected = weights_by_clipping(set.points, inside, 1e6);
      for (std::size_t i = 0; i < weights.size(); ++i)
        CHECK(weights[i] == doctest::Approx(expected[i]).epsilon(1e-9).scale(1));
    }
  }
}

/// How far a convex combination is from p, as a part of the distances that it sums; and from a sum of 1.
double error_of(const DynamicTriangulation& sites, Point2 p, const std::vector<VertexWeight>& weights) {
  mpq_class x = 0, y = 0, sum = 0, size = 0;
  for (const auto& [v, weight] : weights) {
    CHECK(weight >= 0);
    const mpq_class dx = mpq_class(sites.point(v).x) - mpq_class(p.x);
    const mpq_class dy = mpq_class(sites.point(v).y) - mpq_class(p.y);
    x += weight * dx;
    y += weight * dy;
    size += weight * (abs(dx) + abs(dy));
    sum += weight;
  }
  const mpq_class off = abs(x) + abs(y), from_one = abs(mpq_class(sum - 1));
  const mpq_class relative = size == 0 ? off : mpq_class(off / size);
  return std::max(relative.get_d(), from_one.get_d());
}

TEST_CASE("weights_are_convex_combinations_of_the_point_in_every_family") {
  std::vector<shapes::NamedPoints> all = shapes::families();
  all.push_back({"line", {{0, 0}, {3, 1}, {9, 3}, {27, 9}}});
  all.push_back(
      {"whole range", {{-1.7e308, -1.7e308}, {1.7e308, -1.7e308}, {0, 1.7e308}, {0, 0}, {1e300, 1e299}}});
  for (const shapes::NamedPoints& family : all) {
    CAPTURE(family.name);
    const DynamicTriangulation sites(family.points);
    std::mt19937_64 random(17);
    const auto any = [&] { return family.points[random() % family.points.size()]; };
    for (int i = 0; i < 60; ++i) {
      const Point2 a = any(), b = any(), c = any();
      const Point2 p{a.x / 4 + b.x / 4 + c.x / 2, a.y / 4 + b.y / 4 + c.y / 2};
      const NaturalNeighbours found = sites.natural_neighbours(p);
      CHECK(found.where == sites.locate(p).kind);
      if (found.where == Kind::outside) {
        CHECK(found.weights.empty());
        continue;
      }
      CHECK(error_of(sites, p, found.weights) < 1e-9);
    }
  }
}

TEST_CASE("linear_functions_are_reproduced") {
  const std::vector<Point2> points = shapes::uniform(2000, 21);
  const DynamicTriangulation sites(points);
  const auto f = [](Point2 p) { return 3 * p.x - 7 * p.y + 2; };
  std::vector<double> values;
  for (const Point2 p : points) values.push_back(f(p));
  std::vector<Point2> queries = shapes::uniform(2000, 22);
  std::size_t inside = 0;
  for (const Point2 p : queries) {
    const auto linear = sites.interpolate_linear(p, values);
    const auto natural = sites.interpolate_natural_neighbour(p, values);
    CHECK(linear.inside() == natural.inside());
    if (!linear.inside()) {
      CHECK(std::isnan(linear.value));
      CHECK(std::isnan(natural.value));
      continue;
    }
    ++inside;
    CHECK(linear.value == doctest::Approx(f(p)).epsilon(1e-10).scale(1));
    CHECK(natural.value == doctest::Approx(f(p)).epsilon(1e-10).scale(1));
  }
  CHECK(inside > 1900);
}

TEST_CASE("interpolation_is_defined_on_vertices_edges_hull_and_outside") {
  const DynamicTriangulation sites(std::vector<Point2>{{0, 0}, {4, 0}, {0, 4}, {1, 1}});
  const std::vector<double> values{0, 8, 4, 100};
  for (const bool natural : {false, true}) {
    const auto at = [&](Point2 p) {
      return natural ? sites.interpolate_natural_neighbour(p, values) : sites.interpolate_linear(p, values);
    };
    CHECK(at({1, 1}).where == Kind::on_vertex);
    CHECK(at({1, 1}).value == 100);
    CHECK(at({1, 0}).where == Kind::on_edge);
    CHECK(at({1, 0}).value == 2);
    CHECK(at({3, 1}).value == 7);
    CHECK(at({0.5, 0.5}).where == Kind::on_edge);
    CHECK(at({1, 0.5}).where == Kind::in_triangle);
    CHECK(at({-1e-300, 1}).where == Kind::outside);
    CHECK(std::isnan(at({5, 5}).value));
  }
  CHECK(sites.interpolate_linear({0.5, 0.5}, values).value == 50);
  CHECK(sites.natural_neighbours({0.5, 0.5}).weights.size() == 4);
  CHECK(sites.natural_neighbours({3, 1}).weights.size() == 2);
}

TEST_CASE("natural_neighbour_interpolation_is_continuous_next_to_the_hull_and_to_vertices") {
  const std::vector<Point2> points = shapes::uniform(60, 31);
  DynamicTriangulation sites(points);
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i) values.push_back(std::sin(static_cast<double>(7 * i)));
  const std::vector<VertexId> hull = sites.hull();
  const Point2 centre{0.5, 0.5};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const VertexId from = hull[i], to = hull[(i + 1) % hull.size()];
    const Point2 a = sites.point(from), b = sites.point(to);
    const double on_edge = 0.75 * values[from.index()] + 0.25 * values[to.index()];
    for (const double step : {1e-7, 1e-10, 1e-13}) {
      const Point2 on_hull{0.75 * a.x + 0.25 * b.x, 0.75 * a.y + 0.25 * b.y};
      const Point2 p = on_hull + step * (centre - on_hull), near_vertex = a + step * (centre - a);
      const auto next_to_hull = sites.interpolate_natural_neighbour(p, values);
      const auto next_to_vertex = sites.interpolate_natural_neighbour(near_vertex, values);
      if (next_to_hull.inside()) CHECK(std::abs(next_to_hull.value - on_edge) < 1e4 * step + 1e-9);
      if (next_to_vertex.inside())
        CHECK(std::abs(next_to_vertex.value - values[from.index()]) < 1e4 * step + 1e-9);
    }
  }
}

}  // namespace
}  // namespace leonhard
