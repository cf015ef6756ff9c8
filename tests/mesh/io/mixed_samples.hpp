// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <algorithm>

#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/mixed_shelf.hpp"

namespace leonhard::test {

/// Everything that a mesh of mixed cells can carry: markers with names, inner facets, regions, vertex markers.
///
/// first_marker  of the boundary, which has three
/// region_step   regions are 0, 1, 2 or 3 times as much
template <int Dim>
MixedMesh<Dim> with_everything(MixedMesh<Dim> mesh, Marker first_marker, double region_step) {
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    mesh.boundary[i].marker = static_cast<Marker>(i % 3) + first_marker;
  for (const CellId cell : mesh.kinds.ids()) {
    mesh.regions[cell] = region_step * static_cast<double>(cell.index() % 4);
    for (std::size_t side = 0; side < mesh.shape(cell).facets.size(); ++side) {
      const auto facet = mesh.facet_of(cell, side);
      const bool is_boundary =
          std::any_of(mesh.boundary.begin(), mesh.boundary.end(), [&](const auto& other) {
            return std::is_permutation(facet.begin(), facet.end(), other.corners.begin(),
                                       other.corners.end());
          });
      const bool is_first = facet[0] < facet[1];  // of the two cells at an edge of the plane
      if (!is_boundary && (Dim == 2 ? is_first : cell.index() % 5 == 0 && side == 1))
        mesh.inner_facets.push_back({facet, 40 + static_cast<Marker>(side)});
    }
  }
  for (const VertexId v : mesh.points.ids()) mesh.vertex_markers[v] = static_cast<Marker>(v.index()) - 4;
  mesh.marker_names = {{first_marker, "wall"}, {first_marker + 2, "far field"}, {99, "nowhere"}};
  REQUIRE_FALSE(mesh::validate(mesh));
  return mesh;
}

}  // namespace leonhard::test
