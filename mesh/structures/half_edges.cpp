// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/half_edges.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

std::array<VertexId, 3> sorted_corners(const TriangleMesh& mesh, TriangleId t) {
  auto corners = mesh.corners[t];
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Words for what is wrong with one edge, given its half-edges; none if it is in order.
std::optional<std::string> broken_group(const TriangleMesh& mesh, VertexId low,
                                        std::span<const HalfEdge> group) {
  if (group.size() == 1 || (group.size() == 2 && group[0].forward != group[1].forward)) return std::nullopt;
  for (std::size_t i = 0; i + 1 < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const TriangleId s = group[i].triangle, t = group[j].triangle;
      if (sorted_corners(mesh, s) == sorted_corners(mesh, t)) {
        return words(mesh, t) + " has the same vertices as triangle " + std::to_string(s.raw);
      }
    }
  }
  const std::string edge = words(mesh, low, group[0].high);
  const std::string first_two =
      std::to_string(group[0].triangle.raw) + " and " + std::to_string(group[1].triangle.raw);
  if (group.size() == 2) {
    return "triangles " + first_two + " lie on the same side of " + edge +
           ": one of them is turned over or overlaps";
  }
  return edge + " belongs to " + std::to_string(group.size()) + " triangles, among them " + first_two +
         " and " + std::to_string(group[2].triangle.raw);
}

/// Calls visit(low, half-edges of one edge) for each edge in the order of (low, high) until it returns true.
template <class Visit>
void for_each_edge_until(const HalfEdgeTable& table, Visit visit) {
  for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
    for (std::size_t begin = table.first[v], end = begin; begin < table.first[v + 1]; begin = end) {
      while (end < table.first[v + 1] && table.entries[end].high == table.entries[begin].high) ++end;
      if (visit(VertexId::from(v), std::span(table.entries).subspan(begin, end - begin))) return;
    }
  }
}

}  // namespace

HalfEdgeTable half_edge_table(const TriangleMesh& mesh) {
  HalfEdgeTable table;
  table.first.assign(mesh.vertex_count() + 1, 0);
  const auto low_of = [&](TriangleId t, std::size_t side) {
    return std::min(mesh.corners[t][(side + 1) % 3], mesh.corners[t][(side + 2) % 3]);
  };
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t side = 0; side < 3; ++side) ++table.first[low_of(t, side).index() + 1];
  }
  for (std::size_t v = 1; v < table.first.size(); ++v) table.first[v] += table.first[v - 1];

  table.entries.resize(3 * mesh.triangle_count());
  std::vector<std::size_t> next(table.first.begin(), table.first.end() - 1);
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId from = mesh.corners[t][(side + 1) % 3], to = mesh.corners[t][(side + 2) % 3];
      table.entries[next[std::min(from, to).index()]++] = {std::max(from, to), t,
                                                           static_cast<std::uint8_t>(side), from < to};
    }
  }
  const auto before = [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.high, a.triangle, a.side) < std::tie(b.high, b.triangle, b.side);
  };
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto begin = table.entries.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(table.first[v]),
              begin + static_cast<std::ptrdiff_t>(table.first[v + 1]), before);
  }
  return table;
}

std::optional<std::string> broken_edge(const TriangleMesh& mesh, const HalfEdgeTable& table) {
  std::optional<std::string> problem;
  for_each_edge_until(table, [&](VertexId low, std::span<const HalfEdge> group) {
    problem = broken_group(mesh, low, group);
    return problem.has_value();
  });
  return problem;
}

PerId<TriangleId, std::array<MaybeId<TriangleId>, 3>> neighbours_of(const TriangleMesh& mesh,
                                                                    const HalfEdgeTable& table) {
  PerId<TriangleId, std::array<MaybeId<TriangleId>, 3>> neighbours(mesh.triangle_count());
  for_each_edge_until(table, [&](VertexId, std::span<const HalfEdge> group) {
    if (group.size() == 2) {
      neighbours[group[0].triangle][group[0].side] = group[1].triangle;
      neighbours[group[1].triangle][group[1].side] = group[0].triangle;
    }
    return false;
  });
  return neighbours;
}

}  // namespace leonhard::mesh
