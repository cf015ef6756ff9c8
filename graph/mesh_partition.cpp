// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/partition/partition_checks.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/compressed_rows.hpp"
#include "leonhard/mesh/edges.hpp"

namespace leonhard::graph {
namespace {

/// The part that most of a vertex's triangles are in; the smallest of several.
std::uint32_t most_frequent(std::span<std::uint32_t> parts) {
  std::ranges::sort(parts);
  std::uint32_t found = 0;
  std::ptrdiff_t most = 0;
  for (auto run = parts.begin(); run != parts.end();) {
    const auto end = std::upper_bound(run, parts.end(), *run);
    if (end - run > most) {
      most = end - run;
      found = *run;
    }
    run = end;
  }
  return found;
}

bool lacks_coordinates(const PartitionOptions& options) {
  return (options.method == PartitionMethod::coordinate || options.method == PartitionMethod::inertial) &&
         std::visit([](const auto& points) { return points.empty(); }, options.coordinates);
}

template <class Point, class CellId, std::size_t corner_count>
std::vector<Point> corner_means(const PerId<VertexId, Point>& points,
                                const PerId<CellId, std::array<VertexId, corner_count>>& corners) {
  std::vector<Point> means;
  means.reserve(corners.size());
  for (const auto& cell : corners) {
    Point mean{};
    for (const VertexId v : cell) {
      const Point p = points[v];
      mean.x += p.x / corner_count, mean.y += p.y / corner_count;
      if constexpr (std::is_same_v<Point, Point3>) mean.z += p.z / corner_count;
    }
    means.push_back(mean);
  }
  return means;
}

/// The dual graph cut; cells are triangles or tetrahedra.
template <class CellId, class Mesh>
PartitionOf<CellId> partition_cells(const Mesh& mesh, std::uint32_t parts, PartitionOptions options) {
  const CsrGraph graph = dual_graph(mesh);
  const auto means = lacks_coordinates(options) ? corner_means(mesh.points, mesh.corners)
                                                : decltype(corner_means(mesh.points, mesh.corners)){};
  if (lacks_coordinates(options)) options.coordinates = std::span(means);
  return partition_of<CellId>(partition(graph, parts, options));
}

template <class Mesh>
VertexPartition cut_vertices(const Mesh& mesh, const CsrGraph& graph, std::uint32_t parts,
                             PartitionOptions options) {
  if (lacks_coordinates(options)) options.coordinates = std::span(mesh.points.flat());
  return partition_of<VertexId>(partition(graph, parts, options));
}

}  // namespace

TrianglePartition partition_triangles(const TriangleMesh& mesh, std::uint32_t parts,
                                      const PartitionOptions& options) {
  return partition_cells<TriangleId>(mesh, parts, options);
}

TetPartition partition_tets(const TetMesh& mesh, std::uint32_t parts, const PartitionOptions& options) {
  return partition_cells<TetId>(mesh, parts, options);
}

VertexPartition partition_vertices(const TriangleMesh& mesh, std::uint32_t parts,
                                   const PartitionOptions& options) {
  return cut_vertices(mesh, vertex_graph(mesh, mesh::build_edges(mesh)), parts, options);
}

VertexPartition partition_vertices(const TetMesh& mesh, std::uint32_t parts,
                                   const PartitionOptions& options) {
  return cut_vertices(mesh, vertex_graph(mesh), parts, options);
}

VertexPartition vertex_partition_from_dual(const TriangleMesh& mesh, const TrianglePartition& triangles) {
  detail::check_partition(triangles, mesh.triangle_count(), "triangles");
  for (const auto& corners : mesh.corners)
    for (const VertexId v : corners)
      if (!mesh.points.contains(v))
        throw InputError("mesh",
                         "a triangle has corner " + std::to_string(v.raw) + " of " +
                             std::to_string(mesh.vertex_count()) + " vertices",
                         "see mesh::validate");
  auto parts_at = collect_rows<std::uint32_t, std::size_t>(mesh.vertex_count(), [&](const auto& add) {
    for (const TriangleId t : mesh.corners.ids())
      for (const VertexId v : mesh.corners[t]) add(v.index(), triangles.part_of[t]);
  });
  VertexPartition result{triangles.parts, PerId<VertexId, std::uint32_t>(mesh.vertex_count()),
                         triangles.outcome};
  for (const VertexId v : result.part_of.ids()) result.part_of[v] = most_frequent(parts_at[v.index()]);
  return result;
}

}  // namespace leonhard::graph
