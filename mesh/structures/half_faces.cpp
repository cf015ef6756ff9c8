// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/half_faces.hpp"

#include <algorithm>
#include <tuple>

#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

std::array<VertexId, 4> sorted_corners(const TetMesh& mesh, TetId t) {
  auto corners = mesh.corners[t];
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Words for what is wrong with one face, given its half-faces; none if it is in order.
std::optional<std::string> broken_group(const TetMesh& mesh, VertexId low, std::span<const HalfFace> group) {
  if (group.size() == 1 || (group.size() == 2 && group[0].even != group[1].even)) return std::nullopt;
  for (std::size_t i = 0; i + 1 < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const TetId s = group[i].tet, t = group[j].tet;
      if (sorted_corners(mesh, s) == sorted_corners(mesh, t)) {
        return words(mesh, t) + " has the same vertices as tetrahedron " + std::to_string(s.raw);
      }
    }
  }
  const std::string face = words(mesh, {low, group[0].middle, group[0].high});
  const std::string first_two = std::to_string(group[0].tet.raw) + " and " + std::to_string(group[1].tet.raw);
  if (group.size() == 2) {
    return "tetrahedra " + first_two + " lie on the same side of " + face +
           ": one of them is turned over or overlaps";
  }
  return face + " belongs to " + std::to_string(group.size()) + " tetrahedra, among them " + first_two +
         " and " + std::to_string(group[2].tet.raw);
}

/// The smallest vertex of each of a tetrahedron's faces: its smallest, but on the face opposite that one its second.
std::array<VertexId, 4> lows_of(const std::array<VertexId, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  const VertexId ab = std::min(a, b), cd = std::min(c, d);
  return {std::min(b, cd), std::min(a, cd), std::min(d, ab), std::min(c, ab)};
}

}  // namespace

std::span<const HalfFace> HalfFaceTable::find(const std::array<VertexId, 3>& face) const {
  const std::size_t low = face[0].index();
  if (low + 1 >= first.size()) return {};
  const auto group = std::span(entries).subspan(first[low], first[low + 1] - first[low]);
  const auto begin = std::partition_point(group.begin(), group.end(), [&](const HalfFace& h) {
    return std::tie(h.middle, h.high) < std::tie(face[1], face[2]);
  });
  auto end = begin;
  while (end != group.end() && end->middle == face[1] && end->high == face[2]) ++end;
  return {begin, end};
}

HalfFaceTable half_face_table(const TetMesh& mesh) {
  HalfFaceTable table;
  table.first.assign(mesh.vertex_count() + 1, 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId low : lows_of(corners)) ++table.first[low.index() + 1];
  }
  for (std::size_t v = 1; v < table.first.size(); ++v) table.first[v] += table.first[v - 1];

  table.entries.resize(4 * mesh.tet_count());
  std::vector<std::size_t> next(table.first.begin(), table.first.end() - 1);
  for (const TetId t : mesh.corners.ids()) {
    for (std::uint8_t side = 0; side < 4; ++side) {
      const SortedFace face = sorted_face(outward_face(mesh.corners[t], side));
      const auto& [low, middle, high] = face.corners;
      table.entries[next[low.index()]++] = {middle, high, t, side, face.even};
    }
  }
  const auto before = [](const HalfFace& a, const HalfFace& b) {
    if (a.middle != b.middle) return a.middle < b.middle;
    if (a.high != b.high) return a.high < b.high;
    return a.tet < b.tet;
  };
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto begin = table.entries.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(table.first[v]),
              begin + static_cast<std::ptrdiff_t>(table.first[v + 1]), before);
  }
  return table;
}

std::optional<std::string> broken_face(const TetMesh& mesh, const HalfFaceTable& table) {
  std::optional<std::string> problem;
  for_each_face_until(table, [&](VertexId low, std::span<const HalfFace> group) {
    problem = broken_group(mesh, low, group);
    return problem.has_value();
  });
  return problem;
}

PerId<TetId, std::array<MaybeId<TetId>, 4>> neighbours_of(const TetMesh& mesh, const HalfFaceTable& table) {
  PerId<TetId, std::array<MaybeId<TetId>, 4>> neighbours(mesh.tet_count());
  for_each_face_until(table, [&](VertexId, std::span<const HalfFace> group) {
    if (group.size() == 2) {
      neighbours[group[0].tet][group[0].side] = group[1].tet;
      neighbours[group[1].tet][group[1].side] = group[0].tet;
    }
    return false;
  });
  return neighbours;
}

}  // namespace leonhard::mesh
