// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/soup_checks.hpp"

#include <limits>

#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

template <int Dim>
void check_counts(const MeshSoup<Dim>& soup) {
  if (soup.mesh.points.empty()) throw InputError(soup.source, "the file holds no points");
  if (soup.mesh.kinds.empty())
    throw InputError(soup.source,
                     std::string("the file holds no cells of ") + (Dim == 2 ? "the plane" : "space"),
                     Dim == 2 ? "" : "a surface has to be filled with a mesh first");
  if (soup.mesh.corners.link_count() >= std::numeric_limits<IdRaw>::max())
    throw InputError(soup.source, "the mesh has more corners than ids can number",
                     sizeof(IdRaw) < 8 ? "build with LEONHARD_64BIT_IDS" : "");
}

template <int Dim>
std::string cell_name(const MeshSoup<Dim>& soup, CellId cell) {
  return std::string(soup.mesh.shape(cell).name) + " " + std::to_string(cell.index());
}

/// Calls visit(corners, where, what) for each cell and each facet; the last two give words.
template <int Dim, class Visit>
void for_each_list_of_corners(const MeshSoup<Dim>& soup, Visit visit) {
  for (const CellId cell : soup.mesh.kinds.ids())
    visit(
        soup.mesh.corners_of(cell), [&] { return place_in(soup, soup.cell_lines, cell.index()); },
        [&] { return cell_name(soup, cell); });
  const auto& facets = soup.mesh.boundary;
  for (std::size_t i = 0; i < facets.size(); ++i)
    visit(
        facets[i].corners, [&] { return place_in(soup, soup.facet_lines, i); },
        [&] { return marked_facet_words(facets[i]); });
}

}  // namespace

template <int Dim>
void check_corners_and_places(const MeshSoup<Dim>& soup) {
  for (const VertexId v : soup.mesh.points.ids())
    if (!is_finite(soup.mesh.points[v]))
      throw InputError(soup.source, mesh::words(soup.mesh, v) + " is not at a finite place",
                       "NaN and infinities are bad input; find out what wrote them");
  for_each_list_of_corners(soup, [&](const auto& corners, auto where, auto what) {
    for (const VertexId v : corners)
      if (!soup.mesh.points.contains(v))
        throw InputError(where(),
                         what() + " names vertex " + std::to_string(v.index()) +
                             ", but the file has only vertices 0 to " +
                             std::to_string(soup.mesh.vertex_count() - 1),
                         "correct it or the number of points");
  });
}

template <int Dim>
void check_soup(const MeshSoup<Dim>& soup) {
  check_counts(soup);
  check_corners_and_places(soup);
}

template <int Dim>
void refuse_repeated_vertices(const MeshSoup<Dim>& soup) {
  for_each_list_of_corners(soup, [&](const auto& corners, auto where, auto what) {
    for (auto corner = corners.begin(); corner != corners.end(); ++corner)
      if (std::find(corners.begin(), corner, *corner) != corner)
        throw InputError(where(), what() + " names vertex " + std::to_string(corner->index()) + " twice",
                         "correct its vertices, or write it as a cell of fewer corners");
  });
}

template void check_soup(const MeshSoup<2>&);
template void check_soup(const MeshSoup<3>&);
template void check_corners_and_places(const MeshSoup<2>&);
template void check_corners_and_places(const MeshSoup<3>&);
template void refuse_repeated_vertices(const MeshSoup<2>&);
template void refuse_repeated_vertices(const MeshSoup<3>&);

}  // namespace leonhard::io
