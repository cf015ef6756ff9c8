// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "leonhard/kernel/exact_implicit.hpp"
#include "leonhard/kernel/implicit_point.hpp"
#include "tests/kernel/point_families.hpp"

/// Explicit and implicit points with their exact coordinates.
namespace leonhard::testing {

inline constexpr std::array all_stages{kernel::Stage::filter, kernel::Stage::double_double,
                                       kernel::Stage::expansion, kernel::Stage::rational};

struct TestPoint2 {
  Quadruple defining;
  std::optional<kernel::LineCrossing> crossing;  ///< if none: the first defining point
  kernel::exact::RationalPoint2 truth;

  [[nodiscard]] kernel::PointRef2 ref() const {
    return crossing ? kernel::PointRef2(*crossing) : kernel::PointRef2(defining[0]);
  }
};

inline TestPoint2 explicit_point(const Point2& p) { return {{p}, {}, kernel::exact::rational(p)}; }

/// The crossing of two lines if there is one.
inline std::optional<TestPoint2> crossing(const Quadruple& q) {
  if (!kernel::exact::lines_cross(q[0], q[1], q[2], q[3])) return {};
  return TestPoint2{q, kernel::LineCrossing(q[0], q[1], q[2], q[3]),
                    kernel::exact::line_crossing(q[0], q[1], q[2], q[3])};
}

/// A point given by members of the pool, so that points drawn from one pool lie on lines in common.
template <class Pool>
TestPoint2 draw_point(Random& random, const Pool& pool) {
  const auto member = [&] {
    return pool[static_cast<std::size_t>(integer(random, 0, int(pool.size()) - 1))];
  };
  for (int attempt = integer(random, 0, 4); attempt > 0; --attempt)
    if (const auto p = crossing({member(), member(), member(), member()})) return *p;
  return explicit_point(member());
}

template <std::size_t Count>
std::string as_source(const std::array<TestPoint2, Count>& points) {
  std::string source;
  for (const TestPoint2& p : points) source += (p.crossing ? "crossing " : "point ") + as_source(p.defining);
  return source;
}

}  // namespace leonhard::testing
