// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

namespace leonhard::app {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double usual_corner_deg = 40;
constexpr double nose_corner_deg = 120;

/// Solve the tridiagonal system below[i] x[i-1] + on[i] x[i] + above[i] x[i+1] = right[i] by elimination without pivots:
/// spline systems are diagonally dominant.
std::vector<double> solve_tridiagonal(const std::vector<double>& below, std::vector<double> on,
                                      const std::vector<double>& above, std::vector<double> right) {
  const std::size_t n = on.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = below[i] / on[i - 1];
    on[i] -= factor * above[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) right[i] = (right[i] - (i + 1 < n ? above[i] * right[i + 1] : 0)) / on[i];
  return right;
}

/// Second derivatives at the knots of the cubic spline through (t, y); de Boor, A Practical Guide to Splines (1978), chapter IV.
/// Open: constant second derivative in the first and last interval. Periodic: y.front() == y.back().
std::vector<double> second_derivatives(const std::vector<double>& t, const std::vector<double>& y,
                                       bool periodic) {
  const std::size_t n = t.size();
  std::vector<double> zero(n, 0.0);
  if (n < 3) return zero;
  const auto slope = [&](std::size_t i) { return (y[i + 1] - y[i]) / (t[i + 1] - t[i]); };
  const auto step = [&](std::size_t i) { return t[i + 1] - t[i]; };
  // The rows 1 .. n - 2 hold in both cases; the ends differ.
  std::vector<double> below(n), on(n, 1.0), above(n), right(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    below[i] = step(i - 1);
    on[i] = 2 * (step(i - 1) + step(i));
    above[i] = step(i);
    right[i] = 6 * (slope(i) - slope(i - 1));
  }
  if (!periodic) {
    above[0] = below[n - 1] = -1;
    return solve_tridiagonal(below, on, above, right);
  }
  // Sherman and Morrison: fix M[0] = M[n-1] = 0 for one solution and = 1 for the other, then satisfy the row at the seam.
  const std::vector<double> with_zero = solve_tridiagonal(below, on, above, right);
  std::vector<double> ones(n, 0.0);
  ones.front() = ones.back() = 1;
  const std::vector<double> with_one = solve_tridiagonal(below, on, above, ones);
  const auto seam = [&](const std::vector<double>& m) {
    return step(n - 2) * m[n - 2] + 2 * (step(n - 2) + step(0)) * m[0] + step(0) * m[1];
  };
  const double scale = (6 * (slope(0) - slope(n - 2)) - seam(with_zero)) / seam(with_one);
  for (std::size_t i = 0; i < n; ++i) zero[i] = with_zero[i] + scale * with_one[i];
  return zero;
}

/// A cubic spline through points, by chord length.
class Spline {
 public:
  Spline(std::vector<Point2> points, bool periodic) : points_(std::move(points)) {
    t_.push_back(0);
    for (std::size_t i = 1; i < points_.size(); ++i)
      t_.push_back(t_.back() + distance(points_[i - 1], points_[i]));
    std::vector<double> x, y;
    for (const Point2 p : points_) x.push_back(p.x), y.push_back(p.y);
    mx_ = second_derivatives(t_, x, periodic);
    my_ = second_derivatives(t_, y, periodic);
  }

  [[nodiscard]] const std::vector<double>& knots() const { return t_; }

  [[nodiscard]] Point2 at(double t) const {
    const auto next = std::upper_bound(t_.begin() + 1, t_.end() - 1, t);
    const std::size_t i = static_cast<std::size_t>(next - t_.begin()) - 1;
    if (t <= t_[i]) return points_[i];  // knots are met to the last bit
    if (t >= t_[i + 1]) return points_[i + 1];
    const double h = t_[i + 1] - t_[i], a = (t_[i + 1] - t) / h, b = 1 - a;
    const double ca = (a * a * a - a) * h * h / 6, cb = (b * b * b - b) * h * h / 6;
    return {a * points_[i].x + b * points_[i + 1].x + ca * mx_[i] + cb * mx_[i + 1],
            a * points_[i].y + b * points_[i + 1].y + ca * my_[i] + cb * my_[i + 1]};
  }

 private:
  std::vector<Point2> points_;
  std::vector<double> t_, mx_, my_;
};

CurvePiece spline_piece(std::vector<Point2> points, bool periodic) {
  const auto spline = std::make_shared<const Spline>(std::move(points), periodic);
  return {[spline](double t) { return spline->at(t); }, spline->knots()};
}

/// The angle by which the closed polygon turns at point i, in [0, 180] degrees.
double turn_deg(const std::vector<Point2>& points, std::size_t i) {
  const std::size_t n = points.size();
  const Vec2 in = points[i] - points[(i + n - 1) % n], out = points[(i + 1) % n] - points[i];
  return std::abs(std::atan2(cross(in, out), dot(in, out))) / degree;
}

std::size_t farthest_from(const std::vector<Point2>& points, Point2 from) {
  const auto nearer = [from](Point2 a, Point2 b) { return distance(a, from) < distance(b, from); };
  return static_cast<std::size_t>(std::ranges::max_element(points, nearer) - points.begin());
}

}  // namespace

OutlineCurve spline_outline(const std::vector<Point2>& points, bool blunt_trailing_edge,
                            std::optional<double> corner_angle_deg) {
  assert(points.size() >= 4);
  const std::size_t n = points.size();
  OutlineCurve curve;
  curve.trailing_edge = points.front();
  if (blunt_trailing_edge) curve.trailing_edge = points.front() + 0.5 * (points.back() - points.front());
  const std::size_t nose = farthest_from(points, curve.trailing_edge);
  curve.leading_edge = points[nose];

  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const bool base_end = blunt_trailing_edge && (i == 0 || i == n - 1);
    const double limit = corner_angle_deg.value_or(i == nose ? nose_corner_deg : usual_corner_deg);
    if (base_end || turn_deg(points, i) > limit) corners.push_back(i);
  }
  curve.smooth_start = corners.empty();
  if (corners.empty()) corners.push_back(0);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t begin = corners[c], end = c + 1 < corners.size() ? corners[c + 1] : corners[0] + n;
    std::vector<Point2> stretch;
    for (std::size_t i = begin; i <= end; ++i) stretch.push_back(points[i % n]);
    curve.pieces.push_back(spline_piece(std::move(stretch), curve.smooth_start));
  }
  return curve;
}

double chord_length(const OutlineCurve& curve) { return distance(curve.leading_edge, curve.trailing_edge); }

Point2 Placement::operator()(Point2 p) const {
  if (rotation_deg == 0) return {scale * p.x + translation.x, scale * p.y + translation.y};
  const double c = std::cos(rotation_deg * degree), s = std::sin(rotation_deg * degree);
  return {scale * (c * p.x - s * p.y) + translation.x, scale * (s * p.x + c * p.y) + translation.y};
}

OutlineCurve place(const OutlineCurve& curve, const Placement& placement) {
  OutlineCurve placed = curve;
  for (CurvePiece& piece : placed.pieces)
    piece.at = [at = std::move(piece.at), placement](double t) { return placement(at(t)); };
  placed.leading_edge = placement(curve.leading_edge);
  placed.trailing_edge = placement(curve.trailing_edge);
  return placed;
}

}  // namespace leonhard::app
