// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/visibility.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {
namespace {

/// Positions along the edge, 0 at a, 1 at b.
using Shadow = std::pair<mpq_class, mpq_class>;

mpq_class cross(const Point2& o, const Point2& u, const Point2& v) {
  const mpq_class x = o.x, y = o.y;
  return (u.x - x) * (v.y - y) - (u.y - y) * (v.x - x);
}

/// The triangle of all lines of sight from p, counter-clockwise p a b, and what walls in it hide.
class Sight {
 public:
  Sight(const Point2& p, const Point2& a, const Point2& b) : p_(p), a_(a), b_(b), area2_(cross(p, a, b)) {}

  [[nodiscard]] std::optional<Shadow> shadow(const Wall& wall) const {
    if (is_beyond(wall, p_, a_) || is_beyond(wall, a_, b_) || is_beyond(wall, b_, p_)) return std::nullopt;
    const Place from = place(wall[0]), to = place(wall[1]);
    const mpq_class total = area2_;
    mpq_class first = 0, last = 1;
    clip(from.along_a, to.along_a, first, last);
    clip(from.along_b, to.along_b, first, last);
    clip(total - from.along_a - from.along_b, total - to.along_a - to.along_b, first, last);
    if (first >= last) return std::nullopt;
    const auto one = position(from, to, first), other = position(from, to, last);
    if (!one || !other || *one == *other) return std::nullopt;
    return std::minmax(*one, *other);
  }

 private:
  /// p + (along_a (a - p) + along_b (b - p)) / area2.
  struct Place {
    mpq_class along_a, along_b;
  };
  [[nodiscard]] Place place(const Point2& x) const { return {cross(p_, x, b_), cross(p_, a_, x)}; }

  /// Has the wall nothing on the triangle's side of the line uv?
  static bool is_beyond(const Wall& wall, const Point2& u, const Point2& v) {
    return kernel::orient2d(u, v, wall[0]) != Sign::positive &&
           kernel::orient2d(u, v, wall[1]) != Sign::positive;
  }
  /// Keep that part of the wall where a linear function with these values at its ends is not negative.
  static void clip(const mpq_class& at_from, const mpq_class& at_to, mpq_class& first, mpq_class& last) {
    if (at_from < 0 && at_to < 0) last = -1;
    if (at_from < 0 && at_to >= 0) first = std::max<mpq_class>(first, at_from / (at_from - at_to));
    if (at_from >= 0 && at_to < 0) last = std::min<mpq_class>(last, at_from / (at_from - at_to));
  }
  /// Where the ray from p through a point of the wall meets the edge; none for p itself.
  static std::optional<mpq_class> position(const Place& from, const Place& to, const mpq_class& along) {
    const mpq_class a = from.along_a + along * (to.along_a - from.along_a),
                    b = from.along_b + along * (to.along_b - from.along_b);
    if (a + b == 0) return std::nullopt;
    return mpq_class(b / (a + b));
  }

  Point2 p_, a_, b_;
  mpq_class area2_;
};

bool leave_a_gap(std::vector<Shadow> shadows) {
  std::sort(shadows.begin(), shadows.end());
  mpq_class covered = 0;
  for (const auto& [begin, end] : shadows) {
    if (begin > covered) return true;
    covered = std::max(covered, end);
  }
  return covered < 1;
}

}  // namespace

bool sees_edge(const Point2& p, const Point2& a, const Point2& b, std::span<const Wall> walls) {
  const bool is_left = kernel::orient2d(a, b, p) == Sign::positive;
  const Sight sight(p, is_left ? a : b, is_left ? b : a);
  std::vector<Shadow> shadows;
  for (const Wall& wall : walls)
    if (auto shadow = sight.shadow(wall)) shadows.push_back(*std::move(shadow));
  return leave_a_gap(std::move(shadows));
}

}  // namespace leonhard::delaunay
