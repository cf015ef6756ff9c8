// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::app {

/// A closed polygon with what messages call it.
struct NamedOutline {
  std::string name;   ///< "main"
  std::string where;  ///< "case.toml:12"
  std::vector<Point2> points;
};

enum class PointPlace { inside, on_boundary, outside };

/// Where a point lies, exactly, for a polygon that does not cross itself, either way round. Cost O(n).
[[nodiscard]] PointPlace locate_in_polygon(std::span<const Point2> polygon, Point2 p);

/// Whether two closed segments have a point in common. Exact.
[[nodiscard]] bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d);

/// Twice the signed area, rounded; for orientation of polygons that do not cross themselves.
[[nodiscard]] double rounded_area2(std::span<const Point2> polygon);

/// One body by itself: at least 3 finite points, none given twice, no area of zero, no edge that crosses or touches another.
/// throws InputError naming the body, the points' numbers (from 1) and coordinates. Cost O(n log n) for usual shapes.
void check_outline(const NamedOutline& body);

/// No edge of one body meets one of another; one may contain another.
/// throws InputError naming both, where, and the remedy. Each must have passed check_outline.
void check_edges_apart(std::span<const NamedOutline> bodies, const std::string& remedy);

/// Bodies among each other: none crosses, touches or contains another.
/// throws InputError naming both bodies and where. Each must have passed check_outline.
void check_apart(std::span<const NamedOutline> bodies);

/// Every body strictly inside the far field, a convex polygon.
/// throws InputError naming the body, the first point outside, and what to change
void check_inside_far_field(std::span<const NamedOutline> bodies, std::span<const Point2> far_field,
                            const std::string& where);

/// A point strictly inside a polygon that passed check_outline, by exact test; some way from the boundary where the
/// polygon's shape allows. throws InputError if the polygon is so thin that doubles have no such point.
[[nodiscard]] Point2 point_inside(const NamedOutline& body);

}  // namespace leonhard::app
