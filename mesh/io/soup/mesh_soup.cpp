// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/structures/sorted_facet.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

/// What is said of cells and facets, by dimension.
template <int Dim>
struct Terms;
template <>
struct Terms<2> {
  static constexpr const char *cell = "cell", *cells = "triangles or quadrilaterals", *no_cells_remedy = "",
                              *negative = "clockwise", *among_positive = "clockwise (inverted)",
                              *among_negative = "counter-clockwise", *both = "two";
};
template <>
struct Terms<3> {
  static constexpr const char *cell = "tetrahedron", *cells = "tetrahedra",
                              *no_cells_remedy = "a surface has to be filled with a mesh first",
                              *negative = "inverted", *among_positive = "inverted (of negative volume)",
                              *among_negative = "of positive volume", *both = "three";
};

template <int Dim>
std::string where(const MeshSoup<Dim>& soup, std::uint32_t line) {
  return line == 0 ? soup.source : at_line(soup.source, line);
}

template <int Dim>
std::string cell_words(const MeshSoup<Dim>& soup, std::size_t index) {
  const SoupCell& cell = soup.cells[index];
  std::string ids, places;
  for (std::uint32_t i = 0; i < cell.corner_count; ++i) {
    ids += (i == 0 ? "" : ", ") + std::to_string(cell.corners[i].index());
    places += (i == 0 ? "" : ", ") + mesh::words(soup.points[cell.corners[i]]);
  }
  return Terms<Dim>::cell + (" " + std::to_string(index)) + " (vertices " + ids + " at " + places + ")";
}

template <int Dim>
std::string facet_words(const SoupFacet<Dim>& facet) {
  std::string ids;
  for (const VertexId v : facet.corners) ids += (ids.empty() ? "" : "-") + std::to_string(v.index());
  return std::string("the marked ") + Simplex<Dim>::facet + " " + ids;
}

template <int Dim>
void check_sizes(const MeshSoup<Dim>& soup) {
  if (soup.points.empty()) throw InputError(soup.source, "the file holds no points");
  if (soup.cells.empty())
    throw InputError(soup.source, std::string("the file holds no ") + Terms<Dim>::cells,
                     Terms<Dim>::no_cells_remedy);
  constexpr std::size_t most = std::numeric_limits<IdRaw>::max() - 1;
  if (soup.points.size() > most || soup.cells.size() > most / 4)
    throw InputError(soup.source, "the mesh has more points or cells than ids can number");
}

/// The predicates that follow know finite numbers only.
template <int Dim>
void check_finite(const MeshSoup<Dim>& soup) {
  for (const VertexId v : soup.points.ids())
    if (!is_finite(soup.points[v]))
      throw InputError(soup.source,
                       "vertex " + std::to_string(v.index()) + " is at " + mesh::words(soup.points[v]) +
                           ", which is not finite",
                       "NaN and infinities are bad input; find out what wrote them");
}

template <int Dim>
[[noreturn]] void refuse_corner(const MeshSoup<Dim>& soup, VertexId corner, const std::string& what,
                                std::uint32_t line) {
  throw InputError(where(soup, line),
                   what + " names vertex " + std::to_string(corner.index()) +
                       ", but the file has only vertices 0 to " + std::to_string(soup.points.size() - 1),
                   "correct it or the number of points");
}

template <int Dim>
void check_ids(const MeshSoup<Dim>& soup) {
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const SoupCell& cell = soup.cells[c];
    for (std::uint32_t i = 0; i < cell.corner_count; ++i)
      if (!soup.points.contains(cell.corners[i]))
        refuse_corner(soup, cell.corners[i], Terms<Dim>::cell + (" " + std::to_string(c)), cell.line);
  }
  for (const SoupFacet<Dim>& facet : soup.facets)
    for (const VertexId v : facet.corners)
      if (!soup.points.contains(v)) refuse_corner(soup, v, facet_words(facet), facet.line);
}

// ---- quadrilaterals ----

using Corners = std::array<VertexId, 3>;
using SplitQuadrilateral = std::array<Corners, 2>;

/// The two triangles of a quadrilateral whose corners run counter-clockwise; none if no diagonal gives two
/// positive ones. A convex quadrilateral takes the Delaunay diagonal.
std::optional<SplitQuadrilateral> split(const PerId<VertexId, Point2>& points,
                                        const std::array<VertexId, 4>& q) {
  const auto positive = [&](const Corners& t) {
    return kernel::orient2d(points[t[0]], points[t[1]], points[t[2]]) == Sign::positive;
  };
  const SplitQuadrilateral along_02{Corners{q[0], q[1], q[2]}, Corners{q[0], q[2], q[3]}};
  const SplitQuadrilateral along_13{Corners{q[1], q[2], q[3]}, Corners{q[1], q[3], q[0]}};
  const bool good_02 = positive(along_02[0]) && positive(along_02[1]);
  const bool good_13 = positive(along_13[0]) && positive(along_13[1]);
  if (!good_02 && !good_13) return std::nullopt;
  if (!good_13) return along_02;
  if (!good_02) return along_13;
  const Sign inside = kernel::incircle_perturbed(points[q[0]], points[q[1]], points[q[2]], points[q[3]]);
  return inside == Sign::positive ? along_13 : along_02;
}

// ---- orientation ----

/// Positive: counter-clockwise; negative: clockwise; zero: no area, or a quadrilateral that crosses itself.
Sign orientation(const PerId<VertexId, Point2>& points, const SoupCell& cell) {
  const auto& c = cell.corners;
  if (cell.corner_count == 3) return kernel::orient2d(points[c[0]], points[c[1]], points[c[2]]);
  if (split(points, c)) return Sign::positive;
  return split(points, {c[3], c[2], c[1], c[0]}) ? Sign::negative : Sign::zero;
}

Sign orientation(const PerId<VertexId, Point3>& points, const SoupCell& cell) {
  const auto& [a, b, c, d] = cell.corners;
  return kernel::orient3d(points[a], points[b], points[c], points[d]);
}

/// Programs that write several kinds of cells may turn each kind its own way.
struct KindCounts {
  std::uint32_t corner_count;
  const char *name, *no_size;
  std::size_t count = 0, negative = 0;
};
template <int Dim>
std::vector<KindCounts> cell_kinds() {
  if constexpr (Dim == 3) return {{4, "tetrahedra", " has no volume"}};
  return {{3, "triangles", " has zero area"}, {4, "quadrilaterals", " has zero area or crosses itself"}};
}

/// Names the first negative cells among positive ones of a kind, or the other way round if these are fewer.
template <int Dim>
[[noreturn]] void refuse_mixture(const MeshSoup<Dim>& soup, const KindCounts& kind) {
  const bool few_are_negative = 2 * kind.negative <= kind.count;
  const std::size_t count = few_are_negative ? kind.negative : kind.count - kind.negative;
  const Sign odd = few_are_negative ? Sign::negative : Sign::positive;
  constexpr std::size_t named_at_most = 3;
  std::string names;
  const SoupCell* first = nullptr;
  for (std::size_t c = 0, named = 0; c < soup.cells.size() && named < named_at_most; ++c) {
    const SoupCell& cell = soup.cells[c];
    if (cell.corner_count != kind.corner_count || orientation(soup.points, cell) != odd) continue;
    if (first == nullptr) first = &cell;
    names += (named++ == 0 ? "" : "; ") + cell_words(soup, c);
  }
  throw InputError(where(soup, first->line),
                   std::to_string(count) + " of " + std::to_string(kind.count) + " " + kind.name + " are " +
                       (few_are_negative ? Terms<Dim>::among_positive : Terms<Dim>::among_negative) +
                       " unlike the others: " + names + (count > named_at_most ? "; ..." : ""),
                   "a corner or a coordinate of these is wrong, or the mesh is tangled there");
}

/// All cells positive, or an error. Turning a whole kind over is safe, since cells that then overlap are found by
/// validate_embedding.
template <int Dim>
void orient_cells(MeshSoup<Dim>& soup, std::vector<std::string>& warnings) {
  std::vector<KindCounts> kinds = cell_kinds<Dim>();
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const SoupCell& cell = soup.cells[c];
    KindCounts& kind = kinds[cell.corner_count == kinds[0].corner_count ? 0 : 1];
    const Sign sign = orientation(soup.points, cell);
    if (sign == Sign::zero)
      throw InputError(where(soup, cell.line), cell_words(soup, c) + kind.no_size,
                       "correct its corners or their coordinates");
    ++kind.count;
    if (sign == Sign::negative) ++kind.negative;
  }
  for (const KindCounts& kind : kinds) {
    if (kind.negative == 0) continue;
    if (kind.negative < kind.count) refuse_mixture(soup, kind);
    for (SoupCell& cell : soup.cells) {
      if (cell.corner_count != kind.corner_count) continue;
      const auto first = Dim == 2 ? cell.corners.begin() : cell.corners.begin() + 2;
      std::reverse(first, cell.corners.begin() + cell.corner_count);
    }
    warnings.push_back("all " + std::to_string(kind.count) + " " + kind.name + " are " +
                       Terms<Dim>::negative + " in the file; they were turned over");
  }
}

// ---- the mesh ----

template <int Dim>
struct Cells {
  PerId<typename Simplex<Dim>::CellId, typename SimplexMesh<Dim>::CellCorners> corners;
  std::vector<double> regions;  ///< empty if the soup has none
};

/// Both halves of a quadrilateral get its values.
void give_halves_their_rows(const std::vector<SoupCell>& cells, CellField& field) {
  std::vector<double> values;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto row = field.values.begin() + static_cast<std::ptrdiff_t>(c * field.components);
    for (std::uint32_t i = 2; i < cells[c].corner_count; ++i)
      values.insert(values.end(), row, row + static_cast<std::ptrdiff_t>(field.components));
  }
  field.values = std::move(values);
}

/// Triangles, quadrilaterals split.
Cells<2> take_cells(MeshSoup<2>& soup, std::vector<std::string>& warnings) {
  Cells<2> result;
  result.corners.reserve(soup.cells.size());
  std::size_t quadrilaterals = 0;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const SoupCell& cell = soup.cells[c];
    if (cell.corner_count == 3) {
      result.corners.push_back({cell.corners[0], cell.corners[1], cell.corners[2]});
    } else {
      ++quadrilaterals;
      const SplitQuadrilateral halves = *split(soup.points, cell.corners);  // oriented, so there is one
      for (const Corners& half : halves) result.corners.push_back(half);
    }
    if (!soup.cell_regions.empty())
      for (std::uint32_t i = 2; i < cell.corner_count; ++i) result.regions.push_back(soup.cell_regions[c]);
  }
  if (quadrilaterals == 0) return result;
  for (CellField& field : soup.cell_fields) give_halves_their_rows(soup.cells, field);
  warnings.push_back(std::to_string(quadrilaterals) +
                     " quadrilaterals were split into triangles along their Delaunay diagonals");
  soup.note += (soup.note.empty() ? "" : "; ");
  soup.note += "triangles are numbered after quadrilaterals were split";
  return result;
}

Cells<3> take_cells(MeshSoup<3>& soup, std::vector<std::string>&) {
  Cells<3> result;
  result.corners.reserve(soup.cells.size());
  for (const SoupCell& cell : soup.cells) result.corners.push_back(cell.corners);
  result.regions = std::move(soup.cell_regions);
  return result;
}

/// Two lines that give one face would be two claims about its marker.
void refuse_faces_given_twice(const MeshSoup<3>& soup) {
  std::vector<std::pair<std::array<VertexId, 3>, std::size_t>> sorted;
  sorted.reserve(soup.facets.size());
  for (std::size_t i = 0; i < soup.facets.size(); ++i)
    sorted.emplace_back(mesh::sorted_facet(soup.facets[i].corners).corners, i);
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == sorted.end()) return;
  const SoupFacet<3>&first = soup.facets[twice->second], &second = soup.facets[std::next(twice)->second];
  throw InputError(where(soup, second.line),
                   facet_words(second) + " comes a second time" +
                       (first.line == 0 ? std::string() : ", after line " + std::to_string(first.line)) +
                       " (markers " + std::to_string(first.marker) + " and " + std::to_string(second.marker) +
                       ")",
                   "give each face one marker");
}

/// The marker of boundary facets that are not listed and whose vertices share none.
template <int Dim>
Marker marker_of_unlisted(const MeshSoup<Dim>& soup) {
  Marker marker = 1;
  if constexpr (Dim == 3) {
    std::set<Marker> used;
    for (const SoupFacet<Dim>& facet : soup.facets) used.insert(facet.marker);
    for (const auto& [named, name] : soup.marker_names) used.insert(named);
    while (used.contains(marker)) ++marker;
  }
  return marker;
}

/// The marker that the vertices of a facet share, or 0.
template <int Dim>
Marker shared_marker(const MeshSoup<Dim>& soup, const std::array<VertexId, Dim>& facet) {
  if (soup.vertex_markers.empty()) return 0;
  const auto marker_of = [&](VertexId v) { return soup.vertex_markers[v.index()]; };
  const Marker marker = marker_of(facet[0]);
  const bool shared =
      std::all_of(facet.begin(), facet.end(), [&](VertexId v) { return marker_of(v) == marker; });
  return shared ? marker : 0;
}

/// make_mesh has put the boundary facets that the soup does not list behind those that it does.
template <int Dim>
void mark_unlisted(SimplexMesh<Dim>& mesh, const MeshSoup<Dim>& soup, Marker otherwise,
                   std::vector<std::string>& warnings) {
  const std::string facet = Simplex<Dim>::facet;
  const std::size_t listed = soup.facets.size() - mesh.inner_facets().size();
  for (std::size_t i = listed; i < mesh.boundary.size(); ++i) {
    const Marker shared = shared_marker<Dim>(soup, Simplex<Dim>::corners_of(mesh.boundary[i]));
    mesh.boundary[i].marker = shared != 0 ? shared : otherwise;
  }
  if (listed < mesh.boundary.size())
    warnings.push_back(std::to_string(mesh.boundary.size() - listed) + " of " +
                       std::to_string(mesh.boundary.size()) + " boundary " + facet +
                       "s have no marker in the file; they got the marker their " + Terms<Dim>::both +
                       " vertices share, or " + std::to_string(otherwise));
}

/// The checks of mesh/ on the whole: what one cell cannot show.
template <int Dim>
SimplexMesh<Dim> checked_mesh(MeshSoup<Dim>& soup, FacetRule rule, std::vector<std::string>& warnings) {
  Cells<Dim> cells = take_cells(soup, warnings);
  std::vector<typename Simplex<Dim>::MarkedFacet> facets;
  facets.reserve(soup.facets.size());
  for (const SoupFacet<Dim>& facet : soup.facets)
    facets.push_back(Simplex<Dim>::marked(facet.corners, facet.marker));
  mesh::MarkedFacetRules rules;
  rules.take_inner_facets = rule != FacetRule::facets_are_the_boundary;
  const Marker otherwise = marker_of_unlisted(soup);
  if (rule == FacetRule::fill_in_the_boundary) rules.unlisted_boundary = otherwise;

  SimplexMesh<Dim> mesh =
      mesh::make_mesh<Dim>(std::move(soup.points), std::move(cells.corners), std::move(facets),
                           std::move(soup.marker_names), soup.source, rules);
  if (rule == FacetRule::fill_in_the_boundary) {
    mark_unlisted(mesh, soup, otherwise, warnings);
    if constexpr (Dim == 3)
      std::erase_if(mesh.interfaces, [](const MarkedFace& face) { return face.marker == 0; });
  }
  if (!cells.regions.empty())
    mesh.regions = PerId<typename Simplex<Dim>::CellId, double>(std::move(cells.regions));
  if (!soup.vertex_markers.empty())
    mesh.vertex_markers = PerId<VertexId, Marker>(std::move(soup.vertex_markers));
  if (const auto overlap = mesh::validate_embedding(mesh))
    throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                     "correct the coordinates or the cells there");
  return mesh;
}

}  // namespace

template <int Dim>
SimplexMeshFile<Dim> assemble(MeshSoup<Dim> soup, FacetRule rule) {
  try {
    check_sizes(soup);
    check_finite(soup);
    check_ids(soup);
    if constexpr (Dim == 3)
      if (rule != FacetRule::boundary_and_inner_facets) refuse_faces_given_twice(soup);
    SimplexMeshFile<Dim> result;
    result.warnings = std::move(soup.warnings);
    orient_cells(soup, result.warnings);
    result.mesh = checked_mesh(soup, rule, result.warnings);
    result.point_fields = std::move(soup.point_fields);
    result.cell_fields = std::move(soup.cell_fields);
    return result;
  } catch (const InputError& error) {
    if (soup.note.empty()) throw;
    throw InputError(error.where(), error.problem(),
                     error.remedy() + (error.remedy().empty() ? "" : "; ") + soup.note);
  }
}

template MeshFile assemble(MeshSoup<2>, FacetRule);
template TetMeshFile assemble(MeshSoup<3>, FacetRule);

}  // namespace leonhard::io
