// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/half_facets.hpp"

#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

template <std::size_t count>
bool comes_before(const std::array<VertexId, count>& a, const std::array<VertexId, count>& b) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (a[i] != b[i]) return a[i] < b[i];
  }
  return a[count - 1] < b[count - 1];
}

template <int Dim>
typename SimplexMesh<Dim>::CellCorners sorted_corners(const SimplexMesh<Dim>& mesh,
                                                      typename Simplex<Dim>::CellId t) {
  auto corners = mesh.corners[t];
  std::sort(corners.begin(), corners.end());
  return corners;
}

template <int Dim>
typename SimplexMesh<Dim>::FacetCorners facet_of(VertexId low, const HalfFacet<Dim>& half) {
  typename SimplexMesh<Dim>::FacetCorners facet{low};
  std::copy(half.higher.begin(), half.higher.end(), facet.begin() + 1);
  return facet;
}

/// Words for what is wrong with one facet, given its half-facets; none if it is in order.
template <int Dim>
std::optional<std::string> broken_group(const SimplexMesh<Dim>& mesh, VertexId low,
                                        std::span<const HalfFacet<Dim>> group) {
  using Kind = Simplex<Dim>;
  if (group.size() == 1 || (group.size() == 2 && group[0].even != group[1].even)) return std::nullopt;
  for (std::size_t i = 0; i + 1 < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const auto s = group[i].cell, t = group[j].cell;
      if (sorted_corners(mesh, s) == sorted_corners(mesh, t)) {
        return words(mesh, t) + " has the same vertices as " + Kind::cell + " " + std::to_string(s.raw);
      }
    }
  }
  const std::string facet = words(mesh, facet_of(low, group[0]));
  const std::string first_two =
      std::to_string(group[0].cell.raw) + " and " + std::to_string(group[1].cell.raw);
  if (group.size() == 2) {
    return std::string(Kind::cells) + " " + first_two + " lie on the same side of " + facet +
           ": one of them is turned over or overlaps";
  }
  return facet + " belongs to " + std::to_string(group.size()) + " " + Kind::cells + ", among them " +
         first_two + " and " + std::to_string(group[2].cell.raw);
}

/// The smallest vertex of each of a cell's facets: its smallest, but on the facet opposite that one its second.
template <std::size_t count>
std::array<VertexId, count> lows_of(const std::array<VertexId, count>& corners) {
  VertexId lowest = std::min(corners[0], corners[1]), next = std::max(corners[0], corners[1]);
  for (std::size_t i = 2; i < count; ++i) {
    next = std::min(next, std::max(lowest, corners[i]));
    lowest = std::min(lowest, corners[i]);
  }
  std::array<VertexId, count> lows;
  for (std::size_t i = 0; i < count; ++i) lows[i] = corners[i] == lowest ? next : lowest;
  return lows;
}

}  // namespace

template <int Dim>
std::span<const HalfFacet<Dim>> HalfFacetTable<Dim>::find(const std::array<VertexId, Dim>& facet) const {
  const std::size_t low = facet[0].index();
  if (low + 1 >= first.size()) return {};
  const auto group = std::span(entries).subspan(first[low], first[low + 1] - first[low]);
  std::array<VertexId, Dim - 1> higher;
  std::copy(facet.begin() + 1, facet.end(), higher.begin());
  const auto begin = std::partition_point(
      group.begin(), group.end(), [&](const HalfFacet<Dim>& h) { return comes_before(h.higher, higher); });
  auto end = begin;
  while (end != group.end() && end->higher == higher) ++end;
  return {begin, end};
}

template <int Dim>
HalfFacetTable<Dim> half_facet_table(const SimplexMesh<Dim>& mesh) {
  HalfFacetTable<Dim> table;
  table.first.assign(mesh.vertex_count() + 1, 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId low : lows_of(corners)) ++table.first[low.index() + 1];
  }
  for (std::size_t v = 1; v < table.first.size(); ++v) table.first[v] += table.first[v - 1];

  table.entries.resize((Dim + 1) * mesh.cell_count());
  std::vector<std::size_t> next(table.first.begin(), table.first.end() - 1);
  for (const auto t : mesh.corners.ids()) {
    for (std::uint8_t side = 0; side <= Dim; ++side) {
      const SortedFacet<Dim> facet = sorted_facet(outward_facet(mesh.corners[t], side));
      HalfFacet<Dim>& half = table.entries[next[facet.corners[0].index()]++];
      std::copy(facet.corners.begin() + 1, facet.corners.end(), half.higher.begin());
      half.cell = t;
      half.side = side;
      half.even = facet.even;
    }
  }
  const auto before = [](const HalfFacet<Dim>& a, const HalfFacet<Dim>& b) {
    return a.higher != b.higher ? comes_before(a.higher, b.higher) : a.cell < b.cell;
  };
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto begin = table.entries.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(table.first[v]),
              begin + static_cast<std::ptrdiff_t>(table.first[v + 1]), before);
  }
  return table;
}

template <int Dim>
std::optional<std::string> broken_facet(const SimplexMesh<Dim>& mesh, const HalfFacetTable<Dim>& table) {
  std::optional<std::string> problem;
  for_each_facet_until(table, [&](VertexId low, std::span<const HalfFacet<Dim>> group) {
    problem = broken_group(mesh, low, group);
    return problem.has_value();
  });
  return problem;
}

template <int Dim>
PerId<typename Simplex<Dim>::CellId, typename SimplexMesh<Dim>::CellNeighbours> neighbours_of(
    const SimplexMesh<Dim>& mesh, const HalfFacetTable<Dim>& table) {
  PerId<typename Simplex<Dim>::CellId, typename SimplexMesh<Dim>::CellNeighbours> neighbours(
      mesh.cell_count());
  for_each_facet_until(table, [&](VertexId, std::span<const HalfFacet<Dim>> group) {
    if (group.size() == 2) {
      neighbours[group[0].cell][group[0].side] = group[1].cell;
      neighbours[group[1].cell][group[1].side] = group[0].cell;
    }
    return false;
  });
  return neighbours;
}

template <int Dim>
FacetList<Dim> facet_list(const SimplexMesh<Dim>& mesh, const HalfFacetTable<Dim>& table) {
  FacetList<Dim> list;
  const std::size_t expected = table.entries.size() / 2 + mesh.boundary.size() / 2 + 1;
  list.corners.reserve(expected);
  list.sides.reserve(expected);
  list.first.assign(mesh.vertex_count() + 1, 0);
  for_each_facet_until(table, [&](VertexId low, std::span<const HalfFacet<Dim>> group) {
    list.corners.push_back(facet_of(low, group[0]));
    list.sides.push_back({});
    for (const HalfFacet<Dim>& half : group) list.sides.flat().back()[half.even ? 0 : 1] = half.cell;
    ++list.first[low.index() + 1];
    return false;
  });
  for (std::size_t v = 1; v < list.first.size(); ++v) list.first[v] += list.first[v - 1];
  return list;
}

template struct HalfFacetTable<2>;
template struct HalfFacetTable<3>;
template HalfFacetTable<2> half_facet_table(const SimplexMesh<2>&);
template HalfFacetTable<3> half_facet_table(const SimplexMesh<3>&);
template std::optional<std::string> broken_facet(const SimplexMesh<2>&, const HalfFacetTable<2>&);
template std::optional<std::string> broken_facet(const SimplexMesh<3>&, const HalfFacetTable<3>&);
template PerId<TriangleId, SimplexMesh<2>::CellNeighbours> neighbours_of(const SimplexMesh<2>&,
                                                                         const HalfFacetTable<2>&);
template PerId<TetId, SimplexMesh<3>::CellNeighbours> neighbours_of(const SimplexMesh<3>&,
                                                                    const HalfFacetTable<3>&);
template FacetList<2> facet_list(const SimplexMesh<2>&, const HalfFacetTable<2>&);
template FacetList<3> facet_list(const SimplexMesh<3>&, const HalfFacetTable<3>&);

}  // namespace leonhard::mesh
