// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/vtk_grid.hpp"

#include <algorithm>
#include <utility>

#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {
namespace {

constexpr const char* ghost_array = "vtkGhostType";

/// Arrays that both have, the piece's rows behind the grid's.
void append_arrays(std::vector<VtkNumbers>& arrays, std::vector<VtkNumbers>&& of_piece, bool is_first,
                   const char* rows, std::vector<std::string>& warnings) {
  if (is_first) {
    arrays = std::move(of_piece);
    return;
  }
  const auto drop = [&](const std::string& name) {
    warnings.push_back("the field " + in_quotes(name) + " of " + rows +
                       " was left out: not every piece has it");
  };
  const auto same = [](const VtkNumbers& a) {
    return [&a](const VtkNumbers& b) { return a.name == b.name && a.components == b.components; };
  };
  for (const VtkNumbers& array : of_piece)
    if (std::none_of(arrays.begin(), arrays.end(), same(array))) drop(array.name);
  std::erase_if(arrays, [&](VtkNumbers& array) {
    const auto more = std::find_if(of_piece.begin(), of_piece.end(), same(array));
    if (more == of_piece.end()) return drop(array.name), true;
    array.values.insert(array.values.end(), more->values.begin(), more->values.end());
    array.is_whole = array.is_whole && more->is_whole;
    return false;
  });
}

template <class T>
void keep_marked_rows(std::vector<T>& values, const std::vector<bool>& kept, std::size_t components) {
  std::size_t next = 0;
  for (std::size_t row = 0; row < kept.size(); ++row)
    for (std::size_t k = 0; kept[row] && k < components; ++k)
      values[next++] = std::move(values[row * components + k]);
  values.resize(next);
}

/// Cells that another piece has too.
void drop_ghosts(VtkGrid& piece) {
  const auto ghosts = std::find_if(piece.cell_arrays.begin(), piece.cell_arrays.end(),
                                   [](const VtkNumbers& array) { return array.name == ghost_array; });
  if (ghosts == piece.cell_arrays.end()) return;
  constexpr unsigned duplicate = 1;
  std::vector<bool> kept(piece.cell_count());
  for (std::size_t c = 0; c < kept.size(); ++c)
    kept[c] = (static_cast<unsigned>(ghosts->values[c]) & duplicate) == 0;
  piece.cell_arrays.erase(ghosts);
  if (std::find(kept.begin(), kept.end(), false) == kept.end()) return;
  std::vector<std::int64_t> connectivity, offsets;
  for (std::size_t c = 0; c < kept.size(); ++c) {
    if (!kept[c]) continue;
    const auto vertices = piece.vertices(c);
    connectivity.insert(connectivity.end(), vertices.begin(), vertices.end());
    offsets.push_back(std::ssize(connectivity));
  }
  piece.connectivity = std::move(connectivity);
  piece.offsets = std::move(offsets);
  keep_marked_rows(piece.types, kept, 1);
  for (VtkNumbers& array : piece.cell_arrays) keep_marked_rows(array.values, kept, array.components);
}

bool is_of_space(std::int64_t type) {
  const auto kind = vtk_kind_of(type);
  return kind && kind->dimension == 3;
}

}  // namespace

void append_piece(VtkGrid& grid, VtkGrid&& piece) {
  const bool is_first = grid.points.empty() && grid.types.empty();
  drop_ghosts(piece);
  const std::int64_t first_point = std::ssize(grid.points), first_corner = std::ssize(grid.connectivity);
  grid.points.insert(grid.points.end(), piece.points.begin(), piece.points.end());
  grid.types.insert(grid.types.end(), piece.types.begin(), piece.types.end());
  for (const std::int64_t v : piece.connectivity) grid.connectivity.push_back(v + first_point);
  for (const std::int64_t end : piece.offsets) grid.offsets.push_back(end + first_corner);
  append_arrays(grid.point_arrays, std::move(piece.point_arrays), is_first, "points", grid.warnings);
  append_arrays(grid.cell_arrays, std::move(piece.cell_arrays), is_first, "cells", grid.warnings);
  if (is_first) {
    grid.points_line = piece.points_line;
    grid.cells_line = piece.cells_line;
    grid.own_facets = piece.own_facets;
    grid.marker_names = std::move(piece.marker_names);
    grid.region_names = std::move(piece.region_names);
  } else {
    grid.own_facets.reset();  // whoever made pieces of a file may have doubled facets
  }
  grid.warnings.insert(grid.warnings.end(), piece.warnings.begin(), piece.warnings.end());
}

void join_pieces(VtkGrid& grid, const std::vector<std::size_t>& first_points) {
  const auto piece_of = [&](std::size_t p) {
    return std::upper_bound(first_points.begin(), first_points.end(), p) - first_points.begin();
  };
  std::vector<std::size_t> order(grid.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(grid.points[a], a) < std::pair(grid.points[b], b);
  });
  std::vector<std::size_t> stands_for(order.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    bool one_a_piece = true;
    for (end = begin + 1; end < order.size() && grid.points[order[end]] == grid.points[order[begin]]; ++end)
      one_a_piece = one_a_piece && piece_of(order[end]) != piece_of(order[end - 1]);
    for (std::size_t i = begin; i < end; ++i) stands_for[order[i]] = one_a_piece ? order[begin] : order[i];
  }
  std::vector<bool> kept(order.size());
  std::vector<std::int64_t> new_number(order.size());
  std::int64_t next = 0;
  for (std::size_t p = 0; p < kept.size(); ++p) {
    kept[p] = stands_for[p] == p;
    if (kept[p]) new_number[p] = next++;
  }
  for (std::int64_t& v : grid.connectivity) v = new_number[stands_for[static_cast<std::size_t>(v)]];
  keep_marked_rows(grid.points, kept, 1);
  for (VtkNumbers& array : grid.point_arrays) keep_marked_rows(array.values, kept, array.components);
}

int dimension_of(const VtkGrid& grid) {
  if (std::any_of(grid.types.begin(), grid.types.end(), is_of_space)) return 3;
  return std::all_of(grid.points.begin(), grid.points.end(),
                     [&](const Point3& p) { return p.z == grid.points[0].z; })
             ? 2
             : 3;
}

}  // namespace leonhard::io
