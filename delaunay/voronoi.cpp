// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "leonhard/delaunay/plane/circumcentre.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

VertexId opposite_corner(const TriangleMesh& mesh, TriangleId t, const std::array<VertexId, 2>& edge) {
  const auto& corners = mesh.corners[t];
  return *std::find_if(corners.begin(), corners.end(),
                       [&](VertexId v) { return v != edge[0] && v != edge[1]; });
}

/// Triangles with the same circumcircle, gathered. throws InputError where the mesh is not Delaunay
mesh::DisjointSets cocircular_triangles(const TriangleMesh& mesh, const EdgeStructure& edges) {
  mesh::DisjointSets sets(mesh.triangle_count());
  for (const EdgeId e : edges.ends.ids()) {
    if (edges.is_boundary(e)) continue;
    const TriangleId left = *edges.sides[e][0], right = *edges.sides[e][1];
    const auto& [a, b, c] = mesh.corners[left];
    const Point2 d = mesh.points[opposite_corner(mesh, right, edges.ends[e])];
    const Sign inside = kernel::incircle(mesh.points[a], mesh.points[b], mesh.points[c], d);
    if (inside == Sign::positive)
      throw InputError("voronoi_diagram",
                       "the mesh is not Delaunay: " + mesh::words(d) +
                           " lies inside the circumcircle of triangle " + std::to_string(left.index()),
                       "give the mesh that triangulate() makes of the points alone");
    if (inside == Sign::zero) sets.join(left.index(), right.index());
  }
  return sets;
}

void refuse_what_is_not_convex(const TriangleMesh& mesh) {
  PerId<VertexId, MaybeId<VertexId>> next(mesh.vertex_count());
  for (const MarkedEdge& edge : mesh.boundary) next[edge.from] = edge.to;
  const std::string remedy = "give the mesh that triangulate() makes of the points alone";
  if (mesh.boundary.empty()) throw InputError("voronoi_diagram", "the mesh lists no boundary", remedy);
  std::size_t length = 0;
  const VertexId start = mesh.boundary.front().from;
  MaybeId<VertexId> v = start;
  do {
    v = next[*v];
    ++length;
  } while (v && v != MaybeId<VertexId>(start) && length < mesh.boundary.size());
  if (v != MaybeId<VertexId>(start) || length != mesh.boundary.size())
    throw InputError("voronoi_diagram", "the mesh's boundary is not a single loop", remedy);
  for (const MarkedEdge& edge : mesh.boundary) {
    const Point2 a = mesh.points[edge.from], b = mesh.points[edge.to], c = mesh.points[*next[edge.to]];
    if (kernel::orient2d(a, b, c) == Sign::negative)
      throw InputError("voronoi_diagram", "the mesh's boundary is not convex at " + mesh::words(b), remedy);
  }
}

VoronoiDiagram::Vertex circumcentre(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  return rounded_circumcentre({mesh.points[a], mesh.points[b], mesh.points[c]});
}

/// One a triangle: the diagram's vertex. Of the circumcentres that are the same point the most accurate is taken.
PerId<TriangleId, VoronoiVertexId> make_vertices(const TriangleMesh& mesh, mesh::DisjointSets sets,
                                                 VoronoiDiagram& diagram) {
  PerId<TriangleId, VoronoiVertexId> vertex_of(mesh.triangle_count());
  std::vector<MaybeId<VoronoiVertexId>> vertex_of_set(mesh.triangle_count());
  for (const TriangleId t : mesh.corners.ids()) {
    const VoronoiDiagram::Vertex centre = circumcentre(mesh, t);
    MaybeId<VoronoiVertexId>& vertex = vertex_of_set[sets.find(t.index())];
    if (!vertex) vertex = diagram.vertices.push_back(centre);
    if (centre.error < diagram.vertices[*vertex].error) diagram.vertices[*vertex] = centre;
    vertex_of[t] = *vertex;
  }
  return vertex_of;
}

/// One a Delaunay edge: its Voronoi edge, none where the two cells only share a vertex.
PerId<EdgeId, MaybeId<VoronoiEdgeId>> make_edges(const EdgeStructure& edges,
                                                 const PerId<TriangleId, VoronoiVertexId>& vertex_of,
                                                 VoronoiDiagram& diagram) {
  PerId<EdgeId, MaybeId<VoronoiEdgeId>> edge_of(edges.edge_count());
  const auto vertex = [&](MaybeId<TriangleId> t) {
    return t ? MaybeId<VoronoiVertexId>(vertex_of[*t]) : MaybeId<VoronoiVertexId>();
  };
  for (const EdgeId e : edges.ends.ids()) {
    const MaybeId<VoronoiVertexId> from = vertex(edges.sides[e][1]), to = vertex(edges.sides[e][0]);
    if (from == to) continue;
    edge_of[e] = diagram.edges.push_back({edges.ends[e], {from, to}});
  }
  return edge_of;
}

/// The triangle at each vertex from which all others follow counter-clockwise, with the vertex's place in it.
struct Start {
  MaybeId<TriangleId> triangle;
  unsigned corner = 0;
};
PerId<VertexId, Start> fan_starts(const TriangleMesh& mesh) {
  PerId<VertexId, Start> starts(mesh.vertex_count());
  for (const TriangleId t : mesh.corners.ids())
    for (unsigned i = 0; i < 3; ++i) {
      const bool first = !mesh.neighbours[t][(i + 2) % 3];
      Start& start = starts[mesh.corners[t][i]];
      if (first || !start.triangle) start = {t, i};
    }
  return starts;
}

/// Visit the vertices joined to v, counter-clockwise, on the hull from the one that follows it there.
template <class Visit>
void for_each_neighbour(const TriangleMesh& mesh, VertexId v, const Start& start, Visit visit) {
  TriangleId t = *start.triangle;
  unsigned i = start.corner;
  while (true) {
    visit(mesh.corners[t][(i + 1) % 3]);
    const MaybeId<TriangleId> next = mesh.neighbours[t][(i + 1) % 3];
    if (!next) return visit(mesh.corners[t][(i + 2) % 3]);
    if (*next == *start.triangle) return;
    t = *next;
    i = static_cast<unsigned>(std::find(mesh.corners[t].begin(), mesh.corners[t].end(), v) -
                              mesh.corners[t].begin());
  }
}

void make_cells(const TriangleMesh& mesh, const EdgeStructure& edges,
                const PerId<EdgeId, MaybeId<VoronoiEdgeId>>& edge_of, VoronoiDiagram& diagram) {
  const PerId<VertexId, Start> starts = fan_starts(mesh);
  diagram.first_edge.push_back(0);
  diagram.cell_edges.reserve(2 * diagram.edges.size());
  for (const VertexId v : mesh.points.ids()) {
    for_each_neighbour(mesh, v, starts[v], [&](VertexId n) {
      if (const auto edge = edge_of[*edges.find(v, n)]) diagram.cell_edges.push_back(*edge);
    });
    diagram.first_edge.push_back(diagram.cell_edges.size());
  }
}

/// Strips between parallel lines. sites are distinct and collinear.
VoronoiDiagram collinear_diagram(PerId<VertexId, Point2> sites) {
  VoronoiDiagram diagram;
  diagram.sites = std::move(sites);
  std::vector<VertexId> order(diagram.sites.ids().begin(), diagram.sites.ids().end());
  std::sort(order.begin(), order.end(),
            [&](VertexId a, VertexId b) { return diagram.sites[a] < diagram.sites[b]; });
  for (std::size_t i = 1; i < order.size(); ++i) diagram.edges.push_back({{order[i - 1], order[i]}, {}});

  PerId<VertexId, std::size_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  diagram.first_edge.push_back(0);
  for (const VertexId v : diagram.sites.ids()) {
    if (place[v] + 1 < order.size()) diagram.cell_edges.push_back(VoronoiEdgeId::from(place[v]));
    if (place[v] > 0) diagram.cell_edges.push_back(VoronoiEdgeId::from(place[v] - 1));
    diagram.first_edge.push_back(diagram.cell_edges.size());
  }
  return diagram;
}

/// Distinct points in the order in which they first appear, and one entry an input point.
std::pair<PerId<VertexId, Point2>, std::vector<VertexId>> distinct_in_order(std::span<const Point2> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> first(points.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? first[order[k - 1]] : order[k];
  PerId<VertexId, Point2> sites;
  std::vector<VertexId> site_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    site_of[i] = first[i] == i ? sites.push_back(points[i]) : site_of[first[i]];
  return {std::move(sites), std::move(site_of)};
}

}  // namespace

bool VoronoiDiagram::is_unbounded(VertexId site) const {
  const auto of_site = cell(site);
  return of_site.empty() || !edges[of_site.front()].is_bounded();
}

Vec2 VoronoiDiagram::direction(VoronoiEdgeId e) const {
  const Vec2 across = unit(towards(sites[edges[e].sites[0]], sites[edges[e].sites[1]]));
  return {-across.y, across.x};
}

Point2 VoronoiDiagram::anchor(VoronoiEdgeId e) const {
  for (const auto& end : edges[e].ends)
    if (end) return vertices[*end].at;
  const Point2 a = sites[edges[e].sites[0]], b = sites[edges[e].sites[1]];
  return {std::midpoint(a.x, b.x), std::midpoint(a.y, b.y)};
}

std::vector<VoronoiVertexId> VoronoiDiagram::cell_vertices(VertexId site) const {
  std::vector<VoronoiVertexId> corners;
  for (const VoronoiEdgeId e : cell(site)) {
    const auto to = edges[e].ends[edges[e].sites[0] == site ? 1 : 0];
    if (to) corners.push_back(*to);
  }
  return corners;
}

VoronoiDiagram voronoi_diagram(const TriangleMesh& delaunay) {
  mesh::require_ids_in_range(delaunay);
  VoronoiDiagram diagram;
  diagram.sites = delaunay.points;
  const auto ids = delaunay.points.ids();
  diagram.site_of_input.assign(ids.begin(), ids.end());
  diagram.first_edge.assign(delaunay.triangle_count() == 0 ? 1 : 0, 0);
  if (delaunay.triangle_count() == 0) return diagram;
  refuse_what_is_not_convex(delaunay);
  const EdgeStructure edges = mesh::build_edges(delaunay);
  const auto vertex_of = make_vertices(delaunay, cocircular_triangles(delaunay, edges), diagram);
  const auto edge_of = make_edges(edges, vertex_of, diagram);
  make_cells(delaunay, edges, edge_of, diagram);
  return diagram;
}

std::optional<VoronoiDiagram> voronoi_diagram(std::span<const Point2> points,
                                              const TriangulateOptions& options) {
  Triangulation result = triangulate(std::vector<Point2>(points.begin(), points.end()), options);
  const auto stopped = [&] { return options.progress.stop_requested(); };
  if (result.outcome == TriangulateOutcome::stopped || stopped()) return std::nullopt;
  if (result.outcome == TriangulateOutcome::done) {
    VoronoiDiagram diagram = voronoi_diagram(result.mesh);
    if (stopped()) return std::nullopt;
    diagram.site_of_input.clear();
    for (const MaybeId<VertexId> site : result.vertex_of_input) diagram.site_of_input.push_back(*site);
    return diagram;
  }
  auto [sites, site_of_input] = distinct_in_order(points);
  VoronoiDiagram diagram = collinear_diagram(std::move(sites));
  diagram.site_of_input = std::move(site_of_input);
  return diagram;
}

}  // namespace leonhard::delaunay
