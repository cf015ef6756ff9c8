// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/sign.hpp"
#include "tests/kernel/point_families.hpp"

/// Points of space chosen to hurt predicates, five at a time.
namespace leonhard::testing {

using Quintuple = std::array<Point3, 5>;

struct PointFamily3 {
  const char* name;
  std::function<Quintuple(Random&)> draw;
};

template <class Draw>
Quintuple each_coordinate3(Draw draw) {
  Quintuple points;
  for (Point3& p : points) p = {draw(), draw(), draw()};
  return points;
}

inline Point3 nudge(Random& random, const Point3& p) {
  return {nudge(random, p.x), nudge(random, p.y), nudge(random, p.z)};
}

inline Vec3 any_vector(Random& random) { return {uniform(random), uniform(random), uniform(random)}; }

inline Quintuple nearly_coplanar(Random& random) {
  const Point3 start{uniform(random), uniform(random), uniform(random)};
  const Vec3 u = any_vector(random), v = any_vector(random);
  Quintuple points;
  for (Point3& p : points) p = nudge(random, start + (uniform(random) * u + uniform(random) * v));
  return points;
}

inline Quintuple nearly_on_a_line(Random& random) {
  const Point3 start{uniform(random), uniform(random), uniform(random)};
  const Vec3 u = any_vector(random);
  Quintuple points;
  for (Point3& p : points) p = nudge(random, start + uniform(random) * u);
  return points;
}

inline Quintuple nearly_cospherical(Random& random) {
  const Point3 centre{uniform(random), uniform(random), uniform(random)};
  const double radius = std::exp2(integer(random, -20, 2));
  Quintuple points;
  for (Point3& p : points) {
    const Vec3 v = any_vector(random);
    p = nudge(random, centre + (radius / norm(v)) * v);
  }
  return points;
}

/// Five corners of a box given by its least and greatest coordinates, in any order: cospherical to the last bit.
inline Quintuple box_corners(Random& random, const Point3& low, const Point3& high) {
  std::array<unsigned, 8> corners{0, 1, 2, 3, 4, 5, 6, 7};
  std::ranges::shuffle(corners, random);
  Quintuple points;
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = {(corners[i] & 1U) != 0 ? high.x : low.x, (corners[i] & 2U) != 0 ? high.y : low.y,
                 (corners[i] & 4U) != 0 ? high.z : low.z};
  return points;
}

/// Corners of a box, one of them a step away half of the time; at times far off the origin.
inline Quintuple nearly_a_box(Random& random) {
  const Point3 low{uniform(random), uniform(random), uniform(random)};
  const auto side = [&random] { return std::exp2(integer(random, -40, 2)); };
  Quintuple points = box_corners(random, low, {low.x + side(), low.y + side(), low.z + side()});
  if (integer(random, 0, 1) == 1) points[2].y = nudge(random, points[2].y);
  return points;
}

/// Corners of a box of any coordinates: a tie whose differences round, unlike those of neighbours.
inline Quintuple any_box(Random& random) {
  const auto any = [&random] { return any_exponent(random, -30, 1); };
  return box_corners(random, {any(), any(), any()}, {any(), any(), any()});
}

/// Moves one coordinate of one point by at most two units in the last place, half of the time.
inline void nudge_one(Random& random, Quintuple& points) {
  if (integer(random, 0, 1) == 0) return;
  Point3& p = points[static_cast<std::size_t>(integer(random, 0, 4))];
  const std::array coordinates{&p.x, &p.y, &p.z};
  double& coordinate = *coordinates[static_cast<std::size_t>(integer(random, 0, 2))];
  coordinate = nudge(random, coordinate);
}

/// Corners of a box, one of them a step away at times; coordinates of any exponents.
inline Quintuple box_of_any_exponents(Random& random) {
  const auto any = [&random] { return any_exponent(random, -1074, 1020); };
  Quintuple points = box_corners(random, {any(), any(), any()}, {any(), any(), any()});
  nudge_one(random, points);
  return points;
}

/// Points of a plane through the z axis, one of them a step away at times; coordinates of any exponents.
inline Quintuple plane_of_any_exponents(Random& random) {
  const Vec2 direction{uniform(random), uniform(random)};
  Quintuple points;
  for (Point3& p : points) {
    const double factor = std::ldexp(integer(random, 0, 1) == 0 ? 1 : -1, integer(random, -900, 1020));
    p = {factor * direction.x, factor * direction.y, any_exponent(random, -1074, 1020)};
  }
  nudge_one(random, points);
  return points;
}

/// Three points whose coordinates' products underflow, and others so far away that what was lost would count.
inline Quintuple tiny_beside_huge(Random& random) {
  Quintuple points = each_coordinate3([&random] { return any_exponent(random, -538, -536); });
  for (std::size_t i = 3; i < points.size(); ++i) {
    const auto far = [&random] { return any_exponent(random, 395, 423); };
    points[i] = {far(), far(), far()};
  }
  return points;
}

/// Drawn points times a power of two, to bring their last bits where products would lose them.
template <class Draw>
auto scaled(Draw draw, double factor) {
  return [draw, factor](Random& random) {
    Quintuple points = draw(random);
    for (Point3& p : points) p = {factor * p.x, factor * p.y, factor * p.z};
    return points;
  };
}

inline std::vector<PointFamily3> point_families3() {
  const auto exponents = [](int low, int high) {
    return [low, high](Random& r) { return each_coordinate3([&] { return any_exponent(r, low, high); }); };
  };
  const auto multiples = [](double unit, int most) {
    return
        [unit, most](Random& r) { return each_coordinate3([&] { return unit * integer(r, -most, most); }); };
  };
  return {
      {"uniform", [](Random& r) { return each_coordinate3([&r] { return uniform(r); }); }},
      {"integer grid", multiples(1, 2)},
      {"tenths", multiples(0.1, 3)},
      {"nearly coplanar", nearly_coplanar},
      {"nearly on a line", nearly_on_a_line},
      {"nearly cospherical", nearly_cospherical},
      {"nearly a box", nearly_a_box},
      {"any box", any_box},
      {"subnormal", multiples(0x1p-1074, 4)},
      {"subnormal and tiny", exponents(-1080, -1000)},
      {"huge", [](Random& r) { return each_coordinate3([&r] { return uniform(r) * 1.79e308; }); }},
      {"huge grid", multiples(1e300, 2)},
      // Terms of a few smallest numbers: 0.6 + 0.6 - 1.4 of them rounds to 1 + 1 - 1, the wrong sign.
      {"squares of a few smallest numbers", exponents(-538, -536)},
      {"cubes of a few smallest numbers", exponents(-359, -357)},
      {"fifth powers of a few smallest numbers", exponents(-216, -214)},
      {"cubes near underflow", exponents(-365, -330)},
      {"fifth powers near underflow", exponents(-222, -195)},
      {"cubes near overflow", exponents(330, 345)},
      {"fifth powers near overflow", exponents(195, 208)},
      {"nearly a box, fifth powers of last bits near underflow", scaled(nearly_a_box, 0x1p-165)},
      {"nearly coplanar, cubes of last bits near underflow", scaled(nearly_coplanar, 0x1p-310)},
      {"tiny beside huge", tiny_beside_huge},
      {"some exponents", exponents(-60, 60)},
      {"all exponents", exponents(-1074, 1024)},
      {"a box of any exponents", box_of_any_exponents},
      {"a plane of any exponents", plane_of_any_exponents},
      {"a unit cube beside tiny numbers",
       [](Random& r) { return each_coordinate3([&r] { return unit_or_tiny(r); }); }},
  };
}

/// Points as C++ source, to be pasted into a regression test.
inline std::string as_source(const Point3& p) {
  char text[120];
  std::snprintf(text, sizeof text, "{%a, %a, %a}, ", p.x, p.y, p.z);
  return text;
}

inline std::string as_source(const Quintuple& points) {
  std::string source;
  for (const Point3& p : points) source += as_source(p);
  return source;
}

/// The sign of a permutation of indices.
template <std::size_t Count>
Sign permutation_sign(const std::array<std::size_t, Count>& p) {
  bool odd = false;
  for (std::size_t j = 0; j < Count; ++j)
    for (std::size_t l = j + 1; l < Count; ++l) odd ^= p[j] > p[l];
  return odd ? Sign::negative : Sign::positive;
}

}  // namespace leonhard::testing
