// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/pslg.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"
#include "leonhard/mesh/validate.hpp"

/// Point sets and graphs that the delaunay tests share.
namespace leonhard::shapes {

struct NamedPoints {
  std::string name;
  std::vector<Point2> points;
};

inline std::vector<Point2> uniform(std::size_t n, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(random);
    points.push_back({x, unit(random)});
  }
  return points;
}

inline std::vector<Point2> grid(std::size_t side, double angle = 0) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto x = static_cast<double>(i % side), y = static_cast<double>(i / side);
    points.push_back({x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)});
  }
  return points;
}

/// Exactly cocircular: integer points with x^2 + y^2 = 5^2 13^2 17^2, and the centre.
inline std::vector<Point2> cocircular() {
  constexpr int r = 5 * 13 * 17;
  std::vector<Point2> points{{0, 0}};
  for (int x = -r; x <= r; ++x)
    for (int y = -r; y <= r; ++y)
      if (x * x + y * y == r * r) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

inline std::vector<Point2> transformed(std::vector<Point2> points, double scale, double offset) {
  for (Point2& p : points) p = {p.x * scale + offset, p.y * scale - offset};
  return points;
}

/// Gaussian clusters of very different widths.
inline std::vector<Point2> gaussian_clusters(std::size_t n, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::vector<Point2> centres = uniform(7, seed);
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double width = std::pow(0.1, static_cast<double>(i % 7)), x = normal(random);
    points.push_back(centres[i % 7] + width * Vec2{x, normal(random)});
  }
  return points;
}

/// Points of a circle rounded to doubles: nearly all just off it.
inline std::vector<Point2> circle(std::size_t n) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle_rad = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.push_back({std::cos(angle_rad), std::sin(angle_rad)});
  }
  return points;
}

/// The integer points with x^2 + y^2 = radius^2; many if radius is a product of primes of the form 4 k + 1.
inline std::vector<Point2> lattice_circle(int radius) {
  std::vector<Point2> points;
  for (double x = -radius; x <= radius; ++x) {
    const double y2 = static_cast<double>(radius) * radius - x * x, y = std::round(std::sqrt(y2));
    if (y * y != y2) continue;
    points.push_back({x, y});
    if (y > 0) points.push_back({x, -y});
  }
  return points;
}

/// An Archimedean spiral of `turns` turns.
inline std::vector<Point2> spiral(std::size_t n, double turns = 12) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = static_cast<double>(i + 1) / static_cast<double>(n),
                 angle_rad = 2 * std::numbers::pi * turns * radius;
    points.push_back({radius * std::cos(angle_rad), radius * std::sin(angle_rad)});
  }
  return points;
}

/// Points of y = x^2, -1 <= x <= 1, rounded to doubles.
inline std::vector<Point2> parabola(std::size_t n) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 2 * static_cast<double>(i) / static_cast<double>(n - 1) - 1;
    points.push_back({x, x * x});
  }
  return points;
}

/// Two parallel lines of evenly spaced points, `gap` spacings apart.
inline std::vector<Point2> line_pair(std::size_t n, double gap = 8) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i / 2), i % 2 == 0 ? 0 : gap});
  return points;
}

/// Figure 3.3.8 of Barth's notes: a column of sites, then a row of as many to its right that comes nearer and
/// nearer. In this order each site of the row is joined to the whole column.
inline std::vector<Point2> column_and_row(std::size_t half) {
  std::vector<Point2> points;
  const auto step = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(half); };
  for (std::size_t i = 0; i < half; ++i) points.push_back({0, 2 * step(i) - 1});
  for (std::size_t i = 0; i < half; ++i) points.push_back({3 - step(i), 0});
  return points;
}

/// A few thousand points of every distribution on which algorithms are compared.
inline std::vector<NamedPoints> distributions() {
  return {{"uniform", uniform(4000)},
          {"Gaussian clusters", gaussian_clusters(4000)},
          {"grid", grid(60)},
          {"rotated grid", grid(60, 0.7)},
          {"circle", circle(2000)},
          {"lattice circle", lattice_circle(5 * 13 * 17 * 29 * 37)},
          {"spiral", spiral(3000)},
          {"parabola", parabola(2000)},
          {"line pair", line_pair(2000)}};
}

/// Sets with every kind of degeneracy; each has at least three points that are not collinear.
inline std::vector<NamedPoints> families() {
  std::vector<NamedPoints> all;
  all.push_back({"triangle", {{0, 0}, {1, 0}, {0, 1}}});
  all.push_back({"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  all.push_back({"uniform", uniform(300)});
  all.push_back({"grid", grid(14)});
  all.push_back({"rotated grid", grid(14, 0.3)});
  all.push_back({"cocircular", cocircular()});
  std::vector<Point2> line{{0.5, 3}};
  for (int i = 0; i < 60; ++i) line.push_back({static_cast<double>(i), static_cast<double>(2 * i)});
  all.push_back({"collinear and one", line});
  std::vector<Point2> repeated = grid(6);
  for (const Point2 p : grid(6)) repeated.push_back(p);
  repeated.push_back({-0.0, 0.0});
  all.push_back({"duplicates", repeated});
  std::vector<Point2> clusters = transformed(uniform(80, 2), 1e-9, 0.5);
  for (const Point2 p : transformed(uniform(80, 3), 1e-3, -7)) clusters.push_back(p);
  clusters.push_back({1e6, -1e6});
  all.push_back({"clusters", clusters});
  all.push_back({"offset 1e300", transformed(grid(8), 1e285, 1e300)});
  all.push_back({"subnormal", transformed(grid(8), 5e-324, 0)});
  all.push_back({"huge", transformed(uniform(80, 4), 1.7e308, 0)});
  return all;
}

/// In lexicographic order, each once.
inline std::vector<Point2> distinct(std::vector<Point2> points) {
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

/// The same graph with its points and segments in another order, some segments turned round.
inline Pslg shuffled(const Pslg& pslg, std::uint64_t seed) {
  std::vector<std::size_t> old_of_new(pslg.points.size()), new_of_old(pslg.points.size());
  std::iota(old_of_new.begin(), old_of_new.end(), std::size_t{0});
  old_of_new = shuffled(old_of_new, seed);
  Pslg other = pslg;
  for (std::size_t i = 0; i < old_of_new.size(); ++i) {
    new_of_old[old_of_new[i]] = i;
    other.points[i] = pslg.points[old_of_new[i]];
    if (!pslg.point_markers.empty()) other.point_markers[i] = pslg.point_markers[old_of_new[i]];
  }
  other.segments = shuffled(pslg.segments, seed + 1);
  for (std::size_t i = 0; i < other.segments.size(); ++i) {
    Pslg::Segment& s = other.segments[i];
    s = {new_of_old[s.from], new_of_old[s.to], s.marker};
    if (i % 2 == 0) std::swap(s.from, s.to);
  }
  return other;
}

/// Append a closed polygon.
inline void add_loop(Pslg& pslg, const std::vector<Point2>& corners, Marker marker = 1) {
  const std::size_t first = pslg.points.size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    pslg.points.push_back(corners[i]);
    pslg.segments.push_back({first + i, first + (i + 1) % corners.size(), marker});
  }
}

inline std::vector<Point2> box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// A square of side 64 with a square island of side 16 in it, and in this a lake of side 4.
inline Pslg nested() {
  Pslg pslg;
  add_loop(pslg, box(0, 0, 64, 64), 1);
  add_loop(pslg, box(24, 24, 16, 16), 2);
  add_loop(pslg, box(30, 30, 4, 4), 3);
  pslg.source = "nested squares";
  return pslg;
}

/// A comb with teeth of width 1 and height `height`, gaps of width 1.
inline Pslg comb(int teeth, double height) {
  std::vector<Point2> outline{{0, -1}};
  outline.push_back({2.0 * teeth, -1});
  for (int i = teeth; i-- > 0;) {
    const double x = 2 * i;
    outline.insert(outline.end(), {{x + 2, 0}, {x + 1, 0}, {x + 1, height}, {x, height}});
  }
  outline.push_back({0, 0});
  // The last tooth's left side and the first corner are collinear with the outline's left side.
  Pslg pslg;
  add_loop(pslg, outline);
  pslg.source = "comb";
  return pslg;
}

/// A box with `spokes` segments from its centre, `degrees` apart, that end on no common point.
inline Pslg fan(int spokes, double degrees) {
  Pslg pslg;
  add_loop(pslg, box(-8, -8, 16, 16));
  const std::size_t centre = pslg.points.size();
  pslg.points.push_back({0, 0});
  for (int i = 0; i < spokes; ++i) {
    const double angle = 0.1 + i * degrees * std::numbers::pi / 180, length = 3 + 0.37 * (i % 5);
    pslg.points.push_back({length * std::cos(angle), length * std::sin(angle)});
    pslg.segments.push_back({centre, pslg.points.size() - 1, 5});
  }
  pslg.source = "fan";
  return pslg;
}

/// Whether two segments have a point in common that is an end of neither.
inline bool segments_cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return kernel::orient2d(a, b, c) * kernel::orient2d(a, b, d) == Sign::negative &&
         kernel::orient2d(c, d, a) * kernel::orient2d(c, d, b) == Sign::negative;
}

/// Points of a small grid in a box, joined by random segments of which none cross: collinear and cocircular points,
/// overlaps, T-junctions and hanging segments in every one of them.
inline Pslg random_graph(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::uint64_t n) { return random() % n; };
  Pslg pslg;
  add_loop(pslg, box(0, 0, 9, 9), 4);
  for (int i = 0; i < 25; ++i) {
    const auto x = static_cast<double>(below(10));
    pslg.points.push_back({x, static_cast<double>(below(10))});
  }
  for (int i = 0; i < 60; ++i) {
    const Pslg::Segment s{below(pslg.points.size()), below(pslg.points.size()), 7};
    const bool crosses = std::any_of(pslg.segments.begin(), pslg.segments.end(), [&](const Pslg::Segment& t) {
      return segments_cross(pslg.points[s.from], pslg.points[s.to], pslg.points[t.from], pslg.points[t.to]);
    });
    if (!crosses) pslg.segments.push_back(s);
  }
  return pslg;
}

/// All public validators.
inline void require_valid(const TriangleMesh& mesh) {
  for (const auto& broken :
       {mesh::validate(mesh), mesh::validate_embedding(mesh), mesh::validate_delaunay(mesh)}) {
    INFO(broken.value_or(""));
    REQUIRE_FALSE(broken.has_value());
  }
}

}  // namespace leonhard::shapes
