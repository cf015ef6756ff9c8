// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "leonhard/mesh/euler.hpp"
#include "leonhard/mesh/faces.hpp"
#include "leonhard/mesh/tet_edges.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

/// Euler's account of a tetrahedral mesh: counts that were taken independently of one another, and the formulas of
/// Barth's notes 1.1 that tie them together, both sides as integers.
///
/// Pinches. The account counts as if pinches were opened by a hair's breadth:
/// - An edge counts once per *fan*, tetrahedra about it that are joined across faces at it. Two parts that touch along
///   an edge come apart; two cavities that touch along an edge open into one another.
/// - A vertex counts once per *star*, tetrahedra about it that are joined across faces at it. Two parts that touch at a
///   vertex come apart.
/// - On the boundary a vertex counts once per *sheet*, boundary faces about it that are joined across open fans. Where
///   two cavities touch at a vertex, one star has two sheets; the cavities remain two.
/// So `stars` takes the place of n(v), `fans` that of n(e), and `sheets` that of n(v)_bound; parts that only touch are
/// different components. Then the boundary is a number of closed surfaces, the *shells*, each a sphere with handles.
/// Without pinches stars == vertices, fans == edges, and sheets are the vertices on the boundary.
struct TetEulerAccount {
  using Formula = EulerAccount::Formula;

  std::size_t vertices{};    ///< entries of mesh.points
  std::size_t edges{};       ///< entries of the edge list
  std::size_t faces{};       ///< entries of the face structure
  std::size_t tetrahedra{};  ///< entries of mesh.corners
  std::size_t stars{};  ///< classes of corners joined across faces; vertices without tetrahedron have none
  std::size_t vertex_pinches{};         ///< over all vertices, stars beyond the first
  std::size_t fans{};                   ///< classes of tetrahedra's edges joined across faces
  std::size_t edge_pinches{};           ///< over all edges, pairs of boundary faces beyond the first
  std::size_t boundary_faces{};         ///< faces with a tetrahedron on one side
  std::size_t boundary_edges{};         ///< open fans
  std::size_t sheets{};                 ///< classes of boundary faces' corners joined across open fans
  std::size_t sheet_pinches{};          ///< over all stars, sheets beyond the first
  std::size_t listed_boundary_faces{};  ///< entries of mesh.boundary
  std::size_t components{};             ///< classes of tetrahedra joined across faces: the number b0
  std::size_t shells{};                 ///< classes of boundary faces joined across open fans
  std::size_t outer_shells{};           ///< shells that enclose a positive volume, by its exact sign
  std::size_t cavities{};               ///< shells that enclose a negative volume: the number b2
  std::size_t handles{};                ///< of all shells, from Euler's formula on them: the number b1
  std::vector<Formula> formulas;

  /// stars - fans + faces - tetrahedra, Euler's characteristic: 1 for a ball, 0 for a torus, 2 for a hollow ball.
  [[nodiscard]] std::int64_t characteristic() const;
  /// Whether all formulas hold.
  [[nodiscard]] bool balances() const;
};

namespace mesh {

/// Euler's account of a mesh with any number of components, handles, cavities and pinches.
///
/// mesh    `validate` finds nothing wrong with it. Stars, fans and shells are found by way of mesh.neighbours
/// faces   of this mesh, from build_faces, and
/// edges   from build_edges: both from the corners alone
/// Formulas, with n(v) = stars, n(e) = fans, n(phi) = tetrahedra, C = components, H = handles, K = cavities, S = shells:
/// - (1.1.5), a cone over each shell closing the mesh to a space without boundary:
///   n(v) + S + n(f) + n(e)_bound = n(e) + n(v)_bound + n(phi) + n(f)_bound + H
/// - (1.1.6), that is chi = C - H + K: n(f) + n(v) = n(e) + n(phi) + C - H + K
/// - (1.1.7) to (1.1.9) star by star, N_b(v) being the sheets: how many stars satisfy them, beside how many there are
/// - (1.1.10): their sum, times 2: 2 sum d_e = sum d_phi + sum F_b - 2 sum N_b + 4 n(v). (The notes' print leaves out
///   the last term, which their (1.1.12) has.)
/// - (1.1.11): sum d_e = 2 n(e), sum d_phi = 4 n(phi)
/// - (1.1.12), times 4: 4 n(e) = 4 n(phi) + 4 n(v) + sum F_b - 2 sum N_b
/// - (1.1.13), times 4: 4 n(e) = 4 n(phi) + 4 n(v) + 3 n(f)_bound - 2 n(v)_bound
/// - (1.1.14), times 2: 2 n(f) = 4 n(phi) + n(f)_bound
/// - (1.1.15), times 4: 4 n(e) + 4 n(phi) = 4 n(f) + 4 n(v) + n(f)_bound - 2 n(v)_bound
/// - half the boundary's: 2 chi = n(v)_bound - n(e)_bound + n(f)_bound
/// - 2 n(e)_bound = 3 n(f)_bound, and sum F_b = 3 n(f)_bound
/// - outer shells = C, and S = C + K
/// - boundary faces listed = n(f)_bound
/// - n(v) = vertices + pinches, n(e) = edges + pinches
///
/// mesh    its corners and neighbours are those that mesh::validate would let pass: a precondition
/// throws  InputError naming the first face or edge that is none of the mesh's; what is missing makes the account not balance
/// Cost O(vertices + tetrahedra) nearly, plus an exact sum a shell.
[[nodiscard]] TetEulerAccount euler_account(const TetMesh& mesh, const FaceStructure& faces,
                                            const TetEdges& edges);

}  // namespace mesh
}  // namespace leonhard
