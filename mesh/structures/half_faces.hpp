// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/structures/sorted_face.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::mesh {

/// One side of a tetrahedron, seen as a part of the face low-middle-high, whichever way round.
struct HalfFace {
  VertexId middle, high;  ///< the face's vertices but for the smallest, ascending
  TetId tet;              ///< whose side it is
  std::uint8_t side;      ///< 0..3: opposite corners[tet][side]
  bool even;  ///< whether low, middle, high turn counter-clockwise as seen from outside the tetrahedron
};

/// All sides of all tetrahedra, grouped by smallest vertex, sorted by (middle, high, tet) within a group: the table from
/// which neighbours and faces are read.
struct HalfFaceTable {
  std::vector<HalfFace> entries;   ///< 4 per tetrahedron
  std::vector<std::size_t> first;  ///< entries with smallest vertex v are first[v] .. first[v + 1] - 1

  /// The entries of one face, given with its vertices ascending; empty if there is none. Cost O(log degree).
  [[nodiscard]] std::span<const HalfFace> find(const std::array<VertexId, 3>& face) const;
};

/// The table of a mesh whose corners are in range and distinct within each tetrahedron.
/// Cost O(vertices + tetrahedra log degree).
[[nodiscard]] HalfFaceTable half_face_table(const TetMesh& mesh);

/// Calls visit(low, half-faces of one face) for each face in the order of (low, middle, high) until it returns true.
template <class Visit>
void for_each_face_until(const HalfFaceTable& table, Visit visit) {
  const auto same = [](const HalfFace& a, const HalfFace& b) {
    return a.middle == b.middle && a.high == b.high;
  };
  for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
    for (std::size_t begin = table.first[v], end = begin; begin < table.first[v + 1]; begin = end) {
      while (end < table.first[v + 1] && same(table.entries[end], table.entries[begin])) ++end;
      if (visit(VertexId::from(v), std::span(table.entries).subspan(begin, end - begin))) return;
    }
  }
}

/// Words for the first face that has more than two tetrahedra or two on the same side (a tetrahedron given twice
/// included); none if every face is that of an oriented space.
[[nodiscard]] std::optional<std::string> broken_face(const TetMesh& mesh, const HalfFaceTable& table);

/// The neighbours that the table implies, shaped as TetMesh::neighbours. Every face must be in order (broken_face).
[[nodiscard]] PerId<TetId, std::array<MaybeId<TetId>, 4>> neighbours_of(const TetMesh& mesh,
                                                                        const HalfFaceTable& table);

}  // namespace leonhard::mesh
