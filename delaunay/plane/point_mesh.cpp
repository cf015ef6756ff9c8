// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/point_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/delaunay/support/parallel.hpp"

namespace leonhard::delaunay {
namespace {

/// One an input point: its vertex in the mesh.
std::vector<MaybeId<VertexId>> vertices_of_input(const SortedPoints& sorted) {
  const std::size_t n = sorted.sorted_index.size();
  std::vector<MaybeId<VertexId>> vertex_of(n);
  if (sorted.first_input.size() == n) {
    for (std::size_t i = 0; i < n; ++i) vertex_of[i] = VertexId::from(i);
    return vertex_of;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = sorted.first_input[sorted.sorted_index[i]];
    vertex_of[i] = first == i ? VertexId::from(count++) : *vertex_of[first];
  }
  return vertex_of;
}

/// Keep the points that made a vertex, which come in the order of their vertices.
std::vector<Point2> vertex_points(std::vector<Point2> input, const std::vector<MaybeId<VertexId>>& vertex_of,
                                  std::size_t count) {
  if (count < input.size()) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < input.size(); ++i)
      if ((*vertex_of[i]).index() == next) input[next++] = input[i];
    input.resize(count);
  }
  return input;
}

/// One a triangle: its number among the real ones, none for a ghost.
PerId<AnyTriangleId, MaybeId<TriangleId>> real_numbers(const GhostTriangulation& cells) {
  PerId<AnyTriangleId, MaybeId<TriangleId>> number(large_vector<MaybeId<TriangleId>>(cells.triangle_count()));
  std::size_t count = 0;
  for (const AnyTriangleId t : number.ids())
    if (!cells.is_ghost(t)) number[t] = TriangleId::from(count++);
  return number;
}

std::vector<MarkedEdge> hull_edges(const GhostTriangulation& cells,
                                   std::span<const std::uint32_t> vertex_number) {
  const auto vertex = [&](AnyTriangleId g, unsigned i) {
    return VertexId{vertex_number[cells.corner(g, i).index()]};
  };
  MaybeId<AnyTriangleId> first;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    if (!cells.is_ghost(t)) continue;
    ++count;
    if (!first || vertex(t, 2) < vertex(*first, 2)) first = t;
  }
  std::vector<MarkedEdge> boundary;
  boundary.reserve(count);
  for (AnyTriangleId g = *first; boundary.size() < count; g = cells.triangle(cells.twin(cells.side(g, 2))))
    boundary.push_back({vertex(g, 2), vertex(g, 1), 1});
  return boundary;
}

/// TriangleMesh's neighbours of the `count` real triangles.
PerId<TriangleId, std::array<MaybeId<TriangleId>, 3>> neighbours_of(const GhostTriangulation& cells,
                                                                    std::size_t count, unsigned threads) {
  PerId<TriangleId, std::array<MaybeId<TriangleId>, 3>> neighbours(
      large_vector<std::array<MaybeId<TriangleId>, 3>>(count));
  const PerId<AnyTriangleId, MaybeId<TriangleId>> number = real_numbers(cells);
  parallel_for_indices(0, number.size(), threads, [&](std::size_t i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    if (!number[t]) return;
    for (unsigned k = 0; k < 3; ++k)
      neighbours[*number[t]][k] = number[cells.triangle(cells.twin(cells.side(t, k)))];
  });
  return neighbours;
}

}  // namespace

PointMesh to_mesh(GhostTriangulation cells, SortedPoints sorted, std::vector<Point2> input,
                  unsigned threads) {
  PointMesh result;
  TriangleMesh& mesh = result.mesh;
  result.vertex_of_input = vertices_of_input(sorted);
  release(sorted.sorted_index);
  std::vector<std::uint32_t> number_of = std::move(sorted.first_input);
  const std::size_t vertices = number_of.size();
  if (vertices < input.size())
    for (std::uint32_t& i : number_of) i = static_cast<std::uint32_t>((*result.vertex_of_input[i]).raw);
  mesh.points.flat() = vertex_points(std::move(input), result.vertex_of_input, vertices);

  mesh.boundary = hull_edges(cells, number_of);
  const std::size_t count = cells.triangle_count() - mesh.boundary.size();
  mesh.neighbours = neighbours_of(cells, count, threads);
  auto& corners = mesh.corners.flat() = std::move(cells).take_corners();
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    if (corners[t][0] != GhostTriangulation::ghost)
      for (VertexId& v : corners[t]) v = VertexId{number_of[v.index()]};
  });
  std::erase_if(corners, [](const auto& triangle) { return triangle[0] == GhostTriangulation::ghost; });
  release(number_of);
  mesh.regions.flat() = large_vector<double>(count);
  mesh.vertex_markers.resize(vertices, 0);
  return result;
}

}  // namespace leonhard::delaunay
