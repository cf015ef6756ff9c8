// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard::mesh {

/// A mesh of mixed cells cut into simplices, and whose parts they are.
template <int Dim>
struct SplitMesh {
  using PartId = typename Simplex<Dim>::CellId;

  SimplexMesh<Dim> mesh;
  PerId<PartId, CellId> cell_of;  ///< the cell that a triangle or tetrahedron is a part of, ascending
};

/// The same mesh of triangles or tetrahedra, without new vertices: a cell is cut from its smallest vertex, and so is each
/// of its faces, so that two cells cut a common face alike (the pulling triangulation: De Loera, Rambau and Santos,
/// Triangulations, 2010, section 4.3.2; for these cells Dompierre, Labbe, Vallet and Camarero, 8th International Meshing
/// Roundtable, 1999). Boundary and inner facets are cut with the cells and keep their order, markers, names and regions go along.
///
/// mesh    `validate` finds nothing wrong with it. `validate` finds nothing wrong with the result either
/// throws  InputError naming the first cell of which a part is not positive, by exact orient3d: faces of four vertices that
///         bend may leave no room; quadrilaterals of the plane can always be cut
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] SplitMesh<Dim> split_cells(const MixedMesh<Dim>& mesh);

}  // namespace leonhard::mesh
