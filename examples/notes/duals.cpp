// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "leonhard/delaunay/voronoi_clip.hpp"
#include "leonhard/kernel/constructions.hpp"
#include "leonhard/mesh/data_structures.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

/// Seven sites about a central one, which is vertex 0.
std::vector<Point2> star() {
  std::vector<Point2> sites{{0, 0}};
  constexpr std::array radii{1.0, 1.15, 0.9, 1.1, 1.0, 1.2, 0.95};
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + 0.25 * std::sin(3.0 * static_cast<double>(i))) / 7;
    sites.push_back({radii[i] * std::cos(angle), radii[i] * std::sin(angle)});
  }
  return sites;
}

enum class Dual { median, centroid, dirichlet };

/// The dual's edges between triangles that share an edge of the centre, and the centre's cell shaded.
Diagram dual_about_centre(const TriangleMesh& mesh, Dual dual, const std::string& title) {
  Diagram diagram = diagram_of(mesh, title);
  const EdgeStructure edges = mesh::build_edges(mesh);
  const auto centre_of = [&](TriangleId t) {
    const auto all = corners(mesh, t);
    return dual == Dual::dirichlet ? kernel::circumcircle(all[0], all[1], all[2]).centre : centroid(all);
  };
  for (const EdgeId e : edges.ends.ids()) {
    if (edges.ends[e][0] != VertexId{0}) continue;
    const Point2 a = mesh.points[edges.ends[e][0]], b = mesh.points[edges.ends[e][1]];
    const Point2 left = centre_of(*edges.sides[e][0]), right = centre_of(*edges.sides[e][1]);
    const Point2 middle = a + 0.5 * (b - a);
    const std::vector<Point2> face =
        dual == Dual::median ? std::vector<Point2>{right, middle, left} : std::vector<Point2>{right, left};
    std::vector<Point2> part = face;
    part.push_back(a);
    diagram.areas.push_back({part, shade});
    diagram.paths.push_back({face, strong});
  }
  return diagram;
}

std::vector<Diagram> three_duals() {
  const TriangleMesh mesh = delaunay::triangulate(star()).mesh;
  return {dual_about_centre(mesh, Dual::median, "Median segments"),
          dual_about_centre(mesh, Dual::centroid, "Centroid segments"),
          dual_about_centre(mesh, Dual::dirichlet, "Dirichlet tessellation")};
}

void number_vertices(Diagram& diagram, const TriangleMesh& mesh) {
  const Point2 middle = centroid(mesh.points.flat());
  for (const VertexId v : mesh.points.ids()) {
    const Vec2 out = mesh.points[v] - middle;
    const Vec2 shift = norm(out) > 0.3 ? 1.0 / norm(out) * out : Vec2{1.1, -0.7};
    diagram.words.push_back({mesh.points[v], std::to_string(v.index()), shift});
  }
}

Diagram finite_elements(const TriangleMesh& mesh) {
  Diagram diagram = diagram_of(mesh, "(a) Finite elements");
  number_vertices(diagram, mesh);
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    diagram.words.push_back(
        {centroid(corners(mesh, t)),
         std::to_string(a.index()) + " " + std::to_string(b.index()) + " " + std::to_string(c.index()),
         {},
         second});
  }
  return diagram;
}

/// Of each edge at the centre the row of the structure: its ends, then the triangles left and right.
Diagram edges_with_sides(const TriangleMesh& mesh) {
  Diagram diagram = diagram_of(mesh, "(b) Edges: ends, cells left and right", light);
  const EdgeStructure edges = mesh::build_edges(mesh);
  number_vertices(diagram, mesh);
  for (const TriangleId t : mesh.corners.ids())
    diagram.words.push_back(
        {centroid(corners(mesh, t)), std::string(1, static_cast<char>('A' + t.index())), {}, second});
  const EdgeId e = *edges.find(VertexId{0}, VertexId{2});
  const Point2 a = mesh.points[edges.ends[e][0]], b = mesh.points[edges.ends[e][1]];
  diagram.add_arrow(a, b, strong);
  const auto letter = [](TriangleId t) { return std::string(1, static_cast<char>('A' + t.index())); };
  diagram.words.push_back({{-0.75, -1.15},
                           "edge " + std::to_string(e.index()) + ": " +
                               std::to_string(edges.ends[e][0].index()) + ", " +
                               std::to_string(edges.ends[e][1].index()) + ", " + letter(*edges.sides[e][0]) +
                               ", " + letter(*edges.sides[e][1]),
                           {},
                           accent});
  return diagram;
}

Diagram out_degrees(const TriangleMesh& mesh) {
  const OutDegreeList list = mesh::out_degree_list(mesh);
  Diagram diagram;
  diagram.title = "(c) Out-degree lists";
  for (const VertexId v : mesh.points.ids()) {
    diagram.dots.push_back({mesh.points[v]});
    for (const VertexId head : list.heads_of(v)) {
      const Vec2 way = mesh.points[head] - mesh.points[v];
      diagram.add_arrow(mesh.points[v], mesh.points[v] + (1 - 0.06 / norm(way)) * way, thin);
    }
  }
  number_vertices(diagram, mesh);
  return diagram;
}

/// One edge e with the next and previous edges of the region on its left, and the dual edge that crosses it.
Diagram quad_edges(const TriangleMesh& mesh) {
  Diagram diagram = diagram_of(mesh, "(d) Quad-edge: e, its left ring, its dual", light);
  const QuadEdge quads = mesh::quad_edge(mesh);
  const EdgeStructure edges = mesh::build_edges(mesh);
  EdgeRef e{0};
  while (!(quads.origin(e) == MaybeId(VertexId{0}) && quads.destination(e) == MaybeId(VertexId{2})))
    e = quads.onext(e);
  const auto at = [&](MaybeId<VertexId> v) { return mesh.points[*v]; };
  const auto arrow = [&](EdgeRef f, const std::string& name, draw::Colour colour, Vec2 shift) {
    diagram.add_arrow(at(quads.origin(f)), at(quads.destination(f)), {.colour = colour, .width = 2});
    const Point2 ends[]{at(quads.origin(f)), at(quads.destination(f))};
    diagram.words.push_back({centroid(ends), name, shift, colour});
  };
  arrow(e, "e", accent, {-1.7, -1.2});
  arrow(quads.lnext(e), "lnext", second, {0.2, -1.1});
  arrow(quads.lprev(e), "lprev", second, {-2.0, -0.3});
  const EdgeId edge = *edges.find(VertexId{0}, VertexId{2});
  diagram.add_arrow(centroid(corners(mesh, *edges.sides[edge][1])),
                    centroid(corners(mesh, *edges.sides[edge][0])),
                    {.colour = accent, .width = 1.4, .style = draw::LineStyle::dashed});
  diagram.words.push_back({centroid(corners(mesh, *edges.sides[edge][1])), "rot e", {1.6, -0.2}, accent});
  return diagram;
}

std::vector<Diagram> four_structures() {
  const TriangleMesh mesh = delaunay::triangulate(star()).mesh;
  return {finite_elements(mesh), edges_with_sides(mesh), out_degrees(mesh), quad_edges(mesh)};
}

std::vector<Diagram> forty_cells() {
  const std::vector<Point2> sites = random_sites(40, 3, 0.05);
  const auto diagram = delaunay::voronoi_diagram(sites);
  const auto window = delaunay::window_about(sites, 0.08);
  const auto cells = delaunay::clip(*diagram, window);
  Diagram picture;
  picture.region = draw::Box{window[0], window[2]};
  for (const VertexId site : diagram->sites.ids()) {
    const auto cell = cells.cell(site);
    picture.paths.push_back({{cell.begin(), cell.end()}, thin, true});
    picture.dots.push_back({diagram->sites[site]});
  }
  return {picture};
}

}  // namespace

std::vector<Figure> dual_figures() {
  return {{"1.2.0", "Several triangulation duals", three_duals, 3},
          {"1.3.0", "Data structures for planar graphs", four_structures, 2},
          {"3.1.0", "Voronoi diagram of 40 random sites", forty_cells}};
}

}  // namespace leonhard::notes
