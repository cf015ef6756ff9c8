// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mixed_euler.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "leonhard/mesh/check/mixed_invariants.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/exact_sum.hpp"
#include "leonhard/mesh/mesh_dual.hpp"

namespace leonhard {

std::int64_t MixedEulerAccount::characteristic(int dimension) const {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  return dimension == 2 ? n(stars) - n(fans) + n(cells) : n(stars) - n(fans) + n(facets) - n(cells);
}

bool MixedEulerAccount::balances() const {
  return std::all_of(formulas.begin(), formulas.end(), [](const Formula& f) { return f.holds(); });
}

namespace mesh {
namespace {

/// Numbers for the corners of all cells, and in space for their edges, one after another.
template <int Dim>
class PartsOfCells {
 public:
  explicit PartsOfCells(const MixedMesh<Dim>& mesh) : mesh_(mesh) {
    for (const CellId cell : mesh.kinds.ids()) {
      for_each_edge_of(mesh, cell, [&](VertexId a, VertexId b) { edges_.add_link({a, b}); });
      edges_.end_row();
    }
  }

  [[nodiscard]] std::size_t corner_count() const { return mesh_.corners.link_count(); }
  [[nodiscard]] std::size_t edge_count() const { return edges_.link_count(); }

  [[nodiscard]] std::size_t corner(CellId cell, VertexId v) const {
    const auto row = mesh_.corners_of(cell);
    return mesh_.corners.offsets()[cell.index()] +
           static_cast<std::size_t>(std::find(row.begin(), row.end(), v) - row.begin());
  }
  [[nodiscard]] std::size_t edge(CellId cell, VertexId a, VertexId b) const {
    const auto row = edges_[cell.index()];
    const auto at = std::find_if(row.begin(), row.end(), [&](const std::array<VertexId, 2>& ends) {
      return (ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a);
    });
    return edges_.offsets()[cell.index()] + static_cast<std::size_t>(at - row.begin());
  }

 private:
  const MixedMesh<Dim>& mesh_;
  CompressedRows<std::array<VertexId, 2>, std::size_t> edges_;  ///< a row a cell
};

/// Calls visit(a, b) for the edges of a facet; an edge is its own.
template <int Dim, class Visit>
void for_each_edge_of_facet(const MixedFacet<Dim>& facet, Visit visit) {
  if constexpr (Dim == 2) {
    visit(facet[0], facet[1]);
  } else {
    for (std::size_t i = 0; i < facet.size(); ++i) visit(facet[i], facet[i + 1 == facet.size() ? 0 : i + 1]);
  }
}

/// What is joined across facets.
struct CellClasses {
  std::size_t facets;
  DisjointSets components, stars, fans;
};

template <int Dim>
CellClasses classes_of_cells(const MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides,
                             const PartsOfCells<Dim>& parts) {
  CellClasses classes{0, DisjointSets(mesh.cell_count()), DisjointSets(parts.corner_count()),
                      DisjointSets(parts.edge_count())};
  sides.for_each_facet_until([&](auto group) {
    ++classes.facets;
    if (group.size() == 1) return false;
    const CellId one = group[0].cell, other = group[1].cell;
    const MixedFacet<Dim> facet = mesh.facet_of(one, group[0].side);
    classes.components.join(one.index(), other.index());
    for (const VertexId v : facet) classes.stars.join(parts.corner(one, v), parts.corner(other, v));
    for_each_edge_of_facet(facet, [&](VertexId a, VertexId b) {
      classes.fans.join(parts.edge(one, a, b), parts.edge(other, a, b));
    });
    return false;
  });
  return classes;
}

/// Adds what a boundary facet encloses with the origin, up to a factor that all have: about its centre, which is twice the
/// mean of what the triangles of its two diagonals give.
void add_enclosed(ExactSum& sum, const MixedMesh<2>& mesh, const MixedFacet<2>& edge) {
  const Point2 a = mesh.points[edge[0]], b = mesh.points[edge[1]];
  sum.add_cross(a.x, a.y, b.x, b.y);
}
void add_enclosed(ExactSum& sum, const MixedMesh<3>& mesh, const MixedFacet<3>& face) {
  const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
    sum.add_determinant(mesh.points[face[i]], mesh.points[face[j]], mesh.points[face[k]]);
  };
  if (face.size() == 3) return add(0, 1, 2), add(0, 1, 2);
  add(0, 1, 2), add(0, 2, 3);
  add(1, 2, 3), add(1, 3, 0);
}

/// The facets of one cell, and how they hang together.
template <int Dim>
class MixedBoundary {
 public:
  MixedBoundary(const MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides) : mesh_(mesh) {
    sides.for_each_facet_until([&](auto group) {
      if (group.size() == 1) add(group[0]);
      return false;
    });
    shells_ = DisjointSets(facets_.size());
    corners_ = DisjointSets(first_corner_.back());
  }

  /// Joins facets at what they have in common within one cell's surroundings: in the plane a star, in space a fan.
  void join_at(const PartsOfCells<Dim>& parts, CellClasses& classes) {
    std::map<std::size_t, std::size_t> first;  // facet at a star or fan
    const auto meet = [&](std::size_t ridge, std::size_t f, std::initializer_list<VertexId> common) {
      const auto [at, is_new] = first.emplace(ridge, f);
      if (is_new) return;
      shells_.join(at->second, f);
      for (const VertexId v : common) corners_.join(corner(at->second, v), corner(f, v));
    };
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const CellId cell = cells_[f];
      if constexpr (Dim == 2) {
        for (const VertexId v : facets_[f]) meet(classes.stars.find(parts.corner(cell, v)), f, {v});
      } else {
        for_each_edge_of_facet(facets_[f], [&](VertexId a, VertexId b) {
          meet(classes.fans.find(parts.edge(cell, a, b)), f, {a, b});
        });
      }
    }
    ridges_ = first.size();
  }

  [[nodiscard]] const std::vector<MixedFacet<Dim>>& facets() const { return facets_; }
  [[nodiscard]] std::size_t corner_count() const { return first_corner_.back(); }
  [[nodiscard]] std::size_t ridge_count() const { return ridges_; }  ///< open stars or fans
  [[nodiscard]] std::size_t sheet_count() const { return corners_.class_count(); }
  [[nodiscard]] std::size_t shell_count() const { return shells_.class_count(); }

  /// The sign of what each shell encloses.
  [[nodiscard]] std::vector<Sign> shell_signs() {
    std::map<std::size_t, ExactSum> enclosed;
    for (std::size_t f = 0; f < facets_.size(); ++f)
      add_enclosed(enclosed[shells_.find(f)], mesh_, facets_[f]);
    std::vector<Sign> signs;
    for (const auto& entry : enclosed) signs.push_back(entry.second.sign());
    return signs;
  }

 private:
  void add(const MixedSide<Dim>& side) {
    facets_.push_back(mesh_.facet_of(side.cell, side.side));
    cells_.push_back(side.cell);
    first_corner_.push_back(first_corner_.back() + facets_.back().size());
  }
  [[nodiscard]] std::size_t corner(std::size_t f, VertexId v) const {
    return first_corner_[f] +
           static_cast<std::size_t>(std::find(facets_[f].begin(), facets_[f].end(), v) - facets_[f].begin());
  }

  const MixedMesh<Dim>& mesh_;
  std::vector<MixedFacet<Dim>> facets_;
  std::vector<CellId> cells_;  ///< whose facets they are
  std::vector<std::size_t> first_corner_{0};
  DisjointSets shells_{0}, corners_{0};
  std::size_t ridges_ = 0;
};

/// Pairs of boundary faces beyond the first, over all edges.
std::size_t pinched_edges(const std::vector<MixedFacet<3>>& boundary, const EdgeList& edges) {
  PerId<EdgeId, IdRaw> faces(edges.edge_count(), 0);
  for (const MixedFacet<3>& face : boundary)
    for_each_edge_of_facet(face, [&](VertexId a, VertexId b) { ++faces[*edges.find(a, b)]; });
  return std::accumulate(faces.begin(), faces.end(), std::size_t{0},
                         [](std::size_t sum, IdRaw n) { return sum + (n > 2 ? n / 2 - 1 : 0); });
}

/// What formulas read besides the account.
struct CellSums {
  std::int64_t sides{};           ///< of all cells
  std::int64_t boundary_corners;  ///< of all boundary facets
};

void write_plane_formulas(MixedEulerAccount& account, const CellSums& sums) {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const std::int64_t v = n(account.stars), e = n(account.edges), f = n(account.cells),
                     c = n(account.components), h = n(account.cavities), l = n(account.shells),
                     bound = n(account.boundary_facets);
  account.formulas = {
      {"(1.1.1)", "cells + vertices are edges + components - holes", f + v, e + c - h},
      {"(1.1.2)", "2 interior edges + boundary edges are the sides of all cells", 2 * (e - bound) + bound,
       sums.sides},
      {"no handles", "vertices - edges + cells are 2 components - loops", v - e + f, 2 * c - l},
      {"edges", "edges by their ends are as many as by their sides", e, n(account.facets)},
      {"boundary vertices", "each loop has as many vertices as edges", n(account.boundary_vertices), bound},
  };
}

void write_space_formulas(MixedEulerAccount& account, const CellSums& sums) {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const std::int64_t v = n(account.stars), e = n(account.fans), f = n(account.facets), phi = n(account.cells),
                     c = n(account.components), h = n(account.handles), k = n(account.cavities);
  const std::int64_t v_bound = n(account.boundary_vertices), e_bound = n(account.boundary_edges),
                     f_bound = n(account.boundary_facets);
  account.formulas = {
      {"(1.1.6)", "faces + vertices are edges + cells + components - handles + cavities", f + v,
       e + phi + c - h + k},
      {"(1.1.14)", "2 faces are the sides of all cells + boundary faces", 2 * f, sums.sides + f_bound},
      {"half the boundary's", "twice the characteristic is the boundary's: vertices - edges + faces",
       2 * account.characteristic(3), v_bound - e_bound + f_bound},
      {"boundary edges", "each boundary edge has two faces, a face as many edges as corners", 2 * e_bound,
       sums.boundary_corners},
      {"fans", "every edge has a fan, and pinched ones one more for each pinch", e,
       n(account.edges) + n(account.edge_pinches)},
  };
}

void write_common_formulas(MixedEulerAccount& account) {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const std::int64_t c = n(account.components);
  account.formulas.push_back({"outer shells", "each component has one shell that encloses a positive size",
                              n(account.outer_shells), c});
  account.formulas.push_back({"shells", "shells are outer shells, one a component, and cavities or holes",
                              n(account.shells), c + n(account.cavities)});
  account.formulas.push_back({"boundary", "the boundary facets that the mesh lists are those with one cell",
                              n(account.listed_boundary_facets), n(account.boundary_facets)});
  account.formulas.push_back({"vertices",
                              "every vertex has a cell, and pinched ones one star more for each pinch",
                              n(account.stars), n(account.vertices) + n(account.vertex_pinches)});
}

std::size_t vertices_of_cells(const PerId<VertexId, char>& used) {
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

}  // namespace

template <int Dim>
MixedEulerAccount euler_account(const MixedMesh<Dim>& mesh) {
  MixedEulerAccount account;
  const EdgeList edges = build_edges(mesh);
  refuse(repeated_corner(mesh), "mesh", "correct the list of cells");
  const MixedSides<Dim> sides(mesh);
  refuse(broken_facet(mesh, sides), "mesh", "correct the list of cells");
  account.vertices = mesh.vertex_count();
  account.edges = edges.edge_count();
  account.cells = mesh.cell_count();
  account.listed_boundary_facets = mesh.boundary.size();

  const PartsOfCells<Dim> parts(mesh);
  CellClasses classes = classes_of_cells(mesh, sides, parts);
  account.facets = classes.facets;
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const VertexId v : mesh.corners.links()) used[v] = 1;
  account.components = classes.components.class_count();
  account.stars = classes.stars.class_count();
  account.fans = classes.fans.class_count();
  account.vertex_pinches = account.stars - vertices_of_cells(used);

  MixedBoundary<Dim> boundary(mesh, sides);
  boundary.join_at(parts, classes);
  const std::vector<Sign> signs = boundary.shell_signs();
  account.boundary_facets = boundary.facets().size();
  account.boundary_edges = Dim == 2 ? account.boundary_facets : boundary.ridge_count();
  account.boundary_vertices = Dim == 2 ? boundary.ridge_count() : boundary.sheet_count();
  account.shells = boundary.shell_count();
  account.outer_shells = static_cast<std::size_t>(std::count(signs.begin(), signs.end(), Sign::positive));
  account.cavities = static_cast<std::size_t>(std::count(signs.begin(), signs.end(), Sign::negative));

  const CellSums sums{static_cast<std::int64_t>(sides.entries().size()),
                      static_cast<std::int64_t>(boundary.corner_count())};
  if constexpr (Dim == 2) {
    write_plane_formulas(account, sums);
  } else {
    account.edge_pinches = pinched_edges(boundary.facets(), edges);
    // Each shell is a closed, oriented surface: its vertices - edges + faces are 2 - 2 handles.
    account.handles =
        (2 * account.shells + account.boundary_edges - account.boundary_vertices - account.boundary_facets) /
        2;
    write_space_formulas(account, sums);
  }
  write_common_formulas(account);
  return account;
}

template MixedEulerAccount euler_account(const MixedMesh<2>&);
template MixedEulerAccount euler_account(const MixedMesh<3>&);

}  // namespace mesh
}  // namespace leonhard
