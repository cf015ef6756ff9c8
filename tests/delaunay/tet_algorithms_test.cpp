// SPDX-License-Identifier: MIT
// Every algorithm in space gives the same tetrahedra, for any order of the points.
#include <doctest/doctest.h>

#include "leonhard/delaunay/tet_algorithm.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "tests/delaunay/shapes3.hpp"
#include "tests/delaunay/tet_oracles.hpp"

namespace leonhard {
namespace {

using delaunay::NamedTetAlgorithm;
using delaunay::TetrahedralizeOutcome;

std::vector<Point3> along_curve(const std::vector<Point3>& points) {
  std::vector<Point3> sorted;
  for (const std::uint32_t i : kernel::hilbert_order(points)) sorted.push_back(points[i]);
  return sorted;
}

TEST_CASE("all_algorithms_give_the_same_tetrahedra_for_any_order_and_seed") {
  for (const shapes3::NamedPoints& family : shapes3::families()) {
    CAPTURE(family.name);
    const std::vector<Point3> points = shapes3::distinct(family.points);
    std::vector<oracles::TetPoints> expected;
    for (const NamedTetAlgorithm& named : delaunay::named_tet_algorithms) {
      CAPTURE(named.name);
      for (std::uint64_t seed = 1; seed < 4; ++seed) {
        delaunay::TetAlgorithmOptions options;
        options.seed = seed;
        const std::vector<Point3> order = seed == 1 ? along_curve(points) : shapes3::shuffled(points, seed);
        const auto made = delaunay::tetrahedralize_distinct(order, named.algorithm, options);
        REQUIRE(made.outcome == TetrahedralizeOutcome::done);
        for (const auto& broken : {made.cells.validate(), oracles::broken_geometry(made.cells, order)}) {
          INFO(broken.value_or(""));
          REQUIRE_FALSE(broken.has_value());
        }
        const auto tets = oracles::tet_set(made.cells, order);
        if (expected.empty()) expected = tets;
        REQUIRE(tets == expected);
      }
    }
  }
}

TEST_CASE("all_algorithms_tell_what_spans_no_tetrahedron") {
  for (const NamedTetAlgorithm& named : delaunay::named_tet_algorithms) {
    CAPTURE(named.name);
    const auto outcome = [&](const std::vector<Point3>& points) {
      return delaunay::tetrahedralize_distinct(points, named.algorithm, {}).outcome;
    };
    CHECK(outcome({}) == TetrahedralizeOutcome::too_few_points);
    CHECK(outcome({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == TetrahedralizeOutcome::too_few_points);
    CHECK(outcome({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}) == TetrahedralizeOutcome::all_collinear);
    CHECK(outcome(shapes3::grid(3, 1, 3)) == TetrahedralizeOutcome::all_coplanar);
  }
}

}  // namespace
}  // namespace leonhard
