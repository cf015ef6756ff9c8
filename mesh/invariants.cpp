// SPDX-License-Identifier: MIT
#include "leonhard/mesh/invariants.hpp"

#include <algorithm>
#include <tuple>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

std::string neighbour_words(MaybeId<TriangleId> t) {
  return t ? "triangle " + std::to_string((*t).raw) : std::string("none");
}

std::string entry_words(const TriangleMesh& mesh, const char* array, std::size_t entry,
                        const MarkedEdge& edge) {
  return std::string(array) + " entry " + std::to_string(entry) + ", " + words(mesh, edge.from, edge.to) +
         ", marker " + std::to_string(edge.marker) + ",";
}

/// How many triangles have the edge between two vertices of the mesh.
std::ptrdiff_t triangles_at(const HalfEdgeTable& table, VertexId a, VertexId b) {
  const auto begin = table.entries.begin();
  const auto first = static_cast<std::ptrdiff_t>(table.first[std::min(a, b).index()]);
  const auto last = static_cast<std::ptrdiff_t>(table.first[std::min(a, b).index() + 1]);
  return std::count_if(begin + first, begin + last,
                       [&](const HalfEdge& h) { return h.high == std::max(a, b); });
}

}  // namespace

std::optional<std::string> broken_sizes(const TriangleMesh& mesh) {
  const auto unlike = [](const char* array, std::size_t size, const char* of, std::size_t count) {
    return std::string(array) + " has " + std::to_string(size) + " entries for " + std::to_string(count) +
           " " + of;
  };
  const std::size_t v = mesh.vertex_count(), t = mesh.triangle_count();
  if (mesh.neighbours.size() != t) return unlike("neighbours", mesh.neighbours.size(), "triangles", t);
  if (mesh.regions.size() != t) return unlike("regions", mesh.regions.size(), "triangles", t);
  if (mesh.vertex_markers.size() != v)
    return unlike("vertex_markers", mesh.vertex_markers.size(), "vertices", v);
  return std::nullopt;
}

std::optional<std::string> broken_point(const TriangleMesh& mesh) {
  for (const VertexId v : mesh.points.ids()) {
    if (!is_finite(mesh.points[v])) return words(mesh, v) + " has a coordinate that is no finite number";
  }
  return std::nullopt;
}

std::optional<std::string> broken_corner(const TriangleMesh& mesh) {
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    for (const VertexId v : mesh.corners[t]) {
      if (!mesh.points.contains(v)) {
        return "vertex " + std::to_string(v.raw) + " of " + words(mesh, t) + " does not exist, there are " +
               std::to_string(mesh.vertex_count()) + " vertices";
      }
    }
    if (a == b || b == c || c == a) return words(mesh, t) + " has a vertex twice";
  }
  return std::nullopt;
}

std::optional<std::string> unused_vertex(const TriangleMesh& mesh) {
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) used[v] = 1;
  }
  for (const VertexId v : used.ids()) {
    if (!used[v]) return words(mesh, v) + " belongs to no triangle";
  }
  return std::nullopt;
}

std::optional<std::string> broken_orientation(const TriangleMesh& mesh) {
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    const Sign turn = kernel::orient2d(mesh.points[a], mesh.points[b], mesh.points[c]);
    if (turn == Sign::zero) return words(mesh, t) + " has area zero";
    if (turn == Sign::negative) return words(mesh, t) + " is clockwise: its area is negative";
  }
  return std::nullopt;
}

std::optional<std::string> broken_neighbour(const TriangleMesh& mesh, const HalfEdgeTable& table) {
  const auto truth = neighbours_of(mesh, table);
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (mesh.neighbours[t][i] == truth[t][i]) continue;
      return words(mesh, t) + " names " + neighbour_words(mesh.neighbours[t][i]) + " as neighbour " +
             std::to_string(i) + ", but behind " +
             words(mesh, mesh.corners[t][(i + 1) % 3], mesh.corners[t][(i + 2) % 3]) + " there is " +
             neighbour_words(truth[t][i]);
    }
  }
  return std::nullopt;
}

BoundaryEdges::BoundaryEdges(const TriangleMesh& mesh) {
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!mesh.neighbours[t][i])
        edges_.push_back({mesh.corners[t][(i + 1) % 3], mesh.corners[t][(i + 2) % 3], t});
    }
  }
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
}

std::optional<std::size_t> BoundaryEdges::find(VertexId from, VertexId to) const {
  const auto at = std::partition_point(edges_.begin(), edges_.end(), [&](const Edge& e) {
    return std::tie(e.from, e.to) < std::tie(from, to);
  });
  if (at == edges_.end() || at->from != from || at->to != to) return std::nullopt;
  return static_cast<std::size_t>(at - edges_.begin());
}

std::optional<std::string> broken_boundary(const TriangleMesh& mesh, const BoundaryEdges& edges) {
  constexpr std::size_t never = static_cast<std::size_t>(-1);
  std::vector<std::size_t> listed_as(edges.edges().size(), never);
  for (std::size_t entry = 0; entry < mesh.boundary.size(); ++entry) {
    const MarkedEdge& edge = mesh.boundary[entry];
    const auto at = edges.find(edge.from, edge.to);
    if (!at) {
      const bool reversed = edges.find(edge.to, edge.from).has_value();
      return entry_words(mesh, "boundary", entry, edge) +
             (reversed ? " has the mesh on its right" : " is no boundary edge of the mesh");
    }
    if (listed_as[*at] != never) {
      return entry_words(mesh, "boundary", entry, edge) + " is there already as entry " +
             std::to_string(listed_as[*at]);
    }
    listed_as[*at] = entry;
  }
  for (std::size_t i = 0; i < listed_as.size(); ++i) {
    if (listed_as[i] != never) continue;
    const auto& edge = edges.edges()[i];
    return "boundary " + words(mesh, edge.from, edge.to) + " of triangle " +
           std::to_string(edge.triangle.raw) + " has no marker";
  }
  return std::nullopt;
}

std::optional<std::string> broken_constraint(const TriangleMesh& mesh, const HalfEdgeTable& table) {
  for (std::size_t entry = 0; entry < mesh.constraints.size(); ++entry) {
    const MarkedEdge& edge = mesh.constraints[entry];
    const bool in_range = mesh.points.contains(edge.from) && mesh.points.contains(edge.to);
    if (!in_range || triangles_at(table, edge.from, edge.to) != 2) {
      return entry_words(mesh, "constraints", entry, edge) + " is no interior edge of the mesh";
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::mesh
