// SPDX-License-Identifier: MIT
// The figure of section 2.1: a planar graph oriented with out-degree three at most.
#include <set>
#include <string>

#include "figures.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/orientation.hpp"
#include "leonhard/mesh/edges.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

const draw::Stroke directed{.colour = second, .width = 1.4};

Diagram base_of(const TriangleMesh& mesh, const std::string& title) {
  Diagram diagram;
  diagram.title = title;
  diagram.region = draw::Box{{-0.08, -0.08}, {1.08, 1.08}};
  for (const Point2 p : mesh.points) diagram.dots.push_back({p, {0.1, 0.1, 0.1}, 0.8});
  return diagram;
}

void add_directed(Diagram& diagram, Point2 from, Point2 to, const draw::Stroke& stroke) {
  const Vec2 along = to - from;
  diagram.add_arrow(from + 0.08 * along, from + 0.90 * along, stroke);
}

/// After `removed` vertices: what is left thin, what the last one directed red, the boundary vertex itself red.
Diagram after_removals(const TriangleMesh& mesh, const EdgeStructure& edges,
                       const graph::PlanarOrientation& found, std::size_t removed) {
  Diagram diagram = base_of(mesh, removed == 0 ? "undirected" : std::to_string(removed) + " removed");
  const std::set<std::uint32_t> gone(found.removed.begin(),
                                     found.removed.begin() + static_cast<std::ptrdiff_t>(removed));
  const PerId<EdgeId, VertexId> tail = graph::tails(edges, found.orientation);
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    const VertexId head = tail[e] == a ? b : a;
    const bool last =
        removed > 0 && (a.raw == found.removed[removed - 1] || b.raw == found.removed[removed - 1]);
    const std::size_t gone_before =
        gone.count(static_cast<std::uint32_t>(a.raw)) + gone.count(static_cast<std::uint32_t>(b.raw));
    if (gone_before == 0)
      diagram.add_segment(mesh.points[a], mesh.points[b], thin);
    else if (last && gone_before == 1)
      add_directed(diagram, mesh.points[tail[e]], mesh.points[head], {.colour = accent, .width = 2});
    else
      add_directed(diagram, mesh.points[tail[e]], mesh.points[head], {.colour = faint, .width = 1});
  }
  if (removed > 0)
    diagram.dots.push_back({mesh.points[VertexId::from(found.removed[removed - 1])], accent, 1.6});
  return diagram;
}

std::vector<Diagram> orientation() {
  const TriangleMesh mesh = delaunay::triangulate(random_sites(11, 5, 0.2)).mesh;
  const EdgeStructure edges = mesh::build_edges(mesh);
  std::vector<std::uint32_t> boundary;
  for (const MarkedEdge& edge : mesh.boundary) boundary.push_back(static_cast<std::uint32_t>(edge.from.raw));
  const graph::PlanarOrientation found = graph::orient_planar(graph::vertex_graph(mesh, edges), boundary);
  std::vector<Diagram> panels;
  for (std::size_t removed = 0; removed < 9; ++removed)
    panels.push_back(after_removals(mesh, edges, found, removed));
  Diagram all = base_of(mesh, "all edges directed, at most " +
                                  std::to_string(found.orientation.max_out_degree()) + " leave a vertex");
  for (std::uint32_t v = 0; v < found.orientation.vertex_count(); ++v)
    for (const std::uint32_t w : found.orientation.heads_of(v))
      add_directed(all, mesh.points[VertexId::from(v)], mesh.points[VertexId::from(w)], directed);
  panels.push_back(std::move(all));
  return panels;
}

}  // namespace

std::vector<Figure> orientation_figures() {
  return {{"2.1.0", "Orientation with out-degree 3 at most, by reducible boundary vertices", orientation, 5}};
}

}  // namespace leonhard::notes
