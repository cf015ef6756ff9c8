// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/mixed_invariants.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "leonhard/mesh/check/mixed_orientation.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

std::string no_such_vertex(VertexId v, const std::string& of, std::size_t vertices) {
  return "vertex " + std::to_string(v.raw) + " of " + of + " does not exist, there are " +
         std::to_string(vertices) + " vertices";
}

/// A corner of marked facets that is no vertex.
///
/// array  its name
template <int Dim>
std::optional<std::string> marked_corner_out_of_range(const MixedMesh<Dim>& mesh, const char* array,
                                                      const std::vector<MarkedMixedFacet<Dim>>& facets) {
  for (std::size_t entry = 0; entry < facets.size(); ++entry) {
    const auto where = [&] { return std::string(array) + " entry " + std::to_string(entry); };
    if (facets[entry].corners.size() < Dim)
      return where() + " has " + std::to_string(facets[entry].corners.size()) + " corners";
    for (const VertexId v : facets[entry].corners)
      if (!mesh.points.contains(v)) return no_such_vertex(v, where(), mesh.vertex_count());
  }
  return std::nullopt;
}

/// "boundary entry 3, face 0-1-2-3 at ..., marker 2,".
template <int Dim>
std::string marked_words(const MixedMesh<Dim>& mesh, const char* array, std::size_t entry,
                         const MarkedMixedFacet<Dim>& facet) {
  return std::string(array) + " entry " + std::to_string(entry) + ", " + words(mesh, facet.corners) +
         ", marker " + std::to_string(facet.marker) + ",";
}

template <class Corners>
bool repeats(const Corners& corners) {
  for (auto corner = corners.begin(); corner != corners.end(); ++corner)
    if (std::find(corners.begin(), corner, *corner) != corner) return true;
  return false;
}

template <int Dim>
std::vector<VertexId> ascending_corners(const MixedMesh<Dim>& mesh, CellId cell) {
  const auto corners = mesh.corners_of(cell);
  std::vector<VertexId> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Words for what is wrong with one facet, given the sides of cells on it; none if it is in order.
template <int Dim>
std::optional<std::string> broken_group(const MixedMesh<Dim>& mesh, typename MixedSides<Dim>::Group group) {
  if (group.size() == 1 || (group.size() == 2 && group[0].turned != group[1].turned)) return std::nullopt;
  const auto cell_name = [&](CellId cell) {
    return std::string(mesh.shape(cell).name) + " " + std::to_string(cell.raw);
  };
  for (std::size_t i = 0; i + 1 < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size(); ++j) {
      const CellId s = group[i].cell, t = group[j].cell;
      if (ascending_corners(mesh, s) == ascending_corners(mesh, t))
        return words(mesh, t) + " has the same vertices as " + cell_name(s);
    }
  }
  const std::string facet = words(mesh, facet_of_ring<Dim>(group[0].ring));
  const std::string first_two = cell_name(group[0].cell) + " and " + cell_name(group[1].cell);
  if (group.size() == 2)
    return first_two + " lie on the same side of " + facet + ": one of them is turned over or overlaps";
  return facet + " belongs to " + std::to_string(group.size()) + " cells, among them " + first_two + " and " +
         cell_name(group[2].cell);
}

/// A facet of one cell, in words: "face 0-1-2-3 at ... of hexahedron 7".
template <int Dim>
std::string side_words(const MixedMesh<Dim>& mesh, const MixedSide<Dim>& side) {
  return words(mesh, mesh.facet_of(side.cell, side.side)) + " of " + mesh.shape(side.cell).name + " " +
         std::to_string(side.cell.raw);
}

/// The faces that lie on one of four vertices without being it: three of them, or all four in another order.
std::array<MixedFacet<3>, 6> faces_within(const FacetRing<3>& q) {
  return {{{q[0], q[1], q[2]},
           {q[1], q[2], q[3]},
           {q[2], q[3], q[0]},
           {q[3], q[0], q[1]},
           {q[0], q[2], q[1], q[3]},
           {q[0], q[1], q[3], q[2]}}};
}

}  // namespace

template <int Dim>
std::optional<std::string> broken_sizes(const MixedMesh<Dim>& mesh) {
  const auto unlike = [](const char* array, std::size_t size, const char* of, std::size_t count) {
    return std::string(array) + " has " + std::to_string(size) + " entries for " + std::to_string(count) +
           " " + of;
  };
  const std::size_t v = mesh.vertex_count(), c = mesh.cell_count();
  if (mesh.corners.size() != c) return unlike("corners", mesh.corners.size(), "cells", c);
  if (mesh.regions.size() != c) return unlike("regions", mesh.regions.size(), "cells", c);
  if (mesh.vertex_markers.size() != v)
    return unlike("vertex_markers", mesh.vertex_markers.size(), "vertices", v);
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_kind(const MixedMesh<Dim>& mesh) {
  for (const CellId cell : mesh.kinds.ids()) {
    const auto name = [&] { return "cell " + std::to_string(cell.raw); };
    if (static_cast<std::size_t>(mesh.kinds[cell]) >= cell_kind_count)
      return name() + " is of kind " + std::to_string(static_cast<int>(mesh.kinds[cell])) +
             ", which there is not";
    const CellShape& shape = mesh.shape(cell);
    if (shape.dimension != Dim)
      return name() + " is a " + shape.name + ", which is no cell of " + (Dim == 2 ? "the plane" : "space");
    if (mesh.corners_of(cell).size() != shape.corner_count)
      return name() + ", a " + shape.name + ", has " + std::to_string(mesh.corners_of(cell).size()) +
             " corners and not " + std::to_string(shape.corner_count);
  }
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> corner_out_of_range(const MixedMesh<Dim>& mesh) {
  for (const CellId cell : mesh.kinds.ids())
    for (const VertexId v : mesh.corners_of(cell))
      if (!mesh.points.contains(v)) return no_such_vertex(v, words(mesh, cell), mesh.vertex_count());
  if (auto problem = marked_corner_out_of_range(mesh, "boundary", mesh.boundary)) return problem;
  return marked_corner_out_of_range(mesh, "inner_facets", mesh.inner_facets);
}

template <int Dim>
std::optional<std::string> broken_point(const MixedMesh<Dim>& mesh) {
  for (const VertexId v : mesh.points.ids())
    if (!is_finite(mesh.points[v])) return words(mesh, v) + " has a coordinate that is no finite number";
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> repeated_corner(const MixedMesh<Dim>& mesh) {
  for (const CellId cell : mesh.kinds.ids())
    if (repeats(mesh.corners_of(cell))) return words(mesh, cell) + " has a vertex twice";
  for (std::size_t entry = 0; entry < mesh.boundary.size(); ++entry)
    if (repeats(mesh.boundary[entry].corners))
      return marked_words(mesh, "boundary", entry, mesh.boundary[entry]) + " has a vertex twice";
  for (std::size_t entry = 0; entry < mesh.inner_facets.size(); ++entry)
    if (repeats(mesh.inner_facets[entry].corners))
      return marked_words(mesh, "inner_facets", entry, mesh.inner_facets[entry]) + " has a vertex twice";
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> unused_vertex(const MixedMesh<Dim>& mesh) {
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const VertexId v : mesh.corners.links()) used[v] = 1;
  for (const VertexId v : used.ids())
    if (!used[v]) return words(mesh, v) + " belongs to no cell";
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_orientation(const MixedMesh<Dim>& mesh) {
  for (const CellId cell : mesh.kinds.ids()) {
    const Orientation turn = orientation_of(mesh, cell);
    if (turn.sign != Sign::positive) return orientation_words(mesh, cell, turn);
  }
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_facet(const MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides) {
  std::optional<std::string> problem;
  sides.for_each_facet_until([&](auto group) {
    problem = broken_group(mesh, group);
    return problem.has_value();
  });
  return problem;
}

std::optional<std::string> unconforming_face(const MixedMesh<3>& mesh, const MixedSides<3>& sides) {
  std::optional<std::string> problem;
  sides.for_each_facet_until([&](MixedSides<3>::Group group) {
    if (group.size() != 1 || facet_of_ring<3>(group[0].ring).size() != 4) return false;
    for (const MixedFacet<3>& face : faces_within(group[0].ring)) {
      const auto other = sides.find(directed_ring(face).ring);
      if (other.size() != 1) continue;
      problem = side_words(mesh, group[0]) + " meets " + side_words(mesh, other[0]) + ", which has " +
                (face.size() == 3 ? "three of its vertices" : "its vertices in another order") +
                ": the cells do not conform";
      return true;
    }
    return false;
  });
  return problem;
}

template <int Dim>
std::optional<std::string> broken_boundary(const MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides) {
  constexpr std::size_t never = static_cast<std::size_t>(-1);
  const std::string facet_word = Simplex<Dim>::facet;
  std::vector<std::size_t> listed_as(sides.entries().size(), never);
  for (std::size_t entry = 0; entry < mesh.boundary.size(); ++entry) {
    const auto said = [&] { return marked_words(mesh, "boundary", entry, mesh.boundary[entry]); };
    const auto [ring, turned] = directed_ring(mesh.boundary[entry].corners);
    const auto group = sides.find(ring);
    if (group.empty()) return said() + " is no " + facet_word + " of a cell";
    if (group.size() > 1) return said() + " is no boundary " + facet_word + ": it lies between two cells";
    if (group[0].turned != turned)
      return said() + (Dim == 2 ? " has the mesh on its right" : " has a normal that points into the mesh");
    std::size_t& listed = listed_as[sides.number_of(group[0])];
    if (listed != never) return said() + " is there already as entry " + std::to_string(listed);
    listed = entry;
  }
  std::optional<std::string> problem;
  sides.for_each_facet_until([&](auto group) {
    if (group.size() == 1 && listed_as[sides.number_of(group[0])] == never)
      problem = "boundary " + side_words(mesh, group[0]) + " has no marker";
    return problem.has_value();
  });
  return problem;
}

template <int Dim>
std::optional<std::string> broken_inner_facet(const MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides) {
  for (std::size_t entry = 0; entry < mesh.inner_facets.size(); ++entry)
    if (sides.find(directed_ring(mesh.inner_facets[entry].corners).ring).size() != 2)
      return marked_words(mesh, "inner_facets", entry, mesh.inner_facets[entry]) +
             " does not lie between two cells";
  return std::nullopt;
}

template std::optional<std::string> broken_sizes(const MixedMesh<2>&);
template std::optional<std::string> broken_kind(const MixedMesh<2>&);
template std::optional<std::string> corner_out_of_range(const MixedMesh<2>&);
template std::optional<std::string> broken_point(const MixedMesh<2>&);
template std::optional<std::string> repeated_corner(const MixedMesh<2>&);
template std::optional<std::string> unused_vertex(const MixedMesh<2>&);
template std::optional<std::string> broken_orientation(const MixedMesh<2>&);
template std::optional<std::string> broken_facet(const MixedMesh<2>&, const MixedSides<2>&);
template std::optional<std::string> broken_boundary(const MixedMesh<2>&, const MixedSides<2>&);
template std::optional<std::string> broken_inner_facet(const MixedMesh<2>&, const MixedSides<2>&);

template std::optional<std::string> broken_sizes(const MixedMesh<3>&);
template std::optional<std::string> broken_kind(const MixedMesh<3>&);
template std::optional<std::string> corner_out_of_range(const MixedMesh<3>&);
template std::optional<std::string> broken_point(const MixedMesh<3>&);
template std::optional<std::string> repeated_corner(const MixedMesh<3>&);
template std::optional<std::string> unused_vertex(const MixedMesh<3>&);
template std::optional<std::string> broken_orientation(const MixedMesh<3>&);
template std::optional<std::string> broken_facet(const MixedMesh<3>&, const MixedSides<3>&);
template std::optional<std::string> broken_boundary(const MixedMesh<3>&, const MixedSides<3>&);
template std::optional<std::string> broken_inner_facet(const MixedMesh<3>&, const MixedSides<3>&);

}  // namespace leonhard::mesh
