// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/io/surface_contents.hpp"

namespace leonhard::io {

/// Collects a surface while its file is read; finish() checks what can only be checked at the end, since polygons may
/// come before the points that they name.
class SurfaceBuilder {
 public:
  /// source        names the file in errors
  /// first_number  of the file's vertices, as errors tell them
  SurfaceBuilder(std::string source, std::int64_t first_number)
      : source_(std::move(source)), first_number_(first_number) {}

  void set_points(PointSet3 set, std::int64_t first_number) {
    surface_.set = std::move(set);
    first_number_ = first_number;
  }
  void reserve_points(std::size_t count) { surface_.set.points.reserve(count); }
  void add_point(const Point3& p) { surface_.set.points.push_back(p); }
  [[nodiscard]] std::size_t point_count() const { return surface_.set.points.size(); }

  /// A corner of the polygon in the making, by the file's number.
  void add_corner(std::int64_t number) { corners_.push_back(number - first_number_); }
  /// Ends the polygon. line: of the file, 0 if it has none.
  void end_polygon(std::size_t line, std::optional<Marker> marker = std::nullopt,
                   std::optional<std::size_t> facet = std::nullopt);

  void warn(std::string warning) { surface_.warnings.push_back(std::move(warning)); }

  /// throws InputError: no points, coordinates that are not finite, corners that are no vertices
  [[nodiscard]] SurfaceFile finish() &&;

 private:
  void check_points() const;
  void check_corners() const;

  std::string source_;
  std::int64_t first_number_;
  SurfaceFile surface_;
  std::vector<std::int64_t> corners_;  ///< 0-based, not yet known to exist
  std::vector<std::size_t> lines_;     ///< one a polygon
};

}  // namespace leonhard::io
