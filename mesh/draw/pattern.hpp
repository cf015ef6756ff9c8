// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "leonhard/mesh/draw/picture.hpp"

/// Pictures of sparse matrices. Format, errors and determinism as in mesh_picture.hpp.
namespace leonhard::draw {

/// Where a square sparse matrix is not zero, as compressed sparse rows: the columns of row i are
/// links[offsets[i]] .. links[offsets[i + 1] - 1], in any order. The spans must outlive the call only.
struct MatrixPattern {
  std::span<const std::uint32_t> offsets{};  ///< rows + 1, from 0, never falling, ending at links.size()
  std::span<const std::uint32_t> links{};    ///< columns, below the number of rows
  std::span<const std::uint32_t>
      order{};                 ///< order[new] = old: rows and columns so renumbered; empty: as they are
  std::string title{};         ///< "reverse Cuthill-McKee"
  std::string subtitle{};      ///< "bandwidth 5305, envelope 2,159,155"
  bool add_diagonal = true;  ///< a graph does not list the diagonal, the matrix has it
};

/// One pattern, or several side by side (before and after an ordering), row 0 at the top. Small matrices show
/// each entry as a square; large ones the density of entries in a pixel, darker where denser, no entry lost.
///
/// throws  InputError for offsets or links out of order or range, naming the row; or an order that is no permutation
/// Cost O(entries + pixels).
void draw_pattern(const std::filesystem::path& path, std::span<const MatrixPattern> patterns,
                  const std::string& title = {}, const PictureSize& size = {});

}  // namespace leonhard::draw
