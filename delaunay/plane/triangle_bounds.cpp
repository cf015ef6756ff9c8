// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/triangle_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {

CornerPoints canonical(Point2 a, Point2 b, Point2 c) {
  if (b < a && b < c) return {{b, c, a}, 1};
  if (c < a && c < b) return {{c, a, b}, 2};
  return {{a, b, c}, 0};
}

Shape shape_of(const CornerPoints& t) {
  std::array<double, 3> length2;
  for (unsigned i = 0; i < 3; ++i) {
    const Vec2 edge = t.at[(i + 2) % 3] - t.at[(i + 1) % 3];
    length2[i] = dot(edge, edge);
  }
  Shape shape;
  for (unsigned i = 1; i < 3; ++i)
    if (length2[i] < length2[shape.shortest]) shape.shortest = i;
  shape.shortest2 = length2[shape.shortest];
  shape.longest2 = std::max({length2[0], length2[1], length2[2]});
  const double area2 = cross(t.at[1] - t.at[0], t.at[2] - t.at[0]);
  shape.area = area2 / 2;
  shape.radius2 = area2 > 0 ? (length2[0] / area2) * (length2[1] / area2) * length2[2] / 4
                            : std::numeric_limits<double>::infinity();
  return shape;
}

TriangleBounds::TriangleBounds(double min_angle_deg, std::function<double(Point2)> size, double max_area)
    : worst_ratio2_(std::numeric_limits<double>::infinity()), size_(std::move(size)), max_area_(max_area) {
  if (min_angle_deg > 0) {
    // Law of sines: the shortest edge is 2 R sin(smallest angle).
    const double sine = std::sin(min_angle_deg * std::numbers::pi / 180);
    worst_ratio2_ = 1 / (4 * sine * sine);
  }
}

double TriangleBounds::size_at(Point2 p) const {
  const double h = size_(p);
  if (!(h > 0) || !std::isfinite(h))
    throw InputError("RefineOptions::size",
                     "the target edge length at " + mesh::words(p) + " is " + mesh::words(h),
                     "return a positive, finite length everywhere in the domain");
  return h;
}

TriangleBounds::Miss TriangleBounds::miss(const CornerPoints& t, const Shape& shape,
                                          double region_area) const {
  Miss miss;
  double excess = 0;  // squared ratio of size to bound
  if (size_) {
    const double target =
        size_at({(t.at[0].x + t.at[1].x + t.at[2].x) / 3, (t.at[0].y + t.at[1].y + t.at[2].y) / 3});
    const double bound = longest_in_targets * target;
    excess = shape.longest2 / (bound * bound);
  }
  for (const double area : {max_area_, region_area})
    if (area > 0) excess = std::max(excess, shape.area / area);
  miss.size = excess > 1;
  miss.angle = shape.radius2 > worst_ratio2_ * shape.shortest2;
  return miss;
}

}  // namespace leonhard::delaunay
