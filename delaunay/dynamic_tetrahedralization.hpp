// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/delaunay/dynamic_queries.hpp"
#include "leonhard/delaunay/extent.hpp"
#include "leonhard/delaunay/location.hpp"
#include "leonhard/delaunay/space/coplanar_points.hpp"
#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_cavity.hpp"
#include "leonhard/delaunay/topology/tet_conflict_zone.hpp"
#include "leonhard/delaunay/topology/tet_replacement.hpp"
#include "leonhard/delaunay/topology/tet_star.hpp"
#include "leonhard/delaunay/topology/tetrahedralization_views.hpp"
#include "leonhard/delaunay/voronoi_corner.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {

/// The part of space that is nearer to a vertex than to any other: a convex polyhedron, maybe without bound.
///
/// Topology is exact: tetrahedra with the same circumsphere make one corner, and vertices whose cells touch this one in an
/// edge or a corner only are not across a face. Only the corners' coordinates are rounded.
struct TetVoronoiCell {
  struct Face {
    VertexId across;                   ///< the vertex beyond
    std::vector<std::size_t> corners;  ///< indices of corners, counter-clockwise as seen from beyond
    /// Of an unbounded face two indices of rays: it comes from infinity along the first to its first corner, and goes from
    /// its last corner to infinity along the second.
    std::vector<std::size_t> rays;
  };
  /// An edge that goes to infinity.
  struct Ray {
    std::size_t corner;  ///< where it starts
    Vec3 direction;  ///< of length 1; 0 where the face of the hull that it is normal to is too thin to say
  };
  std::vector<VoronoiCorner<Point3>> corners;
  std::vector<Ray> rays;    ///< none if the cell is bounded
  std::vector<Face> faces;  ///< in rising order of the vertices beyond

  [[nodiscard]] bool is_bounded() const { return !corners.empty() && rays.empty(); }
};

/// The Delaunay tetrahedralisation of a point set that changes: points are inserted and removed in any order, and at any time the
/// tetrahedra are those that tetrahedralize() would give for the points that are there, ties included
/// (kernel::insphere_perturbed). No order, hint or number of threads enters. DynamicTriangulation in space.
///
///     delaunay::DynamicTetrahedralization sites(points);     // vertex i is point i unless points repeat
///     const VertexId v = sites.insert({0.5, 0.5, 0.1}).vertex;
///     for (const VertexId w : sites.neighbours(v)) use(sites.point(w));
///     if (const auto here = sites.locate({0.2, 0.3, 0.4}, v); here.inside()) ...
///     sites.remove(v);
///
/// Vertex ids are stable: while a vertex lives its id does not change. A removed vertex's id means nothing until a later
/// insertion takes it for its own. Views are valid until the next change.
///
/// Points that span no tetrahedron (extent() below space) are kept without edges or faces between them: what asks for
/// tetrahedra finds none, locate tells vertices, the rest of their span and the outside apart. The point that leaves the
/// plane makes the tetrahedra, removing the last one off a plane takes them away.
///
/// throws  InputError on a point that is not finite and on a vertex that does not live, nothing changed; the same for
///         points that are not finite in queries
/// Memory: 28 bytes a vertex and 33 a tetrahedron, ghosts on the hull included, at the largest that it has been; a map's
/// node for each vertex while all are coplanar.
class DynamicTetrahedralization : public DynamicQueries<DynamicTetrahedralization, Point3, TetLocation> {
 public:
  DynamicTetrahedralization() = default;
  /// As insert(points).
  explicit DynamicTetrahedralization(std::span<const Point3> points, unsigned threads = 1);

  // ---- Changes ----

  using Inserted = delaunay::Inserted;
  /// Cost: that of locate and O(k log k) for k tetrahedra made, some 27 for points that fill space, at worst all n; that
  /// of tetrahedralize() where the extent becomes space.
  /// Method: Bowyer 1981 and Watson 1981 with a ghost vertex.
  Inserted insert(const Point3& p, MaybeId<VertexId> hint = {});
  /// The vertices of many points, as inserting them one by one would leave them; equal points share one. Where there was
  /// no vertex before, all ids are new: 0, 1, ... in the order of the points that made them, at the cost of
  /// tetrahedralize().
  std::vector<VertexId> insert(std::span<const Point3> points, unsigned threads = 1);
  /// The vertex may lie on the hull; its id may be given to a later insertion.
  ///
  /// The hole is filled with tetrahedra of the Delaunay tetrahedralisation of the k neighbours: those with the vertex in
  /// their spheres. Cost O(k log k) expected for neighbours all around, O(k^2) at worst; O(n log n) where the extent
  /// becomes a plane.
  /// Method: O. Devillers and M. Teillaud, "Perturbations for Delaunay and weighted Delaunay 3D triangulations" (2011).
  void remove(VertexId v);
  void clear();

  // ---- What is there ----

  [[nodiscard]] std::size_t size() const { return points_.size() - free_.size(); }  ///< number of vertices
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Extent extent() const { return has_tets() ? Extent::space : flat_.extent(); }
  /// All ids are below: the size of an array by vertex.
  [[nodiscard]] std::size_t id_bound() const { return points_.size(); }
  [[nodiscard]] bool contains(VertexId v) const { return points_.contains(v) && is_finite(points_[v]); }
  [[nodiscard]] const Point3& point(VertexId v) const {
    if (!contains(v)) [[unlikely]]
      require_living(v);
    return points_[v];
  }

  [[nodiscard]] TetVertexView vertices() const { return TetVertexView(points_.flat()); }
  /// The ends of each edge, each edge once, in no particular order. Cost of going through all: O(tetrahedra).
  [[nodiscard]] TetEdgeView edges() const { return TetEdgeView(cells_); }
  [[nodiscard]] std::size_t edge_count() const;  ///< cost O(vertices on the hull)
  /// The corners of each tetrahedron, positive, in no particular order.
  [[nodiscard]] TetView tets() const { return TetView(cells_); }
  [[nodiscard]] std::size_t tet_count() const;  ///< cost O(vertices on the hull)
  /// The other ends of a vertex's edges, in rising order. Cost O(degree).
  [[nodiscard]] std::vector<VertexId> neighbours(VertexId v) const;
  /// The corners, positive, of each tetrahedron at a vertex, in no particular order. Cost O(degree).
  [[nodiscard]] std::vector<VertexQuadruple> tets_at(VertexId v) const;
  /// Whether a vertex lies on the boundary of the convex hull, in whatever part of it; true of all vertices while they
  /// are coplanar. Cost O(degree).
  [[nodiscard]] bool on_hull(VertexId v) const;
  /// The triangles of the convex hull's boundary, each counter-clockwise as seen from outside with the least id first, in
  /// rising order; none while all vertices are coplanar. Cost O(k log k) for k of them.
  [[nodiscard]] std::vector<VertexTriple> hull() const;
  /// The vertex's cell among the vertices that there are; empty while all of them are coplanar. Cost O(k log k) for k
  /// tetrahedra at the vertex.
  [[nodiscard]] TetVoronoiCell voronoi_cell(VertexId v) const;

  struct Mesh {
    TetMesh mesh;  ///< empty unless there are tetrahedra; boundary faces have marker 1
    std::vector<MaybeId<VertexId>> mesh_vertex;  ///< one an id: its vertex in the mesh, in the order of ids
  };
  [[nodiscard]] Mesh to_mesh() const;
  /// mesh::fingerprint of to_mesh(): that of tetrahedralize() for the same points.
  [[nodiscard]] Fingerprint fingerprint() const { return mesh::fingerprint(to_mesh().mesh); }

  /// The first broken invariant in words, none if all hold: removed ids and coordinates agree; while all vertices are
  /// coplanar, every one is in its place and in the span; else the tetrahedralisation of the 3-sphere is one, the
  /// tetrahedra about every vertex, the ghost too, close to a sphere by Euler's formula and make up all there are, every
  /// real one is positive, and every one is Delaunay with its neighbours, ties and hull included.
  /// Cost O(tetrahedra).
  [[nodiscard]] std::optional<std::string> validate() const;

 private:
  friend class DynamicQueries<DynamicTetrahedralization, Point3, TetLocation>;

  /// What a query keeps to itself: where the next walk starts, and buffers.
  struct Search {
    explicit Search(MaybeId<VertexId> near_to) : near(near_to) {}
    MaybeId<VertexId> near;
    TetStar star;
    TetConflictZone zone;
    std::vector<VertexWeight> weights;
  };
  [[nodiscard]] bool has_tets() const { return cells_.tet_count() > 0; }
  [[nodiscard]] Search search_for(const Point3& p, MaybeId<VertexId> hint) const;
  [[nodiscard]] VertexId sampled_vertex(const Point3& p, VertexId best) const;
  [[nodiscard]] TetId find(const Point3& p, Search& search) const;
  [[nodiscard]] TetLocation answer(const Point3& p, TetId found) const;
  [[nodiscard]] TetLocation locate_in_span(const Point3& p) const;
  [[nodiscard]] TetLocation locate_from(const Point3& p, Search& search) const;
  [[nodiscard]] MaybeId<VertexId> nearest_from(const Point3& p, Search& search) const;
  [[nodiscard]] bool is_nearer(const Point3& p, VertexId a, VertexId b) const;
  void collect_neighbours(VertexId v, Search& search, std::vector<VertexId>& into) const;
  TetLocation::Kind find_linear_weights(const Point3& p, Search& search) const;
  TetLocation::Kind find_natural_weights(const Point3& p, Search& search) const;
  [[nodiscard]] bool zone_is_flat_on_hull(const TetConflictZone& zone) const;
  struct HullSize {
    std::size_t vertices{}, faces{};
  };
  [[nodiscard]] HullSize hull_size() const;

  void require_living(VertexId v) const;
  VertexId new_vertex(const Point3& p);
  void kill(VertexId v);
  Inserted insert_flat(const Point3& p);
  VertexId insert_in_space(const Point3& p, TetId destroyed);
  void insert_first(std::span<const Point3> points, std::vector<VertexId>& vertex_of, unsigned threads);
  void build(unsigned threads);
  void fall_flat(VertexId removed);
  void fill_with_ghosts(VertexId v);
  void fill_with_tets(VertexId v, std::span<const VertexId> link, const GhostTetrahedralization& without_v);
  void set_tets_of(TetId t);

  [[nodiscard]] std::optional<std::string> broken_id() const;
  [[nodiscard]] std::optional<std::string> broken_span() const;
  [[nodiscard]] std::optional<std::string> broken_topology() const;
  [[nodiscard]] std::optional<std::string> broken_star() const;
  [[nodiscard]] std::optional<std::string> broken_geometry() const;

  PerId<VertexId, Point3> points_;  // NaN where removed
  PerId<VertexId, TetId> tets_;     // in space: of each vertex a tetrahedron, maybe a ghost
  std::vector<VertexId> free_;      // removed, to be used again
  CoplanarPoints flat_;             // all vertices, unless there are tetrahedra
  GhostTetrahedralization
      cells_;  // empty unless there are tetrahedra; those out of use have the ghost at all corners
  std::vector<TetId> spare_;  // numbers of cells_ out of use
  TetId ghost_tet_{};         // in space: a ghost
  VertexId last_{};           // in space: where something was changed last
  TetCavity cavity_;
  TetReplacement replacement_;
  TetStar star_;
};

}  // namespace leonhard::delaunay
