// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/arithmetic/expansion.hpp"
#include "leonhard/kernel/double_double.hpp"
#include "leonhard/kernel/point.hpp"

/// Vectors of longer numbers, double-double ones or expansions: what the predicates' later stages compute
/// with.
namespace leonhard::kernel {

template <class Number>
struct LongVec2 {
  Number x, y;
};

template <class Number>
struct LongVec3 {
  Number x, y, z;
};

/// The exact difference of two points.
[[nodiscard]] inline LongVec2<DoubleDouble> long_difference(const Point2& a, const Point2& b) {
  return {{two_difference(a.x, b.x)}, {two_difference(a.y, b.y)}};
}
[[nodiscard]] inline LongVec3<DoubleDouble> long_difference(const Point3& a, const Point3& b) {
  return {{two_difference(a.x, b.x)}, {two_difference(a.y, b.y)}, {two_difference(a.z, b.z)}};
}

[[nodiscard]] inline LongVec2<Expansion<2>> expanded(const LongVec2<DoubleDouble>& v) {
  return {Expansion<2>(v.x), Expansion<2>(v.y)};
}
[[nodiscard]] inline LongVec3<Expansion<2>> expanded(const LongVec3<DoubleDouble>& v) {
  return {Expansion<2>(v.x), Expansion<2>(v.y), Expansion<2>(v.z)};
}

[[nodiscard]] inline bool is_one_double(const LongVec2<DoubleDouble>& v) {
  return v.x.low == 0 && v.y.low == 0;
}
[[nodiscard]] inline bool is_one_double(const LongVec3<DoubleDouble>& v) {
  return v.x.low == 0 && v.y.low == 0 && v.z.low == 0;
}

/// |v|^2, good to a few u: enough for the scale of an error bound.
[[nodiscard]] inline double rounded_square(const LongVec2<DoubleDouble>& v) {
  return v.x.high * v.x.high + v.y.high * v.y.high;
}
[[nodiscard]] inline double rounded_square(const LongVec3<DoubleDouble>& v) {
  return v.x.high * v.x.high + v.y.high * v.y.high + v.z.high * v.z.high;
}

template <class Number>
[[nodiscard]] auto dot(const LongVec2<Number>& u, const LongVec2<Number>& v) {
  return u.x * v.x + u.y * v.y;
}
template <class Number>
[[nodiscard]] auto dot(const LongVec3<Number>& u, const LongVec3<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class Number>
[[nodiscard]] auto cross(const LongVec2<Number>& u, const LongVec2<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

}  // namespace leonhard::kernel
