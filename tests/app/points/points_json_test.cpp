// SPDX-License-Identifier: MIT
#include "leonhard/app/points/points_json.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/app/input_error_of.hpp"

using namespace leonhard;

namespace {

PointsFile parse(const std::string& text) { return app::parse_points_json(text, "p.json"); }
std::string complaint(const std::string& text) {
  return input_error_of([&] { return parse(text); });
}
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string collection(const std::string& geometry) {
  return "{\"type\": \"FeatureCollection\", \"bbox\": [0, 1, 2, 3], \"features\": [\n"
         "{\"type\": \"Feature\", \"properties\": {\"coordinates\": [[[[[7]]]]], \"points\": \"many\"}, "
         "\"geometry\": " +
         geometry + "},\n{\"type\": \"Feature\", \"geometry\": null, \"properties\": null}\n]}";
}

}  // namespace

TEST_CASE("plain_json_gives_points_in_pairs_or_flat_alone_or_under_points") {
  const std::vector<Point2> expected{{1, 2}, {-0.5, 3e4}, {0, 18446744073709551615.0}};
  for (const std::string text :
       {"[[1, 2], [-0.5, 3e4], [0, 18446744073709551615]]", "[1, 2, -0.5, 3e4, 0, 18446744073709551615]",
        "\xEF\xBB\xBF{\"points\": [[1, 2],\n[-0.5, 3e4], [0, 18446744073709551615]]}",
        "{\"name\": [1, [2]], \"about\": {\"points\": 3}, \"points\": [1, 2, -0.5, 3e4, 0, "
        "18446744073709551615], "
        "\"more\": null}"}) {
    CAPTURE(text);
    const PointsFile file = parse(text);
    CHECK(file.set.points == expected);
    CHECK(file.warnings.empty());
  }
}

TEST_CASE("geojson_points_are_read_from_geometries_features_and_collections") {
  const std::vector<Point2> expected{{1, 2}, {3, 4}};
  const std::string points = "{\"coordinates\": [[1, 2], [3, 4]], \"type\": \"MultiPoint\"}";
  CHECK(parse(points).set.points == expected);
  CHECK(parse(collection(points)).set.points == expected);
  CHECK(
      parse(collection(
                "{\"type\": \"GeometryCollection\", \"geometries\": [{\"type\": \"Point\", \"coordinates\": "
                "[1, 2]}, {\"type\": \"Point\", \"coordinates\": [3, 4]}]}"))
          .set.points == expected);
  CHECK(parse(collection(points)).warnings.empty());
}

TEST_CASE("vertices_of_lines_and_polygons_are_taken_with_a_warning_and_rings_closed_once") {
  const PointsFile ring =
      parse(collection("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [4, 0], [0, 4], [0, 0]], [[1, 1], "
                       "[1, 2], [2, 1], [1, 1]]]}"));
  CHECK(ring.set.points == std::vector<Point2>{{0, 0}, {4, 0}, {0, 4}, {1, 1}, {1, 2}, {2, 1}});
  REQUIRE(ring.warnings.size() == 1);
  CHECK(holds(ring.warnings[0], "6 of the points are vertices"));
  const PointsFile line = parse("{\"type\": \"LineString\", \"coordinates\": [[0, 0, 9], [4, 0, 9]]}");
  CHECK(line.set.points.size() == 2);
  REQUIRE(line.warnings.size() == 2);
  CHECK(holds(line.warnings[1], "the heights of 2 points"));
  CHECK(parse("{\"type\": \"MultiPolygon\", \"coordinates\": [[[[0, 0], [1, 0], [0, 1], [0, 0]]]]}")
            .set.points.size() == 3);
}

TEST_CASE("bad_json_is_refused_with_its_line") {
  CHECK(holds(complaint("[[1, 2],\n[3]]"), "p.json:2: a point has 1 coordinates"));
  CHECK(holds(complaint("[[1, 2],\n[3, 4, 5]]"), "p.json:2: a point has 3 coordinates"));
  // The parser has read the newline by then: the culprit is the number before it.
  CHECK(holds(complaint("[[0, 0],\n5\n]"), "p.json:2: found lone coordinates"));
  CHECK(holds(complaint("[1, 2,\n3]"), "p.json:2: the number of coordinates is odd"));
  CHECK(holds(complaint("[[1, 2], 3, 4]"), "mixed"));
  CHECK(holds(complaint("[1, 2, [3, 4]]"), "mixed"));
  CHECK(holds(complaint("[1, [3, 4]]"), "found an array among the coordinates"));
  CHECK(holds(complaint("[[1, 2], []]"), "without coordinates"));
  CHECK(holds(complaint("[[1, \"2\"]]"), "found a word"));
  CHECK(holds(complaint("[[1, null]]"), "found null"));
  CHECK(holds(complaint("[{\"x\": 1, \"y\": 2}]"), "found an object"));
  CHECK(holds(complaint("[[1, 2],\n[3, NaN]]"), "p.json:2: is no valid JSON"));
  CHECK(holds(complaint("[[1, 1e999]]"), "no valid JSON"));
  CHECK(holds(complaint("[[1, 2]"), "no valid JSON"));
  CHECK(holds(complaint("[[1, 2]] 3"), "no valid JSON"));
  CHECK(holds(complaint("[[[1, 2]]]"), "nested too deeply"));
  CHECK(holds(complaint(std::string(100000, '[')), "nested too deeply"));
  CHECK(holds(complaint("\x89PNG\r\n\x1a\n"), "no valid JSON"));
  for (const char* nothing : {"[]", "{}", "3", "\"x\"", "{\"points\": []}", "{\"points\": 3}"})
    CHECK(holds(complaint(nothing), "no point was found"));
}

TEST_CASE("bad_geojson_is_refused") {
  CHECK(holds(complaint("{\"type\": \"Point\", \"coordinates\": [[1, 2]]}"), "nested 2 deep, not 1"));
  CHECK(holds(complaint("{\"type\": \"Blob\", \"coordinates\": [1, 2]}"), "\"Blob\""));
  CHECK(holds(complaint("{\"type\": \"Point\", \"coordinates\": [1]}"), "1 coordinates"));
  CHECK(holds(complaint("{\"type\": \"Point\", \"coordinates\": []}"), "no point was found"));
}
