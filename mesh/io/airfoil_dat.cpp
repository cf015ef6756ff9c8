// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/airfoil_dat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/soup/simple_polygon.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

constexpr double widest_gap = 0.05;                  ///< of a blunt trailing edge, in chords
constexpr double corner_rad = std::numbers::pi / 4;  ///< a trailing edge's corner turns by more than this
constexpr std::size_t fewest_points = 5;

struct LocatedPoint {
  Point2 at;
  std::size_t line;
};

/// The curve as the file gives it, in file order.
struct RawCurve {
  std::string source;
  std::string name;
  std::vector<LocatedPoint> points;
  bool closed = false;  ///< the last point was a repetition of the first, and is gone

  [[nodiscard]] std::string words(std::size_t i) const {
    return mesh::words(points[i].at) + " (line " + std::to_string(points[i].line) + ")";
  }
  [[noreturn]] void fail(std::size_t i, std::string problem, std::string remedy) const {
    throw InputError(at_line(source, points[i].line), std::move(problem), std::move(remedy));
  }
};

/// Whether the first line is data: two words of which the first is a number with a decimal point, or both are
/// numbers
/// ("0.98 O.01" is a mistyped point, "0012 section" a name).
bool looks_like_point(TextScanner scan) {
  const std::string_view first = scan.word("a name or x and y");
  if (scan.line_done()) return false;
  const std::string_view second = scan.word("a name or x and y");
  if (!scan.line_done()) return false;
  double unused = 0;
  const bool first_is_number = parse_number(first, unused) != NumberFault::not_a_number;
  const bool second_is_number = parse_number(second, unused) != NumberFault::not_a_number;
  return first_is_number && (second_is_number || first.find('.') != std::string_view::npos);
}

RawCurve read_points(std::string_view text, const std::string& source) {
  TextScanner scan(text, source, {.comment = '#', .extra_blank = ','});
  RawCurve curve;
  curve.source = source;
  scan.need_line("the name of the airfoil or its first point");
  bool on_data = looks_like_point(scan);
  if (!on_data) curve.name = scan.rest();
  while (on_data || scan.next_line()) {
    on_data = false;
    const double x = scan.number("the x coordinate of a point");
    const double y = scan.number("the y coordinate of a point");
    scan.expect_line_end("x and y");
    curve.points.push_back({{x, y}, scan.line()});
  }
  if (curve.points.empty()) scan.fail("the file holds no points", "give one point, x and y, a line");
  return curve;
}

std::size_t farthest_from(Point2 p, const std::vector<LocatedPoint>& points) {
  const auto farther = [&](const LocatedPoint& a, const LocatedPoint& b) {
    return distance(a.at, p) < distance(b.at, p);
  };
  return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), farther) - points.begin());
}

/// Whether the first line holds Lednicer's counts: two whole numbers, and the last point does not come back
/// to them as it does to the first point of a curve in Selig's order.
bool begins_with_counts(const RawCurve& curve) {
  const Point2 first = curve.points.front().at;
  const auto is_count = [](double value) { return value > 1.5 && value < 1e9 && value == std::floor(value); };
  if (!is_count(first.x) || !is_count(first.y)) return false;
  const double extent = distance(first, curve.points[farthest_from(first, curve.points)].at);
  return distance(first, curve.points.back().at) > widest_gap * extent;
}

/// Lednicer's format begins with the numbers of points of the upper and lower side, both of which run from
/// the leading to the trailing edge. Turns it into Selig's order; leaves a curve in Selig's order alone.
void undo_lednicer_order(RawCurve& curve) {
  if (!begins_with_counts(curve)) return;
  const Point2 counts = curve.points.front().at;
  const std::size_t found = curve.points.size() - 1;
  const auto upper = static_cast<std::size_t>(counts.x), lower = static_cast<std::size_t>(counts.y);
  if (upper + lower != found)
    curve.fail(0,
               "declares " + std::to_string(upper) + " upper and " + std::to_string(lower) +
                   " lower points (Lednicer's format), but " + std::to_string(found) + " points follow",
               "the file was cut short, or correct the two counts");
  const auto first = curve.points.begin() + 1, middle = first + static_cast<std::ptrdiff_t>(upper);
  const bool leading_edge_twice = first->at == middle->at;
  std::vector<LocatedPoint> loop(first, middle);
  std::reverse(loop.begin(), loop.end());
  loop.insert(loop.end(), middle + (leading_edge_twice ? 1 : 0), curve.points.end());
  curve.points = std::move(loop);
}

void refuse_repeated_points(RawCurve& curve) {
  if (curve.points.size() > 1 && curve.points.front().at == curve.points.back().at) {
    curve.closed = true;
    curve.points.pop_back();
  }
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    if (curve.points[i].at == curve.points[i - 1].at)
      curve.fail(i,
                 "the point " + mesh::words(curve.points[i].at) + " repeats the one of line " +
                     std::to_string(curve.points[i - 1].line),
                 "remove one of the two lines");
  if (curve.points.size() < fewest_points)
    curve.fail(curve.points.size() - 1,
               "an airfoil needs at least " + std::to_string(fewest_points) + " different points, found " +
                   std::to_string(curve.points.size()),
               "was the file cut short?");
}

/// Where a curve begins, seen from its other end.
struct Ends {
  Point2 start;           ///< middle of the first and last point
  double chord;           ///< extent of the section, seen from the point farthest from start
  bool at_trailing_edge;  ///< the start is an end of the section, the one of larger x
};

Ends find_ends(const RawCurve& curve) {
  const Point2 first = curve.points.front().at, last = curve.closed ? first : curve.points.back().at;
  Ends ends;
  ends.start = {first.x / 2 + last.x / 2, first.y / 2 + last.y / 2};
  const Point2 other_end = curve.points[farthest_from(ends.start, curve.points)].at;
  ends.chord = distance(other_end, curve.points[farthest_from(other_end, curve.points)].at);
  if (!std::isfinite(ends.chord))
    curve.fail(0, "the section is larger than the range of double", "scale it down");
  ends.at_trailing_edge = distance(ends.start, other_end) >= 0.9 * ends.chord && ends.start.x >= other_end.x;
  return ends;
}

void refuse_open_curve(const RawCurve& curve, const Ends& ends) {
  if (curve.closed) return;
  const double gap = distance(curve.points.front().at, curve.points.back().at);
  const std::string between =
      "between its first point " + curve.words(0) + " and its last " + curve.words(curve.points.size() - 1);
  if (gap > widest_gap * ends.chord)
    curve.fail(curve.points.size() - 1,
               "the curve is open: the gap " + between + " is " +
                   mesh::words(std::round(1000 * gap / ends.chord) / 10) + " % of the chord",
               "a blunt trailing edge may have 5 %; close the curve, or add the missing points");
  if (!ends.at_trailing_edge)
    curve.fail(
        curve.points.size() - 1,
        "the curve is open away from its trailing edge (its end of larger x): there is a gap " + between,
        "begin and end at the trailing edge, or close the curve by repeating the first point");
}

void refuse_crossings(const RawCurve& curve, std::span<const Point2> loop) {
  const auto crossing = edges_that_meet(loop);
  if (!crossing) return;
  const auto edge = [&](std::size_t i) {
    return "from " + curve.words(i) + " to " + curve.words(i + 1 == loop.size() ? 0 : i + 1);
  };
  curve.fail(crossing->second,
             "the curve crosses or touches itself: the segment " + edge(crossing->first) +
                 " meets the segment " + edge(crossing->second),
             "correct these points or their order");
}

/// The angle by which the closed curve turns at a point, 0 to pi.
double turn_rad(const std::vector<Point2>& loop, std::size_t i) {
  const std::size_t n = loop.size();
  const Vec2 in = loop[i] - loop[(i + n - 1) % n], out = loop[(i + 1) % n] - loop[i];
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

/// The corners within a small way of the trailing edge, on both sides along a counter-clockwise loop.
struct Corners {
  std::size_t lower,
      upper;     ///< the first before and the last after the trailing edge; equal: at most one corner
  double apart;  ///< way along the loop between them
};

Corners corners_near(const std::vector<Point2>& loop, std::size_t trailing_edge, double reach) {
  const std::size_t n = loop.size();
  const auto last_corner = [&](std::size_t step) -> std::pair<std::optional<std::size_t>, double> {
    std::optional<std::size_t> corner;
    double way = 0, way_to_corner = 0;
    for (std::size_t i = trailing_edge, steps = 0; steps < n && way <= reach; ++steps) {
      if (turn_rad(loop, i) > corner_rad) {
        corner = i;
        way_to_corner = way;
      }
      const std::size_t next = (i + step) % n;
      way += distance(loop[i], loop[next]);
      i = next;
    }
    return {corner, way_to_corner};
  };
  const auto [upper, way_up] = last_corner(1);
  const auto [lower, way_down] = last_corner(n - 1);
  const std::size_t only = upper ? *upper : lower ? *lower : trailing_edge;
  if (!upper || !lower) return {only, only, 0};
  return {*lower, *upper, way_up + way_down};
}

/// Begin a closed counter-clockwise loop at its trailing edge, or at the upper corner of a blunt one.
/// returns whether it is blunt
bool begin_at_trailing_edge(std::vector<Point2>& loop, std::size_t trailing_edge, double chord) {
  const Corners corners = corners_near(loop, trailing_edge, widest_gap * chord);
  const bool blunt = corners.lower != corners.upper && corners.apart <= widest_gap * chord;
  const std::size_t begin = blunt                            ? corners.upper
                            : corners.lower == corners.upper ? corners.upper
                                                             : trailing_edge;
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(begin), loop.end());
  return blunt;
}

/// Index of the trailing edge of a closed loop that may begin anywhere: the end of larger x of its longest
/// extent.
std::size_t trailing_edge_of(const RawCurve& curve, const Ends& ends) {
  if (ends.at_trailing_edge) return 0;
  const std::size_t one_end = farthest_from(ends.start, curve.points);
  const std::size_t other_end = farthest_from(curve.points[one_end].at, curve.points);
  return curve.points[one_end].at.x >= curve.points[other_end].at.x ? one_end : other_end;
}

}  // namespace

AirfoilCoordinates parse_airfoil(std::string_view text, const std::string& source) {
  RawCurve curve = read_points(text, source);
  undo_lednicer_order(curve);
  refuse_repeated_points(curve);
  const Ends ends = find_ends(curve);
  refuse_open_curve(curve, ends);

  AirfoilCoordinates airfoil;
  airfoil.name = curve.name.empty() ? std::filesystem::path(source).stem().string() : curve.name;
  for (const LocatedPoint& point : curve.points) airfoil.points.push_back(point.at);
  refuse_crossings(curve, airfoil.points);
  std::size_t trailing_edge = curve.closed ? trailing_edge_of(curve, ends) : 0;
  if (!is_counter_clockwise(airfoil.points)) {
    std::reverse(airfoil.points.begin(), airfoil.points.end());
    trailing_edge = airfoil.points.size() - 1 - trailing_edge;
  }
  airfoil.blunt_trailing_edge =
      curve.closed ? begin_at_trailing_edge(airfoil.points, trailing_edge, ends.chord) : true;
  return airfoil;
}

AirfoilCoordinates read_airfoil(const std::filesystem::path& path) {
  return parse_airfoil(read_whole_file(path), path.string());
}

}  // namespace leonhard::io
