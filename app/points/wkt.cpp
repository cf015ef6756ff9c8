// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "leonhard/app/points/planar_shapes.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::app {
namespace {

/// How deep the brackets of a geometry are, and what a list of positions in it is.
struct WktGeometry {
  std::string_view name;
  std::size_t depth;
  bool lines, rings;
};
constexpr std::array wkt_geometries{
    WktGeometry{"POINT", 1, false, false},     WktGeometry{"MULTIPOINT", 2, false, false},
    WktGeometry{"LINESTRING", 1, true, false}, WktGeometry{"MULTILINESTRING", 2, true, false},
    WktGeometry{"POLYGON", 2, true, true},     WktGeometry{"MULTIPOLYGON", 3, true, true},
    WktGeometry{"TRIANGLE", 2, true, true}};

class WktParser {
 public:
  WktParser(std::string_view text, const std::string& source) : text_(text), source_(source) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  PlanarShapes parse() {
    while (skip_blanks(), at_ < text_.size()) {
      if (text_[at_] == ';' || text_[at_] == ',' || text_[at_] == '"') {
        ++at_;
      } else {
        read_geometry();
      }
    }
    if (shapes_.points.set.points.empty())
      fail("no point was found", "give POLYGON ((0 0, 1 0, 0 1, 0 0)) or the like");
    if (heights_ > 0)
      shapes_.points.warnings.push_back(source_ + ": the heights of " + std::to_string(heights_) +
                                        " points were left out");
    return std::move(shapes_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    const auto line =
        1 + std::count(text_.begin(),
                       text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size())), '\n');
    throw InputError(at_line(source_, static_cast<std::size_t>(line)), problem, remedy);
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  [[nodiscard]] bool at(char c) {
    skip_blanks();
    return at_ < text_.size() && text_[at_] == c;
  }
  void expect(char c) {
    if (!at(c))
      fail(at_ < text_.size()
               ? "found " + io::in_quotes(text_.substr(at_, 1)) + " where " + c + " was expected"
               : std::string("the text ends where ") + c + " was expected",
           "brackets do not match, or the text was cut short");
    ++at_;
  }

  std::string word() {
    skip_blanks();
    std::string letters;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0)
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    return letters;
  }

  void read_geometry() {
    const std::size_t begin = at_;
    std::string name = word();
    if (name == "SRID") {
      while (at_ < text_.size() && text_[at_] != ';') ++at_;
      if (at_ < text_.size()) ++at_;
      name = word();
    }
    for (std::string more = word(); !more.empty(); more = word())
      if (more == "EMPTY") return;  // Z, M and ZM say what the positions show
    while (name.size() > 4 && (name.back() == 'Z' || name.back() == 'M')) name.pop_back();
    if (name == "GEOMETRYCOLLECTION") {
      expect('(');
      do {
        read_geometry();
      } while (at(',') && ++at_ > 0);
      return expect(')');
    }
    const auto known = std::find_if(wkt_geometries.begin(), wkt_geometries.end(),
                                    [&](const WktGeometry& geometry) { return geometry.name == name; });
    if (known == wkt_geometries.end())
      fail("found " + io::in_quotes(text_.substr(begin, 20)) + " where a geometry was expected",
           "POINT, LINESTRING, POLYGON, their MULTI forms and GEOMETRYCOLLECTION can be read");
    read_brackets(*known, known->depth, 0);
  }

  /// index  of this bracket within the one about it
  void read_brackets(const WktGeometry& geometry, std::size_t depth, std::size_t index) {
    if (depth > 1) {
      expect('(');
      std::size_t inner = 0;
      do {
        if (geometry.name == "MULTIPOINT" && !at('(')) {
          read_position();
        } else {
          read_brackets(geometry, depth - 1, inner++);
        }
      } while (at(',') && ++at_ > 0);
      return expect(')');
    }
    expect('(');
    std::vector<Point2>& points = shapes_.points.set.points;
    PlanarShapes::Line line{points.size(), 0, geometry.rings, geometry.rings && index > 0};
    do {
      read_position();
    } while (at(',') && ++at_ > 0);
    expect(')');
    if (geometry.rings && points.size() > line.first + 1 && points.back() == points[line.first])
      points.pop_back();
    line.end = points.size();
    if (geometry.lines) shapes_.lines.push_back(line);
  }

  void read_position() {
    const double x = number(), y = number();
    if (skip_blanks(), at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')') {
      number();
      ++heights_;
      if (skip_blanks(), at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')') number();
    }
    shapes_.points.set.points.push_back({x, y});
  }

  double number() {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n,()", at_), text_.size());
    double value = 0;
    const std::string_view found = text_.substr(at_, end - at_);
    if (io::parse_number(found, value) != io::NumberFault::none)
      fail("found " + io::in_quotes(found) + " where a coordinate was expected", "write a finite number");
    at_ = end;
    return value;
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0, heights_ = 0;
  PlanarShapes shapes_;
};

}  // namespace

PlanarShapes parse_wkt(std::string_view text, const std::string& source) {
  return WktParser(text, source).parse();
}

}  // namespace leonhard::app
