// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include "leonhard/graph/graph_file.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::graph {
namespace {

/// Two or three coordinates, as many as on every other line.
Point3 read_point(io::TextScanner& scan, std::uint32_t& dimension) {
  std::array<double, 3> at{};
  std::uint32_t count = 0;
  while (count < 3 && !scan.line_done()) at[count++] = scan.number("a coordinate");
  scan.expect_line_end("a vertex's coordinates");
  if (dimension == 0) dimension = count;
  if (count != dimension)
    scan.fail("the line has " + std::to_string(count) + " coordinates, those before it " +
                  std::to_string(dimension),
              "give two or three on every line");
  return {at[0], at[1], at[2]};
}

void fail_count(const io::TextScanner& scan, std::size_t found, std::size_t vertices) {
  scan.fail(std::to_string(found) + " vertices have coordinates, the graph has " + std::to_string(vertices) +
                " vertices",
            "is it the file of another graph?");
}

/// After the dimension: the number of vertices, then number and coordinates of each, numbered from 0 or 1.
void read_scotch(io::TextScanner& scan, std::size_t vertices, VertexCoordinates& result) {
  scan.need_line("the number of vertices");
  const std::size_t declared = scan.count("the number of vertices", 2);
  scan.expect_line_end("the number of vertices");
  if (declared != vertices) fail_count(scan, declared, vertices);
  result.points.resize(vertices);
  std::vector<char> given(vertices, 0);
  std::int64_t first_number = 0;
  for (std::size_t i = 0; i < vertices; ++i) {
    scan.need_line("a vertex's coordinates");
    const std::int64_t number = scan.integer("a vertex's number");
    if (i == 0) first_number = number == 0 ? 0 : 1;
    const std::int64_t v = number - first_number;
    if (v < 0 || static_cast<std::uint64_t>(v) >= vertices || given[static_cast<std::size_t>(v)] != 0)
      scan.fail("vertex " + std::to_string(number) + " is repeated or does not exist",
                "give each vertex once, numbered from 0 or 1");
    given[static_cast<std::size_t>(v)] = 1;
    result.points[static_cast<std::size_t>(v)] = read_point(scan, result.dimension);
  }
  if (scan.next_line()) scan.fail("found a line after the last vertex's", "correct the number of vertices");
}

/// Whether the line at hand holds a single word.
bool holds_one_word(const io::TextScanner& scan) {
  return scan.rest().find_first_of(" \t") == std::string_view::npos;
}

}  // namespace

VertexCoordinates parse_coordinates(std::string_view text, const std::string& source, std::size_t vertices) {
  io::TextScanner scan(text, source, {.comment = '#'});
  VertexCoordinates result;
  scan.need_line("a vertex's coordinates");
  if (holds_one_word(scan)) {
    const std::int64_t dimension = scan.integer("the dimension");
    if (dimension != 2 && dimension != 3)
      scan.fail("the dimension is " + std::to_string(dimension), "coordinates of 2 or 3 dimensions are read");
    result.dimension = static_cast<std::uint32_t>(dimension);
    read_scotch(scan, vertices, result);
    return result;
  }
  do {
    result.points.push_back(read_point(scan, result.dimension));
  } while (scan.next_line());
  if (result.points.size() != vertices) fail_count(scan, result.points.size(), vertices);
  return result;
}

}  // namespace leonhard::graph
