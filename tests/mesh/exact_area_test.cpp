// SPDX-License-Identifier: MIT
#include "leonhard/mesh/exact_area.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/exact_sum.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;
using mesh::ExactSum;

namespace {

/// Any finite double, all exponents alike.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

}  // namespace

TEST_CASE("exact_sum_is_that_of_rational_numbers_for_doubles_of_all_sizes") {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    ExactSum sum;
    mpq_class expected = 0;
    for (int i = 0; i < 20; ++i) {
      const double a = any_double(random), b = any_double(random);
      sum.add_product(a, b);
      expected += mpq_class(a) * mpq_class(b);
    }
    CHECK(sum.value() == expected);
    CHECK(sum.sign() == sign_of(expected));
  }
}

TEST_CASE("exact_sum_holds_the_ends_of_the_doubles") {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  ExactSum sum;
  sum.add_product(most, most);
  sum.add_product(-least, least);
  CHECK(sum.value() == mpq_class(most) * mpq_class(most) - mpq_class(least) * mpq_class(least));
  sum.add_product(-most, most);
  CHECK(sum.sign() == Sign::negative);
  CHECK(sum.value() == -mpq_class(least) * mpq_class(least));
  sum.add_product(least, least);
  CHECK(sum.sign() == Sign::zero);
  CHECK(sum.value() == 0);
  for (int i = 0; i < 1000; ++i) sum.add_product(-most, most);
  CHECK(sum.value() == -1000 * mpq_class(most) * mpq_class(most));
}

TEST_CASE("exact_area_is_the_sum_over_triangles_in_rational_numbers") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    mpq_class expected = 0;
    for (const auto& [a, b, c] : mesh.corners) {
      const std::array<Point2, 3> triangle{mesh.points[a], mesh.points[b], mesh.points[c]};
      expected += kernel::exact::area2(triangle);
    }
    CHECK(mesh::exact_area2(mesh) == expected);
  }
}

TEST_CASE("exact_area_of_the_triangles_is_that_of_the_boundary") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    CHECK(mesh::exact_area2(mesh) == mesh::exact_boundary_area2(mesh));
  }
  const auto far = shelf::shaken_grid(20, 5, 0.1, {1e12, 1e-3});
  CHECK(mesh::exact_area2(far) == mesh::exact_boundary_area2(far));
}

TEST_CASE("exact_area_of_a_grid_is_its_squares") {
  CHECK(mesh::exact_area2(shelf::grid(7, 4)) == 2 * 7 * 4);
  CHECK(mesh::exact_area2({}) == 0);
}
