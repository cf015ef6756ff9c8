// SPDX-License-Identifier: MIT
#include <charconv>
#include <utility>

#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// x, y, z, perhaps a weight or a colour, which say nothing about where the vertex is.
Point3 read_obj_vertex(TextScanner& scan) {
  const double x = scan.number("the x coordinate of a vertex");
  const double y = scan.number("the y coordinate of a vertex");
  const Point3 p{x, y, scan.number("the z coordinate of a vertex")};
  while (!scan.line_done()) scan.number("a weight or a colour of a vertex");
  return p;
}

/// The vertex of a corner such as 3, 3/1 or 3//2; negative numbers count back from the last vertex so far.
std::int64_t read_corner(TextScanner& scan, std::size_t vertices_so_far) {
  const std::string_view word = scan.word("a corner of a face");
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size())
    scan.fail_found(word, "a corner of a face");
  if (number == 0) scan.fail("a face names vertex 0", "vertices are numbered from 1");
  if (number > 0) return number;
  const std::int64_t counted = static_cast<std::int64_t>(vertices_so_far) + 1 + number;
  if (counted < 1)
    scan.fail("a face names vertex " + std::to_string(number) + ", but only " +
              std::to_string(vertices_so_far) + " vertices come before it");
  return counted;
}

/// A line that ends with a backslash goes on on the next; lines keep their numbers.
std::string with_continued_lines(std::string_view text) {
  std::string joined(text);
  std::size_t breaks = 0;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const bool carriage =
        joined[i] == '\\' && i + 2 < joined.size() && joined[i + 1] == '\r' && joined[i + 2] == '\n';
    if (carriage || (joined[i] == '\\' && i + 1 < joined.size() && joined[i + 1] == '\n')) {
      joined[i] = joined[i + 1] = ' ';
      if (carriage) joined[i + 2] = ' ';
      ++breaks;
    } else if (joined[i] == '\n' && breaks > 0) {
      joined.insert(i, breaks, '\n');
      i += std::exchange(breaks, 0);
    }
  }
  return joined;
}

}  // namespace

SurfaceFile parse_obj(std::string_view text, const std::string& source) {
  const std::string joined = with_continued_lines(text);
  TextScanner scan(joined, source, {.comment = '#'});
  SurfaceBuilder surface(source, 1);
  while (scan.next_line()) {
    const std::string_view keyword = scan.word("a keyword");
    if (keyword == "v") {
      surface.add_point(read_obj_vertex(scan));
    } else if (keyword == "f") {
      std::size_t corners = 0;
      for (; !scan.line_done(); ++corners) surface.add_corner(read_corner(scan, surface.point_count()));
      if (corners < 3)
        scan.fail("a face has " + std::to_string(corners) + " corners", "it needs three or more");
      surface.end_polygon(scan.line());
    }
  }
  return std::move(surface).finish();
}

}  // namespace leonhard::io
