// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "leonhard/mesh/compressed_rows.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// The triangles at each vertex, in compressed rows: made once, then a span a vertex. It keeps no reference to the mesh
/// and is out of date once the mesh changes.
class TriangleIncidence {
 public:
  /// mesh    passes `validate`
  /// throws  InputError if a corner is no vertex, or neighbours are not as many as triangles
  /// Cost O(vertices + triangles); memory: a number a vertex and 3 a triangle.
  explicit TriangleIncidence(const TriangleMesh& mesh);

  /// The triangles that have v as a corner, counter-clockwise about v. About an inner vertex the first is that of smallest
  /// id. About a boundary vertex the first is the one whose clockwise side at v lies on the boundary, the last has the
  /// other boundary edge; where parts of the mesh touch in v, their fans follow each other, in the order of their first
  /// triangles' ids.
  /// throws  InputError if the mesh has no vertex v
  [[nodiscard]] std::span<const TriangleId> triangles_at(VertexId v) const&;
  void triangles_at(VertexId v) const&& = delete;  // the span would outlive what it shows

  [[nodiscard]] std::size_t vertex_count() const { return triangles_.size(); }

 private:
  CompressedRows<TriangleId, std::size_t> triangles_;  // one row a vertex
};

/// The tetrahedra at each vertex, likewise.
class TetIncidence {
 public:
  /// mesh    passes `validate`
  /// throws  InputError if a corner is no vertex
  /// Cost O(vertices + tetrahedra); memory: a number a vertex and 4 a tetrahedron.
  explicit TetIncidence(const TetMesh& mesh);

  /// The tetrahedra that have v as a corner, in ascending order.
  /// throws  InputError if the mesh has no vertex v
  [[nodiscard]] std::span<const TetId> tets_at(VertexId v) const&;
  void tets_at(VertexId v) const&& = delete;

  [[nodiscard]] std::size_t vertex_count() const { return tets_.size(); }

 private:
  CompressedRows<TetId, std::size_t> tets_;  // one row a vertex
};

}  // namespace leonhard::mesh
