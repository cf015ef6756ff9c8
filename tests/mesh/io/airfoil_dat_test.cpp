// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/airfoil_dat.hpp"

#include <cmath>
#include <sstream>

#include "leonhard/mesh/io/soup/simple_polygon.hpp"
#include "tests/mesh/io/sample_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

AirfoilCoordinates parse(const std::string& text) { return io::parse_airfoil(text, "a.dat"); }

const std::string sharp =
    "Diamond-like section\n"
    " 1.0  0.0\n"
    " 0.5  0.1\n"
    " 0.1  0.08\n"
    " 0.0  0.0\n"
    " 0.1 -0.04\n"
    " 0.5 -.05\n"
    " 1.0  0.0\n";

const std::string blunt =
    "1 0.01\n"
    "0.5 0.1\n"
    "0.1 0.08\n"
    "0 0\n"
    "0.1 -0.04\n"
    "0.5 -0.05\n"
    "1 -0.01\n";

const std::vector<Point2> sharp_points{{1, 0}, {0.5, 0.1}, {0.1, 0.08}, {0, 0}, {0.1, -0.04}, {0.5, -0.05}};
const std::vector<Point2> blunt_points{{1, 0.01},    {0.5, 0.1},   {0.1, 0.08}, {0, 0},
                                       {0.1, -0.04}, {0.5, -0.05}, {1, -0.01}};

std::string text_of(const std::vector<Point2>& points) {
  std::ostringstream text;
  for (const Point2 p : points) text << p.x << " " << p.y << "\n";
  return text.str();
}

}  // namespace

TEST_CASE("sharp_airfoil_in_seligs_order_is_read_as_a_loop_without_its_last_point") {
  const AirfoilCoordinates airfoil = parse(sharp);
  CHECK(airfoil.name == "Diamond-like section");
  CHECK(airfoil.points == sharp_points);
  CHECK_FALSE(airfoil.blunt_trailing_edge);
}

TEST_CASE("a_name_that_begins_with_a_number_and_goes_on_in_words_ends") {  // it once was read for ever
  const AirfoilCoordinates airfoil = parse("0012 a section of NACA" + sharp.substr(sharp.find('\n')));
  CHECK(airfoil.name == "0012 a section of NACA");
  CHECK(airfoil.points == sharp_points);
}

TEST_CASE("blunt_airfoil_without_a_name_is_named_after_its_file") {
  const AirfoilCoordinates airfoil = parse(blunt);
  CHECK(airfoil.name == "a");
  CHECK(airfoil.points == blunt_points);
  CHECK(airfoil.blunt_trailing_edge);
}

TEST_CASE("airfoil_is_turned_counter_clockwise_and_begins_at_its_trailing_edge") {
  std::vector<Point2> reversed(blunt_points.rbegin(), blunt_points.rend());
  CHECK(parse(text_of(reversed)).points == blunt_points);
  // A closed curve may begin anywhere, either way round.
  for (std::size_t start = 0; start < sharp_points.size(); ++start)
    for (const bool backward : {false, true}) {
      std::vector<Point2> loop = sharp_points;
      if (backward) std::reverse(loop.begin(), loop.end());
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
      loop.push_back(loop.front());
      const AirfoilCoordinates airfoil = parse(text_of(loop));
      CHECK(airfoil.points == sharp_points);
      CHECK_FALSE(airfoil.blunt_trailing_edge);
    }
}

TEST_CASE("base_of_a_closed_airfoil_is_recognised_wherever_the_curve_begins") {
  for (std::size_t start = 0; start < blunt_points.size(); ++start) {
    std::vector<Point2> loop = blunt_points;
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
    loop.push_back(loop.front());
    const AirfoilCoordinates airfoil = parse(text_of(loop));
    CHECK(airfoil.points == blunt_points);
    CHECK(airfoil.blunt_trailing_edge);
  }
}

TEST_CASE("base_with_a_point_in_its_middle_keeps_it_as_the_last_point") {
  std::vector<Point2> loop = blunt_points;
  loop.insert(loop.begin(), {1, 0});
  loop.push_back({1, 0});
  const AirfoilCoordinates airfoil = parse(text_of(loop));
  CHECK(airfoil.blunt_trailing_edge);
  CHECK(airfoil.points.front() == Point2{1, 0.01});
  CHECK(airfoil.points.back() == Point2{1, 0});
}

TEST_CASE("lednicers_order_gives_the_same_airfoil_as_seligs") {
  const std::string sharp_lednicer =
      "Diamond-like section\n 4. 4.\n\n0 0\n0.1 0.08\n0.5 0.1\n1 0\n\n0 0\n0.1 -0.04\n0.5 -0.05\n1 0\n";
  CHECK(parse(sharp_lednicer).points == sharp_points);
  CHECK(parse(sharp_lednicer).name == "Diamond-like section");
  const std::string blunt_lednicer = "4 3\n0 0\n0.1 0.08\n0.5 0.1\n1 0.01\n0.1 -0.04\n0.5 -0.05\n1 -0.01\n";
  CHECK(parse(blunt_lednicer).points == blunt_points);
}

TEST_CASE("curve_in_whole_numbers_is_not_taken_for_lednicers_counts") {
  // From fuzzing: the first point of a closed curve in Selig's order may look like two counts.
  CHECK(parse("12 21\n5 25\n0 20\n5 18\n10 19\n12 21\n").points.size() == 5);
  CHECK(parse("2 3\n1 4\n0 3\n1 2.5\n1.5 2.7\n2 3\n").points.size() == 5);  // and 2 + 3 lines follow
  CHECK(parse("100 12\n50 20\n0 10\n50 5\n100 10\n").blunt_trailing_edge);
}

TEST_CASE("airfoil_may_be_separated_by_commas_and_tabs_with_comments") {
  CHECK(parse("# a comment\nname, with comma\n1.0,0.0\r\n0.5,\t0.1 # upper\n0.1, 0.08\n0 0\n.1 -.04\n5e-1 "
              "-0.05\n1 0\n")
            .points == sharp_points);
}

TEST_CASE("large_and_small_airfoils_are_read_like_others") {
  for (const double scale : {1e-200, 1e-5, 100.0, 1e150}) {
    std::ostringstream text;
    text.precision(17);
    for (const Point2 p : blunt_points) text << scale * p.x << " " << scale * p.y << "\n";
    CHECK(parse(text.str()).points.size() == blunt_points.size());
  }
}

TEST_CASE("airfoil_bad_input_is_refused_with_file_and_line") {
  const std::string circle_like = "0 1\n-1 0\n0 -1\n1 0\n0.8 0.6\n";
  check_refused(
      {{"empty", "", {"a.dat:1", "file ends"}},
       {"name only", "NACA 0012\n", {"a.dat:1", "no points"}},
       {"letters", replaced(sharp, "0.1  0.08", "0.1  O.08"), {"a.dat:4", "\"O.08\"", "y coordinate"}},
       {"letters in the first point", replaced(blunt, "1 0.01", "1.0 o.01"), {"a.dat:1", "\"o.01\""}},
       {"NaN", replaced(sharp, "0.1  0.08", "nan 0.08"), {"a.dat:4", "\"nan\" is not finite"}},
       {"NaN in the first point", replaced(blunt, "1 0.01", "1.0 nan"), {"a.dat:1", "not finite"}},
       {"infinity", replaced(sharp, "0.1  0.08", "0.1 inf"), {"a.dat:4", "\"inf\" is not finite"}},
       {"one number", replaced(sharp, "0.1  0.08", "0.1"), {"a.dat:4", "line ends", "y coordinate"}},
       {"letters behind", replaced(sharp, "0.1  0.08", "0.1 0.08 z"), {"a.dat:4", "\"z\"", "further column"}},
       {"decimal commas", "1,0 0,01\n", {"a.dat:1"}},
       {"too few", "1 0\n0 0\n0.5 0.1\n1 0\n", {"a.dat:3", "at least 5", "found 3"}},
       {"several elements", sharp + "999 999\n" + blunt, {"a.dat", "2 elements"}},
       {"half a curve", "1 0\n0.8 0.05\n0.5 0.1\n0.1 0.08\n0 0\n", {"a.dat:5", "open", "100 % of the chord"}},
       {"open at the leading edge",
        "0 0.001\n0.5 0.1\n1 0\n0.5 -0.1\n0 -0.001\n",
        {"a.dat:5", "open away from its trailing edge"}},
       {"open at the middle",
        "0.5 0.1\n0 0\n0.5 -0.1\n1 0\n0.51 0.1\n",
        {"a.dat:5", "open away from its trailing edge"}},
       {"crossing",
        replaced(sharp, "0.1 -0.04", "0.1 0.2"),
        {"a.dat:", "crosses or touches itself", "(0.1, 0.2) (line 6)", "meets"}},
       {"touching",
        replaced(sharp, "0.5 -.05", "0.5 0.1"),
        {"a.dat:", "crosses or touches itself", "(line 3)", "(line 7)"}},
       {"folded back",
        "1 0\n0.5 0.25\n0.75 0.125\n0 0\n0.5 -0.25\n1 0\n",
        {"a.dat:", "touches itself", "(0.75, 0.125) (line 3)"}},
       {"flat", "1 0\n0.5 0\n0 0\n0.25 0\n0.75 0\n1 0\n", {"a.dat:", "touches itself"}},
       {"Lednicer cut short",
        "name\n4. 4.\n0 0\n0.1 0.08\n0.5 0.1\n1 0\n0 0\n0.1 -0.04\n0.5 -0.05\n",
        {"a.dat:2", "4 upper and 4 lower", "7 points follow", "cut short"}},
       {"too large", replaced(blunt, "0 0\n", "-1.7e308 1e308\n"), {"a.dat:"}},
       {"binary",
        std::string("\x7f"
                    "ELF\0",
                    5),
        {"a.dat:1", "zero byte"}}},
      [](const std::string& text) { parse(text); });
}

TEST_CASE("airfoil_quirks_of_other_programs_are_read_with_a_word_on_each") {
  const auto warned = [](const std::string& text, const std::vector<Point2>& points, const char* part) {
    const AirfoilCoordinates airfoil = parse(text);
    CHECK(airfoil.points == points);
    const bool told = std::any_of(airfoil.warnings.begin(), airfoil.warnings.end(),
                                  [&](const std::string& w) { return w.find(part) != std::string::npos; });
    CHECK_MESSAGE(told, part);
  };
  warned(replaced(sharp, " 0.1  0.08\n", " 0.1  0.08\n 0.1  0.08\n"), sharp_points, "(0.1, 0.08) on line 5");
  warned(replaced(sharp, " 0.0  0.0\n", " 0.0  0.0\n -0.0  0.0\n"), sharp_points, "line 6");
  warned(replaced(sharp, "0.1  0.08", "0.1 0.08 0"), sharp_points, "behind x and y were left out on 1 lines");
  std::vector<Point2> wide = blunt_points;
  wide.back().y = -0.06;
  warned(replaced(blunt, "1 -0.01", "1 -0.06"), wide, "7 % of the chord");
  CHECK(parse("0012 64\n" + blunt).points == blunt_points);
  CHECK(parse(replaced(sharp, "0.5  0.1", "5.0D-01 1.0d-1")).points == sharp_points);
  CHECK(parse("two lines\nof words\n" + blunt).points == blunt_points);
  std::string old_mac = sharp, semicolons = blunt;
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  CHECK(parse(old_mac).points == sharp_points);
  std::replace(semicolons.begin(), semicolons.end(), ' ', ';');
  CHECK(parse(semicolons).points == blunt_points);
  CHECK(parse("no counts\n0 0\n0.1 0.08\n0.5 0.1\n1 0\n0 0\n0.1 -0.04\n0.5 -0.05\n1 0\n").points ==
        sharp_points);
  const auto elements = io::parse_airfoils(sharp + "999.0 999.0\n" + blunt, "a.dat");
  REQUIRE(elements.size() == 2);
  CHECK(elements[0].points == sharp_points);
  CHECK(elements[1].points == blunt_points);
}

// ---- simple_polygon ----

namespace {

using Wide = long long;

/// Whether segments with integer ends share a point, by Cramer's rule on their parameters in whole numbers: a way of its
/// own, which knows nothing of orientations.
bool share_a_point(const Point2 a, const Point2 b, const Point2 c, const Point2 d) {
  const auto whole = [](double x) { return static_cast<Wide>(x); };
  const Wide rx = whole(b.x - a.x), ry = whole(b.y - a.y), sx = whole(d.x - c.x), sy = whole(d.y - c.y);
  const Wide qx = whole(c.x - a.x), qy = whole(c.y - a.y);
  Wide denominator = rx * sy - ry * sx;
  Wide t = qx * sy - qy * sx, u = qx * ry - qy * rx;
  if (denominator < 0) {
    denominator = -denominator;
    t = -t;
    u = -u;
  }
  if (denominator > 0) return 0 <= t && t <= denominator && 0 <= u && u <= denominator;
  if (u != 0) return false;  // parallel, apart
  const Wide rr = rx * rx + ry * ry, t0 = qx * rx + qy * ry, t1 = t0 + sx * rx + sy * ry;
  return std::max(t0, t1) >= 0 && std::min(t0, t1) <= rr;
}

bool simple_by_all_pairs(const std::vector<Point2>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Point2 a = p[i], b = p[(i + 1) % n], c = p[j], d = p[(j + 1) % n];
      if (j == i + 1 || (i == 0 && j == n - 1)) {  // neighbours: the far ends must not lie on the other edge
        const Point2 shared = j == i + 1 ? b : a, far_i = j == i + 1 ? a : b, far_j = j == i + 1 ? d : c;
        if (share_a_point(shared, far_j, far_i, far_i) || share_a_point(shared, far_i, far_j, far_j))
          return false;
      } else if (share_a_point(a, b, c, d)) {
        return false;
      }
    }
  return true;
}

}  // namespace

TEST_CASE("polygon_is_called_simple_just_when_all_pairs_of_edges_say_so") {
  std::uint64_t state = 12345;
  const auto random = [&](std::uint64_t below) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (state >> 33) % below;
  };
  int simple = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<Point2> polygon;
    const std::size_t n = 3 + random(5);
    while (polygon.size() < n) {
      const Point2 p{static_cast<double>(random(6)), static_cast<double>(random(6))};
      if (polygon.empty() || (polygon.back() != p && (polygon.size() + 1 < n || polygon.front() != p)))
        polygon.push_back(p);
    }
    const bool is_simple = !io::edges_that_meet(polygon);
    REQUIRE(is_simple == simple_by_all_pairs(polygon));
    simple += is_simple;
    if (!is_simple) continue;
    double area2 = 0;  // exact, small whole numbers
    for (std::size_t i = 0; i < n; ++i) {
      const Point2 a = polygon[i], b = polygon[(i + 1) % n];
      area2 += a.x * b.y - b.x * a.y;
    }
    REQUIRE(io::is_counter_clockwise(polygon) == (area2 > 0));
  }
  CHECK(simple > 1000);
  CHECK(simple < 19000);
}
