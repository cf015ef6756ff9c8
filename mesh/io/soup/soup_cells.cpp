// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/soup_cells.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/check/mixed_orientation.hpp"
#include "leonhard/mesh/io/soup/soup_checks.hpp"
#include "leonhard/mesh/structures/mixed_sides.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

// ---- quadrilaterals ----

using TriangleCorners = std::array<VertexId, 3>;
using Halves = std::array<TriangleCorners, 2>;

/// The two triangles of a quadrilateral whose corners run counter-clockwise; none if no diagonal gives two
/// positive ones. A convex quadrilateral takes the Delaunay diagonal.
std::optional<Halves> halves_of(const PerId<VertexId, Point2>& points, const std::array<VertexId, 4>& q) {
  const auto positive = [&](const TriangleCorners& t) {
    return kernel::orient2d(points[t[0]], points[t[1]], points[t[2]]) == Sign::positive;
  };
  const Halves along_02{TriangleCorners{q[0], q[1], q[2]}, TriangleCorners{q[0], q[2], q[3]}};
  const Halves along_13{TriangleCorners{q[1], q[2], q[3]}, TriangleCorners{q[1], q[3], q[0]}};
  const bool good_02 = positive(along_02[0]) && positive(along_02[1]);
  const bool good_13 = positive(along_13[0]) && positive(along_13[1]);
  if (!good_02 && !good_13) return std::nullopt;
  if (!good_13) return along_02;
  if (!good_02) return along_13;
  const Sign inside = kernel::incircle_perturbed(points[q[0]], points[q[1]], points[q[2]], points[q[3]]);
  return inside == Sign::positive ? along_13 : along_02;
}

std::array<VertexId, 4> four_corners(const MixedMesh<2>& mesh, CellId cell) {
  const auto c = mesh.corners_of(cell);
  return {c[0], c[1], c[2], c[3]};
}

/// Of a quadrilateral that need only be simple; zero if it is not.
Sign turn_of_simple(const MixedMesh<2>& mesh, CellId cell) {
  const auto c = four_corners(mesh, cell);
  if (halves_of(mesh.points, c)) return Sign::positive;
  return halves_of(mesh.points, {c[3], c[2], c[1], c[0]}) ? Sign::negative : Sign::zero;
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
      return std::swap(corners[0], corners[2]);
    case CellKind::tetrahedron:
      return std::swap(corners[2], corners[3]);
    case CellKind::quadrilateral:
    case CellKind::pyramid:
      return std::swap(corners[1], corners[3]);
    case CellKind::prism:
      return std::swap(corners[1], corners[2]), std::swap(corners[4], corners[5]);
    case CellKind::hexahedron:
      return std::swap(corners[1], corners[3]), std::swap(corners[5], corners[7]);
  }
}

/// throws  InputError for a cell that has no sign
template <int Dim>
Sign turn_of(const MeshSoup<Dim>& soup, CellId cell, QuadrilateralRule rule) {
  if constexpr (Dim == 2) {
    if (soup.mesh.kinds[cell] == CellKind::quadrilateral && rule == QuadrilateralRule::simple) {
      if (const Sign sign = turn_of_simple(soup.mesh, cell); sign != Sign::zero) return sign;
      throw InputError(place_in(soup, soup.cell_lines, cell.index()),
                       mesh::words(soup.mesh, cell) + " has zero area or crosses itself",
                       "correct its corners or their coordinates");
    }
  }
  const mesh::Orientation turn = mesh::orientation_of(soup.mesh, cell);
  if (turn.sign == Sign::zero)
    throw InputError(place_in(soup, soup.cell_lines, cell.index()),
                     mesh::orientation_words(soup.mesh, cell, turn),
                     "correct its corners or their coordinates");
  return turn.sign;
}

/// "14 of 28 triangles and all 3 quadrilaterals are clockwise in the file; they were turned over".
template <int Dim>
std::optional<std::string> turned_words(const std::array<Turns, cell_kind_count>& turns,
                                        bool prisms_turn_either_way) {
  std::string kinds;
  for (std::size_t k = 0; k < cell_kind_count; ++k) {
    const auto& [count, negative] = turns[k];
    const CellKind kind = static_cast<CellKind>(k);
    if (negative == 0 || (kind == CellKind::prism && prisms_turn_either_way && negative == count)) continue;
    kinds += (kinds.empty() ? "" : " and ") +
             (negative == count ? "all " : std::to_string(negative) + " of ") + std::to_string(count) + " " +
             shape_of(kind).names;
  }
  if (kinds.empty()) return std::nullopt;
  return kinds + " are " + (Dim == 2 ? "clockwise" : "inverted") + " in the file; they were turned over";
}

/// Both halves of a quadrilateral get its row.
void repeat_rows(std::vector<double>& values, std::size_t components,
                 const std::vector<std::size_t>& copies) {
  if (values.empty()) return;
  std::vector<double> repeated;
  for (std::size_t c = 0; c < copies.size(); ++c) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(c * components);
    for (std::size_t i = 0; i < copies[c]; ++i)
      repeated.insert(repeated.end(), row, row + static_cast<std::ptrdiff_t>(components));
  }
  values = std::move(repeated);
}

}  // namespace

template <int Dim>
void orient_cells(MeshSoup<Dim>& soup, QuadrilateralRule rule) {
  std::array<Turns, cell_kind_count> turns{};
  for (const CellId cell : soup.mesh.kinds.ids()) {
    const CellKind kind = soup.mesh.kinds[cell];
    Turns& of_kind = turns[static_cast<std::size_t>(kind)];
    ++of_kind.count;
    if (turn_of(soup, cell, rule) != Sign::negative) continue;
    ++of_kind.negative;
    turn_over(kind, soup.mesh.corners[cell.index()]);
  }
  if (auto words = turned_words<Dim>(turns, soup.prisms_turn_either_way))
    soup.warnings.push_back(std::move(*words));
}

void split_quadrilaterals(MeshSoup<2>& soup) {
  const std::size_t quadrilaterals = soup.mesh.count_of(CellKind::quadrilateral);
  if (quadrilaterals == 0) return;
  MixedMesh<2>& mesh = soup.mesh;
  std::vector<std::size_t> copies;
  PerId<CellId, CellKind> kinds;
  CompressedRows<VertexId, IdRaw> corners;
  std::vector<std::uint32_t> lines;
  const auto add = [&](std::span<const VertexId> triangle, CellId of) {
    for (const VertexId v : triangle) corners.add_link(v);
    corners.end_row();
    kinds.push_back(CellKind::triangle);
    if (!soup.cell_lines.empty()) lines.push_back(soup.cell_lines[of.index()]);
  };
  for (const CellId cell : mesh.kinds.ids()) {
    const bool is_triangle = mesh.kinds[cell] == CellKind::triangle;
    copies.push_back(is_triangle ? 1 : 2);
    if (is_triangle) {
      add(mesh.corners_of(cell), cell);
    } else {
      const Halves halves = *halves_of(mesh.points, four_corners(mesh, cell));  // positive, so there are two
      for (const TriangleCorners& half : halves) add(half, cell);
    }
  }
  mesh.kinds = std::move(kinds);
  mesh.corners = std::move(corners);
  soup.cell_lines = std::move(lines);
  repeat_rows(mesh.regions.flat(), 1, copies);
  for (CellField& field : soup.cell_fields) repeat_rows(field.values, field.components, copies);
  soup.warnings.push_back(std::to_string(quadrilaterals) +
                          " quadrilaterals were split into triangles along their Delaunay diagonals");
  soup.note += (soup.note.empty() ? "" : "; ");
  soup.note += "triangles are numbered after quadrilaterals were split";
}

template <int Dim>
void drop_repeated_facets(MeshSoup<Dim>& soup) {
  auto& facets = soup.mesh.boundary;
  std::vector<std::pair<mesh::FacetRing<Dim>, std::size_t>> sorted;
  sorted.reserve(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
    sorted.emplace_back(mesh::directed_ring(facets[i].corners).ring, i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> repeated(facets.size(), false);
  std::size_t count = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    const std::size_t first = sorted[i - 1].second, second = sorted[i].second;
    if (facets[first].marker != facets[second].marker)
      throw InputError(place_in(soup, soup.facet_lines, second),
                       marked_facet_words(facets[second]) + " comes a second time" +
                           (soup.facet_lines.empty() || soup.facet_lines[first] == 0
                                ? ""
                                : ", after line " + std::to_string(soup.facet_lines[first])) +
                           " (markers " + std::to_string(facets[first].marker) + " and " +
                           std::to_string(facets[second].marker) + ")",
                       std::string("give each ") + Simplex<Dim>::facet + " one marker");
    repeated[second] = true;
    ++count;
  }
  if (count == 0) return;
  std::size_t next = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (repeated[i]) continue;
    facets[next] = facets[i];
    if (!soup.facet_lines.empty()) soup.facet_lines[next] = soup.facet_lines[i];
    ++next;
  }
  facets.resize(next);
  if (!soup.facet_lines.empty()) soup.facet_lines.resize(next);
  soup.warnings.push_back(std::to_string(count) + " marked " + Simplex<Dim>::facet +
                          "s are listed more than once; each was taken once");
}

template void orient_cells(MeshSoup<2>&, QuadrilateralRule);
template void orient_cells(MeshSoup<3>&, QuadrilateralRule);
template void drop_repeated_facets(MeshSoup<2>&);
template void drop_repeated_facets(MeshSoup<3>&);

}  // namespace leonhard::io
