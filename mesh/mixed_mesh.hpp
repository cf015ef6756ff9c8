// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/cell_kind.hpp"
#include "leonhard/mesh/compressed_rows.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// The vertices of a facet of a MixedMesh: of an edge (Dim = 2), of a triangle or quadrilateral (Dim = 3), in a
/// direction. On the boundary the mesh lies to the left of an edge and behind a face.
template <int Dim>
class MixedFacet {
 public:
  static constexpr std::size_t most_corners = Dim == 2 ? 2 : most_facet_corners;

  MixedFacet() = default;
  /// vertices  two in the plane, three or four in space (asserted)
  explicit MixedFacet(std::span<const VertexId> vertices);
  MixedFacet(std::initializer_list<VertexId> vertices)
      : MixedFacet(std::span<const VertexId>(vertices.begin(), vertices.size())) {}

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] VertexId operator[](std::size_t i) const { return vertices_[i]; }
  [[nodiscard]] VertexId& operator[](std::size_t i) { return vertices_[i]; }
  [[nodiscard]] const VertexId* begin() const { return vertices_.data(); }
  [[nodiscard]] const VertexId* end() const { return vertices_.data() + count_; }

  /// The same in the other direction; of a face the first vertex stays.
  [[nodiscard]] MixedFacet reversed() const;

  friend bool operator==(const MixedFacet&, const MixedFacet&) = default;

 private:
  std::array<VertexId, most_corners> vertices_{};  ///< beyond the last: 0
  std::uint8_t count_ = 0;
};

/// A facet that carries a marker.
template <int Dim>
struct MarkedMixedFacet {
  MixedFacet<Dim> corners;
  Marker marker{};
  friend bool operator==(const MarkedMixedFacet&, const MarkedMixedFacet&) = default;
};

/// A mesh of triangles and quadrilaterals (Dim = 2) or of tetrahedra, pyramids, prisms and hexahedra (Dim = 3), any number
/// of components and holes. Plain parallel arrays; `mesh::validate` says which invariant broke.
///
/// Invariants: a row of `corners` has as many vertices as its kind, all different, in the order of CellKind; every cell is
/// positive (see `mesh::validate`); two cells share a facet whole, on opposite sides of it, or not at all; every facet with a
/// cell on one side only appears once in `boundary`, directed outwards; every vertex has a cell. Faces of four vertices
/// need not be flat.
template <int Dim>
struct MixedMesh {
  using Point = typename Simplex<Dim>::Point;
  using Vector = typename Simplex<Dim>::Vector;
  using Facet = MixedFacet<Dim>;
  using MarkedFacet = MarkedMixedFacet<Dim>;

  PerId<VertexId, Point> points;
  PerId<CellId, CellKind> kinds;
  CompressedRows<VertexId, IdRaw> corners;  ///< a row a cell

  std::vector<MarkedFacet> boundary;      ///< each boundary facet once, directed outwards
  std::vector<MarkedFacet> inner_facets;  ///< marked facets between two cells, in either direction

  PerId<VertexId, Marker> vertex_markers;      ///< one a vertex, 0 where none
  PerId<CellId, double> regions;               ///< regional attribute, 0 where none
  std::map<Marker, std::string> marker_names;  ///< e.g. 1 -> "airfoil"
  std::map<Marker, std::string> region_names;  ///< of regions that are whole numbers, e.g. 2 -> "steel"

  [[nodiscard]] std::size_t vertex_count() const { return points.size(); }
  [[nodiscard]] std::size_t cell_count() const { return kinds.size(); }
  /// Of one kind. Cost O(cells).
  [[nodiscard]] std::size_t count_of(CellKind kind) const {
    return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), kind));
  }
  [[nodiscard]] const CellShape& shape(CellId cell) const { return shape_of(kinds[cell]); }
  [[nodiscard]] std::span<const VertexId> corners_of(CellId cell) const { return corners[cell.index()]; }
  /// A facet of a cell, directed outwards; side numbers shape(cell).facets.
  [[nodiscard]] Facet facet_of(CellId cell, std::size_t side) const;

  /// Add a cell at the end, in region 0. corners as many as the kind has (asserted).
  CellId add_cell(CellKind kind, std::span<const VertexId> vertices);

  friend bool operator==(const MixedMesh&, const MixedMesh&) = default;
};

namespace mesh {

/// Calls visit(from, to) once for each edge of a cell, from and to in no order.
template <int Dim, class Visit>
void for_each_edge_of(const MixedMesh<Dim>& mesh, CellId cell, Visit visit) {
  const auto corners = mesh.corners_of(cell);
  for (const FacetShape& facet : mesh.shape(cell).facets) {
    for (std::size_t i = 0; i < facet.size(); ++i) {
      const std::size_t from = facet[i], to = facet[i + 1 == facet.size() ? 0 : i + 1];
      // In the plane a facet is an edge; in space an edge has two facets, in opposite directions.
      if (Dim == 2 ? i == 0 : from < to) visit(corners[from], corners[to]);
    }
  }
}

/// A mesh of simplices as a mixed one: same vertices, cells, markers, in the same order. Neighbours are not read.
/// throws  InputError as require_ids_in_range does
/// Cost O(vertices + cells + boundary).
template <int Dim>
[[nodiscard]] MixedMesh<Dim> mixed_mesh_of(const SimplexMesh<Dim>& mesh);

/// The way back, neighbours found anew.
///
/// throws  InputError naming the first cell that is no simplex, an id out of range, and as build_neighbours does
/// Cost O(vertices + cells + boundary), one sort by buckets.
template <int Dim>
[[nodiscard]] SimplexMesh<Dim> simplex_mesh_of(const MixedMesh<Dim>& mesh);

/// What a mixed mesh needs so that nothing reads beyond the end of an array: kinds of its dimension, rows of their length,
/// one entry a cell in regions, one a vertex in vertex_markers, no vertex out of range. Much less than `validate` asks.
/// throws  InputError naming the array or the entry
/// Cost O(vertices + cells + boundary).
template <int Dim>
void require_ids_in_range(const MixedMesh<Dim>& mesh);

}  // namespace mesh
}  // namespace leonhard
