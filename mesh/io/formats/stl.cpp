// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <numeric>
#include <tuple>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/text/byte_reader.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

// A binary file: 80 bytes of anything, a count, and for each triangle a normal, three corners and two spare bytes.
constexpr std::size_t header_bytes = 80, count_end = header_bytes + 4, triangle_bytes = 50;

/// The declared number of triangles of a binary file.
std::uint64_t binary_count(std::string_view bytes) {
  return number_at<std::uint32_t>(bytes.data() + header_bytes, little_endian_is_foreign);
}

bool is_binary(std::string_view bytes) {
  if (bytes.size() >= count_end && count_end + triangle_bytes * binary_count(bytes) == bytes.size())
    return true;
  const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const std::string_view text = bytes.substr(first);
  return !text.starts_with("solid") && !text.starts_with("SOLID") && !text.starts_with("Solid");
}

/// Three points a triangle.
std::vector<Point3> binary_corners(std::string_view bytes, const std::string& source) {
  if (bytes.size() < count_end)
    throw InputError(source, "is neither a text that begins with solid nor long enough for a binary STL file",
                     "was it written completely?");
  const std::uint64_t count = binary_count(bytes);
  const bool looks_like_text =
      std::all_of(bytes.begin(), bytes.begin() + std::min<std::ptrdiff_t>(std::ssize(bytes), 512),
                  [](char c) { return c == '\t' || c == '\n' || c == '\r' || (c >= ' ' && c < '\x7f'); });
  if (count_end + triangle_bytes * count != bytes.size() && looks_like_text)
    throw InputError(source, "is a text that does not begin with solid", "give an STL file");
  if (count_end + triangle_bytes * count != bytes.size())
    throw InputError(source,
                     "declares " + std::to_string(count) + " triangles, which take " +
                         std::to_string(count_end + triangle_bytes * count) + " bytes, but has " +
                         std::to_string(bytes.size()),
                     "the file was cut short, or is no STL file");
  ByteReader reader(bytes, source, count_end, little_endian_is_foreign);
  std::vector<Point3> corners;
  corners.reserve(3 * count);
  for (std::uint64_t t = 0; t < count; ++t) {
    for (int i = 0; i < 3; ++i) reader.take<float>("a normal");
    for (int i = 0; i < 3; ++i) {
      const float x = reader.take<float>("a coordinate"), y = reader.take<float>("a coordinate");
      corners.push_back({x, y, reader.take<float>("a coordinate")});
    }
    reader.take<std::uint16_t>("the attribute of a triangle");
  }
  return corners;
}

/// Walks over the words of a text, which are keywords in small or capital letters.
class StlText {
 public:
  StlText(std::string_view text, const std::string& source) : scan_(text, source, {}) {}

  std::vector<Point3> read() {
    scan_.need_line("solid");
    do {
      expect("solid");  // its name follows, to the end of the line
      scan_.need_line("facet or endsolid");
      while (!at("endsolid") && !at("end")) read_facet();
    } while (scan_.next_line());
    return std::move(corners_);
  }

 private:
  static bool same(std::string_view word, std::string_view keyword) {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(a))) == b;
    });
  }

  [[nodiscard]] bool at(std::string_view keyword) const {
    return same(scan_.rest().substr(0, scan_.rest().find_first_of(" \t")), keyword);
  }

  void expect(const char* keyword) {
    scan_.need_word(keyword);
    const std::string_view word = scan_.word(keyword);
    if (!same(word, keyword)) scan_.fail_found(word, keyword);
  }

  void read_facet() {
    expect("facet");
    expect("normal");
    for (int i = 0; i < 3; ++i) scan_.word("a component of the normal");  // often NaN, and not needed
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      const double x = scan_.number("an x coordinate"), y = scan_.number("a y coordinate");
      corners_.push_back({x, y, scan_.number("a z coordinate")});
    }
    expect("endloop");
    expect("endfacet");
    scan_.need_line(
        "facet or endsolid");  // what else stands on the line, such as a colour, says nothing here
  }

  TextScanner scan_;
  std::vector<Point3> corners_;
};

/// Every corner's number among the places, which are numbered in the order in which they first come.
std::vector<std::size_t> number_places(const std::vector<Point3>& corners) {
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Point3 &p = corners[a], &q = corners[b];
    return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
  });
  std::vector<std::size_t> first_of(corners.size()), numbers(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first_of[order[i]] =
        i > 0 && corners[order[i]] == corners[order[i - 1]] ? first_of[order[i - 1]] : order[i];
  std::size_t places = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    numbers[i] = first_of[i] == i ? places++ : numbers[first_of[i]];
  return numbers;
}

void refuse_what_is_not_finite(const std::vector<Point3>& corners, const std::string& source) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!is_finite(corners[i]))
      throw InputError(source, "triangle " + std::to_string(i / 3) + " has a coordinate that is not finite",
                       "NaN and infinities are bad input; find out what wrote them");
}

}  // namespace

SurfaceFile parse_stl(std::string_view bytes, const std::string& source) {
  const std::vector<Point3> corners =
      is_binary(bytes) ? binary_corners(bytes, source) : StlText(bytes, source).read();
  refuse_what_is_not_finite(corners, source);
  const std::vector<std::size_t> numbers = number_places(corners);
  SurfaceBuilder surface(source, 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (numbers[i] == surface.point_count()) surface.add_point(corners[i]);
    surface.add_corner(static_cast<std::int64_t>(numbers[i]));
    if (i % 3 == 2) surface.end_polygon(0);
  }
  return std::move(surface).finish();
}

}  // namespace leonhard::io
