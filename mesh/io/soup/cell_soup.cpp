// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/cell_soup.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

using Corners = std::array<VertexId, 3>;
using SplitQuadrilateral = std::array<Corners, 2>;

std::string where(const CellSoup& soup, const Cell& cell) {
  return cell.line == 0 ? soup.source : at_line(soup.source, cell.line);
}

std::string cell_words(const CellSoup& soup, std::size_t index) {
  const Cell& cell = soup.cells[index];
  std::string ids, places;
  for (std::uint32_t i = 0; i < cell.corner_count; ++i) {
    ids += (i == 0 ? "" : ", ") + std::to_string(cell.corners[i].index());
    places += (i == 0 ? "" : ", ") + mesh::words(soup.points[cell.corners[i]]);
  }
  return "cell " + std::to_string(index) + " (vertices " + ids + " at " + places + ")";
}

[[noreturn]] void refuse(const CellSoup& soup, std::size_t index, const std::string& what,
                         std::string remedy) {
  throw InputError(where(soup, soup.cells[index]), cell_words(soup, index) + " " + what, std::move(remedy));
}

/// The predicates that follow know finite numbers only.
void check_finite(const CellSoup& soup) {
  for (const VertexId v : soup.points.ids())
    if (!is_finite(soup.points[v]))
      throw InputError(soup.source,
                       "vertex " + std::to_string(v.index()) + " is at " + mesh::words(soup.points[v]) +
                           ", which is not finite",
                       "NaN and infinities are bad input; find out what wrote them");
}

void check_ids(const CellSoup& soup) {
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const Cell& cell = soup.cells[c];
    for (std::uint32_t i = 0; i < cell.corner_count; ++i)
      if (!soup.points.contains(cell.corners[i]))
        throw InputError(
            where(soup, cell),
            "cell " + std::to_string(c) + " names vertex " + std::to_string(cell.corners[i].index()) +
                ", but the file has only vertices 0 to " + std::to_string(soup.points.size() - 1),
            "correct the cell or the number of points");
  }
  for (const std::vector<MarkedEdge>* edges : {&soup.edges, &soup.constraints})
    for (const MarkedEdge& edge : *edges)
      for (const VertexId v : {edge.from, edge.to})
        if (!soup.points.contains(v))
          throw InputError(soup.source, "the marked edge " + std::to_string(edge.from.index()) + "-" +
                                            std::to_string(edge.to.index()) + " names vertex " +
                                            std::to_string(v.index()) +
                                            ", but the file has only vertices 0 to " +
                                            std::to_string(soup.points.size() - 1));
}

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

/// Positive: counter-clockwise; negative: clockwise; zero: no area, or a quadrilateral that crosses itself.
Sign orientation(const PerId<VertexId, Point2>& points, const Cell& cell) {
  const auto& c = cell.corners;
  if (cell.corner_count == 3) return kernel::orient2d(points[c[0]], points[c[1]], points[c[2]]);
  if (split(points, c)) return Sign::positive;
  return split(points, {c[3], c[2], c[1], c[0]}) ? Sign::negative : Sign::zero;
}

/// Triangles or quadrilaterals of a file: programs that write both may turn each kind its own way.
struct CellKind {
  std::uint32_t corner_count;
  const char* name;
  std::size_t count = 0, clockwise = 0;
};

/// Names the first clockwise cells among counter-clockwise ones of a kind, or the other way round if these
/// are fewer.
[[noreturn]] void refuse_mixture(const CellSoup& soup, const CellKind& kind) {
  const bool minority_is_clockwise = 2 * kind.clockwise <= kind.count;
  const std::size_t count = minority_is_clockwise ? kind.clockwise : kind.count - kind.clockwise;
  const Sign odd = minority_is_clockwise ? Sign::negative : Sign::positive;
  constexpr std::size_t named_at_most = 3;
  std::string names;
  const Cell* first = nullptr;
  for (std::size_t c = 0, named = 0; c < soup.cells.size() && named < named_at_most; ++c) {
    const Cell& cell = soup.cells[c];
    if (cell.corner_count != kind.corner_count || orientation(soup.points, cell) != odd) continue;
    if (first == nullptr) first = &cell;
    names += (named++ == 0 ? "" : "; ") + cell_words(soup, c);
  }
  throw InputError(where(soup, *first),
                   std::to_string(count) + " of " + std::to_string(kind.count) + " " + kind.name + " are " +
                       (minority_is_clockwise ? "clockwise (inverted)" : "counter-clockwise") +
                       " unlike the others: " + names + (count > named_at_most ? "; ..." : ""),
                   "a corner or a coordinate of these cells is wrong, or the mesh is tangled there");
}

/// All cells counter-clockwise, or an error. Turning a whole kind over is safe, since cells that then overlap
/// are found by validate_embedding.
void orient_cells(CellSoup& soup, std::vector<std::string>& warnings) {
  std::array<CellKind, 2> kinds{{{3, "triangles"}, {4, "quadrilaterals"}}};
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const Cell& cell = soup.cells[c];
    CellKind& kind = kinds[cell.corner_count - 3];
    const Sign sign = orientation(soup.points, cell);
    if (sign == Sign::zero)
      refuse(soup, c, cell.corner_count == 3 ? "has zero area" : "has zero area or crosses itself",
             "correct its corners or their coordinates");
    ++kind.count;
    if (sign == Sign::negative) ++kind.clockwise;
  }
  for (const CellKind& kind : kinds) {
    if (kind.clockwise == 0) continue;
    if (kind.clockwise < kind.count) refuse_mixture(soup, kind);
    for (Cell& cell : soup.cells)
      if (cell.corner_count == kind.corner_count)
        std::reverse(cell.corners.begin(), cell.corners.begin() + cell.corner_count);
    warnings.push_back("all " + std::to_string(kind.count) + " " + kind.name +
                       " are clockwise in the file; they were turned over");
  }
}

struct SplitCells {
  PerId<TriangleId, Corners> corners;
  PerId<TriangleId, double> regions;  ///< empty if the soup has none
};

SplitCells split_cells(const CellSoup& soup, std::vector<std::string>& warnings) {
  SplitCells result;
  result.corners.reserve(soup.cells.size());
  std::size_t quadrilaterals = 0;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const Cell& cell = soup.cells[c];
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
  if (quadrilaterals > 0)
    warnings.push_back(std::to_string(quadrilaterals) +
                       " quadrilaterals were split into triangles along their Delaunay diagonals");
  return result;
}

/// Both halves of a quadrilateral get its values.
void give_halves_their_rows(const std::vector<Cell>& cells, CellField& field) {
  std::vector<double> values;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto row = field.values.begin() + static_cast<std::ptrdiff_t>(c * field.components);
    for (std::uint32_t i = 2; i < cells[c].corner_count; ++i)
      values.insert(values.end(), row, row + static_cast<std::ptrdiff_t>(field.components));
  }
  field.values = std::move(values);
}

bool same_ends_less(const MarkedEdge& a, const MarkedEdge& b) {
  return std::minmax(a.from, a.to) < std::minmax(b.from, b.to);
}

/// Sort the soup's edges into boundary and constraints, and add the boundary edges that it does not list.
void fill_in_boundary(CellSoup& soup, const PerId<TriangleId, Corners>& corners,
                      std::vector<std::string>& warnings) {
  TriangleMesh bare;
  bare.points = soup.points;
  bare.corners = corners;
  mesh::build_neighbours(bare);
  std::vector<MarkedEdge> all;
  for (const TriangleId t : corners.ids())
    for (std::size_t i = 0; i < 3; ++i)
      if (!bare.neighbours[t][i]) all.push_back({corners[t][(i + 1) % 3], corners[t][(i + 2) % 3], 0});
  std::sort(all.begin(), all.end(), same_ends_less);

  std::vector<bool> listed(all.size(), false);
  std::vector<MarkedEdge> boundary;
  for (const MarkedEdge& edge : soup.edges) {
    const auto found = std::lower_bound(all.begin(), all.end(), edge, same_ends_less);
    const bool is_boundary = found != all.end() && !same_ends_less(edge, *found);
    (is_boundary ? boundary : soup.constraints).push_back(edge);
    if (is_boundary) listed[static_cast<std::size_t>(found - all.begin())] = true;
  }
  std::size_t added = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (listed[i]) continue;
    ++added;
    const auto marker_of = [&](VertexId v) {
      return soup.vertex_markers.empty() ? 0 : soup.vertex_markers[v.index()];
    };
    const Marker shared = marker_of(all[i].from) == marker_of(all[i].to) ? marker_of(all[i].from) : 0;
    boundary.push_back({all[i].from, all[i].to, shared != 0 ? shared : 1});
  }
  soup.edges = std::move(boundary);
  if (added > 0)
    warnings.push_back(
        std::to_string(added) + " of " + std::to_string(all.size()) +
        " boundary edges have no marker in the file; they got the marker their two vertices share, or 1");
}

/// The checks of mesh/ on the whole: what one cell cannot show.
TriangleMesh checked_mesh(CellSoup& soup, SplitCells&& cells) {
  TriangleMesh mesh =
      mesh::make_triangle_mesh(std::move(soup.points), std::move(cells.corners), std::move(soup.edges),
                               std::move(soup.marker_names), soup.source);
  if (!cells.regions.empty()) mesh.regions = std::move(cells.regions);
  if (!soup.vertex_markers.empty())
    mesh.vertex_markers = PerId<VertexId, Marker>(std::move(soup.vertex_markers));
  if (!soup.constraints.empty()) {
    mesh.constraints = std::move(soup.constraints);
    if (const auto broken = mesh::validate(mesh))
      throw InputError(soup.source, *broken, "correct the marked inner edges");
  }
  if (const auto overlap = mesh::validate_embedding(mesh))
    throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                     "correct the coordinates or the cells there");
  return mesh;
}

}  // namespace

MeshFile assemble(CellSoup soup, EdgeRule rule) {
  if (soup.points.empty()) throw InputError(soup.source, "the file holds no points");
  if (soup.cells.empty()) throw InputError(soup.source, "the file holds no triangles or quadrilaterals");
  check_finite(soup);
  check_ids(soup);
  MeshFile result;
  result.warnings = std::move(soup.warnings);
  orient_cells(soup, result.warnings);
  try {
    SplitCells cells = split_cells(soup, result.warnings);
    if (cells.corners.size() != soup.cells.size())
      soup.note += "triangles are numbered after quadrilaterals were split";
    result.point_fields = std::move(soup.point_fields);
    result.cell_fields = std::move(soup.cell_fields);
    if (cells.corners.size() != soup.cells.size()) {
      for (CellField& field : result.cell_fields) give_halves_their_rows(soup.cells, field);
    }
    if (rule == EdgeRule::fill_in_the_boundary) fill_in_boundary(soup, cells.corners, result.warnings);
    result.mesh = checked_mesh(soup, std::move(cells));
  } catch (const InputError& error) {
    const std::string remedy =
        error.remedy() + (error.remedy().empty() || soup.note.empty() ? "" : "; ") + soup.note;
    throw InputError(error.where().empty() ? soup.source : error.where(), error.problem(), remedy);
  }
  return result;
}

}  // namespace leonhard::io
