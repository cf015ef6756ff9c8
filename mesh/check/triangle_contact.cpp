// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/triangle_contact.hpp"

#include <algorithm>
#include <cstddef>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"

namespace leonhard::mesh {
namespace {

using Triangle = std::array<Point3, 3>;

/// The place in the coordinate plane without that axis.
Point2 dropped(const Point3& p, int axis) {
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.z, p.x};
  return {p.x, p.y};
}

/// A coordinate plane in which the triangle is none that is seen edge on.
int axis_to_drop(const Triangle& t) {
  for (const int axis : {0, 1}) {
    if (kernel::orient2d(dropped(t[0], axis), dropped(t[1], axis), dropped(t[2], axis)) != Sign::zero)
      return axis;
  }
  return 2;
}

// ---- in one plane ----

/// p on the segment ab, given that the three are collinear.
bool between(const Point2& a, const Point2& p, const Point2& b) {
  return (a <= p && p <= b) || (b <= p && p <= a);
}

bool segments_meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Sign abc = kernel::orient2d(a, b, c), abd = kernel::orient2d(a, b, d);
  const Sign cda = kernel::orient2d(c, d, a), cdb = kernel::orient2d(c, d, b);
  if (abc == Sign::zero && between(a, c, b)) return true;
  if (abd == Sign::zero && between(a, d, b)) return true;
  if (cda == Sign::zero && between(c, a, d)) return true;
  if (cdb == Sign::zero && between(c, b, d)) return true;
  return abc == -abd && abc != Sign::zero && cda == -cdb && cda != Sign::zero;
}

bool contains(const std::array<Point2, 3>& t, const Point2& p) {
  bool positive = false, negative = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign s = kernel::orient2d(t[i], t[(i + 1) % 3], p);
    positive = positive || s == Sign::positive;
    negative = negative || s == Sign::negative;
  }
  return !(positive && negative);
}

bool segment_meets_in_plane(const Point3& s, const Point3& e, const Triangle& t) {
  const int axis = axis_to_drop(t);
  const Point2 from = dropped(s, axis), to = dropped(e, axis);
  const std::array<Point2, 3> flat{dropped(t[0], axis), dropped(t[1], axis), dropped(t[2], axis)};
  if (contains(flat, from) || contains(flat, to)) return true;
  return segments_meet(from, to, flat[0], flat[1]) || segments_meet(from, to, flat[1], flat[2]) ||
         segments_meet(from, to, flat[2], flat[0]);
}

// ---- in space ----

/// Does the closed segment meet the closed triangle?
bool segment_meets(const Point3& s, const Point3& e, const Triangle& t) {
  const Sign above_s = kernel::orient3d(t[0], t[1], t[2], s), above_e = kernel::orient3d(t[0], t[1], t[2], e);
  if (above_s == Sign::zero && above_e == Sign::zero) return segment_meets_in_plane(s, e, t);
  if (above_s == above_e) return false;
  bool positive = false, negative = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign side = kernel::orient3d(s, e, t[i], t[(i + 1) % 3]);
    positive = positive || side == Sign::positive;
    negative = negative || side == Sign::negative;
  }
  return !(positive && negative);
}

/// All corners of q but the first `common` strictly on one side of p's plane.
bool parted_by_plane(const Triangle& p, const Triangle& q, std::size_t common) {
  const Sign first = kernel::orient3d(p[0], p[1], p[2], q[common]);
  if (first == Sign::zero) return false;
  for (std::size_t i = common + 1; i < 3; ++i) {
    if (kernel::orient3d(p[0], p[1], p[2], q[i]) != first) return false;
  }
  return true;
}

/// Two triangles on the common edge p[0] p[1] = q[0] q[1].
bool folded_onto_each_other(const Triangle& p, const Triangle& q) {
  if (kernel::orient3d(p[0], p[1], p[2], q[2]) != Sign::zero) return false;
  const int axis = axis_to_drop(p);
  const Point2 a = dropped(p[0], axis), b = dropped(p[1], axis);
  return kernel::orient2d(a, b, dropped(p[2], axis)) == kernel::orient2d(a, b, dropped(q[2], axis));
}

/// Moves the common corners of both to the front, in the same order.
/// returns  how many there are
std::size_t bring_common_to_front(Triangle& p, Triangle& q) {
  std::size_t common = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = std::find(q.begin() + static_cast<std::ptrdiff_t>(common), q.end(), p[i]);
    if (at == q.end()) continue;
    std::swap(*at, q[common]);
    std::swap(p[i], p[common]);
    ++common;
  }
  return common;
}

}  // namespace

bool in_contact(const std::array<Point3, 3>& first, const std::array<Point3, 3>& second) {
  Triangle p = first, q = second;
  const std::size_t common = bring_common_to_front(p, q);
  if (common == 3) return false;
  if (common == 2) return folded_onto_each_other(p, q);
  if (parted_by_plane(p, q, common) || parted_by_plane(q, p, common)) return false;
  // Of two triangles with a common corner the common points are convex with it: they reach an edge opposite to it.
  if (common == 1) return segment_meets(p[1], p[2], q) || segment_meets(q[1], q[2], p);
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets(p[i], p[(i + 1) % 3], q) || segment_meets(q[i], q[(i + 1) % 3], p)) return true;
  }
  return false;
}

}  // namespace leonhard::mesh
