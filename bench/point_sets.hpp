// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Sets of points of the plane on which triangulations are timed, in random order.
namespace leonhard::benching {

using Points = std::vector<Point2>;

/// n points drawn one after another.
template <class Draw>
Points drawn(std::size_t n, const Draw& draw) {
  std::mt19937_64 random(1);
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(draw(random, i));
  return points;
}

inline double unit_of(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(0, 1)(random);
}

inline Points uniform_points(std::size_t n) {
  return drawn(n, [](auto& random, std::size_t) {
    const double x = unit_of(random);
    return Point2{x, unit_of(random)};
  });
}

/// A hundred Gaussian clusters in the unit square, of deviation 0.01.
inline Points clustered_points(std::size_t n) {
  const Points centres = uniform_points(100);
  std::normal_distribution<double> normal(0, 0.01);
  return drawn(n, [&](auto& random, std::size_t i) {
    const Point2 centre = centres[i % centres.size()];
    const double x = normal(random);
    return Point2{centre.x + x, centre.y + normal(random)};
  });
}

/// The largest square grid of integers that n points allow, and the points left over in one row more.
inline Points grid_points(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  Points points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({static_cast<double>(i % side), static_cast<double>(i / side)});
  std::shuffle(points.begin(), points.end(), std::mt19937_64(1));
  return points;
}

inline Points circle_points(std::size_t n) {
  return drawn(n, [](auto& random, std::size_t) {
    const double angle = 2 * std::numbers::pi * unit_of(random);
    return Point2{std::cos(angle), std::sin(angle)};
  });
}

inline Points spiral_points(std::size_t n) {
  return drawn(n, [](auto& random, std::size_t) {
    const double turn = unit_of(random), angle = 40 * std::numbers::pi * std::sqrt(turn);
    return Point2{turn * std::cos(angle), turn * std::sin(angle)};
  });
}

inline Points parabola_points(std::size_t n) {
  return drawn(n, [](auto& random, std::size_t) {
    const double x = unit_of(random);
    return Point2{x, x * x};
  });
}

/// Half of them on one horizontal line, half on another.
inline Points line_pair_points(std::size_t n) {
  return drawn(n, [](auto& random, std::size_t i) {
    return Point2{unit_of(random), static_cast<double>(i % 2)};
  });
}

struct PointSet {
  const char* name;
  Points (*points)(std::size_t n);
};
inline constexpr std::array point_sets{
    PointSet{"uniform", uniform_points},    PointSet{"clusters", clustered_points},
    PointSet{"grid", grid_points},          PointSet{"circle", circle_points},
    PointSet{"spiral", spiral_points},      PointSet{"parabola", parabola_points},
    PointSet{"two lines", line_pair_points}};

}  // namespace leonhard::benching
