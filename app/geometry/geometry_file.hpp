// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/pslg.hpp"

namespace leonhard::app {

/// A planar straight-line graph from a file, and in words what was left out or decided.
struct GeometryFile {
  Pslg pslg;
  std::vector<std::string> warnings;
};

/// Read a geometry of the plane, format by extension: .poly (Triangle's), .wkt (well-known text), .geojson and .json; .msh and
/// .mesh, the edges with their markers (io::read_pslg) and the holes that follow from them (find_holes); .dat, the sections of
/// airfoils, element i with the marker i; and those of points (.node .xy .xyz .csv .txt), which have no segments. Lines and rings
/// of WKT and JSON become segments, all with the marker 1; a ring within a polygon bounds a hole.
///
/// throws  InputError naming file and line, as the readers do, and naming an outline that crosses itself
[[nodiscard]] GeometryFile read_any_geometry(const std::filesystem::path& path);

/// What read_any_geometry knows.
[[nodiscard]] const std::vector<std::string>& any_geometry_extensions();

/// The points of a file joined one after another, the last with the first: an outline. A last point equal to the first is
/// dropped.
[[nodiscard]] GeometryFile as_outline(GeometryFile points);

}  // namespace leonhard::app
