// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "leonhard/mesh/euler.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard {

/// Euler's account of a mesh of mixed cells: counts that were taken independently of one another, and the formulas of
/// Barth's notes 1.1 that tie them together whatever the cells are, both sides as integers.
///
/// Pinches are counted as if they were opened by a hair's breadth, as in EulerAccount and TetEulerAccount: a vertex once per
/// star (cells about it joined across facets at it), in space an edge once per fan (cells about it joined across faces at
/// it), on the boundary of space a vertex once per sheet (boundary faces about it joined across open fans). Then the
/// boundary is a number of closed curves or surfaces, the shells.
struct MixedEulerAccount {
  using Formula = EulerAccount::Formula;

  std::size_t vertices{};        ///< entries of mesh.points
  std::size_t edges{};           ///< entries of the edge list
  std::size_t facets{};          ///< classes of cells' sides: in the plane edges again, in space faces
  std::size_t cells{};           ///< entries of mesh.kinds
  std::size_t stars{};           ///< classes of corners joined across facets
  std::size_t vertex_pinches{};  ///< over all vertices, stars beyond the first
  std::size_t fans{};            ///< in space classes of cells' edges joined across faces; in the plane edges
  std::size_t edge_pinches{};    ///< in space, over all edges, pairs of boundary faces beyond the first
  std::size_t boundary_facets{};         ///< facets with a cell on one side
  std::size_t listed_boundary_facets{};  ///< entries of mesh.boundary
  std::size_t boundary_edges{};          ///< in the plane boundary_facets; in space open fans
  std::size_t boundary_vertices{};       ///< in the plane open stars; in space sheets
  std::size_t components{};              ///< classes of cells joined across facets
  std::size_t shells{};                  ///< classes of boundary facets joined across open stars or open fans
  std::size_t outer_shells{};            ///< shells that enclose a positive area or volume, by its exact sign
  std::size_t cavities{};                ///< shells that enclose a negative one: holes, or cavities
  std::size_t handles{};                 ///< in space, of all shells, from Euler's formula on them
  std::vector<Formula> formulas;

  /// Vertices - edges + cells in the plane, vertices - edges + faces - cells in space, pinches opened.
  [[nodiscard]] std::int64_t characteristic(int dimension) const;
  /// Whether all formulas hold.
  [[nodiscard]] bool balances() const;
};

namespace mesh {

/// Euler's account of a mesh with any number of components, holes, handles, cavities and pinches.
///
/// mesh  `validate` finds nothing wrong with its cells; its boundary is counted only
/// Formulas of the plane, V = stars, E = edges, C = components, H = holes, L = shells:
/// - (1.1.1), that is chi = C - H: cells + V = E + C - H
/// - (1.1.2): 2 interior edges + boundary edges are the corners of all cells
/// - no handles: V - E + cells = 2 C - L
/// - edges by their ends are as many as edges by their sides
/// - boundary vertices are boundary edges
/// Formulas of space, E = fans, H = handles, K = cavities, S = shells:
/// - (1.1.6), that is chi = C - H + K: faces + V = E + cells + C - H + K
/// - (1.1.14): 2 faces are the sides of all cells + boundary faces
/// - half the boundary's: 2 chi = boundary vertices - boundary edges + boundary faces
/// - 2 boundary edges are the corners of all boundary faces
/// - fans are edges + pinches
/// Formulas of both: outer shells = C, S = C + K (L = C + H), boundary facets listed = boundary facets, stars = vertices +
/// pinches.
///
/// A shell's exact volume is that of the triangles about the centres of its faces.
/// throws  InputError as boundary_facets of mixed meshes does
/// Cost O(vertices + cells log degree), plus an exact sum a shell.
template <int Dim>
[[nodiscard]] MixedEulerAccount euler_account(const MixedMesh<Dim>& mesh);

}  // namespace mesh
}  // namespace leonhard
