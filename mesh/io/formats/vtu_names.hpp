// SPDX-License-Identifier: MIT
#pragma once

/// Names of the arrays by which write_vtu and read_vtu carry what VTK has no place for.
namespace leonhard::io::vtu_names {

inline constexpr const char* vertex_marker = "marker";               ///< point data
inline constexpr const char* cell_marker = "marker";                 ///< cell data, of facets
inline constexpr const char* other_cell_marker = "leonhard_marker";  ///< the same, where a field is called so
inline constexpr const char* region = "region";                      ///< cell data
inline constexpr const char* components = "leonhard_components";     ///< attribute of arrays
inline constexpr const char* facets =
    "leonhard_facets";  ///< field data: how many cells are the boundary, and inner facets
inline constexpr const char* marker_numbers = "leonhard_marker_numbers";  ///< field data
inline constexpr const char* marker_names =
    "leonhard_marker_names";  ///< field data: bytes, each name 0-ended
inline constexpr const char* region_numbers = "leonhard_region_numbers";  ///< likewise of regions
inline constexpr const char* region_names = "leonhard_region_names";

}  // namespace leonhard::io::vtu_names
