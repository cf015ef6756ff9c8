// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/words.hpp"

/// The invariants that meshes of triangles and of tetrahedra have in common. `cell` is the word for one cell,
/// `cells` that for many.
namespace leonhard::mesh::detail {

template <class Mesh>
[[nodiscard]] std::optional<std::string> broken_sizes(const Mesh& mesh, const std::string& cells) {
  const auto unlike = [](const char* array, std::size_t size, const std::string& of, std::size_t count) {
    return std::string(array) + " has " + std::to_string(size) + " entries for " + std::to_string(count) +
           " " + of;
  };
  const std::size_t v = mesh.points.size(), t = mesh.corners.size();
  if (mesh.neighbours.size() != t) return unlike("neighbours", mesh.neighbours.size(), cells, t);
  if (mesh.regions.size() != t) return unlike("regions", mesh.regions.size(), cells, t);
  if (mesh.vertex_markers.size() != v)
    return unlike("vertex_markers", mesh.vertex_markers.size(), "vertices", v);
  return std::nullopt;
}

template <class Mesh>
[[nodiscard]] std::optional<std::string> broken_point(const Mesh& mesh) {
  for (const VertexId v : mesh.points.ids()) {
    if (!is_finite(mesh.points[v])) return words(mesh, v) + " has a coordinate that is no finite number";
  }
  return std::nullopt;
}

template <class Mesh>
[[nodiscard]] std::optional<std::string> broken_corner(const Mesh& mesh) {
  for (const auto t : mesh.corners.ids()) {
    const auto& corners = mesh.corners[t];
    for (auto corner = corners.begin(); corner != corners.end(); ++corner) {
      if (!mesh.points.contains(*corner)) {
        return "vertex " + std::to_string((*corner).raw) + " of " + words(mesh, t) +
               " does not exist, there are " + std::to_string(mesh.vertex_count()) + " vertices";
      }
      if (std::find(corners.begin(), corner, *corner) != corner)
        return words(mesh, t) + " has a vertex twice";
    }
  }
  return std::nullopt;
}

template <class Mesh>
[[nodiscard]] std::optional<std::string> unused_vertex(const Mesh& mesh, const std::string& cell) {
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) used[v] = 1;
  }
  for (const VertexId v : used.ids()) {
    if (!used[v]) return words(mesh, v) + " belongs to no " + cell;
  }
  return std::nullopt;
}

}  // namespace leonhard::mesh::detail
