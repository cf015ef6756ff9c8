// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard::io {

/// To each facet, in whatever direction, the number of a cell whose side it is: of two the first.
///
/// throws  InputError if a facet is no side of a cell
/// Cost O(cells + sides at the facets' vertices · log facets).
template <int Dim>
[[nodiscard]] std::vector<std::size_t> cells_at(const SimplexMesh<Dim>& mesh,
                                                const std::vector<MixedFacet<Dim>>& facets);
template <int Dim>
[[nodiscard]] std::vector<std::size_t> cells_at(const MixedMesh<Dim>& mesh,
                                                const std::vector<MixedFacet<Dim>>& facets);

}  // namespace leonhard::io
