// SPDX-License-Identifier: MIT
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/exact_volume.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/exact_sum.hpp"
#include "tests/mesh/shelf.hpp"
#include "tests/mesh/tet_shelf.hpp"

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

struct Q3 {
  mpq_class x, y, z;
};
Q3 difference(const Point3& a, const Point3& b) {
  return {mpq_class(a.x) - mpq_class(b.x), mpq_class(a.y) - mpq_class(b.y), mpq_class(a.z) - mpq_class(b.z)};
}

/// The determinant of b - a, c - a, d - a in rational numbers, summed.
mpq_class volume6_in_rationals(const TetMesh& mesh) {
  mpq_class sum = 0;
  for (const auto& corners : mesh.corners) {
    const Point3 a = mesh.points[corners[0]];
    const Q3 u = difference(mesh.points[corners[1]], a), v = difference(mesh.points[corners[2]], a),
             w = difference(mesh.points[corners[3]], a);
    sum += u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) + u.z * (v.x * w.y - v.y * w.x);
  }
  return sum;
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

TEST_CASE("exact_sum_of_products_of_three_is_that_of_rational_numbers_for_doubles_of_all_sizes") {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    ExactSum sum;
    mpq_class expected = 0;
    for (int i = 0; i < 20; ++i) {
      const double a = any_double(random), b = any_double(random), c = any_double(random);
      sum.add_product(a, b, c);
      sum.add_product(b, c);
      expected += mpq_class(a) * mpq_class(b) * mpq_class(c) + mpq_class(b) * mpq_class(c);
    }
    REQUIRE(sum.value() == expected);
    REQUIRE(sum.sign() == sign_of(expected));
  }
}

TEST_CASE("exact_sum_of_products_of_three_holds_the_ends_of_the_doubles") {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  ExactSum sum;
  mpq_class most_cubed = mpq_class(most) * mpq_class(most) * mpq_class(most);
  for (int i = 0; i < 1000; ++i) sum.add_product(most, -most, most);
  CHECK(sum.value() == -1000 * most_cubed);
  for (int i = 0; i < 1000; ++i) sum.add_product(-most, most, -most);
  CHECK(sum.sign() == Sign::zero);
  sum.add_product(least, least, -least);
  CHECK(sum.sign() == Sign::negative);
  CHECK(sum.value() == -mpq_class(least) * mpq_class(least) * mpq_class(least));
}

TEST_CASE("exact_volume_is_the_sum_over_tetrahedra_in_rational_numbers_and_what_the_boundary_encloses") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const mpq_class volume6 = mesh::exact_volume6(entry.mesh);
    CHECK(volume6 == volume6_in_rationals(entry.mesh));
    CHECK(volume6 == mesh::exact_boundary_volume6(entry.mesh));
    CHECK(volume6 > 0);
  }
  CHECK(mesh::exact_volume6(tet_shelf::box(3, 2, 4)) == 6 * 24);
  CHECK(mesh::exact_volume6(TetMesh{}) == 0);
}

TEST_CASE("exact_volume_holds_where_doubles_cancel_overflow_and_underflow") {
  for (const double scale : {1e-320, 1e-108, 3.7, 1e150, 4e307}) {
    CAPTURE(scale);
    auto mesh = tet_shelf::shaken_box(2, 3);
    for (Point3& p : mesh.points) p = {scale * p.x, scale * (p.y - 1), scale * (p.z + 1)};
    CHECK(mesh::exact_volume6(mesh) == volume6_in_rationals(mesh));
    CHECK(mesh::exact_volume6(mesh) == mesh::exact_boundary_volume6(mesh));
  }
}

TEST_CASE("exact_volumes_differ_if_a_boundary_face_is_missing_or_turned") {
  auto mesh = tet_shelf::shaken_box(2, 1);
  const mpq_class volume6 = mesh::exact_volume6(mesh);
  const auto whole = mesh.boundary;
  mesh.boundary.pop_back();
  CHECK(mesh::exact_boundary_volume6(mesh) != volume6);
  mesh.boundary = whole;
  std::swap(mesh.boundary[5].corners[0], mesh.boundary[5].corners[1]);
  CHECK(mesh::exact_boundary_volume6(mesh) != volume6);
}
