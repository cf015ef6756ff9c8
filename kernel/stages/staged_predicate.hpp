// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include "leonhard/kernel/arithmetic/homogeneous.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/stages/exact_evaluation.hpp"
#include "leonhard/kernel/stages/finite.hpp"
#include "leonhard/kernel/stages/point_ref.hpp"
#include "leonhard/kernel/stages/stage.hpp"

/// How predicates of implicit points are evaluated, the same in the plane and in space.
///
/// Balls come first, doubles and then DoubleDoubles: the determinant of the vectors from the last point to the others,
/// computed of the coordinates that the points carry with them. What they leave open, ties for the most part, is
/// evaluated in homogeneous coordinates relative to one of the points: each vector times the product of two weights,
/// and so the determinant times all of them. Expansions do it if the degree of the whole leaves them exact, else GMP's
/// integers.
namespace leonhard::kernel {

// ---- balls ----

[[nodiscard]] inline NumberBall<double> difference_as(const NumberBall<DoubleDouble>& a,
                                                      const NumberBall<DoubleDouble>& b, double) {
  const double high = a.value.high - b.value.high, low = a.value.low - b.value.low, value = high + low;
  return {value, a.radius + b.radius + 0x1p-53 * (std::abs(high) + std::abs(low) + std::abs(value))};
}
[[nodiscard]] inline NumberBall<DoubleDouble> difference_as(const NumberBall<DoubleDouble>& a,
                                                            const NumberBall<DoubleDouble>& b, DoubleDouble) {
  return a - b;
}

/// The vector with the square of its length after it.
template <class Number, std::size_t Size>
[[nodiscard]] Vector<Number, Size + 1> lifted(const Vector<Number, Size>& v) {
  Vector<Number, Size + 1> row;
  std::ranges::copy(v, row.begin());
  row[Size] = dot(v, v);
  return row;
}

/// The determinant of orient2d or orient3d, or of incircle or insphere if there is one point more.
template <class Value, class Point, std::size_t Count>
[[nodiscard]] FilteredSign ball_sign(const std::array<PointRef<Point>, Count>& points) {
  constexpr std::size_t size = dimension<Point>;
  constexpr bool lift = Count == size + 2;
  const Coordinates<Point> reference = points[Count - 1].coordinates();
  std::array<Vector<NumberBall<Value>, Count - 1>, Count - 1> rows;
  for (std::size_t i = 0; i + 1 < Count; ++i) {
    Vector<NumberBall<Value>, size> v;
    for (std::size_t axis = 0; axis < size; ++axis)
      v[axis] = difference_as(points[i].coordinate(axis), reference[axis], Value{});
    if constexpr (lift)
      rows[i] = lifted(v);
    else
      rows[i] = v;
  }
  return certain_sign(determinant(rows));
}

// ---- exact numbers ----

/// A copy of the defining points of some points, to be scaled.
template <class Point, std::size_t Count>
class DefiningPoints {
 public:
  explicit DefiningPoints(const std::array<PointRef<Point>, Count>& points) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < Count; ++i) {
      const std::span<const Point> defining = points[i].defining_points();
      std::ranges::copy(defining, points_.begin() + static_cast<std::ptrdiff_t>(begin));
      groups_[i] = {begin, defining.size()};
      begin += defining.size();
    }
    all_ = std::span(points_).first(begin);
  }
  DefiningPoints(const DefiningPoints&) = delete;
  DefiningPoints& operator=(const DefiningPoints&) = delete;

  [[nodiscard]] std::span<const Point> operator[](std::size_t i) const {
    return all_.subspan(groups_[i].first, groups_[i].second);
  }
  [[nodiscard]] std::span<Point> all() { return all_; }

 private:
  static constexpr std::size_t most = dimension<Point> == 2 ? 4 : 9;
  std::array<Point, Count * most> points_;
  std::array<std::pair<std::size_t, std::size_t>, Count> groups_;
  std::span<Point> all_;
};

/// The row of a determinant times `weight`, or if lifted times weight^2.
template <class Number, std::size_t Size>
[[nodiscard]] Vector<Number, Size + 1> lifted(const WeightedVector<Number, Size>& v) {
  Vector<Number, Size + 1> row;
  for (std::size_t i = 0; i < Size; ++i) row[i] = v.vector[i] * v.weight;
  row[Size] = dot(v.vector, v.vector);
  return row;
}

/// As ball_sign, relative to the last point.
template <class Point, std::size_t Count, class Numbers>
[[nodiscard]] Sign homogeneous_sign(const Numbers& numbers, const DefiningPoints<Point, Count>& points) {
  using Number = typename Numbers::Number;
  constexpr bool lift = Count == dimension<Point> + 2;
  const auto reference = homogeneous(numbers, points[Count - 1]);
  std::array<Vector<Number, Count - 1>, Count - 1> rows;
  Sign weights = Sign::positive;
  for (std::size_t i = 0; i + 1 < Count; ++i) {
    auto v = weighted_vector(numbers, reference, homogeneous(numbers, points[i]));
    if constexpr (lift) {
      rows[i] = lifted(v);
    } else {
      rows[i] = std::move(v.vector);
      weights = weights * sign_of(v.weight);
    }
  }
  return weights * sign_of(determinant(rows));
}

/// The determinant is a sum of at most 4^degree products, as expansion_shift wants it. Say that an entry of degree d of
/// a row has at most 4^(d-1): 1 if both points are explicit, 4 and 12 and 144 terms of degree 3, 4 and 7 if one is
/// LineCrossing, LinePlaneCrossing or ThreePlaneCrossing, whose weights have 2, 6 and 48; the other cases follow. Then
/// so has the lifted one, with at most 3 squares, and K rows of degrees d have K! 4^(sum of d - K) <= 4^(sum of d).
template <class Point, std::size_t Count>
[[nodiscard]] int determinant_degree(const std::array<PointRef<Point>, Count>& points) {
  constexpr bool lift = Count == dimension<Point> + 2;
  const auto weight = [&points](std::size_t i) { return weight_degree(points[i].defining_points().size()); };
  int degree = lift ? 1 : 0;
  for (std::size_t i = 0; i + 1 < Count; ++i) degree += 1 + (lift ? 2 : 1) * (weight(i) + weight(Count - 1));
  return degree;
}

template <class Point, std::size_t Count>
[[nodiscard]] StagedSign exact_sign(std::array<PointRef<Point>, Count> points, Stage first) {
  // The vectors are taken from the simplest point.
  const auto simplest =
      std::ranges::min_element(points, {}, [](const auto& p) { return p.defining_points().size(); });
  const bool swapped = simplest != std::prev(points.end());
  if (swapped) std::iter_swap(simplest, std::prev(points.end()));
  DefiningPoints<Point, Count> defining(points);
  StagedSign answer =
      evaluate_exactly(defining.all(), determinant_degree(points), first,
                       [&](const auto& numbers) { return homogeneous_sign(numbers, defining); });
  if (swapped) answer.sign = -answer.sign;
  return answer;
}

// ---- all stages ----

/// The sign of the determinant whose rows are the vectors from the last point to the others, lifted if there are two
/// points more than dimensions.
///
/// first  the first stage to be asked, for tests and measurements
template <class Point, std::size_t Count>
[[nodiscard]] StagedSign determinant_sign(const std::array<PointRef<Point>, Count>& points, Stage first) {
  if (first == Stage::filter)
    if (const FilteredSign s = ball_sign<double>(points); s.is_certain()) return {*s, Stage::filter};
  // Zero is exact in DoubleDoubles, whatever it is multiplied by.
  for (const PointRef<Point>& p : points)
    detail::require_finite("predicate of implicit points", p.defining_points()[0]);
  if (first <= Stage::double_double)
    if (const FilteredSign s = ball_sign<DoubleDouble>(points); s.is_certain())
      return {*s, Stage::double_double};
  return exact_sign(points, first);
}

// ---- single coordinates ----

/// The sign of a - b in one coordinate.
template <class Point>
[[nodiscard]] StagedSign coordinate_sign(const PointRef<Point>& a, const PointRef<Point>& b, std::size_t axis,
                                         Stage first) {
  if (first <= Stage::double_double)
    if (const FilteredSign s = certain_sign(a.coordinate(axis) - b.coordinate(axis)); s.is_certain())
      return {*s, Stage::double_double};
  DefiningPoints<Point, 2> defining({a, b});
  const int degree = 1 + weight_degree(defining[0].size()) + weight_degree(defining[1].size());
  return evaluate_exactly(defining.all(), degree, first, [&](const auto& numbers) {
    const auto v =
        weighted_vector(numbers, homogeneous(numbers, defining[1]), homogeneous(numbers, defining[0]));
    return sign_of(v.vector[axis]) * sign_of(v.weight);
  });
}

/// Lexicographic order: negative if a comes first. The stage is the last one that any coordinate took.
template <class Point>
[[nodiscard]] StagedSign lexicographic_sign(const PointRef<Point>& a, const PointRef<Point>& b, Stage first) {
  StagedSign answer{Sign::zero, first};
  for (std::size_t axis = 0; axis < dimension<Point> && answer.sign == Sign::zero; ++axis) {
    const StagedSign s = coordinate_sign(a, b, axis, first);
    answer = {s.sign, std::max(answer.stage, s.stage)};
  }
  return answer;
}

}  // namespace leonhard::kernel
