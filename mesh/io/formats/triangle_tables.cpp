// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/triangle_tables.hpp"

#include "leonhard/mesh/io/number_text.hpp"

namespace leonhard::io {

namespace {

Point2 read_point(TextScanner& scan, Point2 /*of this kind*/) {
  const double x = scan.number("the x coordinate of a vertex");
  return {x, scan.number("the y coordinate of a vertex")};
}

Point3 read_point(TextScanner& scan, const Point3& /*of this kind*/) {
  const Point2 xy = read_point(scan, Point2{});
  return {xy.x, xy.y, scan.number("the z coordinate of a vertex")};
}

void check_dimension(TextScanner& scan, std::int64_t wanted) {
  const std::int64_t dimension = scan.integer("the dimension (2 or 3)");
  if (dimension != wanted)
    scan.fail("the dimension is " + std::to_string(dimension) + ": only files of " +
              (wanted == 2 ? "the plane" : "space") + " can be read here");
}

template <class Point>
constexpr std::int64_t dimension_of = sizeof(Point) / sizeof(double);

}  // namespace

template <class Point>
std::size_t VertexTable<Point>::read_reference(TextScanner& scan, const char* expected) const {
  const std::int64_t number = scan.integer(expected);
  const std::int64_t index = number - first_number;
  if (index < 0 || static_cast<std::uint64_t>(index) >= this->points.size())
    scan.fail("vertex " + std::to_string(number) + " does not exist, the file has vertices " +
                  std::to_string(first_number) + " to " +
                  std::to_string(first_number + static_cast<std::int64_t>(this->points.size()) - 1),
              "correct the number, or add the vertex");
  return static_cast<std::size_t>(index);
}

void check_number(TextScanner& scan, const char* entry, std::int64_t expected) {
  const std::int64_t number = scan.integer("the number of the entry");
  if (number != expected)
    scan.fail(std::string(entry) + " " + std::to_string(number) + " stands where " + entry + " " +
                  std::to_string(expected) + " was expected",
              "entries are numbered in order from 0 or 1; is a line missing or repeated?");
}

void skip_attributes(TextScanner& scan, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) scan.number("an attribute");
}

bool read_flag(TextScanner& scan, const char* expected) {
  if (scan.line_done()) return false;
  const std::int64_t flag = scan.integer(expected);
  if (flag != 0 && flag != 1)
    scan.fail(std::string(expected) + " is " + std::to_string(flag) + ", not 0 or 1");
  return flag == 1;
}

template <class Point>
VertexTable<Point> read_vertices(TextScanner& scan) {
  VertexTable<Point> table;
  scan.need_line("the number of vertices");
  const std::size_t count = scan.count("the number of vertices", shortest_entry);
  check_dimension(scan, dimension_of<Point>);
  table.attributes_each = scan.line_done() ? 0 : scan.count("the number of attributes", 1);
  const bool with_markers = read_flag(scan, "the number of boundary markers");
  scan.expect_line_end("the header of the vertices");

  table.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a vertex");
    if (i == 0) {
      table.first_number = scan.integer("the number of the first vertex");
      if (table.first_number != 0 && table.first_number != 1)
        scan.fail("the first vertex has the number " + std::to_string(table.first_number) + ", not 0 or 1");
    } else {
      check_number(scan, "vertex", table.first_number + static_cast<std::int64_t>(i));
    }
    table.points.push_back(read_point(scan, Point{}));
    for (std::size_t k = 0; k < table.attributes_each; ++k)
      table.attributes.push_back(scan.number("an attribute"));
    if (with_markers) table.markers.push_back(scan.integer32("the boundary marker of a vertex"));
    scan.expect_line_end("the vertex");
  }
  return table;
}

void expect_end(TextScanner& scan, const char* last) {
  if (scan.next_line()) scan.fail("found " + in_quotes(scan.rest()) + " after " + last, "correct the counts");
}

void append_words(std::string& text, std::initializer_list<std::int64_t> numbers) {
  for (const std::int64_t number : numbers) {
    append_number(text, number);
    text += ' ';
  }
}

void end_line(std::string& text) {
  if (text.back() == ' ') text.pop_back();
  text += '\n';
}

void append_point(std::string& text, Point2 p) {
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
  text += ' ';
}

void append_point(std::string& text, const Point3& p) {
  append_point(text, Point2{p.x, p.y});
  append_number(text, p.z);
  text += ' ';
}

template <class Point>
void append_vertices(std::string& text, const std::vector<Point>& points, std::span<const double> attributes,
                     std::span<const Marker> markers) {
  const std::size_t each = points.empty() ? 0 : attributes.size() / points.size();
  append_words(text, {std::ssize(points), dimension_of<Point>, static_cast<std::int64_t>(each),
                      markers.empty() ? 0 : 1});
  end_line(text);
  for (std::size_t i = 0; i < points.size(); ++i) {
    append_words(text, {static_cast<std::int64_t>(i)});
    append_point(text, points[i]);
    for (const double attribute : attributes.subspan(i * each, each)) {
      append_number(text, attribute);
      text += ' ';
    }
    if (!markers.empty()) append_words(text, {markers[i]});
    end_line(text);
  }
}

template struct VertexTable<Point2>;
template struct VertexTable<Point3>;
template VertexTable<Point2> read_vertices(TextScanner&);
template VertexTable<Point3> read_vertices(TextScanner&);
template void append_vertices(std::string&, const std::vector<Point2>&, std::span<const double>,
                              std::span<const Marker>);
template void append_vertices(std::string&, const std::vector<Point3>&, std::span<const double>,
                              std::span<const Marker>);

}  // namespace leonhard::io
