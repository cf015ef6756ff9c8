// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/picture.hpp"

/// Pictures of sparse matrices. Format, errors and determinism as in mesh_picture.hpp.
namespace leonhard::draw {

/// Where a square sparse matrix is not zero, as compressed sparse rows: the columns of row i are
/// links[offsets[i]] .. links[offsets[i + 1] - 1], in any order. The spans must outlive the call only.
struct MatrixPattern {
  std::span<const std::size_t> offsets;  ///< rows + 1, from 0, never falling, ending at links.size()
  std::span<const std::uint32_t> links;  ///< columns, below the number of rows
  std::string title;                     ///< "before", "reverse Cuthill-McKee"
  std::string subtitle;                  ///< "bandwidth 5305, envelope 2,159,155"
  bool add_diagonal = true;              ///< the diagonal is there although a graph does not list it
};

/// One pattern, or several side by side (before and after an ordering), row 0 at the top. Small matrices show each
/// entry as a square; large ones the density of entries in a pixel, no entry being lost.
void draw_pattern(const std::filesystem::path& path, std::span<const MatrixPattern> patterns,
                  const std::string& title = {}, const PictureSize& size = {});

}  // namespace leonhard::draw
