// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/point_set.hpp"

/// What the files of Triangle and TetGen share: numbered entries, vertices. Not meant for callers of the room.
namespace leonhard::io {

inline constexpr TextSyntax triangle_syntax{.comment = '#'};
/// Bytes of "1 0 0" and a line break: a vertex, segment, hole or triangle.
inline constexpr std::size_t shortest_entry = 6;

/// The vertices of a .node file or of the first part of a .poly file.
template <class Point>
struct VertexTable : PointSetOf<Point> {
  std::int64_t first_number = 0;

  /// 0-based index of the vertex that the next word of the line numbers.
  std::size_t read_reference(TextScanner& scan, const char* expected) const;
};

/// Header and vertices; the scanner stays on the last vertex's line.
/// throws InputError if the file is of the other dimension
template <class Point>
[[nodiscard]] VertexTable<Point> read_vertices(TextScanner& scan);

/// Entries carry their number, counted from the first one's.
void check_number(TextScanner& scan, const char* entry, std::int64_t expected);
void skip_attributes(TextScanner& scan, std::size_t count);
/// An optional flag at the end of a header line, 0 where it is missing.
[[nodiscard]] bool read_flag(TextScanner& scan, const char* expected);
/// throws InputError if anything follows
void expect_end(TextScanner& scan, const char* last);

/// Numbers with a blank after each; end_line makes the last one a line break.
void append_words(std::string& text, std::initializer_list<std::int64_t> numbers);
void append_point(std::string& text, Point2 p);
void append_point(std::string& text, const Point3& p);
void end_line(std::string& text);

/// Header and vertices, numbered from 0.
///
/// attributes  as many for each point as it is long in points; or empty
/// markers     one a point, or empty
template <class Point>
void append_vertices(std::string& text, const std::vector<Point>& points, std::span<const double> attributes,
                     std::span<const Marker> markers);

/// The text of an .ele file, numbered from 0: corners, and regions unless there are none.
template <class CellId, std::size_t corner_count>
[[nodiscard]] std::string format_ele(const PerId<CellId, std::array<VertexId, corner_count>>& corners,
                                     const PerId<CellId, double>& regions) {
  std::string text;
  append_words(text, {std::ssize(corners.flat()), corner_count, regions.empty() ? 0 : 1});
  end_line(text);
  for (const CellId cell : corners.ids()) {
    append_words(text, {static_cast<std::int64_t>(cell.index())});
    for (const VertexId v : corners[cell]) append_words(text, {static_cast<std::int64_t>(v.index())});
    if (!regions.empty()) append_number(text, regions[cell]);
    end_line(text);
  }
  return text;
}

/// The text of a .neigh file, numbered from 0; -1 where there is no neighbour.
template <class CellId, std::size_t side_count>
[[nodiscard]] std::string format_neigh(
    const PerId<CellId, std::array<MaybeId<CellId>, side_count>>& neighbours) {
  std::string text;
  append_words(text, {std::ssize(neighbours.flat()), side_count});
  end_line(text);
  for (const CellId cell : neighbours.ids()) {
    append_words(text, {static_cast<std::int64_t>(cell.index())});
    for (const MaybeId<CellId> n : neighbours[cell])
      append_words(text, {n ? static_cast<std::int64_t>((*n).index()) : -1});
    end_line(text);
  }
  return text;
}

}  // namespace leonhard::io
