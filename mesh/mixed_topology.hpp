// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/topology.hpp"

namespace leonhard::mesh {

/// The facets of one cell, directed outwards, a face's smallest vertex first, sorted by vertices.
///
/// marker  of all of them
/// throws  InputError for an id out of range, a vertex twice in a cell, a facet of three cells or of two on the same side
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] std::vector<MarkedMixedFacet<Dim>> boundary_facets(const MixedMesh<Dim>& mesh,
                                                                 Marker marker = 1);

/// The pairs of cells that share a facet, the smaller one first, each pair as often as it shares facets.
///
/// throws  InputError as boundary_facets does
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] std::vector<std::array<CellId, 2>> neighbouring_cells(const MixedMesh<Dim>& mesh);

/// A checked mesh from what a file or a generator holds. `mesh::validate` finds nothing wrong with the result.
///
/// parts   points, kinds, corners and names; in boundary every boundary facet once, in either direction, others as rules
///         allow. vertex_markers and regions are filled with 0 if they are empty
/// source  file or description that errors name as their place; may be empty
/// returns the mesh, its boundary in the order given, directed outwards
/// throws  InputError naming ids and coordinates for all that `validate` finds
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] MixedMesh<Dim> make_mixed_mesh(MixedMesh<Dim> parts, const std::string& source = {},
                                             const MarkedFacetRules& rules = {});

}  // namespace leonhard::mesh
