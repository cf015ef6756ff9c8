// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Points chosen to hurt predicates, four at a time.
namespace leonhard::testing {

using Random = std::mt19937_64;
using Quadruple = std::array<Point2, 4>;

struct PointFamily {
  const char* name;
  std::function<Quadruple(Random&)> draw;
};

inline double uniform(Random& random, double low = -1, double high = 1) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline int integer(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

/// How many random calls a test makes: `calls`, or a share of them where the environment has LEONHARD_TEST_DIVISOR, as
/// on an emulated processor (tests/roundings) and under the sanitizers (CMakePresets.json).
inline int scaled_calls(int calls) {
  const char* divisor = std::getenv("LEONHARD_TEST_DIVISOR");
  return divisor == nullptr ? calls : std::max(1, calls / std::max(1, std::atoi(divisor)));
}

/// Moves x by at most two units in the last place.
inline double nudge(Random& random, double x) {
  for (int steps = integer(random, -2, 2); steps != 0; steps += steps < 0 ? 1 : -1)
    x = std::nextafter(x, steps < 0 ? -INFINITY : INFINITY);
  return x;
}

template <class Draw>
Quadruple each_coordinate(Draw draw) {
  Quadruple points;
  for (Point2& p : points) p = {draw(), draw()};
  return points;
}

inline Quadruple nearly_collinear(Random& random) {
  const Point2 start{uniform(random), uniform(random)};
  const Vec2 direction{uniform(random), uniform(random)};
  Quadruple points;
  for (Point2& p : points) {
    const Point2 on_line = start + uniform(random) * direction;
    p = {nudge(random, on_line.x), nudge(random, on_line.y)};
  }
  return points;
}

inline Quadruple nearly_cocircular(Random& random) {
  const Point2 centre{uniform(random), uniform(random)};
  const double radius = std::exp2(integer(random, -20, 2));
  Quadruple points;
  for (Point2& p : points) {
    const double angle_rad = uniform(random, 0, 6.3);
    p = {nudge(random, centre.x + radius * std::cos(angle_rad)),
         nudge(random, centre.y + radius * std::sin(angle_rad))};
  }
  return points;
}

/// The corners of a rectangle, cocircular to the last bit, or one of them a step away; at times far off the origin.
inline Quadruple nearly_rectangular(Random& random) {
  const double left = uniform(random), bottom = uniform(random);
  const double right = left + std::exp2(integer(random, -40, 2)),
               top = bottom + std::exp2(integer(random, -40, 2));
  Quadruple points{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
  if (integer(random, 0, 1) == 1) points[3].x = nudge(random, points[3].x);
  return points;
}

inline double any_exponent(Random& random, int low, int high) {
  return std::ldexp(uniform(random), integer(random, low, high));
}

/// The corners of a rectangle of any coordinates: a tie whose differences round, unlike those of neighbours.
inline Quadruple any_rectangle(Random& random) {
  const double left = any_exponent(random, -30, 1), right = any_exponent(random, -30, 1);
  const double bottom = any_exponent(random, -30, 1), top = any_exponent(random, -30, 1);
  Quadruple points{{{left, bottom}, {right, top}, {right, bottom}, {left, top}}};
  std::ranges::shuffle(points, random);
  return points;
}

/// Moves one coordinate of one point by at most two units in the last place, half of the time.
inline void nudge_one(Random& random, Quadruple& points) {
  if (integer(random, 0, 1) == 0) return;
  Point2& p = points[static_cast<std::size_t>(integer(random, 0, 3))];
  double& coordinate = integer(random, 0, 1) == 0 ? p.x : p.y;
  coordinate = nudge(random, coordinate);
}

/// The corners of a trapezoid that lies like its mirror image, cocircular to the last bit, or one of them a step away;
/// coordinates of any exponents.
inline Quadruple trapezoid_of_any_exponents(Random& random) {
  const auto any = [&random] { return any_exponent(random, -1074, 1020); };
  const double x = any(), y = any(), other_x = any(), other_y = any();
  Quadruple points{{{x, y}, {-x, y}, {other_x, other_y}, {-other_x, other_y}}};
  nudge_one(random, points);
  std::ranges::shuffle(points, random);
  return points;
}

/// Points of a line through the origin, collinear to the last bit, or one of them a step away; coordinates of any
/// exponents.
inline Quadruple line_of_any_exponents(Random& random) {
  const Vec2 direction{uniform(random), uniform(random)};
  Quadruple points;
  for (Point2& p : points) {
    const double factor = std::ldexp(integer(random, 0, 1) == 0 ? 1 : -1, integer(random, -900, 1020));
    p = {factor * direction.x, factor * direction.y};
  }
  nudge_one(random, points);
  return points;
}

/// -1, 0, 1, or a number that would be lost beside them.
inline double unit_or_tiny(Random& random) {
  return integer(random, 0, 1) == 0 ? integer(random, -1, 1) : any_exponent(random, -1074, -500);
}

inline std::vector<PointFamily> point_families() {
  return {
      {"uniform", [](Random& r) { return each_coordinate([&r] { return uniform(r); }); }},
      {"integer grid", [](Random& r) { return each_coordinate([&r] { return double(integer(r, -3, 3)); }); }},
      {"tenths", [](Random& r) { return each_coordinate([&r] { return 0.1 * integer(r, -3, 3); }); }},
      {"nearly collinear", nearly_collinear},
      {"nearly cocircular", nearly_cocircular},
      {"nearly rectangular", nearly_rectangular},
      {"any rectangle", any_rectangle},
      {"subnormal",
       [](Random& r) { return each_coordinate([&r] { return 0x1p-1074 * integer(r, -5, 5); }); }},
      {"subnormal and tiny",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -1080, -1000); }); }},
      {"huge", [](Random& r) { return each_coordinate([&r] { return uniform(r) * 1.79e308; }); }},
      {"huge grid", [](Random& r) { return each_coordinate([&r] { return 1e300 * integer(r, -3, 3); }); }},
      // Terms of a few smallest numbers: 0.6 + 0.6 - 1.4 of them rounds to 1 + 1 - 1, the wrong sign.
      {"products of a few smallest numbers",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -538, -536); }); }},
      {"fourth powers of a few smallest numbers",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -270, -268); }); }},
      {"products near underflow",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -545, -480); }); }},
      {"squares near underflow",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -275, -240); }); }},
      {"products near overflow",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, 495, 515); }); }},
      {"squares near overflow",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, 240, 260); }); }},
      {"some exponents",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -100, 100); }); }},
      {"all exponents",
       [](Random& r) { return each_coordinate([&r] { return any_exponent(r, -1074, 1024); }); }},
      {"a trapezoid of any exponents", trapezoid_of_any_exponents},
      {"a line of any exponents", line_of_any_exponents},
      {"a unit square beside tiny numbers",
       [](Random& r) { return each_coordinate([&r] { return unit_or_tiny(r); }); }},
  };
}

/// The points as C++ source, to be pasted into a regression test.
inline std::string as_source(const Quadruple& points) {
  std::string source;
  for (const Point2 p : points) {
    char text[80];
    std::snprintf(text, sizeof text, "{%a, %a}, ", p.x, p.y);
    source += text;
  }
  return source;
}

}  // namespace leonhard::testing
