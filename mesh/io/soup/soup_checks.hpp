// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

/// What can be said of a soup before anything is done to it, and how errors name its parts.
namespace leonhard::io {

/// "grid.su2:17", or the file alone. lines: the soup's, of cells or facets
template <int Dim>
[[nodiscard]] std::string place_in(const MeshSoup<Dim>& soup, const std::vector<std::uint32_t>& lines,
                                   std::size_t index) {
  return lines.empty() || lines[index] == 0 ? soup.source : at_line(soup.source, lines[index]);
}

/// "the marked edge 3-4".
template <int Dim>
[[nodiscard]] std::string marked_facet_words(const MarkedMixedFacet<Dim>& facet) {
  std::string ids;
  for (const VertexId v : facet.corners) ids += (ids.empty() ? "" : "-") + std::to_string(v.index());
  return std::string("the marked ") + Simplex<Dim>::facet + " " + ids;
}

/// There are points and cells, not too many, at finite places, and every corner of a cell or facet is one of the points.
/// throws  InputError
template <int Dim>
void check_soup(const MeshSoup<Dim>& soup);

/// What check_soup says of places and corners, whether there are cells or not.
template <int Dim>
void check_corners_and_places(const MeshSoup<Dim>& soup);

/// No cell and no facet has a vertex twice. throws  InputError
template <int Dim>
void refuse_repeated_vertices(const MeshSoup<Dim>& soup);

}  // namespace leonhard::io
