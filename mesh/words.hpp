// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// "0.1": the shortest decimal that reads back as the same double; "nan", "inf", "-inf".
[[nodiscard]] std::string words(double value);

/// "(0.5, 1)".
[[nodiscard]] std::string words(Point2 p);

/// "(0.5, 1, 2)".
[[nodiscard]] std::string words(const Point3& p);

/// "vertex 17 at (0.5, 1)"; without the place where the mesh has no such vertex.
template <int Dim>
[[nodiscard]] std::string words(const SimplexMesh<Dim>& mesh, VertexId v);

/// "edge 3-8 from (0, 0) to (1, 0)".
template <int Dim>
[[nodiscard]] std::string words(const SimplexMesh<Dim>& mesh, VertexId from, VertexId to);

/// An edge of a triangle mesh as above; "face 3-8-9 at (0, 0, 0), (1, 0, 0), (0, 1, 0)".
template <int Dim>
[[nodiscard]] std::string words(const SimplexMesh<Dim>& mesh,
                                const typename SimplexMesh<Dim>::FacetCorners& facet);

/// "triangle 4 (vertices 1, 2, 3 at (0, 0), (1, 0), (0, 1))",
/// "tetrahedron 4 (vertices 1, 2, 3, 5 at (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))".
template <int Dim>
[[nodiscard]] std::string words(const SimplexMesh<Dim>& mesh, typename SimplexMesh<Dim>::CellId cell);

/// The same of mixed meshes: "edge 3-8 from (0, 0) to (1, 0)", "face 3-8-9-4 at ...", "hexahedron 4 (vertices ... at ...)".
template <int Dim>
[[nodiscard]] std::string words(const MixedMesh<Dim>& mesh, VertexId v);
template <int Dim>
[[nodiscard]] std::string words(const MixedMesh<Dim>& mesh, const MixedFacet<Dim>& facet);
template <int Dim>
[[nodiscard]] std::string words(const MixedMesh<Dim>& mesh, CellId cell);

}  // namespace leonhard::mesh
