// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/tet_soup.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/structures/sorted_facet.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

std::string where(const TetSoup& soup, std::uint32_t line) {
  return line == 0 ? soup.source : at_line(soup.source, line);
}

std::string cell_words(const TetSoup& soup, std::size_t index) {
  std::string ids, places;
  for (const VertexId v : soup.cells[index].corners) {
    ids += (ids.empty() ? "" : ", ") + std::to_string(v.index());
    places += (places.empty() ? "" : ", ") + mesh::words(soup.points[v]);
  }
  return "tetrahedron " + std::to_string(index) + " (vertices " + ids + " at " + places + ")";
}

std::string face_words(const TetFace& face) {
  return "the marked face " + std::to_string(face.corners[0].index()) + "-" +
         std::to_string(face.corners[1].index()) + "-" + std::to_string(face.corners[2].index());
}

void check_sizes(const TetSoup& soup) {
  if (soup.points.empty()) throw InputError(soup.source, "the file holds no points");
  if (soup.cells.empty())
    throw InputError(soup.source, "the file holds no tetrahedra",
                     "a surface has to be filled with a mesh first");
  constexpr std::size_t most = std::numeric_limits<IdRaw>::max() - 1;
  if (soup.points.size() > most || soup.cells.size() > most / 4)
    throw InputError(soup.source, "the mesh has more points or tetrahedra than ids can number");
}

/// The predicates that follow know finite numbers only.
void check_finite(const TetSoup& soup) {
  for (const VertexId v : soup.points.ids())
    if (!is_finite(soup.points[v]))
      throw InputError(soup.source,
                       "vertex " + std::to_string(v.index()) + " is at " + mesh::words(soup.points[v]) +
                           ", which is not finite",
                       "NaN and infinities are bad input; find out what wrote them");
}

void check_corner(const TetSoup& soup, VertexId corner, const std::string& what, std::uint32_t line) {
  if (!soup.points.contains(corner))
    throw InputError(where(soup, line),
                     what + " names vertex " + std::to_string(corner.index()) +
                         ", but the file has only vertices 0 to " + std::to_string(soup.points.size() - 1),
                     "correct it or the number of points");
}

void check_ids(const TetSoup& soup) {
  for (std::size_t c = 0; c < soup.cells.size(); ++c)
    for (const VertexId v : soup.cells[c].corners)
      if (!soup.points.contains(v))
        check_corner(soup, v, "tetrahedron " + std::to_string(c), soup.cells[c].line);
  for (const TetFace& face : soup.faces)
    for (const VertexId v : face.corners)
      if (!soup.points.contains(v)) check_corner(soup, v, face_words(face), face.line);
}

Sign orientation(const TetSoup& soup, const TetCell& cell) {
  const auto& [a, b, c, d] = cell.corners;
  return kernel::orient3d(soup.points[a], soup.points[b], soup.points[c], soup.points[d]);
}

/// Names the first tetrahedra that are unlike the others.
[[noreturn]] void refuse_mixture(const TetSoup& soup, std::size_t negative) {
  const bool few_are_negative = 2 * negative <= soup.cells.size();
  const std::size_t count = few_are_negative ? negative : soup.cells.size() - negative;
  const Sign odd = few_are_negative ? Sign::negative : Sign::positive;
  constexpr std::size_t named_at_most = 3;
  std::string names;
  const TetCell* first = nullptr;
  for (std::size_t c = 0, named = 0; c < soup.cells.size() && named < named_at_most; ++c) {
    if (orientation(soup, soup.cells[c]) != odd) continue;
    if (first == nullptr) first = &soup.cells[c];
    names += (named++ == 0 ? "" : "; ") + cell_words(soup, c);
  }
  throw InputError(where(soup, first->line),
                   std::to_string(count) + " of " + std::to_string(soup.cells.size()) + " tetrahedra are " +
                       (few_are_negative ? "inverted (of negative volume)" : "of positive volume") +
                       " unlike the others: " + names + (count > named_at_most ? "; ..." : ""),
                   "a corner or a coordinate of these is wrong, or the mesh is tangled there");
}

/// All tetrahedra positive, or an error.
void orient_cells(TetSoup& soup, std::vector<std::string>& warnings) {
  std::size_t negative = 0;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const Sign sign = orientation(soup, soup.cells[c]);
    if (sign == Sign::zero)
      throw InputError(where(soup, soup.cells[c].line), cell_words(soup, c) + " has no volume",
                       "correct its corners or their coordinates");
    if (sign == Sign::negative) ++negative;
  }
  if (negative == 0) return;
  if (negative < soup.cells.size()) refuse_mixture(soup, negative);
  for (TetCell& cell : soup.cells) std::swap(cell.corners[2], cell.corners[3]);
  warnings.push_back("all " + std::to_string(negative) +
                     " tetrahedra are inverted in the file; they were turned over");
}

/// Two lines that give one face would be two claims about its marker.
void refuse_faces_given_twice(const TetSoup& soup) {
  std::vector<std::pair<std::array<VertexId, 3>, std::size_t>> sorted;
  sorted.reserve(soup.faces.size());
  for (std::size_t i = 0; i < soup.faces.size(); ++i)
    sorted.emplace_back(mesh::sorted_facet(soup.faces[i].corners).corners, i);
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == sorted.end()) return;
  const TetFace &first = soup.faces[twice->second], &second = soup.faces[std::next(twice)->second];
  throw InputError(where(soup, second.line),
                   face_words(second) + " comes a second time" +
                       (first.line == 0 ? std::string() : ", after line " + std::to_string(first.line)) +
                       " (markers " + std::to_string(first.marker) + " and " + std::to_string(second.marker) +
                       ")",
                   "give each face one marker");
}

Marker unused_marker(const TetSoup& soup) {
  std::set<Marker> used;
  for (const TetFace& face : soup.faces) used.insert(face.marker);
  for (const auto& [marker, name] : soup.marker_names) used.insert(marker);
  Marker marker = 1;
  while (used.contains(marker)) ++marker;
  return marker;
}

/// The marker that the three vertices of a face share, or 0.
Marker shared_marker(const TetSoup& soup, const std::array<VertexId, 3>& face) {
  if (soup.vertex_markers.empty()) return 0;
  const auto marker_of = [&](VertexId v) { return soup.vertex_markers[v.index()]; };
  const Marker marker = marker_of(face[0]);
  return marker_of(face[1]) == marker && marker_of(face[2]) == marker ? marker : 0;
}

/// make_tet_mesh has put the boundary faces that the soup does not list behind those that it does.
void mark_unlisted(TetMesh& mesh, const TetSoup& soup, Marker otherwise, std::vector<std::string>& warnings) {
  const std::size_t listed = soup.faces.size() - mesh.interfaces.size();
  for (std::size_t i = listed; i < mesh.boundary.size(); ++i) {
    const Marker shared = shared_marker(soup, mesh.boundary[i].corners);
    mesh.boundary[i].marker = shared != 0 ? shared : otherwise;
  }
  if (listed < mesh.boundary.size())
    warnings.push_back(
        std::to_string(mesh.boundary.size() - listed) + " of " + std::to_string(mesh.boundary.size()) +
        " boundary faces have no marker in the file; they got the marker their three vertices share, "
        "or " +
        std::to_string(otherwise));
}

/// The checks of mesh/ on the whole: what one tetrahedron cannot show.
TetMesh checked_mesh(TetSoup& soup, FaceRule rule, std::vector<std::string>& warnings) {
  PerId<TetId, std::array<VertexId, 4>> corners;
  corners.reserve(soup.cells.size());
  for (const TetCell& cell : soup.cells) corners.push_back(cell.corners);
  std::vector<MarkedFace> faces;
  faces.reserve(soup.faces.size());
  for (const TetFace& face : soup.faces) faces.push_back({face.corners, face.marker});
  mesh::MarkedFacetRules rules;
  rules.take_inner_facets = rule != FaceRule::faces_are_the_boundary;
  const Marker otherwise = unused_marker(soup);
  if (rule == FaceRule::fill_in_the_boundary) rules.unlisted_boundary = otherwise;

  TetMesh mesh = mesh::make_tet_mesh(std::move(soup.points), std::move(corners), std::move(faces),
                                     std::move(soup.marker_names), soup.source, rules);
  if (rule == FaceRule::fill_in_the_boundary) {
    mark_unlisted(mesh, soup, otherwise, warnings);
    std::erase_if(mesh.interfaces, [](const MarkedFace& face) { return face.marker == 0; });
  }
  if (!soup.cell_regions.empty()) mesh.regions = PerId<TetId, double>(std::move(soup.cell_regions));
  if (!soup.vertex_markers.empty())
    mesh.vertex_markers = PerId<VertexId, Marker>(std::move(soup.vertex_markers));
  return mesh;
}

}  // namespace

TetMeshFile assemble(TetSoup soup, FaceRule rule) {
  try {
    check_sizes(soup);
    check_finite(soup);
    check_ids(soup);
    if (rule != FaceRule::boundary_and_interfaces) refuse_faces_given_twice(soup);
    TetMeshFile result;
    result.warnings = std::move(soup.warnings);
    orient_cells(soup, result.warnings);
    result.mesh = checked_mesh(soup, rule, result.warnings);
    if (const auto overlap = mesh::validate_embedding(result.mesh))
      throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                       "correct the coordinates or the tetrahedra there");
    result.point_fields = std::move(soup.point_fields);
    result.cell_fields = std::move(soup.cell_fields);
    return result;
  } catch (const InputError& error) {
    if (soup.note.empty()) throw;
    throw InputError(error.where(), error.problem(),
                     error.remedy() + (error.remedy().empty() ? "" : "; ") + soup.note);
  }
}

}  // namespace leonhard::io
