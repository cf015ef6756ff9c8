// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard {

/// What differs between triangles (Dim = 2, triangle_mesh.hpp) and tetrahedra (Dim = 3, tet_mesh.hpp). A cell has
/// Dim + 1 corners; its facets, one opposite each corner, are the edges of triangles and the faces of tetrahedra.
///
/// Point, Vector     of the space around
/// CellId, FacetId   numbers of cells and of facets
/// MarkedFacet       a facet that carries a marker
/// InnerFacets       the base of SimplexMesh that lists the marked facets between two cells
/// facet_corners     the corners of the facet opposite corner i, as numbers 0 to Dim, directed outwards: the cell lies to
///                   the left of an edge and behind a face (which turns counter-clockwise as seen from outside)
/// corners_of        the corners of a marked facet
/// marked            a marked facet from its corners
/// cell, cells, facet  in words
template <int Dim>
struct Simplex;

/// A mesh of triangles or of tetrahedra, any number of components and holes: the finite-element structure of Barth's
/// notes 1.3, with neighbours. Plain parallel arrays; `mesh::validate` says which invariant broke. Functions for both
/// take `const SimplexMesh<Dim>&`, which TriangleMesh and TetMesh are.
///
/// Invariants: corners positive (kernel::orient2d of the three, kernel::orient3d of the four); neighbours[t][i] lies
/// across the facet opposite corners[t][i] and points back; every facet with a cell on one side only appears once in
/// `boundary`, directed outwards; every vertex has a cell.
template <int Dim>
struct SimplexMesh : Simplex<Dim>::InnerFacets {
  using Point = typename Simplex<Dim>::Point;
  using CellId = typename Simplex<Dim>::CellId;
  using FacetId = typename Simplex<Dim>::FacetId;
  using MarkedFacet = typename Simplex<Dim>::MarkedFacet;
  using CellCorners = std::array<VertexId, Dim + 1>;
  using FacetCorners = std::array<VertexId, Dim>;
  using CellNeighbours = std::array<MaybeId<CellId>, Dim + 1>;

  PerId<VertexId, Point> points;
  PerId<CellId, CellCorners> corners;
  PerId<CellId, CellNeighbours> neighbours;

  std::vector<MarkedFacet> boundary;  ///< each boundary facet once, directed outwards

  PerId<VertexId, Marker> vertex_markers;  ///< one a vertex, 0 where none
  PerId<CellId, double> regions;  ///< regional attribute, 0 where none (Triangle's and TetGen's convention)
  std::map<Marker, std::string> marker_names;  ///< e.g. 1 -> "airfoil"
  std::map<Marker, std::string> region_names;  ///< of regions that are whole numbers, e.g. 2 -> "steel"

  [[nodiscard]] std::size_t vertex_count() const { return points.size(); }
  [[nodiscard]] std::size_t cell_count() const { return corners.size(); }
  [[nodiscard]] std::size_t triangle_count() const requires(Dim == 2) { return cell_count(); }
  [[nodiscard]] std::size_t tet_count() const requires(Dim == 3) { return cell_count(); }

  friend bool operator==(const SimplexMesh&, const SimplexMesh&) = default;
};

}  // namespace leonhard
