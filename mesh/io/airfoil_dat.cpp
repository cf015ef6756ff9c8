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

constexpr double widest_gap = 0.05;                  ///< of a base that needs no word, in chords
constexpr double corner_rad = std::numbers::pi / 4;  ///< a trailing edge's corner turns by more than this
constexpr std::size_t fewest_points = 5;
constexpr double separator = 999;  ///< both coordinates: between two elements

struct LocatedPoint {
  Point2 at;
  std::size_t line;
};

/// The curve as the file gives it, in file order.
struct RawCurve {
  std::string source;
  std::string name;
  std::vector<LocatedPoint> points;
  std::vector<std::string> warnings;
  bool closed = false;  ///< the last point was a repetition of the first, and is gone

  [[nodiscard]] std::string words(std::size_t i) const {
    return mesh::words(points[i].at) + " (line " + std::to_string(points[i].line) + ")";
  }
  [[noreturn]] void fail(std::size_t i, std::string problem, std::string remedy) const {
    throw InputError(at_line(source, points[i].line), std::move(problem), std::move(remedy));
  }
};

/// With line ends and separators that the scanner knows: CR alone ends a line, semicolons are blanks, and where they
/// separate columns of numbers without points commas are decimal ones.
std::string plain_text(std::string_view text) {
  std::string plain(text);
  if (plain.find('\n') == std::string::npos) std::replace(plain.begin(), plain.end(), '\r', '\n');
  if (plain.find(';') == std::string::npos) return plain;
  const std::size_t first = plain.find_last_of('\n', plain.find(';'));
  const std::string_view from_data = std::string_view(plain).substr(first == std::string::npos ? 0 : first);
  const bool decimal_commas = from_data.find('.') == std::string_view::npos;
  for (char& c : plain) {
    if (c == ',' && decimal_commas) c = '.';
    if (c == ';') c = ' ';
  }
  return plain;
}

/// A word as a number, Fortran's exponents D and d included.
NumberFault parse_coordinate(std::string_view word, double& value) {
  const NumberFault fault = parse_number(word, value);
  if (fault != NumberFault::not_a_number) return fault;
  std::string with_e(word);
  for (char& c : with_e)
    if (c == 'D' || c == 'd') c = 'e';
  return with_e == word ? fault : parse_number(with_e, value);
}

double read_coordinate(TextScanner& scan, const char* expected) {
  const std::string_view word = scan.word(expected);
  double value = 0;
  switch (parse_coordinate(word, value)) {
    case NumberFault::none:
      return value;
    case NumberFault::not_a_number:
      scan.fail_found(word, expected);
    case NumberFault::not_finite:
      scan.fail(in_quotes(word) + " is not finite, where " + expected + " was expected",
                "NaN and infinities are bad input; find out what wrote them");
    case NumberFault::too_large:
      break;
  }
  scan.fail(in_quotes(word) + " is beyond the range of double, where " + expected + " was expected");
}

/// Whether a line is data: two words or more of which the first is a number with a decimal point, or all are numbers
/// ("0.98 O.01" is a mistyped point, "0012 section" a name).
bool looks_like_point(TextScanner scan) {
  double unused = 0;
  const std::string_view first = scan.word("a name or x and y");
  if (scan.line_done() || parse_coordinate(first, unused) == NumberFault::not_a_number) return false;
  std::size_t words = 1;
  bool all_are_numbers = true;
  for (; !scan.line_done(); ++words) {
    const std::string_view word = scan.word("a coordinate");
    all_are_numbers = all_are_numbers && parse_coordinate(word, unused) != NumberFault::not_a_number;
  }
  return all_are_numbers || (words == 2 && first.find('.') != std::string_view::npos);
}

/// The elements of a file, one or more.
std::vector<RawCurve> read_curves(std::string_view text, const std::string& source) {
  TextScanner scan(text, source, {.comment = '#', .extra_blank = ','});
  std::vector<RawCurve> curves(1);
  curves.back().source = source;
  scan.need_line("the name of the airfoil or its first point");
  bool on_data = looks_like_point(scan);
  if (!on_data) {
    curves.back().name = scan.rest();
    const bool more = scan.next_line();
    const bool is_word = more && !looks_like_point(scan) && scan.rest().find_first_of("0123456789.+-") != 0;
    on_data = is_word ? scan.next_line() : more;  // a second line of words may follow
  }
  const std::string name = curves.back().name;
  std::size_t columns_left_out = 0;
  for (bool more = on_data; more; more = scan.next_line()) {
    const double x = read_coordinate(scan, "the x coordinate of a point");
    const double y = read_coordinate(scan, "the y coordinate of a point");
    if (!scan.line_done()) ++columns_left_out;
    while (!scan.line_done()) read_coordinate(scan, "a further column");
    if (x >= separator && y >= separator && x < separator + 1 && y < separator + 1) {
      curves.push_back({source, name, {}, {}});
    } else {
      curves.back().points.push_back({{x, y}, scan.line()});
    }
  }
  std::erase_if(curves, [](const RawCurve& curve) { return curve.points.empty(); });
  if (curves.empty()) scan.fail("the file holds no points", "give one point, x and y, a line");
  if (columns_left_out > 0)
    curves.front().warnings.push_back(source + ": columns behind x and y were left out on " +
                                      std::to_string(columns_left_out) + " lines");
  return curves;
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

/// Both sides from the leading to the trailing edge, the lower one from point `middle` on, become Selig's order.
void join_sides(std::vector<LocatedPoint>& points, std::size_t middle) {
  const auto begin = points.begin(), second = begin + static_cast<std::ptrdiff_t>(middle);
  const bool leading_edge_twice = begin->at == second->at;
  std::vector<LocatedPoint> loop(begin, second);
  std::reverse(loop.begin(), loop.end());
  loop.insert(loop.end(), second + (leading_edge_twice ? 1 : 0), points.end());
  points = std::move(loop);
}

/// Whether the first and the last point lie at one end of the section, at the middle of a base of any thickness.
bool ends_meet(const std::vector<LocatedPoint>& points) {
  const Point2 first = points.front().at, last = points.back().at;
  const Point2 start{first.x / 2 + last.x / 2, first.y / 2 + last.y / 2};
  const Point2 other = points[farthest_from(start, points)].at;
  return distance(start, other) >= 0.9 * distance(other, points[farthest_from(other, points)].at);
}

/// Two sides without counts: the longest step goes back from the trailing edge to the leading edge.
std::size_t lower_side_begins(const std::vector<LocatedPoint>& points) {
  std::size_t longest = 1;
  for (std::size_t i = 2; i < points.size(); ++i)
    if (distance(points[i - 1].at, points[i].at) > distance(points[longest - 1].at, points[longest].at))
      longest = i;
  const double chord = distance(points[longest - 1].at, points[longest].at);
  const bool is_lednicer = distance(points.front().at, points[longest].at) <= widest_gap * chord &&
                           distance(points.back().at, points[longest - 1].at) <= 4 * widest_gap * chord;
  return is_lednicer ? longest : 0;
}

/// Lednicer's format begins with the numbers of points of the upper and lower side, both of which run from
/// the leading to the trailing edge. Turns it into Selig's order; leaves a curve in Selig's order alone.
void undo_lednicer_order(RawCurve& curve) {
  if (curve.points.size() < fewest_points) return;
  if (begins_with_counts(curve)) {
    const Point2 counts = curve.points.front().at;
    const std::size_t found = curve.points.size() - 1;
    const auto upper = static_cast<std::size_t>(counts.x), lower = static_cast<std::size_t>(counts.y);
    const LocatedPoint head = curve.points.front();
    curve.points.erase(curve.points.begin());
    if (upper + lower == found) return join_sides(curve.points, upper);
    if (ends_meet(curve.points)) {  // then the two numbers are a name
      curve.warnings.push_back(at_line(curve.source, head.line) + ": the two numbers are taken for a name");
      return;
    }
    curve.points.insert(curve.points.begin(), head);
    curve.fail(0,
               "declares " + std::to_string(upper) + " upper and " + std::to_string(lower) +
                   " lower points (Lednicer's format), but " + std::to_string(found) + " points follow",
               "the file was cut short, or correct the two counts");
  }
  if (ends_meet(curve.points)) return;
  if (const std::size_t middle = lower_side_begins(curve.points); middle > 0)
    join_sides(curve.points, middle);
}

void merge_repeated_points(RawCurve& curve) {
  if (curve.points.size() > 1 && curve.points.front().at == curve.points.back().at) {
    curve.closed = true;
    curve.points.pop_back();
  }
  std::string lines;
  std::vector<LocatedPoint> kept;
  for (const LocatedPoint& point : curve.points) {
    if (kept.empty() || kept.back().at != point.at) {
      kept.push_back(point);
    } else {
      lines += (lines.empty() ? "" : ", ") + mesh::words(point.at) + " on line " + std::to_string(point.line);
    }
  }
  while (curve.closed && kept.size() > 1 && kept.front().at == kept.back().at) {
    lines += (lines.empty() ? "" : ", ") + mesh::words(kept.back().at) + " on line " +
             std::to_string(kept.back().line);
    kept.pop_back();
  }
  if (!lines.empty())
    curve.warnings.push_back(curve.source + ": points that repeat the one before were merged: " + lines);
  curve.points = std::move(kept);
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

void refuse_open_curve(RawCurve& curve, const Ends& ends) {
  if (curve.closed) return;
  const double gap = distance(curve.points.front().at, curve.points.back().at);
  const std::string percent = mesh::words(std::round(1000 * gap / ends.chord) / 10) + " % of the chord";
  const std::string between =
      "between its first point " + curve.words(0) + " and its last " + curve.words(curve.points.size() - 1);
  if (!ends.at_trailing_edge)
    curve.fail(curve.points.size() - 1,
               "the curve is open away from its trailing edge (its end of larger x): there is a gap " +
                   between + ", " + percent,
               "begin and end at the trailing edge, or close the curve by repeating the first point");
  if (gap > widest_gap * ends.chord)
    curve.warnings.push_back(curve.source + ": the open base " + between + " is " + percent +
                             "; a segment closes it");
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

namespace {

AirfoilCoordinates airfoil_of(RawCurve curve) {
  undo_lednicer_order(curve);
  merge_repeated_points(curve);
  const Ends ends = find_ends(curve);
  refuse_open_curve(curve, ends);

  AirfoilCoordinates airfoil;
  airfoil.name = curve.name.empty() ? std::filesystem::path(curve.source).stem().string() : curve.name;
  for (const LocatedPoint& point : curve.points) airfoil.points.push_back(point.at);
  refuse_crossings(curve, airfoil.points);
  std::size_t trailing_edge = curve.closed ? trailing_edge_of(curve, ends) : 0;
  if (!is_counter_clockwise(airfoil.points)) {
    std::reverse(airfoil.points.begin(), airfoil.points.end());
    trailing_edge = airfoil.points.size() - 1 - trailing_edge;
  }
  airfoil.blunt_trailing_edge =
      curve.closed ? begin_at_trailing_edge(airfoil.points, trailing_edge, ends.chord) : true;
  airfoil.warnings = std::move(curve.warnings);
  return airfoil;
}

}  // namespace

std::vector<AirfoilCoordinates> parse_airfoils(std::string_view text, const std::string& source) {
  const std::string plain = plain_text(text);
  std::vector<AirfoilCoordinates> airfoils;
  for (RawCurve& curve : read_curves(plain, source)) airfoils.push_back(airfoil_of(std::move(curve)));
  return airfoils;
}

AirfoilCoordinates parse_airfoil(std::string_view text, const std::string& source) {
  std::vector<AirfoilCoordinates> airfoils = parse_airfoils(text, source);
  if (airfoils.size() > 1)
    throw InputError(source, "the file holds " + std::to_string(airfoils.size()) + " elements",
                     "give each in a file of its own");
  return std::move(airfoils.front());
}

AirfoilCoordinates read_airfoil(const std::filesystem::path& path) {
  return parse_airfoil(read_whole_file(path), path.string());
}
std::vector<AirfoilCoordinates> read_airfoils(const std::filesystem::path& path) {
  return parse_airfoils(read_whole_file(path), path.string());
}

}  // namespace leonhard::io
