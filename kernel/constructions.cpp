// SPDX-License-Identifier: MIT
#include "leonhard/kernel/constructions.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include "leonhard/kernel/double_double.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/finite.hpp"

namespace leonhard::kernel {
namespace {

constexpr double u = 0x1p-53;

// ---- numbers ----

/// A polynomial of differences of coordinates in double-double, and the same polynomial with all terms
/// positive.
///
/// |value - exact| <= k u^2 size and terms in u^3, where k is 0 for a difference, j + k + 7 for a product of
/// numbers with j and k, max(j, k) + 3 for a sum. The largest k below is that of the circle in space: squares
/// 10, |V|^2 W - |W|^2 V 20, V x W 10, the numerator 40. 48 leaves a sixth for the terms in u^3 and the
/// roundings of size.
struct Bounded {
  DoubleDouble value;
  double size;

  [[nodiscard]] double error() const { return 48 * u * u * size; }
  [[nodiscard]] FilteredSign sign() const { return sign_if_beyond(value.high, error()); }
};

Bounded operator+(const Bounded& a, const Bounded& b) { return {a.value + b.value, a.size + b.size}; }
Bounded operator-(const Bounded& a, const Bounded& b) { return {a.value - b.value, a.size + b.size}; }
Bounded operator*(const Bounded& a, const Bounded& b) { return {a.value * b.value, a.size * b.size}; }

FilteredSign sign(const Bounded& x) { return x.sign(); }
FilteredSign sign(const mpq_class& x) { return FilteredSign(sign_of(sgn(x))); }

template <class Number>
Number difference(double a, double b);
template <>
Bounded difference<Bounded>(double a, double b) {
  const TwoTerms d = two_difference(a, b);
  return {{d}, std::abs(d.high)};
}
template <>
mpq_class difference<mpq_class>(double a, double b) {
  return mpq_class(a) - mpq_class(b);
}

// ---- vectors ----

template <class Number, std::size_t Dim>
using Vector = std::array<Number, Dim>;

std::array<double, 2> coordinates(const Point2& p) { return {p.x, p.y}; }
std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }
Point2 point(const std::array<double, 2>& x) { return {x[0], x[1]}; }
Point3 point(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }

template <class Point>
constexpr std::size_t dimension = std::tuple_size_v<decltype(coordinates(Point{}))>;

template <class Number, class Point>
Vector<Number, dimension<Point>> vector(const Point& from, const Point& to) {
  const auto x = coordinates(from), y = coordinates(to);
  Vector<Number, dimension<Point>> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = difference<Number>(y[i], x[i]);
  return v;
}

template <class Number, std::size_t Dim>
Number dot(const Vector<Number, Dim>& v, const Vector<Number, Dim>& w) {
  Number sum = v[0] * w[0];
  for (std::size_t i = 1; i < Dim; ++i) sum = sum + v[i] * w[i];
  return sum;
}

template <class Number>
Number cross(const Vector<Number, 2>& v, const Vector<Number, 2>& w) {
  return v[0] * w[1] - v[1] * w[0];
}
template <class Number>
Vector<Number, 3> cross(const Vector<Number, 3>& v, const Vector<Number, 3>& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

// ---- centres as fractions ----

/// The centre is an origin + numerator / (2 denominator).
template <class Number, std::size_t Dim>
struct Offset {
  Vector<Number, Dim> numerator;
  Number denominator;
};

template <class Number>
Offset<Number, 2> circumcentre(const Vector<Number, 2>& v, const Vector<Number, 2>& w) {
  const Number vv = dot(v, v), ww = dot(w, w);
  return {{vv * w[1] - ww * v[1], ww * v[0] - vv * w[0]}, cross(v, w)};
}

template <class Number>
Offset<Number, 3> circumcentre(const Vector<Number, 3>& v, const Vector<Number, 3>& w) {
  const Number vv = dot(v, v), ww = dot(w, w);
  const Vector<Number, 3> in_plane{vv * w[0] - ww * v[0], vv * w[1] - ww * v[1], vv * w[2] - ww * v[2]};
  const Vector<Number, 3> normal = cross(v, w);
  return {cross(in_plane, normal), dot(normal, normal)};
}

template <class Number>
Offset<Number, 3> circumcentre(const Vector<Number, 3>& v, const Vector<Number, 3>& w,
                               const Vector<Number, 3>& t) {
  const Number vv = dot(v, v), ww = dot(w, w), tt = dot(t, t);
  const Vector<Number, 3> wt = cross(w, t), tv = cross(t, v), vw = cross(v, w);
  Vector<Number, 3> numerator;
  for (std::size_t i = 0; i < 3; ++i) numerator[i] = vv * wt[i] + ww * tv[i] + tt * vw[i];
  return {numerator, dot(v, wt)};
}

/// The point `reach` |v| from the middle of v, on its left if turn is positive, else on its right.
template <class Number>
Offset<Number, 2> above_middle(const Vector<Number, 2>& v, double reach, Sign turn) {
  const Number factor = difference<Number>(turn == Sign::positive ? 2 * reach : -2 * reach, 0);
  return {{v[0] - factor * v[1], v[1] + factor * v[0]}, difference<Number>(1, 0)};
}

// ---- rounding ----

/// What double-double may be given: no bit of a product of five differences, and no bound, underflows or
/// overflows. The last bits of differences are at -172 or higher, the numerators' at -860, their bounds' at
/// -960.
bool is_moderate(double x) {
  const double size = std::abs(x);
  return size == 0 || (size >= 0x1p-120 && size <= 0x1p120);
}

template <class... Point>
bool are_moderate(const Point&... points) {
  const auto moderate = [](const auto& p) { return std::ranges::all_of(coordinates(p), is_moderate); };
  return (moderate(points) && ...);
}

/// The ball about origin + N / 2D through the origin, if its errors are as small as the header promises.
///
/// Let n and d be the high parts, q = n / 2d rounded. N and D are off by at most u |n| + E_N and u |d| + E_D,
/// E being Bounded's error, so with delta = u + E_D / |d| the quotient is off by
///   (u |q| + E_N / 2|d| + |q| delta) / (1 - delta) + u |q|
///     <= (3u |q| + E_N / 2|d| + |q| E_D / |d|) / (1 - delta).
/// 1 + 2^-8 is for delta <= 2^-10 and for what the bounds and q lose in rounding and underflow: R, if not
/// zero, is at least half the smallest difference, 2^-173. The square root of a sum of squares has at most
/// 2.5 roundings; squares that underflow do not count beside R. Adding the origin rounds once more.
template <class Point>
std::optional<RoundedBall<Point>> rounded(const Point& origin, const Offset<Bounded, dimension<Point>>& offset) {
  const double d = offset.denominator.value.high, d_error = offset.denominator.error() / std::abs(d);
  auto x = coordinates(origin);
  double square = 0, error = 0, size = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Bounded& n = offset.numerator[i];
    const double q = n.value.high / (2 * d);
    error += 3 * u * std::abs(q) + n.error() / (2 * std::abs(d)) + std::abs(q) * d_error;
    square += q * q;
    x[i] += q;
    size += std::abs(x[i]);
  }
  const double radius = std::sqrt(square), slack = 1 + 0x1p-8;
  // A reach out of range makes this infinite, NaN, or loses less than the slack.
  const bool good = d_error <= 0x1p-11 && slack * error <= 0x1p-50 * radius && std::isfinite(square);
  if (!good) return {};
  return RoundedBall<Point>{point(x), radius, slack * (error + u * size), slack * (error + 3 * u * radius)};
}

double least_double_above(const mpq_class& x) {
  return std::nextafter(x.get_d(), std::numeric_limits<double>::infinity());  // get_d rounds towards zero
}

constexpr double largest_double = std::numeric_limits<double>::max();

/// The same from exact numbers, D not zero, by rounding towards zero; nothing if it exceeds the largest
/// double.
template <class Point>
std::optional<RoundedBall<Point>> rounded(const Point& origin, const Offset<mpq_class, dimension<Point>>& offset) {
  const mpq_class half_inverse = 1 / (2 * offset.denominator);
  auto x = coordinates(origin);
  mpq_class square = 0, error = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const mpq_class q = offset.numerator[i] * half_inverse, exact = mpq_class(x[i]) + q;
    if (abs(exact) > largest_double) return {};
    x[i] = exact.get_d();
    error += abs(exact - mpq_class(x[i]));
    square += q * q;
  }
  const mpf_class radius = sqrt(mpf_class(square, 128));
  if (radius > largest_double) return {};
  const double r =
      radius.get_d();  // the root is right to 2^-100, and get_d rounds towards zero: 2u and less than u
  return RoundedBall<Point>{point(x), r, least_double_above(error), 3 * u * r + 0x1p-1073};
}

// ---- errors ----

std::string text(double x) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.17g", x);
  return digits.data();
}

template <class Point>
std::string text(const Point& p) {
  std::string list;
  for (const double x : coordinates(p)) list.append(list.empty() ? "(" : ", ").append(text(x));
  return list.append(")");
}

template <class... Point>
std::string list_of(const Point&... points) {
  std::string list;
  (list.append(list.empty() ? "" : ", ").append(text(points)), ...);
  return list;
}

/// The ball through a of the Offset that `formula` makes of the vectors from a to the other points.
template <class Formula, class Point, class... Points>
RoundedBall<Point> construct(const char* what, const Formula& formula, const Point& a, const Points&... others) {
  if (are_moderate(a, others...))
    if (const auto ball = rounded(a, formula(vector<Bounded>(a, others)...))) return *ball;
  detail::require_finite(what, a, others...);
  const auto offset = formula(vector<mpq_class>(a, others)...);
  if (offset.denominator == 0)
    throw InputError(
        what, list_of(a, others...).append(" are ").append(sizeof...(others) == 3 ? "coplanar" : "collinear"),
        "give points that are not");
  const auto ball = rounded(a, offset);
  if (!ball)
    throw InputError(
        what,
        std::string("the circle of ").append(list_of(a, others...)).append(" exceeds the largest double"),
        "scale the coordinates down");
  return *ball;
}

// ---- shortest edge ----

/// A triangle's shortest edge and its apex.
struct Base {
  Point2 from, to, apex;
};

Base shortest_edge(const Point2& a, const Point2& b, const Point2& c) {
  const bool ab_before_bc = compare_distance(b, a, c) != Sign::positive;
  const bool ab_before_ca = compare_distance(a, b, c) != Sign::positive;
  if (ab_before_bc && ab_before_ca) return {a, b, c};
  const bool bc_before_ca = compare_distance(c, b, a) != Sign::positive;
  return bc_before_ca ? Base{b, c, a} : Base{c, a, b};
}

/// Is the circumcentre farther from the base than reach times its length? It lies (W . (W - V)) / (2 V x W)
/// lengths to the left of V.
template <class Number>
FilteredSign is_beyond(const Base& base, double reach, Sign turn) {
  const auto v = vector<Number>(base.from, base.to), w = vector<Number>(base.from, base.apex);
  const auto from_to = vector<Number>(base.to, base.apex);
  const Number factor = difference<Number>(turn == Sign::positive ? 2 * reach : -2 * reach, 0);
  const Number excess = dot(w, from_to) - factor * cross(v, w);
  return sign(excess);
}

bool circumcentre_is_beyond(const Base& base, double reach, Sign turn) {
  if (std::isinf(2 * reach)) return false;
  if (are_moderate(base.from, base.to, base.apex) && is_moderate(reach))
    if (const FilteredSign s = is_beyond<Bounded>(base, reach, turn); s.is_certain())
      return *s == Sign::positive;
  return *is_beyond<mpq_class>(base, reach, turn) == Sign::positive;
}

}  // namespace

Circle circumcircle(const Point2& a, const Point2& b, const Point2& c) {
  return construct(
      "circumcircle", [](const auto& v, const auto& w) { return circumcentre(v, w); }, a, b, c);
}

Sphere circumcircle(const Point3& a, const Point3& b, const Point3& c) {
  return construct(
      "circumcircle", [](const auto& v, const auto& w) { return circumcentre(v, w); }, a, b, c);
}

Sphere circumsphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto centre = [](const auto& v, const auto& w, const auto& t) { return circumcentre(v, w, t); };
  return construct("circumsphere", centre, a, b, c, d);
}

Circle diametral_circle(const Point2& a, const Point2& b) {
  const auto middle = []<class Number>(const Vector<Number, 2>& v) {
    return above_middle(v, 0, Sign::positive);
  };
  return construct("diametral_circle", middle, a, b);
}

Circle containment_circle(const Point2& a, const Point2& b, const Point2& c) {
  if (in_diametral_circle(a, b, c) != Sign::negative) return diametral_circle(b, c);
  if (in_diametral_circle(b, c, a) != Sign::negative) return diametral_circle(c, a);
  if (in_diametral_circle(c, a, b) != Sign::negative) return diametral_circle(a, b);
  return circumcircle(a, b, c);
}

double off_centre_reach(double radius_edge_ratio) {
  if (!(radius_edge_ratio >= 0.5))
    throw InputError("radius_edge_ratio", text(radius_edge_ratio).append(" is less than 1/2"),
                     "give a ratio that triangles can have");
  const double above = radius_edge_ratio - 0.5, below = radius_edge_ratio + 0.5;
  return radius_edge_ratio + std::sqrt(above) * std::sqrt(below);
}

Circle off_centre(const Point2& a, const Point2& b, const Point2& c, double reach) {
  if (!(reach > 0))
    throw InputError("reach", text(reach).append(" is not positive"), "give a positive height");
  const Base base = shortest_edge(a, b, c);
  const Sign turn = orient2d(base.from, base.to, base.apex);
  if (turn == Sign::zero || !circumcentre_is_beyond(base, reach, turn))
    return circumcircle(base.from, base.to, base.apex);
  const auto above = [reach, turn]<class Number>(const Vector<Number, 2>& v) {
    return above_middle(v, reach, turn);
  };
  return construct("off_centre", above, base.from, base.to);
}

}  // namespace leonhard::kernel
