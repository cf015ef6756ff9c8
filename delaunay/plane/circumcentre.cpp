// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/circumcentre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {
namespace {

/// A point at the end of the doubles' range where the circumcentre of a very flat triangle lies beyond it: on the
/// bisector of the longest side, away from the triangle.
Point2 far_point(const std::array<Point2, 3>& corners) {
  Vec2 longest{};
  for (unsigned i = 0; i < 3; ++i) {
    const Vec2 side = towards(corners[i], corners[(i + 1) % 3]);
    if (norm(0.5 * side) > norm(0.5 * longest)) longest = side;
  }
  const Vec2 out = unit({longest.y, -longest.x});
  return {std::numeric_limits<double>::max() * out.x, std::numeric_limits<double>::max() * out.y};
}

}  // namespace

Vec2 unit(Vec2 v) {
  const double largest = std::max(std::abs(v.x), std::abs(v.y));
  const int exponent = std::ilogb(largest);
  const Vec2 scaled{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent)};
  return 1 / norm(scaled) * scaled;
}

Vec2 towards(Point2 a, Point2 b) {
  const Vec2 whole = b - a;
  if (std::isfinite(whole.x) && std::isfinite(whole.y)) return whole;
  return {0.5 * b.x - 0.5 * a.x, 0.5 * b.y - 0.5 * a.y};
}

VoronoiCorner<Point2> rounded_circumcentre(const std::array<Point2, 3>& corners) {
  try {
    const kernel::Circle circle = kernel::circumcircle(corners[0], corners[1], corners[2]);
    return {circle.centre, circle.centre_error};
  } catch (const InputError&) {  // a triangle has a circle, but its centre is no pair of doubles
    return {far_point(corners), std::numeric_limits<double>::infinity()};
  }
}

}  // namespace leonhard::delaunay
