// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/mesh/compressed_rows.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {

/// Everything that the sweeps read of a mesh, as flat arrays in the order in which they are read.
///
/// Vertices are dealt out to the caller's parts, or to parts of about `vertices_per_part` by recursive coordinate
/// bisection, a number that depends on the mesh alone. A part lists every edge that touches one of its vertices, so an edge between two parts is
/// listed, and its flux computed, twice; each part adds to its own vertices only. The sums of a vertex are therefore
/// taken in one order whatever the parts and the number of threads: the same bits.
template <int dim>
struct EdgePlan {
  static constexpr std::size_t vertices_per_part = 2048;

  std::size_t vertex_count{};
  std::vector<double> volume;  ///< of each control volume
  CompressedRows<std::uint32_t>
      neighbours;                 ///< row v: neighbours of v, ascending. A slot is a place among all links
  /// Of joined duals (MeshDual::span), row v: the other end of each edge of v, so that neighbours may come twice and v itself too;
  /// empty: as neighbours.
  CompressedRows<std::uint32_t> stencil;
  std::vector<StencilSlot<dim>> slot;  ///< one a link of the stencil
  std::vector<std::uint32_t> diagonal;  ///< one a vertex: see diagonal_block

  std::vector<PartRange> parts;
  std::vector<std::uint32_t> part_of;        ///< one a vertex
  std::vector<std::uint32_t> part_vertices;  ///< of part 0, part 1, ...; ascending in each
  std::vector<EdgeEnds> ends;                ///< padded to whole batches with edges of size 0
  std::vector<EdgeMetric<dim>> metric;       ///< one a batch
  std::vector<std::uint32_t> part_boundary;  ///< entries of dual.boundary that touch the part
  bool repeats_edges = false;                ///< two vertices may have more than one edge

  [[nodiscard]] SweepMesh<dim> view() const;
  /// Vertices plus one line of rubbish a part, for what an edge would add to a vertex of another part.
  [[nodiscard]] std::size_t padded_count() const { return vertex_count + rubbish_stride * parts.size(); }
  /// Position of the diagonal block of row v, and of the block of a neighbour slot s of v, in a block matrix whose rows
  /// hold the neighbours and v itself in ascending order.
  [[nodiscard]] std::uint32_t diagonal_block(std::uint32_t v) const { return diagonal[v]; }
  [[nodiscard]] std::uint32_t neighbour_block(std::uint32_t v, std::uint32_t s) const {
    return s + v + (neighbours.links()[s] > v ? 1u : 0u);
  }
  /// The slot of a neighbour of v. Cost O(log degree).
  [[nodiscard]] std::uint32_t slot_to(std::uint32_t v, std::uint32_t other) const;
  /// The block of row v in the column of w, v itself or a neighbour. Cost O(log degree).
  [[nodiscard]] std::size_t block_of(std::uint32_t v, std::uint32_t w) const {
    return v == w ? diagonal_block(v) : neighbour_block(v, slot_to(v, w));
  }
  [[nodiscard]] std::size_t block_count() const { return neighbours.link_count() + vertex_count; }
};

/// Gradients are least squares over the edge neighbours, each equation weighted by the inverse of the distance
/// (Barth's notes 4.2; exact for linear functions); a vertex whose neighbours lie on one line, or in space on one plane,
/// gets the gradient along it. Or, away from the boundary, by Green and Gauss: half of each face vector over the control volume.
///
/// part_of  one a vertex, each below `parts` (a part may be empty); an empty list: parts of the plan's own making
/// dual     checked (check_problem)
/// Cost O(vertices log parts).
template <int dim>
[[nodiscard]] EdgePlan<dim> make_edge_plan(const MeshDual<dim>& dual, std::span<const std::uint32_t> part_of = {},
                                           std::uint32_t parts = 0, GradientKind gradient = GradientKind::least_squares);

}  // namespace leonhard::solver
