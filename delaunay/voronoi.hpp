// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/delaunay/voronoi_corner.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

using VoronoiVertexId = Id<struct VoronoiVertexTag>;
using VoronoiEdgeId = Id<struct VoronoiEdgeTag>;

/// The Voronoi diagram of a set of sites as a value (Barth's notes 3.1): to each site the convex region of the plane
/// that is nearer to it than to any other. Dual to the Delaunay triangulation: a vertex for each circumcircle, an edge
/// for each pair of sites whose regions share a segment, a ray where that pair lies on the convex hull.
///
/// Topology is exact: triangles with the same circumcircle, by exact incircle, make one vertex, so that the vertices of
/// a square grid's diagram have four edges. Only the vertices' coordinates are rounded.
///
/// What is asked of a site throws InputError where there is none of its number; ids of edges are a precondition.
struct VoronoiDiagram {
  using Vertex = VoronoiCorner<Point2>;
  /// Directed, its first site on the left: a segment with two ends, a ray with one, a line (collinear sites) with none.
  struct Edge {
    std::array<VertexId, 2> sites;
    std::array<MaybeId<VoronoiVertexId>, 2> ends;  ///< from and to; none: it comes from or goes to infinity
    [[nodiscard]] bool is_bounded() const { return ends[0].has_value() && ends[1].has_value(); }
  };

  PerId<VertexId, Point2> sites;  ///< distinct, in the order of the input points that made them
  PerId<VoronoiVertexId, Vertex> vertices;
  PerId<VoronoiEdgeId, Edge> edges;
  std::vector<std::size_t>
      first_edge;  ///< one a site and one more: where its cell's edges begin in cell_edges
  std::vector<VoronoiEdgeId>
      cell_edges;  ///< cell by cell, counter-clockwise, from the ray that comes from infinity
  std::vector<VertexId> site_of_input;  ///< one an input point; duplicates share a site

  /// throws  InputError if there is no such site
  [[nodiscard]] std::span<const VoronoiEdgeId> cell(VertexId site) const {
    if (!sites.contains(site)) [[unlikely]]
      throw InputError("site " + std::to_string(site.raw), "is none of " + std::to_string(sites.size()));
    return std::span(cell_edges)
        .subspan(first_edge[site.index()], first_edge[site.index() + 1] - first_edge[site.index()]);
  }
  /// Whether the cell reaches infinity: exactly those of the sites on the convex hull's boundary do.
  [[nodiscard]] bool is_unbounded(VertexId site) const;
  /// The site on the edge's other side.
  [[nodiscard]] VertexId across(VoronoiEdgeId e, VertexId site) const {
    return edges[e].sites[edges[e].sites[0] == site ? 1 : 0];
  }
  /// Which way an edge runs from ends[0] to ends[1]: of length 1, sites[1] - sites[0] turned left by a right angle.
  [[nodiscard]] Vec2 direction(VoronoiEdgeId e) const;
  /// A point of the edge's line: an end if it has one, else the midpoint of its sites.
  [[nodiscard]] Point2 anchor(VoronoiEdgeId e) const;
  /// The vertices of a cell, counter-clockwise: all corners of a bounded cell, those between the rays of another.
  [[nodiscard]] std::vector<VoronoiVertexId> cell_vertices(VertexId site) const;
};

/// The diagram of points. Any set has one: none makes it empty, one site has the plane as its cell, collinear sites
/// have strips between parallel lines. Equal points share a site.
///
/// options  for the triangulation; keep_convex_hull does not matter
/// returns  none if a stop was requested
/// throws   InputError for a coordinate that is not finite
/// Cost: the triangulation's, and about a microsecond a site.
[[nodiscard]] std::optional<VoronoiDiagram> voronoi_diagram(std::span<const Point2> points,
                                                            const TriangulateOptions& options = {});

/// The diagram of a mesh's vertices.
///
/// delaunay  the Delaunay triangulation of its vertices with their whole convex hull, as triangulate() makes it of
///           points; sites are numbered as its vertices
/// throws    InputError for a mesh that is not Delaunay, or whose boundary is not one convex loop
[[nodiscard]] VoronoiDiagram voronoi_diagram(const TriangleMesh& delaunay);

}  // namespace leonhard::delaunay
