// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// 3 if the file has cells of space or points that do not lie in a plane z = const, else 2.
[[nodiscard]] int dimension_of(const GmshData& data);

/// What a file of Gmsh states of cells of a dimension and their facets; cells of several kinds by their numbers in the file.
/// throws  InputError: cells of space or points off the plane z = const (Dim = 2)
template <int Dim>
[[nodiscard]] MeshSoup<Dim> gmsh_soup(GmshData&& data, const std::string& source);

}  // namespace leonhard::io
