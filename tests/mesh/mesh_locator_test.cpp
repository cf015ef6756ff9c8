// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mesh_locator.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "leonhard/kernel/arithmetic/homogeneous.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelf.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;
using mesh::MeshLocator;
using mesh::Place;

namespace {

// ---- an oracle in rational numbers ----

template <std::size_t d>
using Exact = std::array<mpq_class, d>;

Exact<2> exact(Point2 p) { return {mpq_class(p.x), mpq_class(p.y)}; }
Exact<3> exact(const Point3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

template <std::size_t d>
Exact<d> minus(const Exact<d>& a, const Exact<d>& b) {
  Exact<d> difference;
  for (std::size_t i = 0; i < d; ++i) difference[i] = a[i] - b[i];
  return difference;
}
template <std::size_t d>
mpq_class dot(const Exact<d>& a, const Exact<d>& b) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < d; ++i) sum += a[i] * b[i];
  return sum;
}
Exact<3> cross(const Exact<3>& a, const Exact<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class volume(const std::array<Exact<2>, 3>& c) {
  const Exact<2> u = minus(c[1], c[0]), v = minus(c[2], c[0]);
  return u[0] * v[1] - u[1] * v[0];
}
mpq_class volume(const std::array<Exact<3>, 4>& c) {
  return dot(cross(minus(c[1], c[0]), minus(c[2], c[0])), minus(c[3], c[0]));
}

/// The barycentric coordinates of p among a cell's corners, by Cramer's rule.
template <class Mesh, class CellId, class Point>
auto barycentric(const Mesh& mesh, CellId c, const Point& p) {
  constexpr std::size_t n = MeshLocator<Mesh>::corners_each;
  std::array<Exact<n - 1>, n> corners;
  for (std::size_t i = 0; i < n; ++i) corners[i] = exact(mesh.points[mesh.corners[c][i]]);
  std::array<mpq_class, n> weights;
  for (std::size_t i = 0; i < n; ++i) {
    auto with_p = corners;
    with_p[i] = exact(p);
    weights[i] = volume(with_p) / volume(corners);
  }
  return weights;
}

/// Is p beyond a cell's corners in some direction? Comparing needs no rational numbers.
template <class Mesh, class CellId, class Point>
bool is_beyond(const Mesh& mesh, CellId c, const Point& p) {
  const auto& corners = mesh.corners[c];
  for (std::size_t axis = 0; axis < kernel::dimension<Point>; ++axis) {
    const double x = kernel::coordinate(p, axis);
    const auto of_corner = [&](VertexId v) { return kernel::coordinate(mesh.points[v], axis); };
    if (std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return of_corner(v) < x; }) ||
        std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return of_corner(v) > x; }))
      return true;
  }
  return false;
}

template <class Mesh, class Point>
typename MeshLocator<Mesh>::Location locate_by_search(const Mesh& mesh, const Point& p) {
  typename MeshLocator<Mesh>::Location location;
  for (const auto c : mesh.corners.ids()) {
    if (is_beyond(mesh, c, p)) continue;
    const auto weights = barycentric(mesh, c, p);
    if (std::any_of(weights.begin(), weights.end(), [](const mpq_class& w) { return w < 0; })) continue;
    location.cell = c;
    std::vector<VertexId> vertices;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] > 0) vertices.push_back(mesh.corners[c][i]);
    }
    std::sort(vertices.begin(), vertices.end());
    std::copy(vertices.begin(), vertices.end(), location.vertices.begin());
    location.place = vertices.size() == weights.size() ? Place::in_cell
                     : vertices.size() == 1            ? Place::on_vertex
                     : vertices.size() == 2            ? Place::on_edge
                                                       : Place::on_face;
    break;
  }
  return location;
}

template <class Point>
mpq_class distance2(const Point& p, const Point& q) {
  const auto d = minus(exact(p), exact(q));
  return dot(d, d);
}

/// The squared distance of p from the segment ab, without rounding.
template <std::size_t d>
mpq_class distance2_to(const Exact<d>& p, const Exact<d>& a, const Exact<d>& b) {
  const auto along = minus(b, a), to_p = minus(p, a);
  mpq_class t = dot(to_p, along) / dot(along, along);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  Exact<d> off = to_p;
  for (std::size_t i = 0; i < d; ++i) off[i] -= t * along[i];
  return dot(off, off);
}
mpq_class distance2_to(const Exact<3>& p, const Exact<3>& a, const Exact<3>& b, const Exact<3>& c) {
  mpq_class least = std::min({distance2_to(p, a, b), distance2_to(p, b, c), distance2_to(p, c, a)});
  const auto normal = cross(minus(b, a), minus(c, a));
  const auto is_inside = [&](const Exact<3>& from, const Exact<3>& to) {
    return dot(cross(minus(to, from), minus(p, from)), normal) >= 0;
  };
  if (is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
    const mpq_class height = dot(minus(p, a), normal);
    least = std::min<mpq_class>(least, height * height / dot(normal, normal));
  }
  return least;
}
mpq_class distance2_to(const TriangleMesh& mesh, const MarkedEdge& edge, Point2 p) {
  return distance2_to(exact(p), exact(mesh.points[edge.from]), exact(mesh.points[edge.to]));
}
mpq_class distance2_to(const TetMesh& mesh, const MarkedFace& face, const Point3& p) {
  const auto& [a, b, c] = face.corners;
  return distance2_to(exact(p), exact(mesh.points[a]), exact(mesh.points[b]), exact(mesh.points[c]));
}

// ---- places to ask for ----

Point2 middle(Point2 a, Point2 b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
Point3 middle(const Point3& a, const Point3& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

/// A random point of the box about a mesh and a quarter more on every side.
Point2 random_point(const TriangleMesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-0.25, 1.25);
  Point2 low = mesh.points[VertexId{0}], high = low;
  for (const Point2 p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low.x + unit(random) * (high.x - low.x), low.y + unit(random) * (high.y - low.y)};
}
Point3 random_point(const TetMesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-0.25, 1.25);
  Point3 low = mesh.points[VertexId{0}], high = low;
  for (const Point3& p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {low.x + unit(random) * (high.x - low.x), low.y + unit(random) * (high.y - low.y),
          low.z + unit(random) * (high.z - low.z)};
}

/// Vertices, middles of edges and of middles, the mirror images of vertices in others, and points at random.
template <class Mesh>
auto places_in_and_about(const Mesh& mesh, unsigned seed) {
  using Point = typename MeshLocator<Mesh>::Point;
  std::mt19937 random(seed);
  std::vector<Point> places(mesh.points.begin(), mesh.points.end());
  for (const auto& corners : mesh.corners) {
    const Point a = mesh.points[corners[0]], b = mesh.points[corners[1]], c = mesh.points[corners[2]];
    places.push_back(middle(a, b));
    places.push_back(middle(middle(a, b), c));
    places.push_back(middle(middle(a, b), mesh.points[corners.back()]));
    places.push_back(a + (a - b));
  }
  std::shuffle(places.begin(), places.end(), random);
  if (places.size() > 24) places.resize(24);
  for (int i = 0; i < 8; ++i) places.push_back(random_point(mesh, random));
  return places;
}

template <class Visit>
void for_each_on_both_shelves(const Visit& visit) {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    visit(entry.mesh);
  }
  for (const tet_shelf::Entry& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    visit(entry.mesh);
  }
}

/// A field that is linear in the coordinates, one value a vertex.
double linear(Point2 p) { return 3 - 2 * p.x + 0.5 * p.y; }
double linear(const Point3& p) { return 3 - 2 * p.x + 0.5 * p.y + 7 * p.z; }

template <class Mesh>
std::vector<double> linear_field(const Mesh& mesh) {
  std::vector<double> values;
  for (const auto& p : mesh.points) values.push_back(linear(p));
  return values;
}

}  // namespace

TEST_CASE("points_are_located_as_a_search_in_rational_numbers_finds_them") {
  for_each_on_both_shelves([](const auto& mesh) {
    const MeshLocator locator(mesh);
    for (const auto& p : places_in_and_about(mesh, 1)) {
      CAPTURE(p);
      CHECK(locator.locate(p) == locate_by_search(mesh, p));
    }
  });
}

TEST_CASE("holes_and_cavities_are_outside_and_their_rims_inside") {
  const TriangleMesh ring = shelf::grid_without(3, {{1, 1}});
  CHECK(!MeshLocator(ring).locate({1.5, 1.5}).inside());
  CHECK(MeshLocator(ring).locate({1, 1.5}).place == Place::on_edge);
  const TetMesh hollow = tet_shelf::cubes(tet_shelf::box_without(3, 3, 3, {{1, 1, 1}}));
  CHECK(!MeshLocator(hollow).locate({1.5, 1.5, 1.5}).inside());
  CHECK(MeshLocator(hollow).locate({1, 1.5, 1.25}).place == Place::on_face);
}

TEST_CASE("where_triangles_overlap_the_one_of_smallest_id_is_found") {
  const TriangleMesh wheels =
      shelf::build({{0, 0}, {2, 0}, {-1, 2}, {-1, -2}, {3, 0}, {-2, 3}, {-2, -3}},
                   {{0, 4, 5}, {0, 5, 6}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 6, 4}});
  REQUIRE(!mesh::validate(wheels));
  const MeshLocator locator(wheels);
  CHECK(locator.locate({0.5, 0.25}).cell == TriangleId{0});
  CHECK(locator.locate({0.5, -0.25}).cell == TriangleId{4});
}

TEST_CASE("the_nearest_vertex_is_exact_and_the_smallest_of_those_as_near") {
  for_each_on_both_shelves([](const auto& mesh) {
    const MeshLocator locator(mesh);
    for (const auto& p : places_in_and_about(mesh, 2)) {
      MaybeId<VertexId> nearest;
      for (const VertexId v : mesh.points.ids()) {
        if (!nearest || distance2(p, mesh.points[v]) < distance2(p, mesh.points[*nearest])) nearest = v;
      }
      CAPTURE(p);
      CHECK(locator.nearest_vertex(p) == nearest);
    }
  });
}

TEST_CASE("the_nearest_point_is_as_near_as_any_on_the_boundary_and_lies_where_it_says") {
  for_each_on_both_shelves([](const auto& mesh) {
    const MeshLocator locator(mesh);
    for (const auto& p : places_in_and_about(mesh, 3)) {
      CAPTURE(p);
      const auto nearest = locator.nearest_point(p);
      if (const auto location = locator.locate(p); location.inside()) {
        CHECK(nearest.point == p);
        CHECK(nearest.distance == 0);
        CHECK(nearest.location == location);
        CHECK(nearest.boundary_entry == mesh.boundary.size());
        continue;
      }
      std::vector<double> distances;
      for (const auto& facet : mesh.boundary)
        distances.push_back(std::sqrt(distance2_to(mesh, facet, p).get_d()));
      const double least = *std::min_element(distances.begin(), distances.end());
      CHECK(nearest.distance == doctest::Approx(least).epsilon(1e-12));
      CHECK(distance(nearest.point, p) == doctest::Approx(least).epsilon(1e-12));
      REQUIRE(nearest.boundary_entry < mesh.boundary.size());
      CHECK(distances[nearest.boundary_entry] == doctest::Approx(least).epsilon(1e-12));
      REQUIRE(nearest.weights.count > 0);
      auto sum = mesh.points[nearest.weights.vertices[0]];
      for (std::size_t i = 1; i < nearest.weights.count; ++i) {
        CHECK(*nearest.location.vertices[i] == nearest.weights.vertices[i]);
        CHECK(nearest.weights.vertices[i - 1] < nearest.weights.vertices[i]);
        sum += nearest.weights.weights[i] *
               (mesh.points[nearest.weights.vertices[i]] - mesh.points[nearest.weights.vertices[0]]);
      }
      CHECK(distance(sum, nearest.point) < 1e-12);
    }
  });
}

TEST_CASE("the_boundary_entry_is_the_first_of_those_equally_near") {
  const TriangleMesh square = shelf::grid(1, 1);
  const auto nearest = MeshLocator(square).nearest_point({-1, -1});
  CHECK(nearest.point == Point2{0, 0});
  CHECK(nearest.location.place == Place::on_vertex);
  for (std::size_t e = 0; e < nearest.boundary_entry; ++e) {
    CHECK(square.boundary[e].from != VertexId{0});
    CHECK(square.boundary[e].to != VertexId{0});
  }
}

TEST_CASE("weights_are_those_of_rational_numbers") {
  for_each_on_both_shelves([](const auto& mesh) {
    const MeshLocator locator(mesh);
    for (const auto& p : places_in_and_about(mesh, 4)) {
      CAPTURE(p);
      const auto location = locator.locate(p);
      const auto weights = locator.weights_at(p);
      CHECK((weights.count > 0) == location.inside());
      if (!location.inside()) continue;
      const auto expected = barycentric(mesh, *location.cell, p);
      std::size_t at = 0;
      for (const MaybeId<VertexId> v : location.vertices) {
        if (!v) continue;
        const auto& corners = mesh.corners[*location.cell];
        const auto i =
            static_cast<std::size_t>(std::find(corners.begin(), corners.end(), *v) - corners.begin());
        CHECK(weights.vertices[at] == *v);
        CHECK(std::abs(weights.weights[at++] - expected[i].get_d()) < 0x1p-40);
      }
      CHECK(at == weights.count);
    }
  });
}

TEST_CASE("weights_in_slivers_are_as_good_as_elsewhere") {
  const TriangleMesh sliver = shelf::build({{0, 0}, {1, 1}, {0.7, 0.7 + 0x1p-50}}, {{0, 1, 2}});
  const TetMesh thin = tet_shelf::build(
      {{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0.25}, {0.375, 0.375, 0.28125 + 0x1p-50}}, {{0, 1, 2, 3}});
  const auto check = [](const auto& mesh, auto p) {
    const MeshLocator locator(mesh);
    const auto location = locator.locate(p);
    REQUIRE(location.inside());
    const auto weights = locator.weights_at(p);
    const auto expected = barycentric(mesh, *location.cell, p);
    std::size_t at = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] > 0) CHECK(std::abs(weights.weights[at++] - expected[i].get_d()) < 0x1p-40);
    }
  };
  std::size_t tried = 0;
  for (double t = 0.71; t < 1; t += 0.01) {
    const Point2 p{t, std::nextafter(t, 2.0)};
    if (!MeshLocator(sliver).locate(p).inside()) continue;
    ++tried;
    check(sliver, p);
  }
  CHECK(tried > 5);
  tried = 0;
  for (double x = 0.2; x < 0.6; x += 0.01) {
    const Point3 p{x, 0.375, 0.5 * x + 0.09375 + 0x1p-52};
    if (!MeshLocator(thin).locate(p).inside()) continue;
    ++tried;
    check(thin, p);
  }
  CHECK(tried > 5);
}

TEST_CASE("linear_fields_are_reproduced_and_constant_ones_to_the_bit") {
  for_each_on_both_shelves([](const auto& mesh) {
    const MeshLocator locator(mesh);
    const std::vector<double> values = linear_field(mesh), constant(mesh.vertex_count(), 0.1);
    for (const auto& p : places_in_and_about(mesh, 5)) {
      double result = -1, same = -1;
      const auto location = locator.interpolate(p, values, std::span(&result, 1));
      CHECK(location == locator.interpolate(p, constant, std::span(&same, 1)));
      CHECK(result == (location.inside() ? doctest::Approx(linear(p)).epsilon(1e-12) : doctest::Approx(-1)));
      CHECK(same == (location.inside() ? 0.1 : -1));
      if (location.place == Place::on_vertex) CHECK(result == values[(*location.vertices[0]).index()]);
    }
  });
}

TEST_CASE("components_of_a_field_are_interpolated_each") {
  const TriangleMesh triangle = shelf::build({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  std::array<double, 2> result{};
  CHECK(MeshLocator(triangle)
            .interpolate({0.25, 0.5}, std::array<double, 6>{0, 100, 4, 200, 8, 400}, result)
            .inside());
  CHECK(result[0] == doctest::Approx(0.25 * 4 + 0.5 * 8));
  CHECK(result[1] == doctest::Approx(0.25 * 100 + 0.25 * 200 + 0.5 * 400));
}

TEST_CASE("batches_answer_as_single_queries_do") {
  for_each_on_both_shelves([](const auto& mesh) {
    using Locator = MeshLocator<std::remove_cvref_t<decltype(mesh)>>;
    const Locator locator(mesh);
    const auto places = places_in_and_about(mesh, 6);
    const std::vector<double> values = linear_field(mesh);
    std::vector<typename Locator::Location> locations(places.size());
    std::vector<MaybeId<VertexId>> vertices(places.size());
    std::vector<double> results(places.size());
    locator.locate(places, locations);
    locator.nearest_vertices(places, vertices);
    const std::size_t outside = locator.interpolate(places, values, 1, results);
    std::size_t expected_outside = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      CHECK(locations[i] == locator.locate(places[i]));
      CHECK(vertices[i] == locator.nearest_vertex(places[i]));
      double result = -1;
      if (locator.interpolate(places[i], values, std::span(&result, 1)).inside()) {
        CHECK(results[i] == result);
      } else {
        CHECK(std::isnan(results[i]));
        ++expected_outside;
      }
    }
    CHECK(outside == expected_outside);
  });
}

TEST_CASE("coordinates_of_any_size_are_located") {
  for (const double size : {1e-310, 1e-150, 1e150, 8e307}) {
    CAPTURE(size);
    const TriangleMesh mesh =
        shelf::build({{-size, -size}, {size, -size}, {size, size}, {-size, size}}, {{0, 1, 2}, {0, 2, 3}});
    const MeshLocator locator(mesh);
    CHECK(locator.locate({size / 2, size / 4}).cell == TriangleId{0});
    CHECK(locator.locate({size / 2, size / 2}).place == Place::on_edge);
    CHECK(!locator.locate({2 * size, size / 4}).inside());
    CHECK(locator.nearest_vertex({size / 2, size / 4}) == VertexId{2});
    const auto nearest = locator.nearest_point({2 * size, size / 2});
    CHECK(nearest.point.x == doctest::Approx(size));
    CHECK(nearest.distance == doctest::Approx(size));
    double result = 0;
    CHECK(locator.interpolate({size / 2, 0}, std::array<double, 4>{0, 1, 1, 0}, std::span(&result, 1))
              .inside());
    CHECK(result == doctest::Approx(0.75));
  }
}

TEST_CASE("the_locator_refuses_what_it_cannot_answer") {
  const TriangleMesh grid = shelf::grid(2, 2);
  const MeshLocator locator(grid);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  std::vector<double> result(1, -1);
  CHECK_THROWS_AS((void)locator.locate({nan, 0}), InputError);
  CHECK_THROWS_AS((void)locator.nearest_vertex({0, inf}), InputError);
  CHECK_THROWS_AS((void)locator.nearest_point({nan, 0}), InputError);
  CHECK_THROWS_AS((void)locator.weights_at({nan, 0}), InputError);
  CHECK_THROWS_AS((void)locator.interpolate({0, 0}, std::vector<double>(8), result), InputError);
  CHECK(result[0] == -1);
  const std::vector<Point2> points{{0, 0}, {nan, 0}};
  std::vector<MeshLocator<TriangleMesh>::Location> locations(2), too_few(1);
  CHECK_THROWS_AS(locator.locate(points, locations), InputError);
  CHECK(!locations[0].inside());
  CHECK_THROWS_AS(locator.locate(points, too_few), InputError);
  TriangleMesh broken = grid;
  broken.corners[TriangleId{1}][0] = VertexId{70};
  CHECK_THROWS_AS(MeshLocator{std::as_const(broken)}, InputError);
  broken = grid;
  broken.points[VertexId{4}].x = nan;
  CHECK_THROWS_AS(MeshLocator{std::as_const(broken)}, InputError);
}

TEST_CASE("in_an_empty_mesh_nothing_is_found") {
  const TetMesh empty;
  const MeshLocator locator(empty);
  CHECK(!locator.locate({0, 0, 0}).inside());
  CHECK(!locator.nearest_vertex({0, 0, 0}));
  const auto nearest = locator.nearest_point({1, 2, 3});
  CHECK(nearest.location.place == Place::outside);
  CHECK(std::isinf(nearest.distance));
  CHECK(nearest.weights.count == 0);
}
