// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// What a neutral map file says of the sides of structured blocks. Not meant for callers of the room.
namespace leonhard::io {

/// A side of a block of the plane.
enum class BlockSide { i_min, i_max, j_min, j_max };

/// Points and cells of a block of the plane.
struct BlockSize {
  std::size_t i{}, j{};  ///< points in either direction
  friend bool operator==(const BlockSize&, const BlockSize&) = default;
};

/// A run of points along a side, by their numbers from 0; to may be less than from.
struct SideRange {
  std::size_t block{};
  BlockSide side{};
  std::size_t from{}, to{};

  [[nodiscard]] std::size_t point_count() const { return (from < to ? to - from : from - to) + 1; }
};

struct NeutralMap {
  struct Patch {
    std::string name;  ///< of the boundary condition, e.g. "viscous_solid"
    SideRange range;
    std::size_t line;  ///< of the file
  };
  struct Join {
    std::array<SideRange, 2> ranges;  ///< the same points, in the same order
    std::size_t line;
  };
  std::vector<Patch> patches;
  std::vector<Join> joins;
};

/// Read a neutral map file (.nmf; NASA Langley, GEOLAB, https://geolab.larc.nasa.gov/Volume/Doc/nmf.htm): blocks with
/// their dimensions, then a line a patch: its type, block, face, and two ranges of points; after the type ONE_TO_ONE the
/// same again for the other side. # begins a comment.
///
/// Blocks with KDIM = 1 are those of a grid of the plane, whose faces are numbered i min, i max, j min, j max. Blocks with two
/// points in one direction are such a grid moved along that direction; their faces are numbered k min, k max, i min, i max, j
/// min, j max, and those that show the grid itself say nothing here.
///
/// sizes   the blocks of the grid
/// throws  InputError naming file and line: other blocks than the grid's, faces and points that there are not, joined sides
///         of unlike numbers of points, a file cut short
[[nodiscard]] NeutralMap parse_neutral_map(std::string_view text, const std::string& source,
                                           const std::vector<BlockSize>& sizes);

}  // namespace leonhard::io
