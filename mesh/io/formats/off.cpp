// SPDX-License-Identifier: MIT
#include <algorithm>

#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

constexpr std::size_t shortest_vertex = 6, shortest_face = 2;

/// The first word: OFF, or OFF after letters for what the vertices carry besides coordinates. A file that forgets the line
/// break after it ("OFF4 4 0") begins with the first count.
/// returns  that count's digits
std::string read_keyword(TextScanner& scan) {
  scan.need_line("the keyword OFF");
  const std::string_view word = scan.word("the keyword OFF");
  const std::string_view keyword = word.substr(0, word.find_first_of("0123456789"));
  const bool known = keyword == "OFF" || keyword == "COFF" || keyword == "NOFF" || keyword == "CNOFF" ||
                     keyword == "STOFF" || keyword == "STNOFF" || keyword == "STCOFF" || keyword == "STCNOFF";
  const std::string_view digits = word.substr(keyword.size());
  if (!known || digits.find_first_not_of("0123456789") != std::string_view::npos)
    scan.fail_found(word, "the keyword OFF");
  if (scan.rest().starts_with("BINARY"))
    scan.fail("the file is a binary one", "only the text form can be read; write it as text, or as .ply");
  return std::string(digits);
}

/// The number of vertices whose digits stand behind the keyword.
std::size_t count_of_digits(TextScanner& scan, const std::string& digits) {
  TextScanner number(digits, scan.source(), {.lines_before = scan.line() - 1});
  number.next_line();
  const std::int64_t count = number.integer("the number of vertices");
  if (static_cast<std::uint64_t>(count) > (scan.bytes_left() + 1) / shortest_vertex)
    scan.fail("the number of vertices is " + digits + ", but the rest of the file cannot hold so many",
              "correct the count, or the file was cut short");
  return static_cast<std::size_t>(count);
}

Point3 read_off_vertex(TextScanner& scan) {
  scan.need_line("a vertex");
  const double x = scan.number("the x coordinate of a vertex");
  const double y = scan.number("the y coordinate of a vertex");
  return {x, y, scan.number("the z coordinate of a vertex")};
}

}  // namespace

SurfaceFile parse_off(std::string_view text, const std::string& source) {
  TextScanner scan(text, source, {.comment = '#'});
  SurfaceBuilder surface(source, 0);
  const std::string digits = read_keyword(scan);
  if (digits.empty()) scan.need_word("the number of vertices");
  const std::size_t vertices =
      digits.empty() ? scan.count("the number of vertices", shortest_vertex) : count_of_digits(scan, digits);
  const std::size_t faces = scan.count("the number of faces", shortest_face);
  if (!scan.line_done()) scan.integer("the number of edges");
  scan.expect_line_end("the counts");

  surface.reserve_points(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    surface.add_point(read_off_vertex(scan));
    while (!scan.line_done()) scan.number("a colour or a normal of a vertex");
  }
  for (std::size_t i = 0; i < faces; ++i) {
    scan.need_line("a face");
    const std::size_t corners = scan.count("the number of corners of a face", 1);
    for (std::size_t k = 0; k < corners; ++k) surface.add_corner(scan.integer("a corner of the face"));
    while (!scan.line_done()) scan.number("a colour of the face");
    surface.end_polygon(scan.line());
  }
  if (scan.next_line())
    scan.fail("found " + in_quotes(scan.rest()) + " after the last face", "correct the counts");
  return std::move(surface).finish();
}

}  // namespace leonhard::io
