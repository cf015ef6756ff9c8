// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/split_points.hpp"

#include <cmath>
#include <numbers>

namespace leonhard::delaunay {

Point2 off_centre(const CornerPoints& t, const Shape& shape, double reach) {
  const Point2 p = t.at[(shape.shortest + 1) % 3], q = t.at[(shape.shortest + 2) % 3],
               r = t.at[shape.shortest];
  const Vec2 edge = q - p, leg = r - p;
  const Vec2 inward{-edge.y, edge.x};
  // Circumcentre = middle + height * inward, from |middle - p|^2 + ... = |middle - r|^2.
  const double height = dot(leg, leg - edge) / (2 * cross(edge, leg));
  return p + (0.5 * edge + std::fmin(height, reach) * inward);
}

double off_centre_reach(double min_angle_deg) {
  return 0.475 / std::tan(min_angle_deg * std::numbers::pi / 360);
}

Point2 middle(Point2 a, Point2 b) { return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y}; }

Point2 shell_point(Point2 apex, Point2 end, double tolerance) {
  const Vec2 way = end - apex;
  const double length = norm(way);
  const double wanted = std::exp2(std::floor(std::log2(length * (2.0 / 3)))) / length;
  double fraction = wanted;
  for (double parts = 2; parts <= 0x1p40; parts *= 2) {
    fraction = std::round(wanted * parts) / parts;
    if (std::abs(fraction - wanted) <= tolerance * wanted) break;
  }
  return apex + fraction * way;
}

}  // namespace leonhard::delaunay
