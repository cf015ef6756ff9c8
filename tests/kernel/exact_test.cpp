// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/exact.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::sign_of;
using namespace leonhard::testing;

namespace {

__extension__ using Wide = __int128;

/// Small integers let a second, independent formula be evaluated without rounding: the determinant of rows
/// (x, y, x^2 + y^2, 1), expanded along the last column. Coordinates up to 2^20.
Wide lifted_determinant(const Quadruple& q) {
  const auto minor = [&q](std::size_t i, std::size_t j, std::size_t l) {
    const auto row = [&q](std::size_t r) {
      const Wide x = static_cast<Wide>(q[r].x), y = static_cast<Wide>(q[r].y);
      return std::array<Wide, 3>{x, y, x * x + y * y};
    };
    const auto a = row(i), b = row(j), c = row(l);
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  return minor(0, 1, 2) - minor(0, 1, 3) + minor(0, 2, 3) - minor(1, 2, 3);
}

}  // namespace

TEST_CASE("the_oracle_agrees_with_128_bit_integers") {
  Random random(41);
  for (int i = 0; i < 20'000; ++i) {
    const int size = i % 2 == 0 ? 4 : 1 << 20;
    const Quadruple q = each_coordinate([&] { return double(integer(random, -size, size)); });
    const auto [a, b, c, d] = q;
    const auto wide = [](double x) { return static_cast<Wide>(x); };
    CAPTURE(as_source(q));
    const Wide turn = wide(a.x) * wide(b.y - c.y) + wide(b.x) * wide(c.y - a.y) + wide(c.x) * wide(a.y - b.y);
    REQUIRE(k::exact::orient2d(a, b, c) == sign_of(turn));
    REQUIRE(k::exact::incircle(a, b, c, d) == sign_of(lifted_determinant(q)));
    const auto square = [&](Point2 p, Point2 r) {
      return wide(p.x - r.x) * wide(p.x - r.x) + wide(p.y - r.y) * wide(p.y - r.y);
    };
    REQUIRE(k::exact::compare_distance(a, b, c) == sign_of(square(a, b) - square(a, c)));
    // Inside the circle over bc: the law of cosines, obtuse at a.
    REQUIRE(k::exact::in_diametral_circle(a, b, c) == sign_of(square(b, c) - square(a, b) - square(a, c)));
  }
}

TEST_CASE("area2_of_known_polygons_is_exact") {
  const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK(k::exact::area2(square) == 2);
  const std::vector<Point2> clockwise(square.rbegin(), square.rend());
  CHECK(k::exact::area2(clockwise) == -2);
  CHECK(k::exact::area2({}) == 0);
  CHECK(k::exact::area2(std::span(square).first(2)) == 0);
  const std::vector<Point2> arrow{{0, 0}, {4, 0}, {4, 4}, {3, 1}};
  CHECK(k::exact::area2(arrow) == 8);
}

TEST_CASE("area2_keeps_what_doubles_would_lose") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<Point2> sliver{{0, 0}, {1e300, 0}, {1e300, tiny}};
  CHECK(k::exact::area2(sliver) == mpq_class(1e300) * mpq_class(tiny));
}
