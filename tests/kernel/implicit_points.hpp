// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "leonhard/kernel/implicit_point.hpp"
#include "leonhard/kernel/implicit_point3.hpp"
#include "leonhard/kernel/stages/exact_implicit.hpp"
#include "tests/kernel/point_families.hpp"
#include "tests/kernel/point_families3.hpp"

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
  const auto truth = kernel::exact::line_crossing(q[0], q[1], q[2], q[3]);
  if (!truth) return {};
  return TestPoint2{q, kernel::LineCrossing(q[0], q[1], q[2], q[3]), *truth};
}

template <class Pool>
auto member(Random& random, const Pool& pool) {
  return pool[static_cast<std::size_t>(integer(random, 0, static_cast<int>(pool.size()) - 1))];
}

/// A point given by members of the pool, so that points drawn from one pool lie on lines in common.
template <class Pool>
TestPoint2 draw_point2(Random& random, const Pool& pool) {
  for (int attempt = integer(random, 0, 4); attempt > 0; --attempt) {
    Quadruple q;
    for (Point2& p : q) p = member(random, pool);
    if (const auto p = crossing(q)) return *p;
  }
  return explicit_point(member(random, pool));
}

template <std::size_t Count>
std::string as_source(const std::array<TestPoint2, Count>& points) {
  std::string source;
  for (const TestPoint2& p : points) source += (p.crossing ? "crossing " : "point ") + as_source(p.defining);
  return source;
}

// ---- space ----

struct TestPoint3 {
  std::vector<Point3> defining;  ///< 1, 5 or 9, as homogeneous.hpp has it
  std::variant<Point3, kernel::LinePlaneCrossing, kernel::ThreePlaneCrossing> point;
  kernel::exact::RationalPoint3 truth;

  [[nodiscard]] kernel::PointRef3 ref() const {
    return std::visit([](const auto& p) { return kernel::PointRef3(p); }, point);
  }
};

inline TestPoint3 explicit_point(const Point3& p) { return {{p}, p, kernel::exact::rational(p)}; }

/// The crossing of a line and a plane, or of three planes, if there is one.
inline std::optional<TestPoint3> crossing(const std::vector<Point3>& q) {
  namespace exact = kernel::exact;
  if (q.size() == 5) {
    const auto truth = exact::line_plane_crossing(q[0], q[1], exact::plane(q[2], q[3], q[4]));
    if (!truth) return {};
    return TestPoint3{q, kernel::LinePlaneCrossing(q[0], q[1], q[2], q[3], q[4]), *truth};
  }
  const auto truth = exact::three_plane_crossing(
      exact::plane(q[0], q[1], q[2]), exact::plane(q[3], q[4], q[5]), exact::plane(q[6], q[7], q[8]));
  if (!truth) return {};
  return TestPoint3{q, kernel::ThreePlaneCrossing({q[0], q[1], q[2]}, {q[3], q[4], q[5]}, {q[6], q[7], q[8]}),
                    *truth};
}

template <class Pool>
TestPoint3 draw_point3(Random& random, const Pool& pool) {
  for (int attempt = integer(random, 0, 5); attempt > 0; --attempt) {
    std::vector<Point3> q(integer(random, 0, 1) == 0 ? 5 : 9);
    for (Point3& p : q) p = member(random, pool);
    if (const auto p = crossing(q)) return *p;
  }
  return explicit_point(member(random, pool));
}

template <std::size_t Count>
std::string as_source(const std::array<TestPoint3, Count>& points) {
  std::string source;
  for (const TestPoint3& p : points) {
    source += std::to_string(p.defining.size()) + " points: ";
    for (const Point3& q : p.defining) source += as_source(q);
  }
  return source;
}

// ---- rounding and balls ----

/// Is no other double nearer to the truth, and none that is even as near?
inline bool is_nearest(double x, const mpq_class& truth) {
  constexpr double largest = std::numeric_limits<double>::max();
  const mpq_class error = abs(x - truth);
  const bool is_even = std::bit_cast<std::uint64_t>(x) % 2 == 0;
  for (const double other : {std::nextafter(x, -largest), std::nextafter(x, largest)}) {
    if (other == x) continue;
    const int nearer = cmp(mpq_class(abs(other - truth)), error);
    if (nearer < 0 || (nearer == 0 && !is_even)) return false;
  }
  return true;
}

/// Does `rounded` keep its promise about one coordinate?
inline bool is_rounded_well(double x, double error, const mpq_class& truth) {
  return is_nearest(x, truth) && (std::isinf(error) || abs(x - truth) <= error);
}

inline bool contains(const kernel::NumberBall<kernel::DoubleDouble>& ball, const mpq_class& x) {
  return !std::isfinite(ball.radius) || abs(mpq_class(ball.value.high) + ball.value.low - x) <= ball.radius;
}

}  // namespace leonhard::testing
