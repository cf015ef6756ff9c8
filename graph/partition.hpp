// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::graph {

enum class PartitionOutcome {
  done,
  empty_parts,  ///< more parts than vertices were asked for: the first n parts hold one vertex, the rest none
  stopped       ///< stop was requested: a valid balanced partition, but its last splits are by index only
};

/// To each vertex (point, triangle) its part.
struct [[nodiscard]] Partition {
  std::uint32_t parts{};
  std::vector<std::uint32_t> part_of;  ///< one a vertex, each below `parts`
  PartitionOutcome outcome = PartitionOutcome::done;
};

/// Recursive coordinate bisection: halve the point set across the longer side of its bounding box.
///
/// Parts differ by at most one point for any number of parts (k parts split as floor(k/2) and the rest,
/// points in proportion). Points are ordered along the longer side, ties by the other coordinate, then by
/// index; a square box is split along x. The first parts hold the smaller coordinates.
///
/// throws  InputError if parts is 0 or a point is not finite
/// Cost O(n log(parts)) expected. Barth's notes 2.3.
Partition recursive_coordinate_bisection(std::span<const Point2> points, std::uint32_t parts);

/// Recursive spectral bisection: halve the graph at the median of its Fiedler vector.
///
/// Parts differ by at most one vertex for any number of parts, as above. Where a piece is not connected its
/// components are dealt out whole, the largest first, and at most one of them is split.
///
/// seed      of the eigensolver's start; the same graph and seed give the same partition
/// progress  stage "spectral bisection"
/// throws    InputError if parts is 0
/// Cost on meshes: about log2(parts) Fiedler vectors of the whole graph.
/// Method: Pothen, Simon and Liou, SIAM J. Matrix Anal. Appl. 11 (1990) 430-452; Barth's notes 2.3.
Partition recursive_spectral_bisection(const CsrGraph& graph, std::uint32_t parts, std::uint64_t seed = 1,
                                       const Progress& progress = {});

/// A partition of the vertices from one of the triangles: a vertex goes to the part that holds most of its
/// triangles, the smallest such part where several do. Parts of few triangles may be left without a vertex.
///
/// throws  InputError if the partition is not of the mesh's triangles or names a part out of range
/// Cost O(triangles).
Partition vertex_partition_from_dual(const TriangleMesh& mesh, const Partition& triangles);

/// What a partition costs, part by part.
struct PartitionCost {
  std::size_t cut{};   ///< edges between different parts
  double imbalance{};  ///< largest part over mean part, less 1; 0 for perfect balance or no vertices
  std::uint32_t smallest{}, largest{};  ///< vertices of the smallest and largest part

  std::vector<std::uint32_t> sizes;       ///< vertices
  std::vector<std::uint32_t> components;  ///< connected pieces; 0 for an empty part, 1 is what one hopes for
  std::vector<std::uint32_t> neighbours;  ///< parts it shares cut edges with: communication graph degree
  std::vector<std::uint32_t> halo;        ///< vertices of other parts next to it: values it receives

  std::uint32_t max_components{}, max_neighbours{}, max_halo{};
  std::size_t total_halo{};  ///< sum of the halos: the communication volume
};

/// throws  InputError if the partition has not one entry a vertex, has 0 parts, or names a part out of range
/// Cost O(n + m + parts), and a sort of the cut edges.
[[nodiscard]] PartitionCost partition_cost(const CsrGraph& graph, const Partition& partition);

}  // namespace leonhard::graph
