// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/edge_list.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard {

/// A facet of the boundary as its vertices' control volumes see it.
template <int Dim>
struct DualFacet {
  using Vector = typename Simplex<Dim>::Vector;
  MixedFacet<Dim> corners;  ///< directed outwards: the mesh lies to the left of an edge, behind a face
  Marker marker{};
  CellKind cell = simplex_kind<Dim>;  ///< of the cell behind it
  Vector normal;                      ///< OUTWARD, times length or area; of a face that bends, the integral of the unit normal
  /// The part of normal that belongs to each of the corners: half of an edge, a third of a triangle, of a quadrilateral the
  /// piece between the corner, the midpoints of its two edges and the centre. They add up to normal; beyond the last: 0.
  std::array<Vector, MixedFacet<Dim>::most_corners> shares{};
  typename Simplex<Dim>::Point centre{};  ///< mean of the corners

  friend bool operator==(const DualFacet&, const DualFacet&) = default;
};

/// The median dual of a mesh of any cells: all that a vertex-centred finite-volume scheme reads. A control volume about
/// each vertex, a face across each edge, the boundary. Lengths in the unit of the coordinates; volumes and face vectors are
/// areas and lengths in the plane.
template <int Dim>
struct MeshDual {
  using Point = typename Simplex<Dim>::Point;
  using Vector = typename Simplex<Dim>::Vector;

  PerId<VertexId, Point> points;  ///< the mesh's
  EdgeList edges;                 ///< sorted by their ends, the smaller one first
  /// One an edge: integral of the unit normal over the control volumes' common face, from ends[0] to ends[1].
  PerId<EdgeId, Vector> face;
  PerId<VertexId, double> volume;        ///< of each control volume
  std::vector<DualFacet<Dim>> boundary;  ///< in the order of the mesh's
  std::map<Marker, std::string> marker_names;
  /// One an edge where periodic sides are joined (mesh::join_sides): the way from ends[0] to ends[1]. Empty: the difference of
  /// their points. Where there is one, two vertices may have several edges, and a vertex one to itself.
  PerId<EdgeId, Vector> span{};

  [[nodiscard]] std::size_t vertex_count() const { return points.size(); }
  [[nodiscard]] std::size_t edge_count() const { return edges.edge_count(); }
  [[nodiscard]] Vector edge_vector(EdgeId e) const {
    return span.empty() ? points[edges.ends[e][1]] - points[edges.ends[e][0]] : span[e];
  }

  friend bool operator==(const MeshDual&, const MeshDual&) = default;
};

namespace mesh {

/// The edges of a mesh of mixed cells, those of its cells; diagonals of quadrilaterals are none.
///
/// throws  InputError as require_ids_in_range does
/// Cost O(vertices + cells), one sort by buckets.
template <int Dim>
[[nodiscard]] EdgeList build_edges(const MixedMesh<Dim>& mesh);

/// The median dual (Barth's notes 1.2, figure 1.2.0) of any cells. The centre of a face or cell is the mean of its corners.
/// Within a cell the control volume about a corner is bounded by pieces of planes: in the plane the way from an edge's
/// midpoint to the cell's centre; in space, for each of the cell's edges, the two triangles from the edge's midpoint and the
/// cell's centre to the centres of the two faces at the edge. A face of four corners that is not flat is taken as the four
/// triangles about its centre, by both cells alike. So:
/// - about each vertex the face vectors, outwards, and the boundary's shares add up to zero, to rounding;
/// - the volumes add up to that of the mesh, whose curved faces are those triangles;
/// - of simplices the dual is median_dual.
///
/// All values are made of differences of coordinates within a cell, so a mesh far from the origin keeps its digits.
///
/// mesh    any; a volume is sure to be positive only if the triangles and tetrahedra between an edge, a face's centre
///         and a cell's centre are
/// throws  InputError as require_ids_in_range does, and naming an entry of the boundary that is no facet of a cell
/// Cost O(cells log degree).
template <int Dim>
[[nodiscard]] MeshDual<Dim> build_dual(const MixedMesh<Dim>& mesh);

/// The same of simplices.
template <int Dim>
[[nodiscard]] MeshDual<Dim> build_dual(const SimplexMesh<Dim>& mesh);

/// The dual of one facet of a boundary, directed outwards: its normal and shares. Marker and kind of the cell behind as given.
template <int Dim>
[[nodiscard]] DualFacet<Dim> dual_facet(const PerId<VertexId, typename Simplex<Dim>::Point>& points,
                                        const MarkedMixedFacet<Dim>& facet,
                                        CellKind cell = simplex_kind<Dim>);

}  // namespace mesh
}  // namespace leonhard
