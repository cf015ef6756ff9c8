// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "leonhard/mesh/simplex_mesh.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"
#include "leonhard/solver/gas.hpp"

namespace leonhard::app {

/// The states that a field.vtu of another run holds, for the vertices of a mesh. Vertices belong together where their
/// coordinates are the same to the last bit, whatever the numbering.
///
/// points   of the mesh
/// throws   InputError as io::read_mixed_mesh, and naming what differs: another number of vertices, a vertex that the file
///          does not have, two vertices of one place where the numberings differ, a field that is missing or has no gas in it
/// Cost O(n log n).
template <int dim>
[[nodiscard]] PerId<VertexId, State<dim>> initial_states(const std::filesystem::path& file,
                                                         const PerId<VertexId, typename Simplex<dim>::Point>& points);

}  // namespace leonhard::app
