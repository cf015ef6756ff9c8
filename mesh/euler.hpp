// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// Euler's account of a mesh: counts that were taken independently of one another, and the formulas of
/// Barth's notes 1.1 that tie them together, both sides as integers.
///
/// Pinched vertices. Where boundary loops touch at a vertex, the triangles about it form several fans
/// (triangles joined across edges at that vertex). The account counts a vertex once per fan, as if the pinch
/// were opened by a hair's breadth: `fans` = vertices + pinches takes the place of n(v). Then every component
/// is a disc with holes, parts that only touch at a vertex are different components, and a loop goes through
/// a pinched vertex within one fan. Without pinches fans == vertices.
struct EulerAccount {
  struct Formula {
    std::string name;   ///< "(1.1.4)", the notes' number, or a short name
    std::string words;  ///< the formula as a sentence
    std::int64_t lhs{}, rhs{};
    [[nodiscard]] bool holds() const { return lhs == rhs; }
  };

  std::size_t vertices{};   ///< entries of mesh.points
  std::size_t fans{};       ///< classes of corners joined across edges; vertices without triangle have none
  std::size_t pinches{};    ///< over all vertices, fans beyond the first
  std::size_t edges{};      ///< entries of the edge structure
  std::size_t triangles{};  ///< entries of mesh.corners
  std::size_t interior_edges{};         ///< edges with a triangle on both sides
  std::size_t boundary_edges{};         ///< edges with a triangle on one side
  std::size_t listed_boundary_edges{};  ///< entries of mesh.boundary
  std::size_t components{};             ///< classes of triangles joined across edges, by union-find
  std::size_t boundary_loops{};         ///< closed walks along boundary edges, the mesh on the left
  std::size_t outer_loops{};            ///< loops whose exact area is positive (counter-clockwise)
  std::size_t holes{};                  ///< loops whose exact area is negative (clockwise): n(h)
  std::vector<Formula> formulas;

  /// Whether all formulas hold.
  [[nodiscard]] bool balances() const;
};

namespace mesh {

/// Euler's account of a mesh with any number of components, holes and pinches.
///
/// edges   of this mesh, from build_edges. mesh.neighbours is not read.
/// throws  InputError naming the first edge that is none of the mesh's; edges that are missing make the account not balance
/// Formulas, with n(v) = fans, C = components, H = holes, L = boundary_loops:
/// - (1.1.0), Euler's, the infinite face and the holes counted as faces: n(f) + H + 1 = n(e) - n(v) + 1 + C
/// - (1.1.1), that is chi = C - H: n(f) + n(v) = n(e) + C - H
/// - (1.1.2): 2 n(e)_interior + n(e)_bound = 3 n(f)
/// - (1.1.3): n(f) = 2 n(v) - n(e)_bound - 2 C + 2 H
/// - (1.1.4): n(e) = 3 n(v) - n(e)_bound - 3 C + 3 H
/// - no handles, each component a sphere with its loops cut out: n(v) - n(e) + n(f) = 2 C - L
/// - outer loops = C, and L = C + H
/// - boundary edges listed = n(e)_bound
/// - n(v) = vertices + pinches
///
/// The notes state them for one component, C = 1.
/// Cost O(vertices + triangles) nearly, plus an exact sum a boundary loop.
[[nodiscard]] EulerAccount euler_account(const TriangleMesh& mesh, const EdgeStructure& edges);

}  // namespace mesh
}  // namespace leonhard
