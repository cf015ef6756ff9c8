// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// Values at the vertices of a mesh, e.g. {"mach", 1, ...} or {"velocity", 2, ...}.
struct PointField {
  std::string name{};
  std::size_t components = 1;
  std::vector<double> values{};  ///< components numbers a vertex, vertex after vertex

  friend bool operator==(const PointField&, const PointField&) = default;
};

/// Values in the triangles or tetrahedra of a mesh, e.g. {"part", 1, ...} or {"stress", 9, ...}.
struct CellField {
  std::string name{};
  std::size_t components = 1;
  std::vector<double> values{};  ///< components numbers a cell, cell after cell

  friend bool operator==(const CellField&, const CellField&) = default;
};

/// What a mesh reader returns: a mesh that passes `mesh::validate` and `mesh::validate_embedding`, and in words what had
/// to be decided on the way (quadrilaterals split, clockwise or inverted cells turned over, boundary facets without a
/// marker, ...).
template <int Dim>
struct SimplexMeshFile {
  SimplexMesh<Dim> mesh;
  std::vector<std::string> warnings;
  std::vector<PointField> point_fields;  ///< in the file's order, as long as the mesh has vertices
  std::vector<CellField> cell_fields;    ///< likewise; both halves of a split quadrilateral have its values
};

using MeshFile = SimplexMeshFile<2>;
using TetMeshFile = SimplexMeshFile<3>;

}  // namespace leonhard
