// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/exact_triangle.hpp"

#include <algorithm>

namespace leonhard::delaunay::exact {
namespace {

struct Vector {
  mpq_class x, y;
};

Vector between(const Point2& from, const Point2& to) {
  return {mpq_class(to.x) - mpq_class(from.x), mpq_class(to.y) - mpq_class(from.y)};
}
mpq_class dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
mpq_class cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }

/// Dot products of the two sides at each corner, and the cross product, which is the same at all three.
struct Corners {
  std::array<mpq_class, 3> dots;
  mpq_class area2;

  explicit Corners(const Triangle& t) {
    const std::array side{between(t[1], t[2]), between(t[2], t[0]), between(t[0], t[1])};
    for (std::size_t i = 0; i < 3; ++i) dots[i] = -dot(side[(i + 1) % 3], side[(i + 2) % 3]);
    area2 = cross(side[0], side[1]);
  }
};

}  // namespace

mpq_class cotangent_of_min_angle(const Triangle& t) {
  const Corners corners(t);
  return *std::max_element(corners.dots.begin(), corners.dots.end()) / corners.area2;
}

mpq_class cotangent_of_max_angle(const Triangle& t) {
  const Corners corners(t);
  return *std::min_element(corners.dots.begin(), corners.dots.end()) / corners.area2;
}

mpq_class squared_containment_radius(const Triangle& t) {
  const Corners corners(t);
  // The squared side opposite corner i is the sum of the dot products at the other two.
  const auto& [a, b, c] = corners.dots;
  const std::array<mpq_class, 3> squares{b + c, c + a, a + b};
  const bool is_acute =
      std::all_of(corners.dots.begin(), corners.dots.end(), [](const mpq_class& d) { return d > 0; });
  if (!is_acute) return *std::max_element(squares.begin(), squares.end()) / 4;
  return squares[0] * squares[1] * squares[2] / (4 * corners.area2 * corners.area2);
}

mpq_class roughness(const Triangle& t, const std::array<double, 3>& values) {
  Vector turned_gradient{0, 0};  // by a right angle, times twice the area
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector opposite = between(t[(i + 1) % 3], t[(i + 2) % 3]);
    const mpq_class value = values[i];
    turned_gradient.x += value * opposite.x;
    turned_gradient.y += value * opposite.y;
  }
  return dot(turned_gradient, turned_gradient) / (2 * Corners(t).area2);
}

}  // namespace leonhard::delaunay::exact
