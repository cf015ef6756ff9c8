// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cstddef>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::sign_of;
using namespace leonhard::testing;

namespace {

__extension__ using Wide = __int128;

/// The determinant of the given rows by expansion along the first column.
template <std::size_t N>
Wide determinant(const std::array<std::array<Wide, N>, N>& rows) {
  if constexpr (N == 1) {
    return rows[0][0];
  } else {
    Wide sum = 0;
    for (std::size_t left_out = 0; left_out < N; ++left_out) {
      std::array<std::array<Wide, N - 1>, N - 1> minor;
      for (std::size_t i = 0, j = 0; i < N; ++i) {
        if (i == left_out) continue;
        for (std::size_t column = 1; column < N; ++column) minor[j][column - 1] = rows[i][column];
        ++j;
      }
      const Wide term = rows[left_out][0] * determinant(minor);
      sum += left_out % 2 == 0 ? term : -term;
    }
    return sum;
  }
}

}  // namespace

TEST_CASE("the_oracle_of_space_agrees_with_128_bit_integers") {
  // Small integers let other formulas be evaluated without rounding: the determinants of homogeneous rows, which have
  // the opposite orientation, and the law of cosines. Fifth powers of 2^18 times 5! stay below 2^100.
  Random random(42);
  for (int i = 0; i < 20'000; ++i) {
    const int size = i % 2 == 0 ? 3 : 1 << 18;
    const Quintuple q = each_coordinate3([&] { return double(integer(random, -size, size)); });
    const auto& [a, b, c, d, e] = q;
    CAPTURE(as_source(q));
    std::array<std::array<Wide, 4>, 4> plane;
    std::array<std::array<Wide, 5>, 5> sphere;
    for (std::size_t row = 0; row < 5; ++row) {
      const Wide x = static_cast<Wide>(q[row].x), y = static_cast<Wide>(q[row].y),
                 z = static_cast<Wide>(q[row].z);
      if (row < 4) plane[row] = {x, y, z, 1};
      sphere[row] = {x, y, z, x * x + y * y + z * z, 1};
    }
    REQUIRE(k::exact::orient3d(a, b, c, d) == -sign_of(determinant(plane)));
    REQUIRE(k::exact::insphere(a, b, c, d, e) == -sign_of(determinant(sphere)));
    const auto square = [](const Point3& p, const Point3& r) {
      const Wide x = static_cast<Wide>(p.x - r.x), y = static_cast<Wide>(p.y - r.y),
                 z = static_cast<Wide>(p.z - r.z);
      return x * x + y * y + z * z;
    };
    REQUIRE(k::exact::compare_distance(a, b, c) == sign_of(square(a, b) - square(a, c)));
    REQUIRE(k::exact::in_diametral_sphere(a, b, c) == sign_of(square(b, c) - square(a, b) - square(a, c)));
  }
}
