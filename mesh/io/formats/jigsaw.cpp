// SPDX-License-Identifier: MIT
#include <cctype>

#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

std::string capitals(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

class JigsawParser {
 public:
  // Semicolons separate the numbers of a line; TextScanner passes over them as over blanks.
  JigsawParser(std::string_view text, const std::string& source)
      : scan_(text, source, {.comment = '#', .extra_blank = ';'}), surface_(source, 0) {}

  SurfaceFile parse() {
    bool skipping = false;
    while (scan_.next_line()) {
      if (!scan_.at_key()) {
        if (skipping) continue;
        scan_.fail_found(scan_.rest(), "a keyword (MSHID=, NDIMS=, POINT=, TRIA3=)");
      }
      const std::string keyword = capitals(scan_.key("a keyword"));
      skipping = !read_section(keyword);
      if (skipping) surface_.warn(scan_.where() + ": the section " + keyword + "= was passed over");
    }
    return std::move(surface_).finish();
  }

 private:
  /// returns whether the section is known
  bool read_section(const std::string& keyword) {
    if (keyword == "MSHID") return true;
    if (keyword == "NDIMS") return read_dimension(), true;
    if (keyword == "POINT") return read_points(), true;
    if (keyword == "TRIA3") return read_triangles(), true;
    return false;
  }

  void read_dimension() {
    const std::int64_t dimension = scan_.integer("the dimension");
    if (dimension != 3)
      scan_.fail("NDIMS=" + std::to_string(dimension), "only files of space can be read here");
  }

  void read_points() {
    const std::size_t count = scan_.count("the number of points", 6);
    surface_.reserve_points(count);
    for (std::size_t i = 0; i < count; ++i) {
      scan_.need_line("a point");
      const double x = scan_.number("the x coordinate of a point"),
                   y = scan_.number("the y coordinate of a point");
      surface_.add_point({x, y, scan_.number("the z coordinate of a point")});
      scan_.integer32("the tag of a point");
      scan_.expect_line_end("the point");
    }
  }

  void read_triangles() {
    const std::size_t count = scan_.count("the number of triangles", 8);
    for (std::size_t i = 0; i < count; ++i) {
      scan_.need_line("a triangle");
      for (int k = 0; k < 3; ++k) surface_.add_corner(scan_.integer("a corner of a triangle"));
      surface_.end_polygon(scan_.line(), scan_.integer32("the tag of a triangle"));
      scan_.expect_line_end("the triangle");
    }
  }

  TextScanner scan_;
  SurfaceBuilder surface_;
};

}  // namespace

SurfaceFile parse_jigsaw(std::string_view text, const std::string& source) {
  return JigsawParser(text, source).parse();
}

}  // namespace leonhard::io
