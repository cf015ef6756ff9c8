// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::io {

/// A triangle or quadrilateral as a file states it: nothing about it is known to be right.
struct Cell {
  std::array<VertexId, 4> corners;
  std::uint32_t corner_count = 3;  ///< 3 or 4
  std::uint32_t line = 0;          ///< of the file; 0: the file has no lines
};

/// What a mesh file states, before anything is checked.
struct CellSoup {
  PerId<VertexId, Point2> points;
  std::vector<Cell> cells;
  std::vector<MarkedEdge> edges;        ///< marked edges, in either direction; see EdgeRule
  std::vector<MarkedEdge> constraints;  ///< interior edges known as such
  std::vector<double> cell_regions;     ///< one a cell, or empty
  std::vector<Marker> vertex_markers;   ///< one a vertex, or empty
  std::map<Marker, std::string> marker_names;
  std::vector<PointField> point_fields;  ///< one row a vertex
  std::vector<CellField> cell_fields;    ///< one row a cell
  std::vector<std::string> warnings;     ///< what the result's begin with
  std::string source;                    ///< names the file in errors
  std::string note;                      ///< added to errors, e.g. that ids in them are numbered from 0
};

enum class EdgeRule {
  edges_are_the_boundary,  ///< every edge of the boundary is listed and no other
  fill_in_the_boundary     ///< listed inner edges are constraints; unlisted boundary edges get a marker
};

/// Make the mesh that a file states, or say why it is none.
///
/// Triangles that are all clockwise are turned over, and so are quadrilaterals; quadrilaterals are split
/// along their Delaunay diagonal (exact, ties by kernel::incircle_perturbed), where that gives two positive
/// triangles, else along the other. Under fill_in_the_boundary an unlisted boundary edge gets the marker its
/// two ends share if it is not 0, else 1. The warnings tell each of these.
///
/// throws InputError naming line, ids and coordinates: id out of range, a cell of zero area or tangled, cells
/// of unlike orientation, and all that make_triangle_mesh, validate and validate_embedding refuse
/// Cost O(cells + boundary log boundary).
[[nodiscard]] MeshFile assemble(CellSoup soup, EdgeRule rule);

}  // namespace leonhard::io
