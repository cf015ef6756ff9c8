// SPDX-License-Identifier: MIT
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/mixed_invariants.hpp"
#include "leonhard/mesh/split_cells.hpp"
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

template <int Dim>
std::optional<std::string> validate_embedding(const MixedMesh<Dim>& mesh) {
  try {
    const SplitMesh<Dim> split = split_cells(mesh);
    auto problem = validate_embedding(split.mesh);
    if (problem && split.mesh.cell_count() != mesh.cell_count())
      *problem += std::string(" (") + Simplex<Dim>::cells + " are numbered after cells were cut into them)";
    return problem;
  } catch (const InputError& error) {
    return "nothing is proved: " + error.problem();
  }
}

template std::optional<std::string> validate(const MixedMesh<2>&);
template std::optional<std::string> validate(const MixedMesh<3>&);
template std::optional<std::string> validate_embedding(const MixedMesh<2>&);
template std::optional<std::string> validate_embedding(const MixedMesh<3>&);

}  // namespace leonhard::mesh
