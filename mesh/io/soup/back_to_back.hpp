// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::io {

/// How many pairs of boundary facets have corners at the same places, at least one of them a different vertex.
/// mesh  passes mesh::validate
/// Cost O(boundary log boundary).
template <int Dim>
[[nodiscard]] std::size_t facets_back_to_back(const SimplexMesh<Dim>& mesh);
template <int Dim>
[[nodiscard]] std::size_t facets_back_to_back(const MixedMesh<Dim>& mesh);

}  // namespace leonhard::io
