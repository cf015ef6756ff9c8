// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/point_ref.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact_evaluation.hpp"

namespace leonhard::kernel {
namespace {

// ---- words ----

std::string words(double x) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

template <class Point>
std::string words(std::span<const Point> points) {
  std::string list;
  for (Point p : points) {
    list += list.empty() ? "(" : ", (";
    const auto of_p = coordinates(p);
    for (std::size_t i = 0; i < of_p.size(); ++i) list += (i == 0 ? "" : ", ") + words(*of_p[i]);
    list += ")";
  }
  return list;
}

// ---- coordinates in balls ----

/// Numbers as exact_numbers.hpp describes them, but balls.
struct Balls {
  using Number = NumberBall<DoubleDouble>;
  [[nodiscard]] Number difference(double a, double b) const { return {{two_difference(a, b)}, 0}; }
  [[nodiscard]] Number one() const { return {{{1, 0}}, 0}; }
};

template <class Point>
struct Located {
  Coordinates<Point> coordinates;
  bool exists;  ///< certainly
};

template <class Point>
Located<Point> nowhere() {
  Located<Point> located{{}, false};
  for (auto& x : located.coordinates) x.radius = std::numeric_limits<double>::infinity();
  return located;
}

/// For coordinates whose polynomials of degree 7 do not overflow, and hardly underflow.
template <class Point>
Located<Point> locate_unscaled(std::span<const Point> defining) {
  const auto p = homogeneous(Balls{}, defining);
  Located<Point> located{{}, certain_sign(p.weight).is_certain()};
  for (std::size_t i = 0; i < located.coordinates.size(); ++i) {
    const NumberBall<DoubleDouble> base{{{coordinate(p.base, i), 0}}, 0};
    located.coordinates[i] = base + p.offset[i] / p.weight;
    located.coordinates[i].radius = inflated(located.coordinates[i].radius);
  }
  return located;
}

/// x 2^exponent; the ball grows by what underflows, and beyond the range of doubles it is the whole line.
NumberBall<DoubleDouble> scaled(const NumberBall<DoubleDouble>& x, int exponent) {
  if (detail::is_exactly_zero(x)) return x;
  const DoubleDouble value{{std::scalbn(x.value.high, exponent), std::scalbn(x.value.low, exponent)}};
  if (!std::isfinite(value.high)) return {{}, std::numeric_limits<double>::infinity()};
  return {value, std::scalbn(x.radius, exponent) + detail::underflow_guard};
}

template <class Point, std::size_t Count>
Located<Point> locate(std::array<Point, Count> points) {
  double largest = 0;
  for (Point& p : points)
    for (const double* x : coordinates(p)) largest = std::max(largest, std::abs(*x));
  const int exponent = largest == 0 ? 0 : std::ilogb(largest);
  if (std::abs(exponent) <= 100) return locate_unscaled(std::span<const Point>(points));

  for (Point& p : points)
    for (double* x : coordinates(p)) {
      const double unscaled = *x;
      *x = std::scalbn(unscaled, -exponent);
      if (std::scalbn(*x, exponent) != unscaled) return nowhere<Point>();  // bits were lost below 2^-1074
    }
  Located<Point> located = locate_unscaled(std::span<const Point>(points));
  for (auto& x : located.coordinates) x = scaled(x, exponent);
  return located;
}

// ---- existence ----

template <class Point, std::size_t Count>
bool exists(std::array<Point, Count> points) {
  return evaluate_exactly(std::span<Point>(points), weight_degree(Count), Stage::expansion,
                          [&points](const auto& numbers) {
                            return sign_of(homogeneous(numbers, std::span<const Point>(points)).weight);
                          })
             .sign != Sign::zero;
}

}  // namespace

template <class Point, std::size_t Count>
ImplicitPoint<Point, Count>::ImplicitPoint(const std::array<Point, Count>& defining_points,
                                           const Refusal& refusal)
    : points_(defining_points) {
  const auto refuse = [&](const char* problem, const char* remedy) {
    throw InputError(refusal.where, problem + (": " + words(std::span<const Point>(points_))), remedy);
  };
  if (!std::ranges::all_of(points_, [](const Point& p) { return is_finite(p); }))
    refuse("a defining point is not finite", "give finite coordinates");
  const Located<Point> located = locate(points_);
  if (!located.exists && !exists(points_)) refuse(refusal.problem, refusal.remedy);
  coordinates_ = located.coordinates;
}

template class ImplicitPoint<Point2, 4>;
template class ImplicitPoint<Point3, 5>;
template class ImplicitPoint<Point3, 9>;

}  // namespace leonhard::kernel
