// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/boundary_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {
namespace {

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw InputError(where, problem, "give a mesh that passes validate");
}

std::array<VertexId, 2> vertices_of(const MarkedEdge& edge) { return {edge.from, edge.to}; }
std::array<VertexId, 3> vertices_of(const MarkedFace& face) { return face.corners; }

template <class CellId, std::size_t N>
struct Side {
  std::array<VertexId, N> vertices;  // ascending
  CellSide<CellId> place;
  bool found = false;
};

template <class CellId, class Mesh>
std::vector<CellSide<CellId>> boundary_cells_of(const Mesh& mesh) {
  constexpr std::size_t n = std::tuple_size_v<typename decltype(Mesh::corners)::value_type>;
  if (mesh.neighbours.size() != mesh.corners.size())
    fail("neighbours", std::to_string(mesh.neighbours.size()) + " entries for " +
                           std::to_string(mesh.corners.size()) + " cells");
  std::vector<Side<CellId, n - 1>> sides;
  for (const CellId c : mesh.corners.ids()) {
    for (unsigned i = 0; i < n; ++i) {
      if (mesh.neighbours[c][i]) continue;
      std::array<VertexId, n - 1> vertices;
      for (unsigned j = 1; j < n; ++j) vertices[j - 1] = mesh.corners[c][(i + j) % n];
      std::sort(vertices.begin(), vertices.end());
      sides.push_back({vertices, {c, i}});
    }
  }
  if (sides.size() != mesh.boundary.size())
    fail("boundary", std::to_string(mesh.boundary.size()) + " entries for " + std::to_string(sides.size()) +
                         " sides without neighbour");
  std::sort(sides.begin(), sides.end(), [](const auto& s, const auto& t) { return s.vertices < t.vertices; });

  std::vector<CellSide<CellId>> places;
  places.reserve(sides.size());
  for (const auto& entry : mesh.boundary) {
    auto vertices = vertices_of(entry);
    std::sort(vertices.begin(), vertices.end());
    const auto side = std::lower_bound(sides.begin(), sides.end(), vertices,
                                       [](const auto& s, const auto& v) { return s.vertices < v; });
    if (side == sides.end() || side->vertices != vertices || side->found)
      fail("boundary", "entry " + std::to_string(places.size()) +
                           " is no side without neighbour, or a second entry of one");
    side->found = true;
    places.push_back(side->place);
  }
  return places;
}

}  // namespace

std::vector<CellSide<TriangleId>> boundary_cells(const TriangleMesh& mesh) {
  return boundary_cells_of<TriangleId>(mesh);
}
std::vector<CellSide<TetId>> boundary_cells(const TetMesh& mesh) { return boundary_cells_of<TetId>(mesh); }

}  // namespace leonhard::mesh
