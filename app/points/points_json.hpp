// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "leonhard/app/points/planar_shapes.hpp"
#include "leonhard/mesh/io/points_file.hpp"

namespace leonhard::app {

/// Points of the plane in a JSON text:
///   [[x, y], ...]  or  [x0, y0, x1, y1, ...]  or  {"points": either of these, ...}
/// or GeoJSON (RFC 7946): the positions of Point and MultiPoint geometries, alone, in features or in collections. The
/// vertices of lines and polygons are taken too, a ring's closing one once, which a warning tells, as it does heights
/// that are left out. Coordinates are taken as they are, whatever their reference system.
///
/// One pass, no tree in memory: 16 bytes a point.
///
/// source  names the text in errors
/// throws  InputError naming file and line: no JSON, NaN, numbers beyond double, points that have not two
///         coordinates, an odd number of coordinates, no point at all
[[nodiscard]] PointsFile parse_points_json(std::string_view text, const std::string& source);

/// The same with the lines and rings of GeoJSON's geometries; then no warning says that points are vertices of them.
[[nodiscard]] PlanarShapes parse_shapes_json(std::string_view text, const std::string& source);

}  // namespace leonhard::app
