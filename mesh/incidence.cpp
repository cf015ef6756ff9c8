// SPDX-License-Identifier: MIT
#include "leonhard/mesh/incidence.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {
namespace {

/// The cells at each vertex, in ascending order.
template <class CellId, std::size_t N>
CompressedRows<CellId, std::size_t> cells_at_vertices(std::size_t vertex_count,
                                                      const PerId<CellId, std::array<VertexId, N>>& corners) {
  for (const CellId c : corners.ids()) {
    for (const VertexId v : corners[c]) {
      if (v.index() >= vertex_count)
        throw InputError("cell " + std::to_string(c.raw),
                         "its corner " + std::to_string(v.raw) + " is no vertex, the mesh has " +
                             std::to_string(vertex_count),
                         "give a mesh that passes validate");
    }
  }
  return collect_rows<CellId, std::size_t>(vertex_count, [&](const auto& add) {
    for (const CellId c : corners.ids()) {
      for (const VertexId v : corners[c]) add(v.index(), c);
    }
  });
}

template <class CellId>
std::span<const CellId> row_of(const CompressedRows<CellId, std::size_t>& rows, VertexId v) {
  if (v.index() >= rows.size())
    throw InputError("vertex " + std::to_string(v.raw),
                     "it does not exist, the mesh has " + std::to_string(rows.size()) + " vertices",
                     "ask for a vertex of the mesh that the incidence was made of");
  return rows[v.index()];
}

/// Which corner of a triangle v is.
std::size_t corner_of(const TriangleMesh& mesh, TriangleId t, VertexId v) {
  const auto& corners = mesh.corners[t];
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

/// Across the side of t that lies clockwise or counter-clockwise about its corner v.
MaybeId<TriangleId> clockwise_of(const TriangleMesh& mesh, TriangleId t, VertexId v) {
  return mesh.neighbours[t][(corner_of(mesh, t, v) + 2) % 3];
}
MaybeId<TriangleId> counter_clockwise_of(const TriangleMesh& mesh, TriangleId t, VertexId v) {
  return mesh.neighbours[t][(corner_of(mesh, t, v) + 1) % 3];
}

/// Puts the triangles at a vertex, given in ascending order, into counter-clockwise order, fan by fan.
class FanSorter {
 public:
  explicit FanSorter(const TriangleMesh& mesh) : mesh_(mesh) {}

  void sort(VertexId v, std::span<TriangleId> at_v) {
    ascending_.assign(at_v.begin(), at_v.end());
    std::size_t count = 0;
    for (const TriangleId t : ascending_) {
      if (!clockwise_of(mesh_, t, v)) walk_fan(v, t, at_v, count);
    }
    while (count < at_v.size()) walk_fan(v, first_left(at_v.first(count)), at_v, count);  // closed
  }

 private:
  void walk_fan(VertexId v, TriangleId start, std::span<TriangleId> at_v, std::size_t& count) const {
    MaybeId<TriangleId> t = start;
    do {
      if (count == at_v.size())
        throw InputError("vertex " + std::to_string(v.raw),
                         "the neighbours of its triangles contradict each other",
                         "give a mesh that passes validate");
      at_v[count++] = *t;
      t = counter_clockwise_of(mesh_, *t, v);
    } while (t && *t != start);
  }

  /// The triangle of smallest id that is in no fan yet.
  [[nodiscard]] TriangleId first_left(std::span<const TriangleId> done) const {
    std::vector<TriangleId> sorted(done.begin(), done.end());
    std::sort(sorted.begin(), sorted.end());
    const auto [left, _] = std::mismatch(ascending_.begin(), ascending_.end(), sorted.begin(), sorted.end());
    return *left;
  }

  const TriangleMesh& mesh_;
  std::vector<TriangleId> ascending_;
};

}  // namespace

TriangleIncidence::TriangleIncidence(const TriangleMesh& mesh) {
  if (mesh.neighbours.size() != mesh.corners.size())
    throw InputError("neighbours",
                     std::to_string(mesh.neighbours.size()) + " entries for " +
                         std::to_string(mesh.corners.size()) + " triangles",
                     "call build_neighbours");
  triangles_ = cells_at_vertices(mesh.points.size(), mesh.corners);
  FanSorter sorter(mesh);
  for (const VertexId v : mesh.points.ids()) sorter.sort(v, triangles_[v.index()]);
}

std::span<const TriangleId> TriangleIncidence::triangles_at(VertexId v) const& {
  return row_of(triangles_, v);
}

TetIncidence::TetIncidence(const TetMesh& mesh)
    : tets_(cells_at_vertices(mesh.points.size(), mesh.corners)) {}

std::span<const TetId> TetIncidence::tets_at(VertexId v) const& { return row_of(tets_, v); }

}  // namespace leonhard::mesh
