// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/tet_point_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/delaunay/support/parallel.hpp"

namespace leonhard::delaunay {
namespace {

/// One an input point: its vertex in the mesh.
std::vector<MaybeId<VertexId>> vertices_of_input(const SortedOrigin& origin) {
  const std::size_t n = origin.sorted_index.size();
  std::vector<MaybeId<VertexId>> vertex_of(n);
  if (origin.first_input.size() == n) {
    for (std::size_t i = 0; i < n; ++i) vertex_of[i] = VertexId::from(i);
    return vertex_of;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = origin.first_input[origin.sorted_index[i]];
    vertex_of[i] = first == i ? VertexId::from(count++) : *vertex_of[first];
  }
  return vertex_of;
}

}  // namespace

TetPointMesh to_mesh(GhostTetrahedralization cells, SortedOrigin origin, std::vector<Point3> input,
                     unsigned threads) {
  TetPointMesh result;
  TetMesh& mesh = result.mesh;
  result.vertex_of_input = vertices_of_input(origin);
  release(origin.sorted_index);
  std::vector<std::uint32_t> number_of = std::move(origin.first_input);
  const std::size_t vertices = number_of.size();
  if (vertices < input.size()) {
    for (std::uint32_t& i : number_of)
      i = static_cast<std::uint32_t>((*result.vertex_of_input[i]).raw);
    std::size_t next = 0;
    for (std::size_t i = 0; i < input.size(); ++i)
      if ((*result.vertex_of_input[i]).index() == next) input[next++] = input[i];
    input.resize(vertices);
  }
  mesh.points.flat() = std::move(input);
  mesh.corners = std::move(cells.corners);
  mesh.neighbours = std::move(cells.neighbours);
  auto& corners = mesh.corners.flat();
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    for (VertexId& v : corners[t]) v = VertexId{number_of[v.index()]};
  });
  for (const TetId t : mesh.corners.ids()) {
    for (unsigned face = 0; face < 4; ++face) {
      if (mesh.neighbours[t][face]) continue;
      const auto [i, j, k] = tet_face_corners[face];
      mesh.boundary.push_back({{mesh.corners[t][i], mesh.corners[t][j], mesh.corners[t][k]}, 1});
    }
  }
  mesh.regions.resize(mesh.tet_count(), 0);
  mesh.vertex_markers.resize(vertices, 0);
  return result;
}

}  // namespace leonhard::delaunay
