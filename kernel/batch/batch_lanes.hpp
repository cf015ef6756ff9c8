// SPDX-License-Identifier: MIT
#pragma once

// As many doubles side by side as the instruction set of the including file has in a register, two or four, and the
// way of points into them. Included by the files that are compiled once per instruction set, so everything has
// internal linkage and nothing of the library's or the standard library's inline functions is called: a linker that
// took one set's copy of a function for both would crash older processors.

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "leonhard/kernel/batch/batch_filters.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

#define LEONHARD_INLINE [[gnu::always_inline]] static inline
#define LEONHARD_INLINE_LAMBDA __attribute__((always_inline))

namespace leonhard::kernel {
namespace {

#if defined(__AVX2__)
constexpr std::size_t lane_count = 4;
#else
constexpr std::size_t lane_count = 2;
#endif

using Lanes = double __attribute__((vector_size(8 * lane_count)));
using LanesMask = long long __attribute__((vector_size(8 * lane_count)));
using HalfLanes = double __attribute__((vector_size(16)));

/// Coordinates of lane_count vectors.
struct Lanes2 {
  Lanes x, y;
};
struct Lanes3 {
  Lanes x, y, z;
};

LEONHARD_INLINE Lanes magnitude(const Lanes& x) {
  return reinterpret_cast<Lanes>(reinterpret_cast<LanesMask>(x) & 0x7fffffffffffffff);
}

/// b - a in every lane.
LEONHARD_INLINE Lanes2 in_every_lane(const Point2& a, const Point2& b) {
  return {Lanes{} + (b.x - a.x), Lanes{} + (b.y - a.y)};
}
LEONHARD_INLINE Lanes3 in_every_lane(const Point3& a, const Point3& b) {
  return {Lanes{} + (b.x - a.x), Lanes{} + (b.y - a.y), Lanes{} + (b.z - a.z)};
}

// ---- Signs ----

#if defined(__SSE2__)
/// The signs to store for every set of sign bits, taken from the lanes two by two: of their numbers, then of their
/// masks.
struct SignTable {
  static constexpr std::size_t sets = std::size_t{1} << (2 * lane_count);
  Sign of_set[sets][lane_count];
};
constexpr SignTable sign_table() {
  SignTable table{};
  for (std::size_t set = 0; set < SignTable::sets; ++set)
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const std::size_t negative = set >> (lane / 2 * 4 + lane % 2), certain = negative >> 2;
      if (certain % 2 == 1) table.of_set[set][lane] = negative % 2 == 1 ? Sign::negative : Sign::positive;
    }
  return table;
}
alignas(64) constexpr SignTable signs_to_store = sign_table();
#endif

/// Stores the signs of x, which is not zero where they are certain; elsewhere zero.
LEONHARD_INLINE void store_signs(Sign* signs, const LanesMask& certain, const Lanes& x) {
#if defined(__AVX2__)
  const int set = _mm256_movemask_ps(_mm256_shuffle_ps((__m256)x, (__m256)certain, 0xdd));
  std::memcpy(signs, signs_to_store.of_set[static_cast<unsigned>(set)], lane_count);
#elif defined(__SSE2__)
  const int set = _mm_movemask_ps(_mm_shuffle_ps((__m128)x, (__m128)certain, 0xdd));
  std::memcpy(signs, signs_to_store.of_set[static_cast<unsigned>(set)], lane_count);
#else
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    signs[lane] = certain[lane] == 0 ? Sign::zero : x[lane] < 0 ? Sign::negative : Sign::positive;
#endif
}

// ---- Points ----
//
// The first two coordinates of points are loaded and subtracted as rows, one point after another as they lie in memory,
// and only the differences turned into columns, one coordinate a register. The third is put into a column number by
// number: rows of three would need so much shuffling that orient3d took a sixth longer.

/// The first two coordinates of a point.
template <class Point>
LEONHARD_INLINE HalfLanes xy_row(const Point& point) {
  HalfLanes xy;
  std::memcpy(&xy, &point, sizeof xy);
  return xy;
}
LEONHARD_INLINE double z_of(const Point3& point) { return point.z; }

/// A record of a SpheresFilter, which begins with a point.
struct PointRecord {
  unsigned char bytes[sphere_record_bytes];
};
LEONHARD_INLINE double z_of(const PointRecord& record) {
  double z;
  std::memcpy(&z, record.bytes + offsetof(Point3, z), sizeof z);
  return z;
}

#if defined(__AVX2__)

/// Points 0 and 2, points 1 and 3: columns are then made without moving anything across the middle of a register.
struct Rows2 {
  Lanes even, odd;
};

LEONHARD_INLINE Lanes side_by_side(const HalfLanes& low, const HalfLanes& high) {
  return (Lanes)_mm256_insertf128_pd(_mm256_castpd128_pd256((__m128d)low), (__m128d)high, 1);
}

/// Points by id; the ids lie `stride` apart.
template <std::size_t stride, class Point>
LEONHARD_INLINE Rows2 xy_rows(const Point* points, const std::uint32_t* ids) {
  return {side_by_side(xy_row(points[ids[0]]), xy_row(points[ids[2 * stride]])),
          side_by_side(xy_row(points[ids[stride]]), xy_row(points[ids[3 * stride]]))};
}
template <std::size_t stride, class Point>
LEONHARD_INLINE Lanes z_column(const Point* points, const std::uint32_t* ids) {
  return Lanes{z_of(points[ids[0]]), z_of(points[ids[stride]]), z_of(points[ids[2 * stride]]),
               z_of(points[ids[3 * stride]])};
}

/// The same point in every row.
template <class Point>
LEONHARD_INLINE Rows2 equal_xy_rows(const Point& p) {
  const Lanes row = side_by_side(xy_row(p), xy_row(p));
  return {row, row};
}

LEONHARD_INLINE Rows2 operator-(const Rows2& a, const Rows2& b) { return {a.even - b.even, a.odd - b.odd}; }

LEONHARD_INLINE Lanes2 columns(const Rows2& r) {
  return {__builtin_shufflevector(r.even, r.odd, 0, 4, 2, 6),
          __builtin_shufflevector(r.even, r.odd, 1, 5, 3, 7)};
}

#else

struct Rows2 {
  Lanes first, second;
};

/// Points by id; the ids lie `stride` apart.
template <std::size_t stride, class Point>
LEONHARD_INLINE Rows2 xy_rows(const Point* points, const std::uint32_t* ids) {
  return {xy_row(points[ids[0]]), xy_row(points[ids[stride]])};
}
template <std::size_t stride, class Point>
LEONHARD_INLINE Lanes z_column(const Point* points, const std::uint32_t* ids) {
  return Lanes{z_of(points[ids[0]]), z_of(points[ids[stride]])};
}

/// The same point in every row.
template <class Point>
LEONHARD_INLINE Rows2 equal_xy_rows(const Point& p) {
  return {xy_row(p), xy_row(p)};
}

LEONHARD_INLINE Rows2 operator-(const Rows2& a, const Rows2& b) {
  return {a.first - b.first, a.second - b.second};
}

LEONHARD_INLINE Lanes2 columns(const Rows2& r) {
  return {__builtin_shufflevector(r.first, r.second, 0, 2), __builtin_shufflevector(r.first, r.second, 1, 3)};
}

#endif

struct Rows3 {
  Rows2 xy;
  Lanes z;
};

/// Points by id; the ids lie `stride` apart.
template <std::size_t stride>
LEONHARD_INLINE Rows2 rows(const Point2* points, const std::uint32_t* ids) {
  return xy_rows<stride>(points, ids);
}
template <std::size_t stride, class Point>
LEONHARD_INLINE Rows3 rows(const Point* points, const std::uint32_t* ids) {
  return {xy_rows<stride>(points, ids), z_column<stride>(points, ids)};
}

/// The same point in every row.
LEONHARD_INLINE Rows2 equal_rows(const Point2& p) { return equal_xy_rows(p); }
LEONHARD_INLINE Rows3 equal_rows(const Point3& p) { return {equal_xy_rows(p), Lanes{} + p.z}; }

LEONHARD_INLINE Rows3 operator-(const Rows3& a, const Rows3& b) { return {a.xy - b.xy, a.z - b.z}; }

LEONHARD_INLINE Lanes3 columns(const Rows3& r) {
  const Lanes2 xy = columns(r.xy);
  return {xy.x, xy.y, r.z};
}

}  // namespace
}  // namespace leonhard::kernel
