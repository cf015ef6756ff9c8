// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/mixed_soup.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/mixed_invariants.hpp"
#include "leonhard/mesh/check/mixed_orientation.hpp"
#include "leonhard/mesh/mixed_topology.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

/// "grid.su2:17", or the file alone.
template <int Dim>
std::string where_is(const MixedSoup<Dim>& soup, const std::vector<std::uint32_t>& lines, std::size_t index) {
  return lines.empty() ? soup.source : at_line(soup.source, lines[index]);
}
template <int Dim>
std::string where_is(const MixedSoup<Dim>& soup, CellId cell) {
  return where_is(soup, soup.cell_lines, cell.index());
}

template <int Dim>
std::string marked_facet_words(const MarkedMixedFacet<Dim>& facet) {
  std::string ids;
  for (const VertexId v : facet.corners) ids += (ids.empty() ? "" : "-") + std::to_string(v.index());
  return std::string("the marked ") + Simplex<Dim>::facet + " " + ids;
}

template <int Dim>
void check_counts(const MixedSoup<Dim>& soup) {
  if (soup.mesh.points.empty()) throw InputError(soup.source, "the file holds no points");
  if (soup.mesh.kinds.empty())
    throw InputError(soup.source,
                     std::string("the file holds no cells of ") + (Dim == 2 ? "the plane" : "space"));
  if (soup.mesh.corners.link_count() >= std::numeric_limits<IdRaw>::max())
    throw InputError(soup.source, "the mesh has more corners than ids can number",
                     sizeof(IdRaw) < 8 ? "build with LEONHARD_64BIT_IDS" : "");
}

template <int Dim>
void check_finite_points(const MixedSoup<Dim>& soup) {
  for (const VertexId v : soup.mesh.points.ids())
    if (!is_finite(soup.mesh.points[v]))
      throw InputError(soup.source, mesh::words(soup.mesh, v) + " is not at a finite place",
                       "NaN and infinities are bad input; find out what wrote them");
}

/// Every corner of a cell or facet is a vertex, none comes twice.
template <int Dim, class Corners, class What>
void check_vertices(const MixedSoup<Dim>& soup, const Corners& corners, const std::string& where, What what) {
  for (auto corner = corners.begin(); corner != corners.end(); ++corner) {
    if (!soup.mesh.points.contains(*corner))
      throw InputError(where,
                       what() + " names vertex " + std::to_string(corner->index()) +
                           ", but the file has only vertices 0 to " +
                           std::to_string(soup.mesh.vertex_count() - 1),
                       "correct it or the number of points");
    if (std::find(corners.begin(), corner, *corner) != corner)
      throw InputError(where, what() + " names vertex " + std::to_string(corner->index()) + " twice",
                       "correct its vertices, or write it as a cell of fewer corners");
  }
}

template <int Dim>
void check_all_vertices(const MixedSoup<Dim>& soup) {
  for (const CellId cell : soup.mesh.kinds.ids())
    check_vertices(soup, soup.mesh.corners_of(cell), where_is(soup, cell), [&] {
      return std::string(soup.mesh.shape(cell).name) + " " + std::to_string(cell.index());
    });
  const auto& facets = soup.mesh.boundary;
  for (std::size_t i = 0; i < facets.size(); ++i)
    check_vertices(soup, facets[i].corners, where_is(soup, soup.facet_lines, i),
                   [&] { return marked_facet_words(facets[i]); });
}

// ---- orientation ----

/// Of the cells of one kind.
struct Turns {
  std::size_t count = 0, negative = 0;
};

/// The same cell, turned over.
void turn_over(CellKind kind, std::span<VertexId> corners) {
  switch (kind) {
    case CellKind::triangle:
    case CellKind::tetrahedron:
      return std::swap(corners[1], corners[2]);
    case CellKind::quadrilateral:
    case CellKind::pyramid:
      return std::swap(corners[1], corners[3]);
    case CellKind::prism:
      return std::swap(corners[1], corners[2]), std::swap(corners[4], corners[5]);
    case CellKind::hexahedron:
      return std::swap(corners[1], corners[3]), std::swap(corners[5], corners[7]);
  }
}

/// Names the first negative cells among positive ones of a kind, or the other way round if these are fewer.
template <int Dim>
[[noreturn]] void refuse_unlike_turns(const MixedSoup<Dim>& soup, CellKind kind, const Turns& turns) {
  const bool few_are_negative = 2 * turns.negative <= turns.count;
  const std::size_t count = few_are_negative ? turns.negative : turns.count - turns.negative;
  const Sign odd = few_are_negative ? Sign::negative : Sign::positive;
  constexpr std::size_t named_at_most = 3;
  std::string names, where;
  std::size_t named = 0;
  for (const CellId cell : soup.mesh.kinds.ids()) {
    if (named == named_at_most) break;
    if (soup.mesh.kinds[cell] != kind || mesh::orientation_of(soup.mesh, cell).sign != odd) continue;
    if (named == 0) where = where_is(soup, cell);
    names += (named++ == 0 ? "" : "; ") + mesh::words(soup.mesh, cell);
  }
  const std::string turned = Dim == 2 ? "clockwise (inverted)" : "inverted (of negative volume)",
                    right = Dim == 2 ? "counter-clockwise" : "of positive volume";
  throw InputError(where,
                   std::to_string(count) + " of " + std::to_string(turns.count) + " " + shape_of(kind).names +
                       " are " + (few_are_negative ? turned : right) + " unlike the others: " + names +
                       (count > named_at_most ? "; ..." : ""),
                   "a corner or a coordinate of these is wrong, or the mesh is tangled there");
}

template <int Dim>
std::array<Turns, cell_kind_count> turns_of(const MixedSoup<Dim>& soup) {
  std::array<Turns, cell_kind_count> turns{};
  for (const CellId cell : soup.mesh.kinds.ids()) {
    const mesh::Orientation turn = mesh::orientation_of(soup.mesh, cell);
    if (turn.sign == Sign::zero)
      throw InputError(where_is(soup, cell), mesh::orientation_words(soup.mesh, cell, turn),
                       "correct its corners or their coordinates");
    Turns& of_kind = turns[static_cast<std::size_t>(soup.mesh.kinds[cell])];
    ++of_kind.count;
    if (turn.sign == Sign::negative) ++of_kind.negative;
  }
  return turns;
}

/// All cells positive, or an error. Turning a whole kind over is safe, since cells that then lie on the same side of a facet
/// are found.
template <int Dim>
void orient_mixed_cells(MixedSoup<Dim>& soup) {
  const std::array<Turns, cell_kind_count> turns = turns_of(soup);
  for (std::size_t k = 0; k < cell_kind_count; ++k) {
    if (turns[k].negative == 0) continue;
    const CellKind kind = static_cast<CellKind>(k);
    if (turns[k].negative < turns[k].count) refuse_unlike_turns(soup, kind, turns[k]);
    for (const CellId cell : soup.mesh.kinds.ids())
      if (soup.mesh.kinds[cell] == kind) turn_over(kind, soup.mesh.corners[cell.index()]);
    if (kind == CellKind::prism && soup.prisms_turn_either_way) continue;
    soup.warnings.push_back("all " + std::to_string(turns[k].count) + " " + shape_of(kind).names + " are " +
                            (Dim == 2 ? "clockwise" : "inverted") + " in the file; they were turned over");
  }
}

// ---- facets ----

/// Two lines that give one facet would be two claims about its marker.
template <int Dim>
void refuse_facets_given_twice(const MixedSoup<Dim>& soup) {
  const auto& facets = soup.mesh.boundary;
  std::vector<std::pair<mesh::FacetRing<Dim>, std::size_t>> sorted;
  sorted.reserve(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
    sorted.emplace_back(mesh::directed_ring(facets[i].corners).ring, i);
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == sorted.end()) return;
  const std::size_t first = twice->second, second = std::next(twice)->second;
  const std::string after =
      soup.facet_lines.empty() ? "" : ", after line " + std::to_string(soup.facet_lines[first]);
  throw InputError(where_is(soup, soup.facet_lines, second),
                   marked_facet_words(facets[second]) + " comes a second time" + after + " (markers " +
                       std::to_string(facets[first].marker) + " and " +
                       std::to_string(facets[second].marker) + ")",
                   std::string("give each ") + Simplex<Dim>::facet + " one marker");
}

template <int Dim>
Marker unused_marker(const MixedMesh<Dim>& mesh) {
  std::set<Marker> used;
  for (const auto& facet : mesh.boundary) used.insert(facet.marker);
  for (const auto& facet : mesh.inner_facets) used.insert(facet.marker);
  for (const auto& name : mesh.marker_names) used.insert(name.first);
  Marker marker = 1;
  while (used.contains(marker)) ++marker;
  return marker;
}

/// make_mixed_mesh has put the boundary facets that the file does not list behind those that it does.
///
/// listed  facets of the file
template <int Dim>
void mark_unlisted_facets(MixedMesh<Dim>& mesh, std::size_t listed, Marker otherwise,
                          std::vector<std::string>& warnings) {
  for (std::size_t i = listed; i < mesh.boundary.size(); ++i) {
    const auto& corners = mesh.boundary[i].corners;
    const Marker marker = mesh.vertex_markers[corners[0]];
    const bool shared = std::all_of(corners.begin(), corners.end(),
                                    [&](VertexId v) { return mesh.vertex_markers[v] == marker; });
    mesh.boundary[i].marker = shared && marker != 0 ? marker : otherwise;
  }
  if (listed < mesh.boundary.size())
    warnings.push_back(std::to_string(mesh.boundary.size() - listed) + " of " +
                       std::to_string(mesh.boundary.size()) + " boundary " + Simplex<Dim>::facet +
                       "s have no marker in the file; they got the marker their vertices share, or " +
                       std::to_string(otherwise));
}

template <int Dim>
MixedMeshFile<Dim> checked_file(MixedSoup<Dim>& soup, FacetRule rule) {
  check_counts(soup);
  check_finite_points(soup);
  check_all_vertices(soup);
  orient_mixed_cells(soup);
  if (rule != FacetRule::boundary_and_inner_facets) refuse_facets_given_twice(soup);
  const std::size_t listed = soup.mesh.boundary.size();
  const Marker otherwise = unused_marker(soup.mesh);
  mesh::MarkedFacetRules rules;
  rules.take_inner_facets = rule != FacetRule::facets_are_the_boundary;
  if (rule == FacetRule::fill_in_the_boundary) rules.unlisted_boundary = otherwise;
  MixedMeshFile<Dim> result{mesh::make_mixed_mesh(std::move(soup.mesh), soup.source, rules),
                            std::move(soup.warnings), std::move(soup.point_fields),
                            std::move(soup.cell_fields)};
  if (rules.unlisted_boundary) {
    mark_unlisted_facets(result.mesh, listed - result.mesh.inner_facets.size(), otherwise, result.warnings);
    if (Dim == 3)
      std::erase_if(result.mesh.inner_facets, [](const auto& facet) { return facet.marker == 0; });
  }
  if constexpr (Dim == 2)
    if (const auto overlap = mesh::validate_embedding(result.mesh))
      throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                       "correct the coordinates or the cells there");
  return result;
}

}  // namespace

template <int Dim>
MixedMeshFile<Dim> assemble(MixedSoup<Dim> soup, FacetRule rule) {
  try {
    return checked_file(soup, rule);
  } catch (const InputError& error) {
    if (soup.note.empty()) throw;
    throw InputError(error.where(), error.problem(),
                     error.remedy() + (error.remedy().empty() ? "" : "; ") + soup.note);
  }
}

template MixedMeshFile<2> assemble(MixedSoup<2>, FacetRule);
template MixedMeshFile<3> assemble(MixedSoup<3>, FacetRule);

}  // namespace leonhard::io
