// SPDX-License-Identifier: MIT
// The Delaunay tetrahedralisation by flips, against its definition.
#include "leonhard/delaunay/space/tet_flipping.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stop_token>

#include "tests/delaunay/shapes3.hpp"
#include "tests/delaunay/tet_oracles.hpp"

namespace leonhard {
namespace {

using delaunay::PointTetrahedralization;
using delaunay::tetrahedralize_flipping;
using delaunay::TetrahedralizeOutcome;

std::vector<oracles::TetPoints> flipped_tets(const std::vector<Point3>& points, std::uint64_t seed = 1) {
  delaunay::TetAlgorithmOptions options;
  options.seed = seed;
  const PointTetrahedralization made = tetrahedralize_flipping(points, options);
  REQUIRE(made.outcome == TetrahedralizeOutcome::done);
  const auto broken = oracles::broken_geometry(made.cells, points);
  INFO(broken.value_or(""));
  REQUIRE_FALSE(broken.has_value());
  return oracles::tet_set(made.cells, points);
}

/// The sets from all of which at most `n` points are drawn.
std::vector<shapes3::NamedPoints> small_families(std::size_t n) {
  std::vector<shapes3::NamedPoints> all = shapes3::families();
  for (shapes3::NamedPoints& family : all) {
    family.points = shapes3::shuffled(shapes3::distinct(family.points), 5);
    family.points.resize(std::min(family.points.size(), n));
  }
  all.push_back({"2 x 2 x 2", shapes3::grid(2, 2, 2)});
  all.push_back({"3 x 3 x 2", shapes3::grid(3, 3, 2)});
  all.push_back({"4 x 2 x 2", shapes3::grid(4, 2, 2)});
  all.push_back({"octahedron", shapes3::lattice_sphere(1)});
  all.push_back({"cuboctahedron", shapes3::lattice_sphere(2)});
  all.push_back({"cuboctahedron and its centre", shapes3::lattice_sphere(2)});
  all.back().points.push_back({0, 0, 0});
  all.push_back({"octahedron in a cube", shapes3::lattice_sphere(3)});
  for (const Point3& p : shapes3::lattice_sphere(1)) all.back().points.push_back(p);
  return all;
}

TEST_CASE("flipping_gives_the_tetrahedra_of_the_definition") {
  for (const shapes3::NamedPoints& family : small_families(15)) {
    CAPTURE(family.name);
    const auto expected = oracles::brute_force_tets(family.points);
    if (expected.empty()) continue;  // what was drawn does not span space
    for (std::uint64_t seed = 1; seed < 9; ++seed)
      REQUIRE(flipped_tets(shapes3::shuffled(family.points, seed), seed) == expected);
  }
}

TEST_CASE("small_integer_points_in_every_position_give_the_tetrahedra_of_the_definition") {
  std::mt19937_64 random(4);
  for (int round = 0; round < 400; ++round) {
    std::vector<Point3> points;
    const unsigned side = 2 + static_cast<unsigned>(round) % 3;
    const auto coordinate = [&] { return static_cast<double>(random() % side); };
    for (int i = 0; i < 14; ++i) {
      const double x = coordinate(), y = coordinate();
      points.push_back({x, y, coordinate()});
    }
    points = shapes3::shuffled(shapes3::distinct(points), random());
    const auto expected = oracles::brute_force_tets(points);
    if (expected.empty()) continue;
    REQUIRE(flipped_tets(points, random()) == expected);
  }
}

TEST_CASE("the_order_of_insertion_does_not_enter") {
  for (const shapes3::NamedPoints& family : shapes3::families()) {
    CAPTURE(family.name);
    const std::vector<Point3> points = shapes3::distinct(family.points);
    const auto expected = flipped_tets(points);
    for (std::uint64_t seed = 2; seed < 5; ++seed)
      REQUIRE(flipped_tets(shapes3::shuffled(points, seed), seed) == expected);
  }
}

TEST_CASE("the_tetrahedra_of_a_grid_fill_it") {
  mpq_class sum = 0;
  for (oracles::TetPoints t : flipped_tets(shapes3::shuffled(shapes3::grid(5, 4, 4), 3)))
    sum += abs(oracles::volume6(t));
  CHECK(sum == 6 * 4 * 3 * 3);
}

TEST_CASE("skew_lines_are_joined_piece_by_piece") {
  CHECK(flipped_tets(shapes3::skew_lines(20)).size() == 19 * 19);
}

TEST_CASE("points_that_span_no_tetrahedron_are_an_outcome") {
  const auto outcome = [](const std::vector<Point3>& points) {
    return tetrahedralize_flipping(points, {}).outcome;
  };
  CHECK(outcome({}) == TetrahedralizeOutcome::too_few_points);
  CHECK(outcome({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == TetrahedralizeOutcome::too_few_points);
  CHECK(outcome({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}) == TetrahedralizeOutcome::all_collinear);
  CHECK(outcome(shapes3::grid(3, 1, 3)) == TetrahedralizeOutcome::all_coplanar);
}

TEST_CASE("a_stop_request_ends_the_flipping") {
  std::stop_source source;
  source.request_stop();
  delaunay::TetAlgorithmOptions options;
  options.progress.stop = source.get_token();
  const PointTetrahedralization made = tetrahedralize_flipping(shapes3::uniform(2000), options);
  CHECK(made.outcome == TetrahedralizeOutcome::stopped);
  CHECK(made.cells.tet_count() == 0);
}

}  // namespace
}  // namespace leonhard
