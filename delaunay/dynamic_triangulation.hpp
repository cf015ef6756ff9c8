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
#include "leonhard/delaunay/plane/collinear_points.hpp"
#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/delaunay/topology/star.hpp"
#include "leonhard/delaunay/topology/triangulation_views.hpp"
#include "leonhard/delaunay/voronoi_corner.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

/// The part of the plane that is nearer to a vertex than to any other: a convex polygon, maybe without bound.
///
/// Topology is exact: triangles with the same circumcircle make one corner, and vertices whose cells only touch this one in
/// a corner are not across a side. Only the corners' coordinates are rounded.
struct VoronoiCell {
  /// Counter-clockwise; of an unbounded cell from the side that comes from infinity.
  std::vector<VoronoiCorner<Point2>> corners;
  /// The vertex beyond each side, counter-clockwise; side i ends in corners[i]. An unbounded cell with corners has one side
  /// more than these: the first comes from infinity, the last goes there. Without corners, while all vertices lie on one
  /// line, each side is the whole bisector.
  std::vector<VertexId> across;
  /// Of an unbounded cell with corners, of length 1: in which directions the first and the last side reach infinity.
  std::vector<Vec2> rays;

  [[nodiscard]] bool is_bounded() const { return !corners.empty() && rays.empty(); }
};

/// The Delaunay triangulation of a point set that changes: points are inserted and removed in any order, and at any time
/// the triangles are those that triangulate() would give for the points that are there, ties included
/// (kernel::incircle_perturbed). No order, hint or number of threads enters.
///
///     delaunay::DynamicTriangulation sites(points);          // vertex i is point i unless points repeat
///     const VertexId v = sites.insert({0.5, 0.5}).vertex;
///     for (const VertexId w : sites.neighbours(v)) use(sites.point(w));
///     if (const auto here = sites.locate({0.2, 0.3}, v); here.inside()) ...
///     sites.remove(v);
///
/// Vertex ids are stable: while a vertex lives its id does not change. A removed vertex's id means nothing
/// until a later insertion takes it for its own. Views and spans are valid until the next change.
///
/// No point, one point and points on one line are states like any other (extent()): the point that leaves the
/// line makes the triangles, and removing the last one off a line takes them away.
///
/// throws  InputError on a point that is not finite and on a vertex that does not live, nothing changed; the
///         same for points that are not finite in queries
/// Memory: 68 bytes a vertex, and a map's node for each vertex while all lie on one line.
class DynamicTriangulation : public DynamicQueries<DynamicTriangulation, Point2, PointLocation> {
 public:
  DynamicTriangulation() = default;
  /// As insert(points).
  explicit DynamicTriangulation(std::span<const Point2> points, unsigned threads = 1);

  // ---- Changes ----

  using Inserted = delaunay::Inserted;
  /// Cost: that of locate and O(degree), expected O(1) for points in random order; O(n) where the extent
  /// becomes a plane. Method: Bowyer 1981 and Watson 1981 (Barth's notes 3.3b) with a ghost vertex.
  Inserted insert(Point2 p, MaybeId<VertexId> hint = {});
  /// The vertices of many points, as inserting them one by one would leave them; equal points share one.
  /// Where there was no vertex before, all ids are new: 0, 1, ... in the order of the points that made them,
  /// in O(n log n).
  std::vector<VertexId> insert(std::span<const Point2> points, unsigned threads = 1);
  /// The vertex may lie on the hull; its id may be given to a later insertion.
  /// Cost O(degree log degree), O(n log n) where the extent becomes a line. Method: the hole is filled with
  /// the triangles that are Delaunay for its corners (Devillers, Int. J. Computational Geometry and
  /// Applications 12 (2002)), see Star.
  void remove(VertexId v);
  void clear();

  // ---- What is there ----

  [[nodiscard]] std::size_t size() const { return points_.size() - free_.size(); }  ///< number of vertices
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Extent extent() const;
  /// All ids are below: the size of an array by vertex.
  [[nodiscard]] std::size_t id_bound() const { return points_.size(); }
  [[nodiscard]] bool contains(VertexId v) const { return points_.contains(v) && is_finite(points_[v]); }
  [[nodiscard]] Point2 point(VertexId v) const {
    if (!contains(v)) [[unlikely]]
      require_living(v);
    return points_[v];
  }

  [[nodiscard]] VertexView vertices() const { return VertexView(points_.flat()); }
  /// The ends of each edge, each edge once, in no particular order; on a line, the pieces between vertices that follow
  /// each other.
  [[nodiscard]] EdgeView edges() const { return EdgeView(triangles_, line_); }
  [[nodiscard]] std::size_t edge_count() const;  ///< cost O(vertices on the hull)
  /// The corners of each triangle, counter-clockwise, in no particular order.
  [[nodiscard]] TriangleView triangles() const { return TriangleView(triangles_); }
  [[nodiscard]] std::size_t triangle_count() const;  ///< cost O(vertices on the hull)
  /// The other ends of a vertex's edges, counter-clockwise; on a line, the vertex before and the one after it.
  [[nodiscard]] NeighbourView neighbours(VertexId v) const;
  /// The corners of each triangle at a vertex, counter-clockwise, the vertex first; the triangles counter-clockwise about
  /// it too, on the hull from the first one within. Cost O(degree).
  [[nodiscard]] std::vector<VertexTriple> triangles_at(VertexId v) const;
  /// Whether a vertex lies on the boundary of the convex hull, within its straight parts too; true of all vertices while
  /// they lie on one line. Cost O(degree).
  [[nodiscard]] bool on_hull(VertexId v) const;
  /// The vertices on the boundary of the convex hull, those within its straight parts too, counter-clockwise
  /// from the lexicographically first. All vertices in lexicographic order if they lie on one line.
  [[nodiscard]] std::vector<VertexId> hull() const;

  /// The vertex's cell among the vertices that there are. Cost O(degree).
  [[nodiscard]] VoronoiCell voronoi_cell(VertexId v) const;

  struct Mesh {
    TriangleMesh mesh;  ///< empty unless there are triangles; boundary edges have marker 1
    std::vector<MaybeId<VertexId>> mesh_vertex;  ///< one an id: its vertex in the mesh, in the order of ids
  };
  [[nodiscard]] Mesh to_mesh() const;
  /// mesh::fingerprint of to_mesh(): that of triangulate() for the same points.
  [[nodiscard]] Fingerprint fingerprint() const { return mesh::fingerprint(to_mesh().mesh); }

  /// The first broken invariant in words, none if all hold: removed ids and coordinates agree; on a line,
  /// every vertex is in its place and all are collinear; in the plane, the triangulation of the sphere is
  /// one, has 2 n - 2 triangles, every one real and counter-clockwise or a ghost, every vertex with one ring
  /// of triangles and a side of its own, and every triangle is Delaunay with its neighbours, ties and hull
  /// included. Cost O(n log n).
  [[nodiscard]] std::optional<std::string> validate() const;

 private:
  friend class DynamicQueries<DynamicTriangulation, Point2, PointLocation>;

  /// What a query keeps to itself: where the next walk starts, and buffers.
  struct Search {
    explicit Search(MaybeId<VertexId> near_to) : near(near_to) {}
    MaybeId<VertexId> near;
    Coin coin;
    Cavity cavity;
    std::vector<VertexWeight> weights;
  };
  [[nodiscard]] Search search_for(Point2 p, MaybeId<VertexId> hint) const;

  [[nodiscard]] AnyTriangleId triangle_at(VertexId v) const;
  [[nodiscard]] AnyTriangleId triangle_towards(Point2 p, Search& search) const;
  [[nodiscard]] VertexId sampled_vertex(Point2 p, VertexId best) const;
  [[nodiscard]] Location find(Point2 p, Search& search) const;
  [[nodiscard]] PointLocation answer(Location found) const;
  [[nodiscard]] PointLocation locate_on_line(Point2 p) const;
  [[nodiscard]] PointLocation locate_from(Point2 p, Search& search) const;
  [[nodiscard]] MaybeId<VertexId> nearest_from(Point2 p, Search& search) const;
  [[nodiscard]] bool is_nearer(Point2 p, VertexId a, VertexId b) const;
  void collect_neighbours(VertexId v, Search& search, std::vector<VertexId>& into) const;
  PointLocation::Kind find_linear_weights(Point2 p, Search& search) const;
  PointLocation::Kind find_natural_weights(Point2 p, Search& search) const;
  void weigh(Point2 p, const PointLocation& at, std::vector<VertexWeight>& weights) const;
  [[nodiscard]] bool on_hull(SideId side) const;
  [[nodiscard]] std::size_t hull_size() const;
  [[nodiscard]] SideId first_side_within(VertexId v) const;
  [[nodiscard]] bool has_one_circle(SideId side) const;

  void require_living(VertexId v) const;
  VertexId new_vertex(Point2 p);
  void kill(VertexId v);
  Inserted insert_on_line(Point2 p);
  VertexId insert_in_plane(Point2 p, AnyTriangleId destroyed);
  void insert_first(std::span<const Point2> points, std::vector<VertexId>& vertex_of, unsigned threads);
  void fan_over_line(VertexId v);
  void add_ghosts(std::span<const SideId> hull_sides);
  [[nodiscard]] bool star_surrounds_a_line() const;
  void collapse_to_line();
  void erase_triangle(AnyTriangleId t);
  void set_side(VertexId v, SideId side);
  void set_sides_of(AnyTriangleId t);

  [[nodiscard]] std::optional<std::string> broken_id() const;
  [[nodiscard]] std::optional<std::string> broken_line() const;
  [[nodiscard]] std::optional<std::string> broken_topology() const;
  [[nodiscard]] std::optional<std::string> broken_ring() const;
  [[nodiscard]] std::optional<std::string> broken_geometry() const;

  PerId<VertexId, Point2> points_;  // NaN where removed
  PerId<VertexId, SideId> sides_;   // in the plane: of each vertex a side that comes from it
  std::vector<VertexId> free_;      // removed, to be used again
  CollinearPoints line_;            // all vertices, unless there are triangles
  GhostTriangulation triangles_;    // empty unless there are triangles
  SideId ghost_side_{};             // in the plane: a side that comes from the ghost
  VertexId last_{};                 // in the plane: where something was changed last
  Cavity cavity_;
  Star star_;
};

}  // namespace leonhard::delaunay
