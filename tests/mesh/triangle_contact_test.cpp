// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/triangle_contact.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "leonhard/kernel/stages/exact.hpp"

using namespace leonhard;

namespace {

using Triangle = std::array<Point3, 3>;
using Row = std::vector<mpq_class>;

/// The one solution of a system whose rows end with the right-hand side; none if there is no or more than one.
std::optional<Row> solution(std::vector<Row> rows) {
  const std::size_t unknowns = rows[0].size() - 1;
  for (std::size_t column = 0; column < unknowns; ++column) {
    auto pivot = rows.begin() + static_cast<std::ptrdiff_t>(column);
    pivot = std::find_if(pivot, rows.end(), [&](const Row& row) { return row[column] != 0; });
    if (pivot == rows.end()) return std::nullopt;
    std::swap(*pivot, rows[column]);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == column || rows[r][column] == 0) continue;
      const mpq_class factor = rows[r][column] / rows[column][column];
      for (std::size_t c = column; c <= unknowns; ++c) rows[r][c] -= factor * rows[column][c];
    }
  }
  Row x(unknowns);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r < unknowns) x[r] = rows[r][unknowns] / rows[r][r];
    if (r >= unknowns && rows[r][unknowns] != 0) return std::nullopt;
  }
  return x;
}

/// Contact as a linear programme in the weights of corners: sum a_i p_i = sum b_j q_j, each kind adding up to 1 and none
/// negative, with weight on corners of p that q has not. Some solution with independent columns has the most.
bool in_contact_by_linear_programming(const Triangle& p, const Triangle& q) {
  std::vector<Row> columns;
  std::vector<bool> counts;
  for (const Point3& a : p) {
    columns.push_back({mpq_class(a.x), mpq_class(a.y), mpq_class(a.z), 1, 0});
    counts.push_back(std::find(q.begin(), q.end(), a) == q.end());
  }
  for (const Point3& b : q) {
    columns.push_back({mpq_class(-b.x), mpq_class(-b.y), mpq_class(-b.z), 0, 1});
    counts.push_back(false);
  }
  const Row right{0, 0, 0, 1, 1};
  for (unsigned subset = 1; subset < 64; ++subset) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < 6; ++i)
      if (subset >> i & 1) chosen.push_back(i);
    if (chosen.size() > 5) continue;
    std::vector<Row> rows(5);
    for (std::size_t r = 0; r < 5; ++r) {
      for (const std::size_t i : chosen) rows[r].push_back(columns[i][r]);
      rows[r].push_back(right[r]);
    }
    const auto x = solution(rows);
    if (!x || std::any_of(x->begin(), x->end(), [](const mpq_class& w) { return w < 0; })) continue;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (counts[chosen[i]] && (*x)[i] > 0) return true;
    }
  }
  return false;
}

bool is_flat(const Triangle& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);  // exact: small integers
  return n == Vec3{};
}

}  // namespace

TEST_CASE("contact_of_triangles_is_that_of_linear_programming_in_rational_numbers") {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coordinate(0, 2), fate(0, 3);
  const auto any_point = [&] {
    return Point3{double(coordinate(random)), double(coordinate(random)), double(coordinate(random))};
  };
  std::array<std::array<int, 2>, 4> seen{};  // by common corners, apart or in contact
  for (int trial = 0; trial < 600; ++trial) {
    Triangle p{any_point(), any_point(), any_point()}, q{any_point(), any_point(), any_point()};
    if (fate(random) == 0) q[0] = p[1], q[2] = p[0];
    if (fate(random) == 0) q[1] = p[2];
    if (is_flat(p) || is_flat(q)) continue;
    const auto common = static_cast<std::size_t>(std::count_if(
        p.begin(), p.end(), [&](const Point3& a) { return std::count(q.begin(), q.end(), a) > 0; }));
    const bool expected = in_contact_by_linear_programming(p, q);
    ++seen[common][expected];
    REQUIRE(mesh::in_contact(p, q) == expected);
    REQUIRE(mesh::in_contact(q, p) == expected);
  }
  for (const std::size_t common : {0, 1, 2}) {
    CHECK(seen[common][0] > 5);
    CHECK(seen[common][1] > 5);
  }
  CHECK(seen[3][0] > 5);
  CHECK(seen[3][1] == 0);
}

TEST_CASE("contact_of_triangles_is_decided_by_the_last_bit") {
  const Triangle p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const auto above = [](double z) { return Triangle{{{0.25, 0.25, z}, {1, 1, 1}, {0, 1, 1}}}; };
  CHECK(mesh::in_contact(p, above(0)));
  CHECK_FALSE(mesh::in_contact(p, above(5e-324)));
  CHECK(mesh::in_contact(p, above(-5e-324)));
}
