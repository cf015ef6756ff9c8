// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/spacing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace leonhard::app {
namespace {

constexpr std::size_t samples_a_piece = 4096;
constexpr std::size_t samples_a_knot = 8;

/// The outline sampled finely, once around: sample i of piece p belongs to parameter t[i]. Where two pieces meet, both have a
/// sample of their own.
struct Samples {
  std::vector<double> t, arc;  ///< parameter in its piece; arc length from the start
  std::vector<Point2> at;
  std::vector<double> direction_rad;     ///< of the curve, unwrapped within each piece
  std::vector<std::size_t> piece_begin;  ///< first sample of each piece, and the total count
};

void sample_piece(const CurvePiece& piece, Samples& samples) {
  const std::size_t intervals = piece.knots.size() - 1;
  const std::size_t parts = std::max(samples_a_knot, samples_a_piece / intervals + 1);
  const std::size_t begin = samples.t.size();
  const double start = samples.arc.empty() ? 0 : samples.arc.back();
  for (std::size_t k = 0; k <= intervals * parts; ++k) {
    const std::size_t i = std::min(k / parts, intervals - 1);
    const double fraction = static_cast<double>(k - i * parts) / static_cast<double>(parts);
    const double t = k == intervals * parts
                         ? piece.knots.back()
                         : piece.knots[i] + fraction * (piece.knots[i + 1] - piece.knots[i]);
    const Point2 p = piece.at(t);
    samples.arc.push_back(k == 0 ? start : samples.arc.back() + distance(samples.at.back(), p));
    samples.t.push_back(t);
    samples.at.push_back(p);
  }
  const auto direction = [&](std::size_t i) {
    const std::size_t before = i == begin ? i : i - 1, after = i + 1 == samples.at.size() ? i : i + 1;
    const Vec2 d = samples.at[after] - samples.at[before];
    return std::atan2(d.y, d.x);
  };
  for (std::size_t i = begin; i < samples.at.size(); ++i) {
    const double angle = direction(i);
    const double near = i == begin ? angle : samples.direction_rad.back();
    samples.direction_rad.push_back(near + std::remainder(angle - near, 2 * std::numbers::pi));
  }
}

Samples sample(const OutlineCurve& curve) {
  Samples samples;
  for (const CurvePiece& piece : curve.pieces) {
    samples.piece_begin.push_back(samples.t.size());
    sample_piece(piece, samples);
  }
  samples.piece_begin.push_back(samples.t.size());
  return samples;
}

/// The direction at an arc length within one piece [begin, end), linear between samples.
double direction_at(const Samples& samples, std::size_t begin, std::size_t end, double arc) {
  const auto first = samples.arc.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = samples.arc.begin() + static_cast<std::ptrdiff_t>(end);
  const auto above = std::upper_bound(first, last, arc);
  if (above == first) return samples.direction_rad[begin];
  if (above == last) return samples.direction_rad[end - 1];
  const std::size_t i = static_cast<std::size_t>(above - samples.arc.begin());
  const double fraction = (arc - samples.arc[i - 1]) / (samples.arc[i] - samples.arc[i - 1]);
  return std::lerp(samples.direction_rad[i - 1], samples.direction_rad[i], fraction);
}

/// The longest edge, from `longest` down to `shortest`, over which the curve turns by no more than asked. Looking at the
/// turn over a whole edge, not at the curvature, keeps the noise of rounded coordinates out.
double edge_by_turn(const Samples& samples, std::size_t begin, std::size_t end, double arc, double turn_rad,
                    double longest, double shortest) {
  double edge = longest;
  while (edge > shortest) {
    const double turn =
        direction_at(samples, begin, end, arc + edge / 2) - direction_at(samples, begin, end, arc - edge / 2);
    if (std::abs(turn) <= turn_rad) return edge;
    edge *= 0.9;
  }
  return shortest;
}

std::size_t nearest_sample(const Samples& samples, Point2 p) {
  const auto nearer = [p](Point2 a, Point2 b) { return distance(a, p) < distance(b, p); };
  return static_cast<std::size_t>(std::ranges::min_element(samples.at, nearer) - samples.at.begin());
}

/// Bound how fast edge lengths change along the closed curve.
void grade(const Samples& samples, double growth, std::vector<double>& edge) {
  const std::size_t n = edge.size();
  for (int round = 0; round < 2; ++round) {
    edge[0] = edge[n - 1] = std::min(edge[0], edge[n - 1]);
    for (std::size_t i = 1; i < n; ++i)
      edge[i] = std::min(edge[i], edge[i - 1] + growth * (samples.arc[i] - samples.arc[i - 1]));
    edge[0] = edge[n - 1] = std::min(edge[0], edge[n - 1]);
    for (std::size_t i = n - 1; i-- > 0;)
      edge[i] = std::min(edge[i], edge[i + 1] + growth * (samples.arc[i + 1] - samples.arc[i]));
  }
}

/// The edge length wanted at each sample.
std::vector<double> wanted_edges(const Samples& samples, const OutlineSpacing& spacing, std::size_t nose) {
  const double shortest = 0.1 * std::min({spacing.elsewhere, spacing.leading_edge, spacing.trailing_edge});
  const double turn_rad = spacing.turn_deg * std::numbers::pi / 180;
  std::vector<double> edge(samples.t.size());
  for (std::size_t piece = 0; piece + 1 < samples.piece_begin.size(); ++piece) {
    const std::size_t begin = samples.piece_begin[piece], end = samples.piece_begin[piece + 1];
    for (std::size_t i = begin; i < end; ++i)
      edge[i] = edge_by_turn(samples, begin, end, samples.arc[i], turn_rad, spacing.elsewhere, shortest);
    const double length = samples.arc[end - 1] - samples.arc[begin];
    for (const std::size_t corner : {begin, end - 1})
      edge[corner] = std::min({edge[corner], spacing.trailing_edge, length});
  }
  edge[nose] = std::min(edge[nose], spacing.leading_edge);
  grade(samples, spacing.growth, edge);
  return edge;
}

/// Points from sample `begin` (included) to sample `end` (excluded) of one piece, equally many edge lengths apart.
void place_points(const CurvePiece& piece, const Samples& samples, const std::vector<double>& edge,
                  std::size_t begin, std::size_t end, std::vector<Point2>& points) {
  std::vector<double> edges_before{0};  // how many edges fit between `begin` and each sample
  for (std::size_t i = begin; i < end; ++i)
    edges_before.push_back(edges_before.back() +
                           (samples.arc[i + 1] - samples.arc[i]) * 0.5 * (1 / edge[i] + 1 / edge[i + 1]));
  // A hair less than a whole number is that number, so that rounding does not tell the two sides of a symmetric section apart.
  const double count = std::max(1.0, std::ceil(edges_before.back() - 1e-6));
  points.push_back(samples.at[begin]);
  std::size_t i = 1;
  for (double k = 1; k < count; ++k) {
    const double here = edges_before.back() * k / count;
    while (edges_before[i] < here) ++i;
    const double fraction = (here - edges_before[i - 1]) / (edges_before[i] - edges_before[i - 1]);
    points.push_back(piece.at(std::lerp(samples.t[begin + i - 1], samples.t[begin + i], fraction)));
  }
}

}  // namespace

std::vector<Point2> distribute(const OutlineCurve& curve, const OutlineSpacing& spacing) {
  const Samples samples = sample(curve);
  const std::size_t nose = nearest_sample(samples, curve.leading_edge);
  const std::vector<double> edge = wanted_edges(samples, spacing, nose);
  std::vector<Point2> points;
  for (std::size_t piece = 0; piece < curve.pieces.size(); ++piece) {
    const std::size_t begin = samples.piece_begin[piece], last = samples.piece_begin[piece + 1] - 1;
    const bool has_nose = begin < nose && nose < last;
    place_points(curve.pieces[piece], samples, edge, begin, has_nose ? nose : last, points);
    if (has_nose) place_points(curve.pieces[piece], samples, edge, nose, last, points);
  }
  return points;
}

}  // namespace leonhard::app
