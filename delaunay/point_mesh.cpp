// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/point_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "leonhard/delaunay/parallel.hpp"

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

/// The edges of the hull; its ghosts are the triangles from `ghosts` on.
std::vector<MarkedEdge> hull_edges(const GhostTriangulation& cells, std::size_t ghosts,
                                   std::span<const std::uint32_t> number_of) {
  const auto number = [&](TriangleId g, unsigned i) {
    return VertexId{number_of[cells.corner(g, i).index()]};
  };
  TriangleId first = TriangleId::from(ghosts);
  for (std::size_t g = ghosts; g < cells.triangle_count(); ++g)
    if (number(TriangleId::from(g), 2) < number(first, 2)) first = TriangleId::from(g);
  std::vector<MarkedEdge> boundary;
  boundary.reserve(cells.triangle_count() - ghosts);
  TriangleId g = first;
  do {
    boundary.push_back({number(g, 2), number(g, 1), 1});
    g = cells.triangle(cells.twin(cells.side(g, 2)));
  } while (g != first);
  return boundary;
}

/// Run body(t) for all triangles below count, in slices.
template <class Body>
void for_triangles(std::size_t count, unsigned threads, const Body& body) {
  constexpr std::size_t slice_size = std::size_t{1} << 15;
  parallel_for_blocks((count + slice_size - 1) / slice_size, threads, [&](std::size_t slice) {
    for (std::size_t t = slice * slice_size; t < std::min(count, (slice + 1) * slice_size); ++t)
      body(TriangleId::from(t));
  });
}

}  // namespace

PointMesh to_mesh(GhostTriangulation cells, SortedPoints sorted, std::vector<Point2> input,
                  unsigned threads) {
  PointMesh result;
  TriangleMesh& mesh = result.mesh;
  result.vertex_of_input = vertices_of_input(sorted);
  sorted.sorted_index = {};
  std::vector<std::uint32_t> number_of = std::move(sorted.first_input);
  const std::size_t vertices = number_of.size();
  if (vertices < input.size())
    for (std::uint32_t& i : number_of) i = static_cast<std::uint32_t>((*result.vertex_of_input[i]).raw);
  mesh.points.flat() = vertex_points(std::move(input), result.vertex_of_input, vertices);

  const std::size_t count = cells.move_ghosts_last();
  mesh.boundary = hull_edges(cells, count, number_of);
  mesh.neighbours.resize(count);
  for_triangles(count, threads, [&](TriangleId t) {
    for (unsigned i = 0; i < 3; ++i) {
      const TriangleId behind = cells.triangle(cells.twin(cells.side(t, i)));
      if (behind.index() < count) mesh.neighbours[t][i] = behind;
    }
  });
  mesh.corners.flat() = std::move(cells).take_corners();
  mesh.corners.resize(count);
  for_triangles(count, threads, [&](TriangleId t) {
    for (VertexId& v : mesh.corners[t]) v = VertexId{number_of[v.index()]};
  });
  mesh.regions.resize(count, 0);
  mesh.vertex_markers.resize(vertices, 0);
  return result;
}

}  // namespace leonhard::delaunay
