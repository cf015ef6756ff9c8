// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Sets of points of space on which tetrahedralisations are timed, in random order.
namespace leonhard::benching {

using Points3 = std::vector<Point3>;

/// n points drawn one after another.
template <class Draw>
Points3 drawn3(std::size_t n, Draw draw) {
  std::mt19937_64 random(1);
  Points3 points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(draw(random, i));
  return points;
}

inline Points3 uniform_points3(std::size_t n) {
  return drawn3(n, [unit = std::uniform_real_distribution<double>(0, 1)](auto& random, std::size_t) mutable {
    const double x = unit(random), y = unit(random);
    return Point3{x, y, unit(random)};
  });
}

/// A hundred Gaussian clusters in the unit cube, of deviation 0.01.
inline Points3 clustered_points3(std::size_t n) {
  const Points3 centres = uniform_points3(100);
  return drawn3(n,
                [&, normal = std::normal_distribution<double>(0, 0.01)](auto& random, std::size_t i) mutable {
                  const double x = normal(random), y = normal(random);
                  return centres[i % centres.size()] + Vec3{x, y, normal(random)};
                });
}

/// The largest cubic grid of integers that n points allow, and the points left over in layers more.
inline Points3 grid_points3(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::cbrt(static_cast<double>(n)) + 1e-9);
  Points3 points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({static_cast<double>(i % side), static_cast<double>(i / side % side),
                      static_cast<double>(i / side / side)});
  std::shuffle(points.begin(), points.end(), std::mt19937_64(1));
  return points;
}

/// On the unit sphere, but for rounding.
inline Points3 sphere_points3(std::size_t n) {
  return drawn3(n, [normal = std::normal_distribution<double>()](auto& random, std::size_t) mutable {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::hypot(x, y, z);
    return Point3{x / r, y / r, z / r};
  });
}

/// On the surface of the unit cube.
inline Points3 box_points3(std::size_t n) {
  return drawn3(n,
                [unit = std::uniform_real_distribution<double>(0, 1)](auto& random, std::size_t i) mutable {
                  const double x = unit(random), y = unit(random), end = static_cast<double>(i / 3 % 2);
                  return i % 3 == 0 ? Point3{x, y, end} : i % 3 == 1 ? Point3{x, end, y} : Point3{end, x, y};
                });
}

struct PointSet3 {
  const char* name;
  Points3 (*points)(std::size_t n);
};
inline constexpr std::array point_sets3{PointSet3{"uniform", uniform_points3},
                                        PointSet3{"clusters", clustered_points3},
                                        PointSet3{"grid", grid_points3}, PointSet3{"sphere", sphere_points3},
                                        PointSet3{"box faces", box_points3}};

}  // namespace leonhard::benching
