// SPDX-License-Identifier: MIT
#include "leonhard/mesh/validate.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

template <int Dim>
std::vector<typename SimplexMesh<Dim>::FacetCorners> sorted_inner_facets(const SimplexMesh<Dim>& mesh) {
  std::vector<typename SimplexMesh<Dim>::FacetCorners> facets;
  for (const auto& facet : mesh.inner_facets())
    facets.push_back(sorted_facet(Simplex<Dim>::corners_of(facet)).corners);
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// The corner of t that does not lie on its facet to `other`.
template <int Dim, class CellId>
VertexId corner_opposite(const SimplexMesh<Dim>& mesh, CellId t, CellId other) {
  const auto& neighbours = mesh.neighbours[t];
  const auto side =
      std::find(neighbours.begin(), neighbours.end(), MaybeId<CellId>(other)) - neighbours.begin();
  return mesh.corners[t][static_cast<std::size_t>(side)];
}

/// Positive: the point lies inside the circumcircle or circumsphere.
Sign in_circumsphere(const std::array<Point2, 3>& p, Point2 q) {
  return kernel::incircle(p[0], p[1], p[2], q);
}
Sign in_circumsphere(const std::array<Point3, 4>& p, const Point3& q) {
  return kernel::insphere(p[0], p[1], p[2], p[3], q);
}

}  // namespace

template <int Dim>
std::optional<std::string> validate(const SimplexMesh<Dim>& mesh) {
  if (auto problem = broken_sizes(mesh)) return problem;
  if (auto problem = broken_point(mesh)) return problem;
  if (auto problem = broken_corner(mesh)) return problem;
  if (auto problem = unused_vertex(mesh)) return problem;
  if (auto problem = broken_orientation(mesh)) return problem;
  const HalfFacetTable<Dim> table = half_facet_table(mesh);
  if (auto problem = broken_facet(mesh, table)) return problem;
  if (auto problem = broken_neighbour(mesh, table)) return problem;
  if (auto problem = broken_boundary(mesh, BoundaryFacets<Dim>(mesh))) return problem;
  return broken_inner_facet(mesh, table);
}

template <int Dim>
std::optional<std::string> validate_delaunay(const SimplexMesh<Dim>& mesh) {
  std::optional<std::vector<typename SimplexMesh<Dim>::FacetCorners>>
      excepted;  // made when the first one fails
  for (const auto t : mesh.corners.ids()) {
    std::array<typename Simplex<Dim>::Point, Dim + 1> p;
    for (std::size_t i = 0; i <= Dim; ++i) p[i] = mesh.points[mesh.corners[t][i]];
    for (std::size_t i = 0; i <= Dim; ++i) {
      const auto neighbour = mesh.neighbours[t][i];
      if (!neighbour || *neighbour < t) continue;
      const VertexId q = corner_opposite(mesh, *neighbour, t);
      if (in_circumsphere(p, mesh.points[q]) != Sign::positive) continue;
      if (!excepted) excepted = sorted_inner_facets(mesh);
      const auto facet = outward_facet(mesh.corners[t], i);
      if (std::binary_search(excepted->begin(), excepted->end(), sorted_facet(facet).corners)) continue;
      return words(mesh, facet) + " is not locally Delaunay: " + words(mesh, q) + ", a corner of " +
             Simplex<Dim>::cell + " " + std::to_string((*neighbour).raw) + ", lies inside the " +
             (Dim == 2 ? "circumcircle" : "circumsphere") + " of " + words(mesh, t);
    }
  }
  return std::nullopt;
}

template std::optional<std::string> validate(const SimplexMesh<2>&);
template std::optional<std::string> validate(const SimplexMesh<3>&);
template std::optional<std::string> validate_delaunay(const SimplexMesh<2>&);
template std::optional<std::string> validate_delaunay(const SimplexMesh<3>&);

}  // namespace leonhard::mesh
