// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// Read a formatted grid of the plane of PLOT3D (Walatka, Buning, Pierce and Elson, NASA TM 101067, 1990, chapter 8): the
/// number of blocks, which may be left out if there is one, the points of each block in either direction, then block after
/// block all x and all y, i fastest. NASA's turbulence modelling resource has such grids as .p2dfmt.
///
/// Cells are quadrilaterals; where a side of a block is drawn together to a point, triangles. Blocks that turn the other way
/// are turned over. Which sides are joined and what the others are called
/// - says a neutral map beside it (parse_neutral_map), of the same name with the extension .nmf: sides that are ONE_TO_ONE
///   are joined point by point, the others get their types as markers' names, one marker a type, in the map's order. Where
///   joined points are not equal the first one is taken, which a warning tells;
/// - or, without a map, the coordinates: points of sides are joined where they are equal (the cut behind an airfoil). The
///   other parts of sides get the markers 1, 2, ..., named i_min, i_max, j_min, j_max, of several blocks
///   block_2_i_min and so on.
/// Points are numbered as in the file, those that are joined to earlier ones left out.
///
/// throws  InputError naming file and line, block and point: counts that the file cannot hold, what is no number, text behind
///         the last one; joined points farther apart than the edges at them; and as read_mixed_mesh
/// Cost O(file size + cells log cells).
[[nodiscard]] MixedMeshFile<2> read_plot3d(const std::filesystem::path& path);

/// The same from text in memory.
///
/// map_text, map_source  the map, if map_source is not empty
[[nodiscard]] MixedMeshFile<2> parse_plot3d(std::string_view text, const std::string& source,
                                            std::string_view map_text = {},
                                            const std::string& map_source = {});

/// What such a file states, with the map beside it if there is one.
[[nodiscard]] MeshSoup<2> read_plot3d_soup(const std::filesystem::path& path);

}  // namespace leonhard::io
