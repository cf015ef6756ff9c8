// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "leonhard/mesh/mesh_dual.hpp"

namespace leonhard {

/// Two sides of a mesh of which the second is the first one moved by a translation.
template <int Dim>
struct PeriodicSides {
  using Vector = typename Simplex<Dim>::Vector;
  Marker from{}, to{};
  std::optional<Vector> translation{};  ///< from the first to the second; none: found from the mesh
};

/// How the vertices of two such sides belong together.
template <int Dim>
struct PeriodicMatch {
  using Vector = typename Simplex<Dim>::Vector;
  Marker from{}, to{};
  Vector translation{};
  std::vector<std::array<VertexId, 2>> pairs;  ///< each vertex of the first side, ascending, and its image on the second
  double mismatch{};                           ///< greatest distance between an image and where it should be
};

/// The dual of a mesh whose periodic sides are one.
template <int Dim>
struct JoinedDual {
  MeshDual<Dim> dual;  ///< without the joined sides; the place of a vertex is that of the first of those it stands for
  PerId<VertexId, VertexId> joined_of;  ///< the vertex of `dual` that stands for a vertex of the mesh
  PerId<VertexId, VertexId> first_of;   ///< the first vertex of the mesh that a vertex of `dual` stands for
};

namespace mesh {

/// Pair the vertices of two sides, and check the facets between them.
///
/// A vertex and its image belong together within 1e-7 of the greatest extent of the mesh, which is what files of seven
/// digits leave; the nearest one counts.
///
/// dual     of the whole mesh, as build_dual makes it
/// throws   InputError naming markers that are on no facet or the same, a translation of 0, vertices on both sides, vertices
///          without a partner with their places (up to five a side), and facets that have no image facing the other way
/// Cost O(n log n) in the vertices of the sides.
template <int Dim>
[[nodiscard]] PeriodicMatch<Dim> match_sides(const MeshDual<Dim>& dual, const PeriodicSides<Dim>& sides);

/// Make paired vertices one: their control volumes are put together, faces between the same vertices the same way apart are
/// added up, and the facets of the joined sides are gone. Closed about each vertex as the mesh's own dual. Vertices that several pairs
/// join (a corner of a box that is periodic both ways) become one.
///
/// dual     as build_dual makes it
/// matches  of this dual
/// Cost O(edges log edges).
template <int Dim>
[[nodiscard]] JoinedDual<Dim> join_sides(const MeshDual<Dim>& dual, std::span<const PeriodicMatch<Dim>> matches);

}  // namespace mesh
}  // namespace leonhard
