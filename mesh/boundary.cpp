// SPDX-License-Identifier: MIT
#include "leonhard/mesh/boundary.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/exact_sum.hpp"
#include "leonhard/mesh/structures/boundary_cells.hpp"

namespace leonhard::mesh {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// To each cell the component it is of, numbered in the order of their smallest cells.
template <class CellId, std::size_t N>
PerId<CellId, std::size_t> components_of(const PerId<CellId, std::array<MaybeId<CellId>, N>>& neighbours) {
  DisjointSets sets(neighbours.size());
  for (const CellId c : neighbours.ids()) {
    for (const MaybeId<CellId> d : neighbours[c]) {
      if (d) sets.join(c.index(), (*d).index());
    }
  }
  std::vector<std::size_t> number_of_class(neighbours.size(), none);
  PerId<CellId, std::size_t> component;
  component.reserve(neighbours.size());
  std::size_t count = 0;
  for (const CellId c : neighbours.ids()) {
    std::size_t& number = number_of_class[sets.find(c.index())];
    if (number == none) number = count++;
    component.push_back(number);
  }
  return component;
}

/// The sides of the boundary, sorted by cell, with their entries in mesh.boundary.
template <class CellId>
class SideTable {
 public:
  explicit SideTable(const std::vector<CellSide<CellId>>& of_entry) {
    sides_.reserve(of_entry.size());
    for (std::size_t e = 0; e < of_entry.size(); ++e) sides_.emplace_back(of_entry[e], e);
    std::sort(sides_.begin(), sides_.end());
  }
  [[nodiscard]] std::size_t entry_of(const CellSide<CellId>& side) const {
    return std::lower_bound(sides_.begin(), sides_.end(), std::pair(side, std::size_t{0}))->second;
  }
  [[nodiscard]] const auto& sides() const { return sides_; }

 private:
  std::vector<std::pair<CellSide<CellId>, std::size_t>> sides_;
};

template <std::size_t N>
unsigned corner_of(const std::array<VertexId, N>& corners, VertexId v) {
  return static_cast<unsigned>(std::find(corners.begin(), corners.end(), v) - corners.begin());
}

// ---- the plane ----

/// The side that goes on from the end of another one, at the other end of the fan of triangles there.
CellSide<TriangleId> next_side(const TriangleMesh& mesh, CellSide<TriangleId> side) {
  const VertexId end = mesh.corners[side.cell][(side.side + 2) % 3];
  TriangleId t = side.cell;
  const auto clockwise_side = [&] { return (corner_of(mesh.corners[t], end) + 2) % 3; };
  while (const MaybeId<TriangleId> across = mesh.neighbours[t][clockwise_side()]) t = *across;
  return {t, clockwise_side()};
}

/// The loop of edges in mesh.boundary, each going on from the one before it.
BoundaryLoop loop_of(const TriangleMesh& mesh, std::vector<std::size_t> entries) {
  const auto from = [&](std::size_t e) { return mesh.boundary[e].from; };
  std::rotate(entries.begin(),
              std::min_element(entries.begin(), entries.end(),
                               [&](std::size_t e, std::size_t f) { return from(e) < from(f); }),
              entries.end());
  BoundaryLoop loop;
  ExactSum area2;
  for (const std::size_t e : entries) {
    const MarkedEdge& edge = mesh.boundary[e];
    loop.vertices.push_back(edge.from);
    loop.markers.push_back(edge.marker);
    const Point2 a = mesh.points[edge.from], b = mesh.points[edge.to];
    area2.add_cross(a.x, a.y, b.x, b.y);
  }
  loop.is_outer = area2.sign() == Sign::positive;
  return loop;
}

// ---- space ----

/// The side on the boundary that the tetrahedra about one of another side's edges lead to: the edge without its corner
/// `apex`.
CellSide<TetId> across_edge(const TetMesh& mesh, const CellSide<TetId>& side, VertexId apex) {
  TetId t = side.cell;
  VertexId behind = mesh.corners[t][side.side];  // the corner of t that is not on the side where we came in
  unsigned exit = corner_of(mesh.corners[t], apex);
  while (const MaybeId<TetId> across = mesh.neighbours[t][exit]) {
    // The next tetrahedron has the edge, `behind`, and a corner of its own.
    const auto &left = mesh.corners[t], &entered = mesh.corners[*across];
    const auto own = std::find_if(entered.begin(), entered.end(),
                                  [&](VertexId v) { return corner_of(left, v) == left.size(); });
    t = *across;
    exit = corner_of(entered, behind);
    behind = *own;
  }
  return {t, exit};
}

BoundarySurface surface_of(const TetMesh& mesh, std::vector<std::size_t> faces, std::size_t component) {
  ExactSum volume6;
  for (const std::size_t f : faces) {
    const auto& [a, b, c] = mesh.boundary[f].corners;
    volume6.add_determinant(mesh.points[a], mesh.points[b], mesh.points[c]);
  }
  return {std::move(faces), component, volume6.sign() == Sign::positive};
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh) {
  const std::vector<CellSide<TriangleId>> side_of = boundary_cells(mesh);
  const SideTable table(side_of);
  const auto component = components_of(mesh.neighbours);
  std::vector<BoundaryLoop> loops;
  std::vector<bool> done(side_of.size());
  std::vector<std::size_t> walk;  // entries of mesh.boundary
  PerId<VertexId, std::size_t> place_in_walk(mesh.vertex_count(), none);

  const auto cut_loop = [&](std::size_t begin) {
    const auto first = walk.begin() + static_cast<std::ptrdiff_t>(begin);
    for (auto e = first; e != walk.end(); ++e) place_in_walk[mesh.boundary[*e].from] = none;
    loops.push_back(loop_of(mesh, {first, walk.end()}));
    loops.back().component = component[side_of[*first].cell];
    walk.erase(first, walk.end());
  };
  for (const auto& [side, start] : table.sides()) {
    if (done[start]) continue;
    for (std::size_t e = start; !done[e]; e = table.entry_of(next_side(mesh, side_of[e]))) {
      done[e] = true;
      std::size_t& place = place_in_walk[mesh.boundary[e].from];
      if (place != none) cut_loop(place);
      place = walk.size();
      walk.push_back(e);
    }
    cut_loop(0);
  }
  const auto key = [](const BoundaryLoop& loop) {
    return std::make_tuple(loop.component, !loop.is_outer, std::cref(loop.vertices));
  };
  std::sort(loops.begin(), loops.end(),
            [&](const BoundaryLoop& l, const BoundaryLoop& m) { return key(l) < key(m); });
  return loops;
}

std::vector<BoundarySurface> boundary_surfaces(const TetMesh& mesh) {
  const std::vector<CellSide<TetId>> side_of = boundary_cells(mesh);
  const SideTable table(side_of);
  const auto component = components_of(mesh.neighbours);
  DisjointSets joined(side_of.size());
  for (std::size_t f = 0; f < side_of.size(); ++f) {
    for (const VertexId apex : mesh.boundary[f].corners)
      joined.join(f, table.entry_of(across_edge(mesh, side_of[f], apex)));
  }
  std::vector<std::vector<std::size_t>> faces_of_class(side_of.size());
  for (std::size_t f = 0; f < side_of.size(); ++f) faces_of_class[joined.find(f)].push_back(f);
  std::vector<BoundarySurface> surfaces;
  for (auto& faces : faces_of_class) {
    if (faces.empty()) continue;
    const std::size_t part = component[side_of[faces.front()].cell];
    surfaces.push_back(surface_of(mesh, std::move(faces), part));
  }
  const auto key = [](const BoundarySurface& s) {
    return std::tuple(s.component, !s.is_outer, s.faces.front());
  };
  std::sort(surfaces.begin(), surfaces.end(),
            [&](const BoundarySurface& s, const BoundarySurface& t) { return key(s) < key(t); });
  return surfaces;
}

}  // namespace leonhard::mesh
