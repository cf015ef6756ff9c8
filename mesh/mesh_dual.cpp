// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mesh_dual.hpp"

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/structures/edges_of_pairs.hpp"
#include "leonhard/mesh/structures/mixed_sides.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

Vec2 quarter_turn(Vec2 v) { return {v.y, -v.x}; }  // clockwise

/// A cell as the dual's formulas want it: its corners as vectors from the first one, so that differences keep their
/// digits, and its centre.
template <int Dim>
class LocalCell {
 public:
  using Vector = typename Simplex<Dim>::Vector;

  LocalCell(const MixedMesh<Dim>& mesh, CellId cell)
      : shape_(mesh.shape(cell)), vertices_(mesh.corners_of(cell)) {
    const auto origin = mesh.points[vertices_[0]];
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      corners_[i] = mesh.points[vertices_[i]] - origin;
      centre_ += corners_[i];
    }
    centre_ /= static_cast<double>(vertices_.size());
  }

  /// Calls visit(from, to, face, volume) for each edge of the cell, in space twice, with vertices and their common face's
  /// part in this cell, directed from the first to the second, and the volume that either of them has at the edge.
  template <class Visit>
  void for_each_piece(Visit visit) const {
    for (const FacetShape& facet : shape_.facets) {
      if constexpr (Dim == 2) {
        visit_piece(facet[0], facet[1], Vector{}, visit);
      } else {
        Vector centre;
        for (const std::size_t i : facet) centre += corners_[i];
        centre /= static_cast<double>(facet.size());
        for (std::size_t i = 0; i < facet.size(); ++i)
          visit_piece(facet[i], facet[i + 1 == facet.size() ? 0 : i + 1], centre, visit);
      }
    }
  }

 private:
  /// The piece of an edge that runs from one corner to another as its face, outwards, turns.
  template <class Visit>
  void visit_piece(std::size_t from, std::size_t to, const Vector& of_face, Visit visit) const {
    const Vector a = corners_[from], along = corners_[to] - a, middle = 0.5 * (corners_[to] + a);
    if constexpr (Dim == 2) {
      visit(vertices_[from], vertices_[to], quarter_turn(centre_ - middle), 0.25 * cross(along, centre_ - a));
    } else {
      visit(vertices_[from], vertices_[to], 0.5 * cross(centre_ - middle, of_face - middle),
            1.0 / 12.0 * dot(cross(along, of_face - a), a - centre_));
    }
  }

  const CellShape& shape_;
  std::span<const VertexId> vertices_;
  std::array<Vector, most_cell_corners> corners_{};
  Vector centre_{};
};

/// Half an edge each.
DualFacet<2> dual_of_facet(const PerId<VertexId, Point2>& points, DualFacet<2> facet) {
  facet.normal = quarter_turn(points[facet.corners[1]] - points[facet.corners[0]]);
  facet.shares = {0.5 * facet.normal, 0.5 * facet.normal};
  return facet;
}

DualFacet<3> dual_of_facet(const PerId<VertexId, Point3>& points, DualFacet<3> facet) {
  const auto& corners = facet.corners;
  const Point3 a = points[corners[0]];
  const Vec3 b = points[corners[1]] - a, c = points[corners[2]] - a;
  if (corners.size() == 3) {
    facet.normal = 0.5 * cross(b, c);
    const Vec3 third = 1.0 / 3.0 * facet.normal;
    facet.shares = {third, third, third, Vec3{}};
    return facet;
  }
  const Vec3 d = points[corners[3]] - a;
  facet.normal = 0.5 * cross(c, d - b);
  const Vec3 centre = 0.25 * (b + c + d);
  const std::array<Vec3, 4> ring{Vec3{}, b, c, d};
  for (std::size_t i = 0; i < 4; ++i) {
    // Half the cross product of the piece's diagonals: to the centre, and between the midpoints.
    const Vec3 next = ring[(i + 1) % 4], previous = ring[(i + 3) % 4];
    facet.shares[i] = 0.25 * cross(centre - ring[i], previous - next);
  }
  return facet;
}

}  // namespace

template <int Dim>
EdgeList build_edges(const MixedMesh<Dim>& mesh) {
  require_ids_in_range(mesh);
  return edges_of(mesh.vertex_count(), [&](auto visit) {
    for (const CellId cell : mesh.kinds.ids()) for_each_edge_of(mesh, cell, visit);
  });
}

template <int Dim>
DualFacet<Dim> dual_facet(const PerId<VertexId, typename Simplex<Dim>::Point>& points,
                          const MarkedMixedFacet<Dim>& facet, CellKind cell) {
  const auto first = points[facet.corners[0]];
  typename Simplex<Dim>::Vector sum{};
  for (const VertexId v : facet.corners) sum += points[v] - first;
  const auto centre = first + (1.0 / static_cast<double>(facet.corners.size())) * sum;
  return dual_of_facet(points, DualFacet<Dim>{facet.corners, facet.marker, cell, {}, {}, centre});
}

namespace {

template <int Dim>
void list_boundary(const MixedMesh<Dim>& mesh, MeshDual<Dim>& dual) {
  dual.boundary.reserve(mesh.boundary.size());
  if (mesh.count_of(simplex_kind<Dim>) == mesh.cell_count()) {
    for (const auto& facet : mesh.boundary) dual.boundary.push_back(dual_facet(mesh.points, facet));
    return;
  }
  const MixedSides<Dim> sides(mesh);
  for (const auto& facet : mesh.boundary) {
    const auto behind = sides.find(directed_ring(facet.corners).ring);
    if (behind.empty())
      throw InputError("boundary", words(mesh, facet.corners) + " is no facet of a cell", "take it out");
    dual.boundary.push_back(dual_facet(mesh.points, facet, mesh.kinds[behind[0].cell]));
  }
}

}  // namespace

template <int Dim>
MeshDual<Dim> build_dual(const MixedMesh<Dim>& mesh) {
  MeshDual<Dim> dual;
  dual.edges = build_edges(mesh);
  dual.points = mesh.points;
  dual.marker_names = mesh.marker_names;
  dual.face.resize(dual.edge_count());
  dual.volume.resize(mesh.vertex_count(), 0.0);
  for (const CellId cell : mesh.kinds.ids()) {
    LocalCell<Dim>(mesh, cell)
        .for_each_piece(
            [&](VertexId from, VertexId to, const typename Simplex<Dim>::Vector& piece, double volume) {
              auto& face = dual.face[*dual.edges.find(from, to)];
              face = from < to ? face + piece : face - piece;
              dual.volume[from] += volume;
              dual.volume[to] += volume;
            });
  }
  list_boundary(mesh, dual);
  return dual;
}

template <int Dim>
MeshDual<Dim> build_dual(const SimplexMesh<Dim>& mesh) {
  return build_dual(mixed_mesh_of(mesh));
}

template EdgeList build_edges(const MixedMesh<2>&);
template EdgeList build_edges(const MixedMesh<3>&);
template DualFacet<2> dual_facet(const PerId<VertexId, Point2>&, const MarkedMixedFacet<2>&, CellKind);
template DualFacet<3> dual_facet(const PerId<VertexId, Point3>&, const MarkedMixedFacet<3>&, CellKind);
template MeshDual<2> build_dual(const MixedMesh<2>&);
template MeshDual<3> build_dual(const MixedMesh<3>&);
template MeshDual<2> build_dual(const SimplexMesh<2>&);
template MeshDual<3> build_dual(const SimplexMesh<3>&);

}  // namespace leonhard::mesh
