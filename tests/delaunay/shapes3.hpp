// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Point sets of space for tests: what is degenerate, huge, tiny or clustered.
namespace leonhard::shapes3 {

struct NamedPoints {
  std::string name;
  std::vector<Point3> points;
};

inline std::vector<Point3> uniform(std::size_t n, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(random), y = unit(random);
    points.push_back({x, y, unit(random)});
  }
  return points;
}

/// Integer points: every cube of eight is cospherical, every plane full of coplanar ones.
inline std::vector<Point3> grid(int nx, int ny, int nz) {
  std::vector<Point3> points;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  return points;
}

inline std::vector<Point3> transformed(std::vector<Point3> points, double scale, double offset) {
  for (Point3& p : points) p = {p.x * scale + offset, p.y * scale - offset, p.z * scale + offset};
  return points;
}

inline std::vector<Point3> rotated(std::vector<Point3> points, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (Point3& p : points) {
    p = {p.x * c - p.y * s, p.x * s + p.y * c, p.z};
    p = {p.x, p.y * c - p.z * s, p.y * s + p.z * c};
  }
  return points;
}

/// Exactly cospherical: the integer points with x^2 + y^2 + z^2 = square.
inline std::vector<Point3> lattice_sphere(int square) {
  const int r = static_cast<int>(std::sqrt(square)) + 1;
  std::vector<Point3> points;
  for (int x = -r; x <= r; ++x)
    for (int y = -r; y <= r; ++y)
      for (int z = -r; z <= r; ++z)
        if (x * x + y * y + z * z == square)
          points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  return points;
}

/// Points of a sphere rounded to doubles: nearly all just off it.
inline std::vector<Point3> sphere(std::size_t n, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = normal(random), y = normal(random);
    const Vec3 v{x, y, normal(random)};
    points.push_back(Point3{} + (1 / norm(v)) * v);
  }
  return points;
}

/// Gaussian clusters of very different widths.
inline std::vector<Point3> gaussian_clusters(std::size_t n, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::vector<Point3> centres = uniform(7, seed);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double width = std::pow(0.1, static_cast<double>(i % 7)), x = normal(random), y = normal(random);
    points.push_back(centres[i % 7] + width * Vec3{x, y, normal(random)});
  }
  return points;
}

/// Two skew lines of n points each: (n - 1)^2 tetrahedra, every piece of the one joined to every piece of the other.
inline std::vector<Point3> skew_lines(int n) {
  std::vector<Point3> points;
  for (int i = 0; i < n; ++i) {
    points.push_back({static_cast<double>(i), 0, 0});
    points.push_back({static_cast<double>(n / 2), static_cast<double>(i - n / 2), static_cast<double>(n)});
  }
  return points;
}

/// Points in pairs one unit in the last place apart.
inline std::vector<Point3> twins(std::size_t n) {
  std::vector<Point3> points;
  for (const Point3& p : uniform(n, 9)) {
    points.push_back(p);
    points.push_back({p.x, std::nextafter(p.y, 2), p.z});
  }
  return points;
}

/// Sets with every kind of degeneracy; each spans space.
inline std::vector<NamedPoints> families() {
  std::vector<NamedPoints> all;
  all.push_back({"tetrahedron", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  all.push_back({"cube", grid(2, 2, 2)});
  all.push_back({"uniform", uniform(200)});
  all.push_back({"grid", grid(6, 5, 4)});
  all.push_back({"rotated grid", rotated(grid(5, 5, 5), 0.3)});
  all.push_back({"integer sphere", lattice_sphere(101)});
  all.back().points.push_back({0, 0, 0});
  all.push_back({"sphere", sphere(150)});
  all.push_back({"Gaussian clusters", gaussian_clusters(150)});
  all.push_back({"skew lines", skew_lines(14)});
  all.push_back({"plane and one", grid(8, 8, 1)});
  all.back().points.push_back({3.25, 2.5, 4});
  all.push_back({"line and two", {{0.5, 3, -1}, {7, -2, 2}}});
  for (int i = 0; i < 40; ++i) all.back().points.push_back({1.0 * i, 2.0 * i, -3.0 * i});
  all.push_back({"duplicates", grid(3, 3, 3)});
  for (const Point3& p : grid(3, 3, 3)) all.back().points.push_back(p);
  all.back().points.push_back({-0.0, 0, -0.0});
  all.push_back({"offset 1e300", transformed(grid(4, 4, 4), 1e285, 1e300)});
  all.push_back({"subnormal", transformed(grid(4, 4, 3), 5e-324, 0)});
  all.push_back({"huge", transformed(uniform(60, 4), 1.7e308, 0)});
  all.push_back({"twins", twins(60)});
  all.push_back({"both ends of the range", transformed(grid(2, 2, 2), 1.7e308, 0)});
  for (const Point3& p : transformed(grid(2, 3, 2), 5e-324, 0)) all.back().points.push_back(p);
  return all;
}

/// In lexicographic order, each once.
inline std::vector<Point3> distinct(std::vector<Point3> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

template <class T>
std::vector<T> shuffled(std::vector<T> values, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::shuffle(values.begin(), values.end(), random);
  return values;
}

}  // namespace leonhard::shapes3
