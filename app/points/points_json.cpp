// SPDX-License-Identifier: MIT
#include "leonhard/app/points/points_json.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

using Json = nlohmann::json;

/// The bytes of a text one after another, counting its lines for those who hear of what was read.
class CountedBytes {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedBytes(const char* at, std::size_t& line) : at_(at), line_(&line) {}
  reference operator*() const { return *at_; }
  CountedBytes& operator++() {
    // The parser reads one byte ahead: a line begins with its first byte, not with the end of the one before.
    if (after_newline_) ++*line_;
    after_newline_ = *at_++ == '\n';
    return *this;
  }
  CountedBytes operator++(int) {
    const CountedBytes old = *this;
    ++*this;
    return old;
  }
  bool operator==(const CountedBytes& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* line_;
  bool after_newline_ = false;
};

/// Which nesting of arrays the coordinates of a geometry have.
struct Geometry {
  std::string_view type;
  std::size_t depth;
  bool vertices;  ///< its positions are vertices of lines, not points
};
constexpr std::array geometries{Geometry{"Point", 1, false},          Geometry{"MultiPoint", 2, false},
                                Geometry{"LineString", 2, true},      Geometry{"Polygon", 3, true},
                                Geometry{"MultiLineString", 3, true}, Geometry{"MultiPolygon", 4, true}};

/// Hears the parser's events and gathers points. An array of coordinates is either the root (or "points" in it), or
/// belongs to the GeoJSON object in which it stands.
class PointsHandler : public nlohmann::json_sax<Json> {
 public:
  PointsHandler(const std::string& source, const std::size_t& line) : source_(source), line_(line) {}

  PlanarShapes finish(bool with_lines) {
    if (file_.set.points.empty()) fail("no point was found", shapes);
    if (lines_vertices_ > 0 && !with_lines)
      warn(std::to_string(lines_vertices_) + " of the points are vertices of lines and polygons");
    if (heights_ > 0) warn("the heights of " + std::to_string(heights_) + " points were left out");
    return {std::move(file_), std::move(lines_)};
  }

  bool null() override { return other("null"); }
  bool boolean(bool) override { return other("true or false"); }
  bool binary(binary_t&) override { return other("binary data"); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }

  bool string(string_t& words) override {
    if (coordinates_depth_ == 0 && !objects_.empty() && objects_.back().key == "type")
      objects_.back().type = words;
    return other("a word");
  }

  bool key(string_t& name) override {
    objects_.back().key = std::move(name);
    return true;
  }

  bool start_object(std::size_t) override {
    other("an object");
    objects_.push_back({});
    objects_.back().skipped = is_skipped();
    return true;
  }

  bool end_object() override {
    if (objects_.back().coordinates_depth > 0) check_geometry(objects_.back());
    objects_.pop_back();
    return true;
  }

  bool start_array(std::size_t) override {
    if (coordinates_depth_ > 0 || starts_coordinates()) {
      if (++coordinates_depth_ > deepest_allowed()) fail("arrays are nested too deeply", shapes);
      if (!position_.empty()) fail("found an array among the coordinates of a point", shapes);
      first_point_[coordinates_depth_] = file_.set.points.size();
    }
    return true;
  }

  bool end_array() override {
    if (coordinates_depth_ == 0) return true;
    if (!position_.empty()) {
      end_position();
    } else if (in_geojson_ && is_ring()) {
      drop_closing_vertex();
      end_list();
    } else if (in_geojson_ && coordinates_depth_ + 1 == objects_.back().coordinates_depth) {
      end_list();
    } else if (in_geojson_) {
      ring_ = 0;  // of the next polygon
    } else if (!in_geojson_ && coordinates_depth_ == 2) {
      fail("found a point without coordinates", shapes);
    }
    --coordinates_depth_;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    std::string words =
        error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    words = words.substr(words.find("] ") == std::string::npos ? 0 : words.find("] ") + 2);
    fail("is no valid JSON: " + words, "NaN and infinities are none, nor are numbers beyond double");
  }

 private:
  struct Object {
    std::string key, type;
    std::size_t first_point = 0, coordinates_depth = 0;
    bool skipped = false;
  };
  static constexpr const char* shapes =
      "give [[x, y], ...], [x0, y0, x1, y1, ...], {\"points\": ...} or GeoJSON points";

  [[noreturn]] void fail(const std::string& problem, const char* remedy) const {
    throw InputError(at_line(source_, line_), problem, remedy);
  }
  void warn(const std::string& words) { file_.warnings.push_back(source_ + ": " + words); }

  /// Inside "properties" and the like anything may stand.
  [[nodiscard]] bool is_skipped() const {
    if (objects_.size() < 2) return false;
    const Object& parent = objects_[objects_.size() - 2];
    return parent.skipped ||
           (parent.key != "features" && parent.key != "geometry" && parent.key != "geometries");
  }

  bool starts_coordinates() {
    if (objects_.empty()) return !std::exchange(root_seen_, true);
    Object& object = objects_.back();
    if (object.skipped) return false;
    if (objects_.size() == 1 && object.key == "points") return true;
    if (object.key != "coordinates") return false;
    in_geojson_ = true;
    object.first_point = file_.set.points.size();
    object.coordinates_depth = 0;
    return true;
  }
  [[nodiscard]] std::size_t deepest_allowed() const { return in_geojson_ ? 4 : 2; }

  bool other(const char* what) const {
    if (coordinates_depth_ > 0)
      fail(std::string("found ") + what + " where a coordinate was expected", shapes);
    return true;
  }

  bool number(double value) {
    if (coordinates_depth_ == 0) return true;
    if (position_.empty()) {
      if (points_depth_ && *points_depth_ != coordinates_depth_ && !in_geojson_)
        fail("found lone coordinates and points mixed", shapes);
      points_depth_ = coordinates_depth_;
    }
    position_.push_back(value);
    if (!in_geojson_ && coordinates_depth_ == 1 && position_.size() == 2) {
      file_.set.points.push_back({position_[0], position_[1]});
      position_.clear();
    }
    return true;
  }

  [[nodiscard]] bool is_ring() const {
    const std::size_t depth = objects_.back().coordinates_depth;
    return depth >= 3 && coordinates_depth_ + 1 == depth;
  }

  void end_position() {
    if (!in_geojson_ && coordinates_depth_ == 1)
      fail("the number of coordinates is odd", "give x and y of each point");
    if (position_.size() < 2 || (position_.size() > 2 && !in_geojson_))
      fail("a point has " + std::to_string(position_.size()) + " coordinates, a point of the plane has 2",
           "give x and y of each point");
    if (position_.size() > 2) ++heights_;
    file_.set.points.push_back({position_[0], position_[1]});
    position_.clear();
    if (in_geojson_)
      objects_.back().coordinates_depth = std::max(objects_.back().coordinates_depth, coordinates_depth_);
  }

  /// The list that ends is a ring of a polygon, or a line of several.
  void drop_closing_vertex() {
    std::vector<Point2>& points = file_.set.points;
    const std::size_t first = first_point_[coordinates_depth_];
    if (points.size() > first + 1 && points.back() == points[first]) points.pop_back();
  }

  /// Of positions that are joined, if the geometry turns out to be one of lines.
  void end_list() {
    lists_.push_back({first_point_[coordinates_depth_], file_.set.points.size(), false, ring_++ > 0});
  }

  /// The lists of a geometry of lines: rings of polygons are closed, the first of each bounds it.
  void take_lines(const Geometry& geometry) {
    const bool rings = geometry.type.ends_with("Polygon");
    for (PlanarShapes::Line line : std::exchange(lists_, {})) {
      line.closed = rings;
      line.hole = rings && line.hole;
      if (geometry.vertices) lines_.push_back(line);
    }
    ring_ = 0;
  }

  void check_geometry(const Object& object) {
    in_geojson_ = false;
    for (const Geometry& known : geometries) {
      if (object.type != known.type) continue;
      if (object.coordinates_depth != known.depth)
        fail("the coordinates of a " + object.type + " are nested " +
                 std::to_string(object.coordinates_depth) + " deep, not " + std::to_string(known.depth),
             "see RFC 7946, section 3.1");
      if (known.vertices) lines_vertices_ += file_.set.points.size() - object.first_point;
      take_lines(known);
      return;
    }
    fail("an object has \"coordinates\" and the type \"" + object.type + "\", which is no geometry",
         "see RFC 7946, section 3.1");
  }

  const std::string& source_;
  const std::size_t& line_;
  PointsFile file_;
  std::vector<Object> objects_;
  std::size_t coordinates_depth_ = 0;  ///< open arrays of coordinates
  std::optional<std::size_t> points_depth_;
  std::vector<double> position_;              ///< of the point being read
  std::array<std::size_t, 5> first_point_{};  ///< of the open arrays, by depth
  std::vector<PlanarShapes::Line> lists_;     ///< of the geometry being read
  std::vector<PlanarShapes::Line> lines_;
  std::size_t ring_ = 0;  ///< of its polygon
  std::size_t lines_vertices_ = 0, heights_ = 0;
  bool root_seen_ = false, in_geojson_ = false;
};

PlanarShapes parse_json(std::string_view text, const std::string& source, bool with_lines) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::size_t line = 1;
  PointsHandler handler(source, line);
  std::size_t ignored = 0;
  Json::sax_parse(CountedBytes(text.data(), line), CountedBytes(text.data() + text.size(), ignored),
                  &handler);
  return handler.finish(with_lines);
}

}  // namespace

PointsFile parse_points_json(std::string_view text, const std::string& source) {
  return parse_json(text, source, false).points;
}

PlanarShapes parse_shapes_json(std::string_view text, const std::string& source) {
  return parse_json(text, source, true);
}

}  // namespace leonhard::app
