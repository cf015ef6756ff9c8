// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition_options.hpp"
#include "leonhard/graph/partition_parts.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::graph {

/// Recursive coordinate bisection: halve the point set across the longer side of its bounding box.
///
/// Parts differ by at most one point for any number of parts (k parts split as floor(k/2) and the rest,
/// points in proportion). Points are ordered along the longer side, ties by the other coordinate, then by
/// index; a square box is split along x. The first parts hold the smaller coordinates.
///
/// weights  one a point, positive; empty: all the same. With weights the parts' weights are in proportion as nearly as
///          points allow.
/// throws   InputError if parts is 0, a point is not finite, or weights are not as many as points
/// Cost O(n log(parts)) expected, with weights O(n log(n) log(parts)). Barth's notes 2.3.
Partition recursive_coordinate_bisection(std::span<const Point2> points, std::uint32_t parts,
                                         std::span<const std::uint32_t> weights = {});
Partition recursive_coordinate_bisection(std::span<const Point3> points, std::uint32_t parts,
                                         std::span<const std::uint32_t> weights = {});

/// Recursive inertial bisection: halve the point set across the axis along which it spreads most (the principal axis
/// of its inertia), whatever its direction. Balance, weights and errors as above; ties are broken by index.
///
/// Method: Simon, Computing Systems in Engineering 2 (1991) 135-148.
Partition recursive_inertial_bisection(std::span<const Point2> points, std::uint32_t parts,
                                       std::span<const std::uint32_t> weights = {});
Partition recursive_inertial_bisection(std::span<const Point3> points, std::uint32_t parts,
                                       std::span<const std::uint32_t> weights = {});

/// Where a Cuthill-McKee ordering is cut in two.
enum class CuthillMcKeeCut {
  median,    ///< balance within one vertex
  level_set  ///< at the boundary of breadth-first levels nearest to the median: fewer pieces, less balance
};

struct CuthillMcKeeOptions {
  double imbalance =
      1;  ///< of the heaviest part, for level_set: where no boundary keeps it the median is taken
  std::span<const std::uint32_t> weights{};  ///< as above; with weights level_set is the median
  Progress progress{};                       ///< only its stop is used
};

/// Recursive bisection of the Cuthill-McKee ordering of each piece (Barth's notes 2.3, figure 2.3.3).
///
/// throws  InputError if parts is 0, the imbalance negative, or weights are not as many as vertices
/// Cost O(m log(parts)) and a sort of each row.
Partition recursive_cuthill_mckee_bisection(const CsrGraph& graph, std::uint32_t parts, CuthillMcKeeCut where,
                                            const CuthillMcKeeOptions& options = {});

/// Recursive spectral bisection: halve the graph at the median of its Fiedler vector.
///
/// Parts differ by at most one vertex for any number of parts, as above. Where a piece is not connected its
/// components are dealt out whole, the largest first, and at most one of them is split.
///
/// seed      of the eigensolver's start; the same graph and seed give the same partition
/// progress  stage "spectral bisection"
/// weights   as above
/// throws    InputError if parts is 0, or weights are not as many as vertices
/// Cost on meshes: about log2(parts) Fiedler vectors of the whole graph.
/// Method: Pothen, Simon and Liou, SIAM J. Matrix Anal. Appl. 11 (1990) 430-452; Barth's notes 2.3.
Partition recursive_spectral_bisection(const CsrGraph& graph, std::uint32_t parts, std::uint64_t seed = 1,
                                       const Progress& progress = {},
                                       std::span<const std::uint32_t> weights = {});

/// A partition of a graph's vertices by any of the methods: parts of nearly equal weight, few edges between them.
///
/// No part is heavier than heaviest_allowed(); if all vertices weigh the same that always succeeds, otherwise the
/// outcome may be `unbalanced`. No part is empty. A geometric, spectral or Cuthill-McKee partition is as its own
/// function gives it, unless that breaks the bound.
///
/// parts   at least 1, at most the number of vertices (1 for a graph without any)
/// throws  InputError on parts, imbalance, weights or coordinates that do not fit; on weights whose sum is 2^31 or more
/// Method, multilevel: Karypis and Kumar, SIAM J. Sci. Comput. 20 (1998) 359-392; Sanders and Schulz, ESA 2011.
Partition partition(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options = {});

/// The weight that no part may exceed: (1 + imbalance) times the mean, rounded down, but at least the mean rounded up.
///
/// weight  of all vertices together
/// throws  InputError if there are no parts, or the imbalance is negative or not finite
[[nodiscard]] std::int64_t heaviest_allowed(std::int64_t weight, std::uint32_t parts, double imbalance);

/// A mesh cut in one call: the partition() of its dual graph or of its vertex graph, typed by what was cut.
///
/// options  weights one a cell or vertex, edge weights as in dual_graph() or vertex_graph(). Without coordinates a method
///          that needs some takes the vertices' points and the cells' corner means
/// throws   InputError as partition() and the graphs do
TrianglePartition partition_triangles(const TriangleMesh& mesh, std::uint32_t parts,
                                      const PartitionOptions& options = {});
VertexPartition partition_vertices(const TriangleMesh& mesh, std::uint32_t parts,
                                   const PartitionOptions& options = {});
TetPartition partition_tets(const TetMesh& mesh, std::uint32_t parts, const PartitionOptions& options = {});
VertexPartition partition_vertices(const TetMesh& mesh, std::uint32_t parts,
                                   const PartitionOptions& options = {});

/// A partition of the vertices from one of the triangles: a vertex goes to the part that holds most of its
/// triangles, the smallest such part where several do. Parts of few triangles may be left without a vertex.
///
/// throws  InputError if the partition is not of the mesh's triangles or names a part out of range
/// Cost O(triangles).
VertexPartition vertex_partition_from_dual(const TriangleMesh& mesh, const TrianglePartition& triangles);

/// What a partition costs, part by part.
struct PartitionCost {
  std::size_t cut{};           ///< edges between different parts
  std::uint64_t cut_weight{};  ///< their weight
  double imbalance{};          ///< heaviest part over mean part, less 1; 0 for perfect balance or no vertices
  std::uint32_t smallest{}, largest{};  ///< vertices of the smallest and largest part

  std::vector<std::uint32_t> sizes;       ///< vertices
  std::vector<std::uint64_t> weights;     ///< of the vertices
  std::vector<std::uint32_t> components;  ///< connected pieces; 0 for an empty part, 1 is what one hopes for
  std::vector<std::uint32_t> neighbours;  ///< parts it shares cut edges with: communication graph degree
  std::vector<std::uint32_t> halo;        ///< vertices of other parts next to it: values it receives

  std::uint32_t max_components{}, max_neighbours{}, max_halo{};
  std::size_t total_halo{};  ///< sum of the halos: the communication volume
};

/// vertex_weights  one a vertex; empty: all 1
/// edge_weights    one a directed edge in the graph's sequence, of which the one at the smaller end counts; empty: all 1
/// throws  InputError if the partition has not one entry a vertex, has 0 parts, or names a part out of range, or
///         weights are not as many as they should be
/// Cost O(n + m + parts), and a sort of the cut edges.
[[nodiscard]] PartitionCost partition_cost(const CsrGraph& graph, const PartitionView& partition,
                                           std::span<const std::uint32_t> vertex_weights = {},
                                           std::span<const std::uint32_t> edge_weights = {});

}  // namespace leonhard::graph
