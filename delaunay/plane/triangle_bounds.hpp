// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>

#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The corners of a triangle, counter-clockwise, the lexicographically smallest first: what is computed from them
/// is the same to the bit whatever number or slot the triangle has.
struct CornerPoints {
  std::array<Point2, 3> at;
  unsigned first{};  ///< at[i] was the argument (first + i) % 3 of canonical
};
[[nodiscard]] CornerPoints canonical(Point2 a, Point2 b, Point2 c);

/// Lengths of a triangle that the bounds and the split points are made from.
struct Shape {
  unsigned shortest{};             ///< the shortest edge lies opposite this corner
  double shortest2{}, longest2{};  ///< squared lengths of the shortest and longest edge
  double radius2{};                ///< squared circumradius; infinite where rounding makes the triangle flat
  double area{};                   ///< may round to 0 or below
};
[[nodiscard]] Shape shape_of(const CornerPoints& t);

/// What a mesh's triangles are asked for, and which of it one misses. Rounded arithmetic is right here: no
/// topology depends on it.
class TriangleBounds {
 public:
  /// min_angle_deg  0: no bound
  /// size           target edge length, may be empty
  /// max_area       not positive: no bound
  TriangleBounds(double min_angle_deg, std::function<double(Point2)> size, double max_area);

  struct Miss {
    bool angle = false;  ///< an angle is too small
    bool size = false;   ///< too large
    explicit operator bool() const { return angle || size; }
  };
  /// region_area  the region's own area bound, not positive: none
  /// throws       InputError if the size function returns a number that is not positive and finite
  [[nodiscard]] Miss miss(const CornerPoints& t, const Shape& shape, double region_area) const;

  /// Target edge length at p, checked; only where has_size().
  [[nodiscard]] double size_at(Point2 p) const;
  [[nodiscard]] bool has_size() const { return static_cast<bool>(size_); }

  /// Size bound: no edge longer than this many target lengths at the triangle's centroid. Refinement then leaves
  /// edges of one target length on average, most of them between 0.7 and 1.4.
  static constexpr double longest_in_targets = 1.55;

 private:
  double worst_ratio2_;  // largest allowed radius2 / shortest2
  std::function<double(Point2)> size_;
  double max_area_;
};

}  // namespace leonhard::delaunay
