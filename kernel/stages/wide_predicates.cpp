// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/wide_predicates.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "leonhard/kernel/arithmetic/term_sum.hpp"
#include "leonhard/kernel/arithmetic/wide_double.hpp"
#include "leonhard/kernel/filtered_sign.hpp"

namespace leonhard::kernel::wide_range {
namespace {

template <class Number, std::size_t Dimension, std::size_t Count>
using Points = std::array<std::array<Number, Dimension>, Count>;

// ---- factors of terms: coordinates point by point, x first; then weights point by point; then 1 ----

template <std::size_t Dimension>
constexpr std::uint8_t coordinate_factor(std::size_t point, std::size_t axis) {
  return static_cast<std::uint8_t>(point * Dimension + axis);
}
template <std::size_t Dimension, std::size_t Count>
constexpr std::uint8_t weight_factor(std::size_t point) {
  return static_cast<std::uint8_t>(Count * Dimension + point);
}
template <std::size_t Dimension, std::size_t Count>
constexpr std::uint8_t one_factor = Count*(Dimension + 1);

template <class Number, std::size_t Dimension, std::size_t Count>
std::array<Number, Count * Dimension> factors_of(const Points<Number, Dimension, Count>& points) {
  std::array<Number, Count * Dimension> factors;
  auto next = factors.begin();
  for (const auto& p : points) next = std::ranges::copy(p, next).out;
  return factors;
}

template <std::size_t Dimension, std::size_t Count>
std::array<WideDouble, Count*(Dimension + 1) + 1> factors_of(
    const Points<WideDouble, Dimension, Count>& points, const std::array<WideDouble, Count>& weights) {
  std::array<WideDouble, Count*(Dimension + 1) + 1> factors;
  auto next = std::ranges::copy(factors_of(points), factors.begin()).out;
  *std::ranges::copy(weights, next).out = wide(1);
  return factors;
}

// ---- terms of determinants ----

template <std::size_t Count>
constexpr bool is_odd(const std::array<std::uint8_t, Count>& permutation) {
  bool odd = false;
  for (std::size_t i = 0; i < Count; ++i)
    for (std::size_t j = i + 1; j < Count; ++j) odd = odd != (permutation[i] > permutation[j]);
  return odd;
}

constexpr std::size_t factorial(std::size_t n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// Calls take(point_of_column, is_negative) for each permutation of the rows of a determinant, one a point, that has the
/// sign of predicates: minus that of the determinant in space.
template <std::size_t Dimension, std::size_t Count, class Take>
constexpr void for_each_permutation(Take take) {
  std::array<std::uint8_t, Count> point_of_column{};
  std::iota(point_of_column.begin(), point_of_column.end(), std::uint8_t{0});
  do take(point_of_column, is_odd(point_of_column) != (Dimension == 3));
  while (std::ranges::next_permutation(point_of_column).found);
}

/// The determinant with rows (x, y, 1), or (x, y, z, 1).
template <std::size_t Dimension>
consteval auto orientation_terms() {
  std::array<Term<Dimension>, factorial(Dimension + 1)> terms{};
  auto next = terms.begin();
  for_each_permutation<Dimension, Dimension + 1>([&](const auto& point, bool is_negative) {
    Term<Dimension> term{{}, is_negative};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
      term.factors[axis] = coordinate_factor<Dimension>(point[axis], axis);
    *next++ = term;
  });
  return terms;
}

/// The determinant with rows (x, y, height, 1), or (x, y, z, height, 1), a height being the square of the other
/// coordinates less the weight, if there are weights.
template <std::size_t Dimension, bool HaveWeights>
consteval auto lifted_terms() {
  constexpr std::size_t degree = Dimension + 2, count = Dimension + 2;
  std::array<Term<degree>, factorial(count) * (HaveWeights ? Dimension + 1 : Dimension)> terms{};
  auto next = terms.begin();
  for_each_permutation<Dimension, count>([&](const auto& point, bool is_negative) {
    Term<degree> term{{}, is_negative};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
      term.factors[axis] = coordinate_factor<Dimension>(point[axis], axis);
    const auto lifted = point[Dimension];
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
      term.factors[Dimension] = term.factors[Dimension + 1] = coordinate_factor<Dimension>(lifted, axis);
      *next++ = term;
    }
    if constexpr (HaveWeights) {
      term.factors[Dimension] = weight_factor<Dimension, count>(lifted);
      term.factors[Dimension + 1] = one_factor<Dimension, count>;
      term.is_negative = !is_negative;
      *next++ = term;
    }
  });
  return terms;
}

// ---- terms of products of vectors from the first of three points to the others ----

/// -(a - p) (b - p).
template <std::size_t Dimension>
consteval auto diametral_terms() {
  std::array<Term<2>, 4 * Dimension> terms{};
  auto next = terms.begin();
  for (std::size_t axis = 0; axis < Dimension; ++axis) {
    const auto p = coordinate_factor<Dimension>(0, axis), a = coordinate_factor<Dimension>(1, axis),
               b = coordinate_factor<Dimension>(2, axis);
    for (const Term<2>& term : {Term<2>{{a, b}, true}, {{a, p}, false}, {{b, p}, false}, {{p, p}, true}})
      *next++ = term;
  }
  return terms;
}

/// (a - p)^2 - (b - p)^2, less the weight of a and plus that of b, if there are weights.
template <std::size_t Dimension, bool HaveWeights>
consteval auto distance_terms() {
  std::array<Term<2>, 6 * Dimension + (HaveWeights ? 2 : 0)> terms{};
  auto next = terms.begin();
  for (std::size_t axis = 0; axis < Dimension; ++axis) {
    const auto p = coordinate_factor<Dimension>(0, axis), a = coordinate_factor<Dimension>(1, axis),
               b = coordinate_factor<Dimension>(2, axis);
    for (const Term<2>& term : {Term<2>{{a, a}, false},
                                {{a, p}, true},
                                {{a, p}, true},
                                {{b, b}, true},
                                {{b, p}, false},
                                {{b, p}, false}})
      *next++ = term;
  }
  if constexpr (HaveWeights)
    for (const std::size_t point : {1, 2})
      *next++ = {{weight_factor<Dimension, 3>(point), one_factor<Dimension, 3>}, point == 1};
  return terms;
}

// ---- determinants in fewer operations ----

template <class Number, std::size_t Dimension>
constexpr Number minor(const std::array<Number, Dimension>& p, const std::array<Number, Dimension>& q) {
  return sum(std::array{p[0] * q[1], -(p[1] * q[0])});
}

/// As orientation_terms.
template <class Number>
constexpr Number orientation(const Points<Number, 2, 3>& points) {
  const auto& [a, b, c] = points;
  return sum(
      std::array{a[0] * b[1], -(a[1] * b[0]), b[0] * c[1], -(b[1] * c[0]), c[0] * a[1], -(c[1] * a[0])});
}

template <class Number>
constexpr Number orientation(const Points<Number, 3, 4>& points) {
  const auto& [a, b, c, d] = points;
  const Number ab = minor(a, b), ac = minor(a, c), ad = minor(a, d), bc = minor(b, c), bd = minor(b, d),
               cd = minor(c, d);
  return sum(std::array{a[2] * sum(std::array{bd, -bc, -cd}), b[2] * sum(std::array{cd, ac, -ad}),
                        c[2] * sum(std::array{ad, -ab, -bd}), d[2] * sum(std::array{ab, bc, -ac})});
}

/// As lifted_terms.
template <class Number>
constexpr Number lifted_orientation(const Points<Number, 2, 4>& p, const std::array<Number, 4>& heights) {
  const auto& [a, b, c, d] = p;
  const Number ab = minor(a, b), ac = minor(a, c), ad = minor(a, d), bc = minor(b, c), bd = minor(b, d),
               cd = minor(c, d);
  const auto area = [](const Number& pq, const Number& qr, const Number& pr) {
    return sum(std::array{pq, qr, -pr});
  };
  return sum(std::array{heights[0] * area(bc, cd, bd), -(heights[1] * area(ac, cd, ad)),
                        heights[2] * area(ab, bd, ad), -(heights[3] * area(ab, bc, ac))});
}

template <class Number>
constexpr Number lifted_orientation(const Points<Number, 3, 5>& points,
                                    const std::array<Number, 5>& heights) {
  const auto& [a, b, c, d, e] = points;
  const Number ab = minor(a, b), ac = minor(a, c), ad = minor(a, d), ae = minor(a, e), bc = minor(b, c),
               bd = minor(b, d), be = minor(b, e), cd = minor(c, d), ce = minor(c, e), de = minor(d, e);
  // The triple product p q r, of the minors of two of them.
  const auto triple = [](const auto& p, const Number& qr, const auto& q, const Number& pr, const auto& r,
                         const Number& pq) {
    return sum(std::array{p[2] * qr, -(q[2] * pr), r[2] * pq});
  };
  const Number abc = triple(a, bc, b, ac, c, ab), abd = triple(a, bd, b, ad, d, ab),
               abe = triple(a, be, b, ae, e, ab), acd = triple(a, cd, c, ad, d, ac),
               ace = triple(a, ce, c, ae, e, ac), ade = triple(a, de, d, ae, e, ad),
               bcd = triple(b, cd, c, bd, d, bc), bce = triple(b, ce, c, be, e, bc),
               bde = triple(b, de, d, be, e, bd), cde = triple(c, de, d, ce, e, cd);
  const auto volume = [](const Number& pqr, const Number& pqs, const Number& prs, const Number& qrs) {
    return sum(std::array{pqr, -pqs, prs, -qrs});
  };
  return sum(std::array{heights[0] * volume(bcd, bce, bde, cde), -(heights[1] * volume(acd, ace, ade, cde)),
                        heights[2] * volume(abd, abe, ade, bde), -(heights[3] * volume(abc, abe, ace, bce)),
                        heights[4] * volume(abc, abd, acd, bcd)});
}

template <class Number>
constexpr Number square(const std::array<Number, 2>& p) {
  return sum(std::array{p[0] * p[0], p[1] * p[1]});
}
template <class Number>
constexpr Number square(const std::array<Number, 3>& p) {
  return sum(std::array{p[0] * p[0], p[1] * p[1], p[2] * p[2]});
}

template <class Number, std::size_t Dimension, std::size_t Count>
constexpr Number lifted_orientation(const Points<Number, Dimension, Count>& points) {
  std::array<Number, Count> heights;
  for (std::size_t i = 0; i < Count; ++i) heights[i] = square(points[i]);
  return lifted_orientation(points, heights);
}

template <class Number, std::size_t Dimension, std::size_t Count>
constexpr Number power_orientation(const Points<Number, Dimension, Count>& points,
                                   const std::array<Number, Count>& weights) {
  std::array<Number, Count> heights;
  for (std::size_t i = 0; i < Count; ++i) heights[i] = sum(std::array{square(points[i]), -weights[i]});
  return lifted_orientation(points, heights);
}

// ---- signs ----

/// Any numbers made by wide().
template <std::size_t Count>
constexpr std::array<WideBound, Count> any() {
  std::array<WideBound, Count> numbers{};
  numbers.fill(wide_bound);
  return numbers;
}
template <std::size_t Dimension, std::size_t Count>
constexpr Points<WideBound, Dimension, Count> any_points() {
  Points<WideBound, Dimension, Count> points{};
  points.fill(any<Dimension>());
  return points;
}

/// The sign of `value`, or else that of the sum of the terms, which is the same number.
template <class Terms, class Factors>
StagedSign sign_of(const WideDouble& value, double error, const Terms& terms, const Factors& factors) {
  if (const FilteredSign s = certain_sign(value, error); s.is_certain()) return {*s, Stage::wide_filter};
  return {sign_of_sum(terms, factors), Stage::wide_exact};
}

template <class Terms, std::size_t Factors>
StagedSign sign_of(const Terms& terms, const std::array<WideDouble, Factors>& factors, double error) {
  return sign_of(sum_of(terms, factors), error, terms, factors);
}

template <std::size_t Dimension>
StagedSign orientation_sign(const Points<WideDouble, Dimension, Dimension + 1>& points) {
  static constexpr auto terms = orientation_terms<Dimension>();
  constexpr double error = orientation(any_points<Dimension, Dimension + 1>()).error;
  return sign_of(orientation(points), error, terms, factors_of(points));
}

template <std::size_t Dimension>
StagedSign lifted_sign(const Points<WideDouble, Dimension, Dimension + 2>& points) {
  static constexpr auto terms = lifted_terms<Dimension, false>();
  constexpr double error = lifted_orientation(any_points<Dimension, Dimension + 2>()).error;
  return sign_of(lifted_orientation(points), error, terms, factors_of(points));
}

template <std::size_t Dimension>
StagedSign power_sign(const Points<WideDouble, Dimension, Dimension + 2>& points,
                      const std::array<WideDouble, Dimension + 2>& weights) {
  static constexpr auto terms = lifted_terms<Dimension, true>();
  constexpr double error =
      power_orientation(any_points<Dimension, Dimension + 2>(), any<Dimension + 2>()).error;
  return sign_of(power_orientation(points, weights), error, terms, factors_of(points, weights));
}

template <std::size_t Dimension>
Sign diametral_sign(const Points<WideDouble, Dimension, 3>& points) {
  static constexpr auto terms = diametral_terms<Dimension>();
  constexpr double error = sum_of(terms, any<3 * Dimension>()).error;
  return sign_of(terms, factors_of(points), error).sign;
}

template <std::size_t Dimension>
Sign distance_sign(const Points<WideDouble, Dimension, 3>& points) {
  static constexpr auto terms = distance_terms<Dimension, false>();
  constexpr double error = sum_of(terms, any<3 * Dimension>()).error;
  return sign_of(terms, factors_of(points), error).sign;
}

template <std::size_t Dimension>
Sign power_distance_sign(const Points<WideDouble, Dimension, 3>& points,
                         const std::array<WideDouble, 3>& weights) {
  static constexpr auto terms = distance_terms<Dimension, true>();
  constexpr double error = sum_of(terms, any<3 * (Dimension + 1) + 1>()).error;
  return sign_of(terms, factors_of(points, weights), error).sign;
}

std::array<WideDouble, 2> wide(const Point2& p) { return {kernel::wide(p.x), kernel::wide(p.y)}; }
std::array<WideDouble, 3> wide(const Point3& p) {
  return {kernel::wide(p.x), kernel::wide(p.y), kernel::wide(p.z)};
}

template <class... Point>
auto all_wide(const Point&... points) {
  return std::array{wide(points)...};
}
template <class... Weight>
auto all_weights(const Weight&... weights) {
  return std::array{kernel::wide(weights)...};
}

}  // namespace

StagedSign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return orientation_sign<2>(all_wide(a, b, c));
}
StagedSign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return lifted_sign<2>(all_wide(a, b, c, d));
}
StagedSign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return orientation_sign<3>(all_wide(a, b, c, d));
}
StagedSign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return lifted_sign<3>(all_wide(a, b, c, d, e));
}

Sign in_diametral_circle(const Point2& p, const Point2& a, const Point2& b) {
  return diametral_sign<2>(all_wide(p, a, b));
}
Sign in_diametral_sphere(const Point3& p, const Point3& a, const Point3& b) {
  return diametral_sign<3>(all_wide(p, a, b));
}
Sign compare_distance(const Point2& p, const Point2& a, const Point2& b) {
  return distance_sign<2>(all_wide(p, a, b));
}
Sign compare_distance(const Point3& p, const Point3& a, const Point3& b) {
  return distance_sign<3>(all_wide(p, a, b));
}

Sign power_test(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                const WeightedPoint2& d) {
  return power_sign<2>(all_wide(a.point, b.point, c.point, d.point),
                       all_weights(a.weight, b.weight, c.weight, d.weight))
      .sign;
}
Sign power_test(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                const WeightedPoint3& d, const WeightedPoint3& e) {
  return power_sign<3>(all_wide(a.point, b.point, c.point, d.point, e.point),
                       all_weights(a.weight, b.weight, c.weight, d.weight, e.weight))
      .sign;
}
Sign compare_power_distance(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b) {
  return power_distance_sign<2>(all_wide(p, a.point, b.point), all_weights(0.0, a.weight, b.weight));
}
Sign compare_power_distance(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b) {
  return power_distance_sign<3>(all_wide(p, a.point, b.point), all_weights(0.0, a.weight, b.weight));
}

}  // namespace leonhard::kernel::wide_range
