// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/pslg.hpp"

/// What SU2 meshes of the plane and of space have in common. Not meant for callers of the room.
namespace leonhard::io {

/// The tag of a marker without a name.
[[nodiscard]] std::string su2_unnamed_tag(Marker marker);

/// The tags under which markers are written: their names, or else su2_unnamed_tag.
/// throws InputError if two markers share a tag, or one cannot stand in a file
[[nodiscard]] std::map<Marker, std::string> su2_tags(const std::map<Marker, std::string>& names,
                                                     const std::set<Marker>& used);

/// One zone of a file.
struct Su2Zone {
  std::string_view text;
  std::size_t lines_before = 0;  ///< of the file
};

/// The zone that is asked for, or the only one.
/// throws  InputError if there is no such zone; listing them, if there are several and none is asked for
[[nodiscard]] Su2Zone find_su2_zone(std::string_view text, const std::string& source,
                                    std::optional<std::size_t> zone);

/// What NDIME= says. throws  InputError if it is missing or neither 2 nor 3
[[nodiscard]] int su2_dimension(const Su2Zone& zone, const std::string& source);

/// Reads the sections of an SU2 file in any order; what cells, points and boundary elements look like is up to the
/// dimension.
class Su2Parser {
 public:
  Su2Parser(const Su2Parser&) = delete;
  Su2Parser& operator=(const Su2Parser&) = delete;

 protected:
  /// text       of the file, where notes on markers are
  /// zone       of it, which is read
  /// dimension  2 or 3, which the zone must have
  Su2Parser(std::string_view text, const Su2Zone& zone, const std::string& source, int dimension);
  ~Su2Parser() = default;

  /// All sections; then the markers have their numbers, and names() and warnings() are complete.
  void read_sections();

  /// The next words as a vertex id, whose range is checked later.
  VertexId read_vertex(const char* expected);
  /// The next words as coordinates, a Point2 or Point3.
  template <class Point>
  Point read_point() {
    const double x = scan_.number("the x coordinate of a point"),
                 y = scan_.number("the y coordinate of a point");
    if constexpr (std::is_same_v<Point, Point2>) {
      return {x, y};
    } else {
      return {x, y, scan_.number("the z coordinate of a point")};
    }
  }
  TextScanner& scan() { return scan_; }
  std::map<Marker, std::string>& names() { return notes_; }
  std::vector<std::string>& warnings() { return warnings_; }

 private:
  /// A cell after its number in the file; the scanner stands on its type.
  virtual void read_cell(std::size_t index) = 0;
  virtual void read_coordinates() = 0;
  /// An element of the boundary other than a vertex; the scanner stands on its type.
  virtual void read_boundary_element(const std::string& tag, Marker marker) = 0;
  virtual void reserve(std::size_t cells, std::size_t points) = 0;
  /// Replace every marker m by number_of_tag[m - 1].
  virtual void renumber(const std::vector<Marker>& number_of_tag) = 0;

  void read_section(const std::string& keyword);
  void read_dimension();
  void need_entry(const char* entry, std::size_t index, std::size_t count);
  void compare_number(const char* entry, std::size_t index, std::int64_t number);
  void read_point_numbers(std::size_t index);
  void check_height(double z, std::size_t index);
  void read_cells();
  void read_points();
  void read_marker_count();
  void read_marker();
  void pass_over_halo();
  std::string read_tag();
  void check_complete() const;
  void number_markers();

  TextScanner scan_;
  int dimension_;
  std::map<Marker, std::string> notes_;
  std::set<std::string> sections_;
  std::vector<std::string> tags_;
  std::size_t marker_count_ = 0, halo_markers_ = 0;
  std::optional<double> height_;  ///< the third coordinate of points of the plane
  bool skipping_ = false;         ///< inside a section that is not known
  bool number_warned_ = false;    ///< one warning about entry numbers is enough
  std::vector<std::string> warnings_;
};

}  // namespace leonhard::io
