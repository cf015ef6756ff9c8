// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/mesh/io/any_mesh_file.hpp"

namespace leonhard::app {

/// The parts of cells that were cut.
struct CutCells {
  std::vector<std::size_t> cell_of;  ///< each part's cell; none if nothing was cut
  std::string words;  ///< "12 cells are drawn cut into triangles", for pictures that show the parts
};

/// A mesh of mixed cells cut into triangles or tetrahedra, for pictures; one of simplices stays as it is. Fields of points stay,
/// those of cells go along.
///
/// throws   InputError as mesh::split_cells does
CutCells cut_cells(AnyMeshFile& file);

}  // namespace leonhard::app
