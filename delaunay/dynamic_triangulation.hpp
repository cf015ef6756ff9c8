// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/delaunay/dynamic/vertex_weights.hpp"
#include "leonhard/delaunay/plane/collinear_points.hpp"
#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/delaunay/topology/star.hpp"
#include "leonhard/delaunay/topology/triangulation_views.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

/// What the vertices span.
enum class Extent {
  nothing,  ///< there is no vertex
  point,    ///< one vertex
  line,     ///< two or more vertices, all on one line
  plane,    ///< there are triangles
};

/// Where a point lies: a closed set of answers, each of which depends on the vertices and the point alone.
struct PointLocation {
  enum class Kind {
    on_vertex,    ///< at vertices[0]
    on_edge,      ///< strictly between vertices[0] < vertices[1], of the triangulation or of the line
    in_triangle,  ///< strictly inside the triangle of the three vertices, counter-clockwise, the least id first
    outside,  ///< not in the convex hull of the vertices, which may be a triangle, a segment, a point or nothing
  };
  Kind kind = Kind::outside;
  std::array<MaybeId<VertexId>, 3> vertices;  ///< as many as the kind says, then none

  [[nodiscard]] bool inside() const { return kind != Kind::outside; }
  friend bool operator==(const PointLocation&, const PointLocation&) = default;
};

/// Vertices whose convex combination a point is.
struct NaturalNeighbours {
  PointLocation::Kind where = PointLocation::Kind::outside;
  std::vector<VertexWeight> weights;  ///< of sum 1; empty outside
};

/// A value at a point.
struct Interpolated {
  PointLocation::Kind where = PointLocation::Kind::outside;
  double value{};  ///< NaN outside

  [[nodiscard]] bool inside() const { return where != PointLocation::Kind::outside; }
};
/// The sum of weighted values, values[v.index()] that of v. throws InputError if one is missing
[[nodiscard]] Interpolated interpolated(PointLocation::Kind where, std::span<const VertexWeight> weights,
                                        std::span<const double> values);

/// The Delaunay triangulation of a point set that changes: points come and go in any order, and at any time
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
/// Queries do not change anything, not even unseen, so any number of threads may query at once. A hint is any
/// vertex thought to be near; it changes the time alone, and one that does not live is ignored. A walk that
/// does not arrive soon starts again from the nearest of some vertices drawn at random ("jump and walk":
/// Mücke, Saias and Zhu, SoCG 1996): expected O(n^(1/3)) for points spread evenly, O(1) from a near hint.
/// Without a hint it starts from where something was changed last.
///
/// throws  InputError on a point that is not finite and on a vertex that does not live, nothing changed; the
///         same for points that are not finite in queries
/// Memory: 68 bytes a vertex, and a map's node for each vertex while all lie on one line.
class DynamicTriangulation {
 public:
  DynamicTriangulation() = default;
  /// As insert(points).
  explicit DynamicTriangulation(std::span<const Point2> points, unsigned threads = 1);

  // ---- Changes ----

  struct Inserted {
    VertexId vertex;
    bool is_new;  ///< false: the vertex was there, at the same coordinates (-0 equal to +0)
  };
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
  [[nodiscard]] EdgeView edges() const { return EdgeView(triangles_, line_); }
  [[nodiscard]] TriangleView triangles() const { return TriangleView(triangles_); }
  [[nodiscard]] NeighbourView neighbours(VertexId v) const;
  /// The vertices on the boundary of the convex hull, those within its straight parts too, counter-clockwise
  /// from the lexicographically first. All vertices in lexicographic order if they lie on one line.
  [[nodiscard]] std::vector<VertexId> hull() const;

  struct Mesh {
    TriangleMesh mesh;  ///< empty unless there are triangles; boundary edges have marker 1
    std::vector<MaybeId<VertexId>> mesh_vertex;  ///< one an id: its vertex in the mesh, in the order of ids
  };
  [[nodiscard]] Mesh to_mesh() const;
  /// mesh::fingerprint of to_mesh(): that of triangulate() for the same points.
  [[nodiscard]] Fingerprint fingerprint() const { return mesh::fingerprint(to_mesh().mesh); }

  // ---- Queries ----

  [[nodiscard]] PointLocation locate(Point2 p, MaybeId<VertexId> hint = {}) const;
  /// The vertex nearest to p by exact comparison, of several equally near the lexicographically first; none
  /// if there is no vertex.
  [[nodiscard]] MaybeId<VertexId> nearest_vertex(Point2 p, MaybeId<VertexId> hint = {}) const;
  /// Sibson's weights: the shares of the Voronoi cell that p would have if it were inserted, by the cells
  /// that they are cut from. On an edge of the hull and on a line the limit, linear between the edge's ends;
  /// on a vertex that vertex alone.
  /// Method: R. Sibson, "A brief description of natural neighbour interpolation" (1981); see sibson_weights
  /// for accuracy. Cost: that of insert.
  [[nodiscard]] NaturalNeighbours natural_neighbours(Point2 p, MaybeId<VertexId> hint = {}) const;
  /// The value at p of the function that is linear on each triangle (each edge, on a line).
  ///
  /// values  one an id, values[v.index()] that of v; InputError if there are fewer than id_bound()
  [[nodiscard]] Interpolated interpolate_linear(Point2 p, std::span<const double> values,
                                                MaybeId<VertexId> hint = {}) const;
  /// The sum of the values times natural_neighbours(p).weights: continuous, smooth but at the vertices, and
  /// exact for linear functions.
  [[nodiscard]] Interpolated interpolate_natural_neighbour(Point2 p, std::span<const double> values,
                                                           MaybeId<VertexId> hint = {}) const;

  // ---- Many queries at once ----
  //
  // The answers in the order of the points, equal to those of single queries. Points are visited along a
  // Hilbert curve, each walk starting where the last one ended, in blocks that threads share; threads 0: as
  // many as there are cores.

  [[nodiscard]] std::vector<PointLocation> locate(std::span<const Point2> points, unsigned threads = 0) const;
  [[nodiscard]] std::vector<MaybeId<VertexId>> nearest_vertices(std::span<const Point2> points,
                                                                unsigned threads = 0) const;
  [[nodiscard]] std::vector<Interpolated> interpolate_linear(std::span<const Point2> points,
                                                             std::span<const double> values,
                                                             unsigned threads = 0) const;
  [[nodiscard]] std::vector<Interpolated> interpolate_natural_neighbour(std::span<const Point2> points,
                                                                        std::span<const double> values,
                                                                        unsigned threads = 0) const;

  /// The first broken invariant in words, none if all hold: removed ids and coordinates agree; on a line,
  /// every vertex is in its place and all are collinear; in the plane, the triangulation of the sphere is
  /// one, has 2 n - 2 triangles, every one real and counter-clockwise or a ghost, every vertex with one ring
  /// of triangles and a side of its own, and every triangle is Delaunay with its neighbours, ties and hull
  /// included. Cost O(n log n).
  [[nodiscard]] std::optional<std::string> validate() const;

 private:
  /// What a query keeps to itself: where the next walk starts, and buffers.
  struct Search {
    explicit Search(MaybeId<VertexId> near_to) : near(near_to) {}
    MaybeId<VertexId> near;
    Coin coin;
    Cavity cavity;
    std::vector<VertexWeight> weights;
  };
  [[nodiscard]] Search search_for(Point2 p, MaybeId<VertexId> hint) const;

  [[nodiscard]] TriangleId triangle_at(VertexId v) const;
  [[nodiscard]] TriangleId triangle_towards(Point2 p, Search& search) const;
  [[nodiscard]] VertexId sampled_vertex(Point2 p, VertexId best) const;
  [[nodiscard]] Location find(Point2 p, Search& search) const;
  [[nodiscard]] PointLocation answer(Location found) const;
  [[nodiscard]] PointLocation locate_on_line(Point2 p) const;
  [[nodiscard]] PointLocation locate(Point2 p, Search& search) const;
  [[nodiscard]] MaybeId<VertexId> nearest_vertex(Point2 p, Search& search) const;
  [[nodiscard]] bool is_nearer(Point2 p, VertexId a, VertexId b) const;
  PointLocation::Kind find_linear_weights(Point2 p, Search& search) const;
  PointLocation::Kind find_natural_weights(Point2 p, Search& search) const;
  void weigh(Point2 p, const PointLocation& at, std::vector<VertexWeight>& weights) const;
  [[nodiscard]] bool on_hull(SideId side) const;
  void require_values(std::span<const double> values) const;

  void require_living(VertexId v) const;
  VertexId new_vertex(Point2 p);
  void kill(VertexId v);
  Inserted insert_on_line(Point2 p);
  VertexId insert_in_plane(Point2 p, TriangleId destroyed);
  void insert_first(std::span<const Point2> points, std::vector<VertexId>& vertex_of, unsigned threads);
  void fan_over_line(VertexId v);
  void add_ghosts(std::span<const SideId> hull_sides);
  [[nodiscard]] bool star_surrounds_a_line() const;
  void collapse_to_line();
  void erase_triangle(TriangleId t);
  void set_side(VertexId v, SideId side);
  void set_sides_of(TriangleId t);

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
