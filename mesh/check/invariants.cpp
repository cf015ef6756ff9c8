// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/invariants.hpp"

#include <algorithm>
#include <tuple>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/check/invariants_impl.hpp"
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
  return detail::broken_sizes(mesh, "triangles");
}

std::optional<std::string> broken_point(const TriangleMesh& mesh) { return detail::broken_point(mesh); }

std::optional<std::string> broken_corner(const TriangleMesh& mesh) { return detail::broken_corner(mesh); }

std::optional<std::string> unused_vertex(const TriangleMesh& mesh) {
  return detail::unused_vertex(mesh, "triangle");
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
