// SPDX-License-Identifier: MIT
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/mixed_invariants.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::mesh {

template <int Dim>
std::optional<std::string> validate(const MixedMesh<Dim>& mesh) {
  if (auto problem = broken_sizes(mesh)) return problem;
  if (auto problem = broken_kind(mesh)) return problem;
  if (auto problem = corner_out_of_range(mesh)) return problem;
  if (auto problem = broken_point(mesh)) return problem;
  if (auto problem = repeated_corner(mesh)) return problem;
  if (auto problem = unused_vertex(mesh)) return problem;
  if (auto problem = broken_orientation(mesh)) return problem;
  const MixedSides<Dim> sides(mesh);
  if (auto problem = broken_facet(mesh, sides)) return problem;
  if constexpr (Dim == 3)
    if (auto problem = unconforming_face(mesh, sides)) return problem;
  if (auto problem = broken_boundary(mesh, sides)) return problem;
  return broken_inner_facet(mesh, sides);
}

std::optional<std::string> validate_embedding(const MixedMesh<2>& mesh) {
  TriangleMesh triangles;
  triangles.points = mesh.points;
  for (const CellId cell : mesh.kinds.ids()) {
    const auto corners = mesh.corners_of(cell);
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles.corners.push_back({corners[0], corners[i - 1], corners[i]});
  }
  for (const auto& [corners, marker] : mesh.boundary)
    triangles.boundary.push_back({corners[0], corners[1], marker});
  triangles.vertex_markers = mesh.vertex_markers;
  triangles.regions.resize(triangles.cell_count(), 0.0);
  build_neighbours(triangles);
  auto problem = validate_embedding(triangles);
  if (problem && triangles.cell_count() != mesh.cell_count())
    *problem += " (triangles are numbered after quadrilaterals were cut in two)";
  return problem;
}

template std::optional<std::string> validate(const MixedMesh<2>&);
template std::optional<std::string> validate(const MixedMesh<3>&);

}  // namespace leonhard::mesh
