// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/io/any_mesh_file.hpp"

namespace leonhard::app {

/// A mesh of mixed cells cut into triangles or tetrahedra, for pictures; one of simplices stays as it is. Fields of points stay,
/// those of cells go along. The warnings of the file tell it.
///
/// returns  the cell that each part is of, or none if nothing was cut
/// throws   InputError as mesh::split_cells does
std::vector<std::size_t> cut_cells(AnyMeshFile& file);

}  // namespace leonhard::app
