// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>

#include "leonhard/mesh/mesh_location.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// Finds points in a triangle or tetrahedral mesh that need neither be convex nor connected.
///
/// Where a point lies is decided by exact predicates and depends on the mesh and the point alone. Queries change nothing:
/// any number of threads may ask one locator. It keeps a reference to the mesh, which must outlive it unchanged.
///
/// Mesh    TriangleMesh or TetMesh
/// Method: trees of boxes over the cells, the vertices and the boundary, each along a Hilbert curve. Cost O(n log n) to make,
/// O(log n) a query where cells are not too long and thin, O(n) at worst; memory: 30 to 55 bytes a triangle, 35 to 65 a
/// tetrahedron.
template <class Mesh>
class MeshLocator {
 public:
  using Point = typename decltype(Mesh::points)::value_type;
  using Corners = typename decltype(Mesh::corners)::value_type;
  static constexpr std::size_t corners_each = std::tuple_size_v<Corners>;
  using CellId = std::conditional_t<corners_each == 3, TriangleId, TetId>;
  using Location = MeshLocation<CellId, corners_each>;
  using Weights = VertexWeights<corners_each>;

  /// The point of a mesh that is nearest to a point.
  struct Nearest {
    Point point;  ///< rounded; the point asked for itself, if that lies in the mesh
    double
        distance{};  ///< from it, in the unit of the coordinates; 0 if it lies in the mesh, infinite if that is empty
    Location
        location;  ///< of the nearest point, as far as rounding tells; the cell is the one behind boundary_entry
    Weights weights;  ///< of the nearest point
    /// The entry of mesh.boundary that it lies on, the least if several are equally near; none (the number of entries) if
    /// the point asked for lies in the mesh or the mesh is empty.
    std::size_t boundary_entry{};
  };

  /// mesh    passes `validate`
  /// throws  InputError if a corner is no vertex, a point used is not finite, or mesh.boundary has no such cell
  explicit MeshLocator(const Mesh& mesh);
  explicit MeshLocator(Mesh&&) = delete;  ///< it would keep a reference to nothing

  /// Where a point lies; on the boundary is inside. throws InputError if it is not finite
  [[nodiscard]] Location locate(const Point& p) const;

  /// The vertex nearest to a point, that of smallest id if several are exactly as far; none if the mesh is empty. Decided
  /// by exact compare_distance. throws InputError if the point is not finite
  [[nodiscard]] MaybeId<VertexId> nearest_vertex(const Point& p) const;

  /// The point of the mesh nearest to p. throws InputError if p is not finite
  [[nodiscard]] Nearest nearest_point(const Point& p) const;

  /// The barycentric coordinates of p among the vertices that span its place; none outside (count 0). Each weight is
  /// within 2^-40 of the exact one. On a vertex, an edge or a face they do not depend on the cell: interpolated values
  /// are continuous.
  /// throws InputError if p is not finite
  [[nodiscard]] Weights weights_at(const Point& p) const;

  /// The values at a point of a field that is linear in each cell.
  ///
  /// values   result.size() numbers a vertex, vertex after vertex
  /// result   where the numbers go; unchanged if the point lies outside
  /// returns  where the point lies: nothing is made up outside
  /// throws   InputError, result unchanged, if values are not result.size() a vertex or the point is not finite
  [[nodiscard]] Location interpolate(const Point& p, std::span<const double> values,
                                     std::span<double> result) const;

  // ---- batches: the same answers, asked along a Hilbert curve: faster where points come in no order ----

  /// throws InputError, nothing written, if there are not as many locations as points or a point is not finite
  void locate(std::span<const Point> points, std::span<Location> locations) const;

  /// throws InputError, nothing written, if there are not as many vertices as points or a point is not finite
  void nearest_vertices(std::span<const Point> points, std::span<MaybeId<VertexId>> vertices) const;

  /// values   `components` >= 1 numbers a vertex, vertex after vertex
  /// results  `components` numbers a point, point after point; NaN for points outside
  /// returns  how many points lie outside
  /// throws   InputError, nothing written, if sizes do not fit or a point is not finite
  [[nodiscard]] std::size_t interpolate(std::span<const Point> points, std::span<const double> values,
                                        std::size_t components, std::span<double> results) const;

 private:
  struct Index;
  std::shared_ptr<const Index> index_;  // copies share it
};

extern template class MeshLocator<TriangleMesh>;
extern template class MeshLocator<TetMesh>;

}  // namespace leonhard::mesh
