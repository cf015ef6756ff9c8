// SPDX-License-Identifier: MIT
// The figures of section 2: orientation, orderings, partitions and communication of a mesh's graph.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "figures.hpp"
#include "leonhard/delaunay/refine.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/communication.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/orientation.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/pattern.hpp"
#include "leonhard/mesh/edges.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

// ---- 2.1.0: orientation ----

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

// ---- 2.2.0 to 2.2.2: the mesh about an aerofoil of three elements, and its matrix ----

/// A closed curve of NACA's four-digit thickness, turned and moved, as a loop of segments with its hole.
void add_element(Pslg& pslg, Point2 nose, double chord, double angle_deg, double thickness) {
  constexpr int half = 24;
  const double angle = angle_deg * std::numbers::pi / 180;
  const std::size_t first = pslg.points.size();
  const auto place = [&](double x, double y) {
    return Point2{nose.x + chord * (x * std::cos(angle) - y * std::sin(angle)),
                  nose.y + chord * (x * std::sin(angle) + y * std::cos(angle))};
  };
  for (int i = 0; i < 2 * half; ++i) {
    const double x = 0.5 * (1 + std::cos(std::numbers::pi * i / half));
    const double t =
        5 * thickness *
        (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
    pslg.points.push_back(place(x, i <= half ? t : -t));
  }
  for (std::size_t i = first; i < pslg.points.size(); ++i)
    pslg.segments.push_back({i, i + 1 < pslg.points.size() ? i + 1 : first, 1});
  pslg.holes.push_back(place(0.4, 0));
}

TriangleMesh multi_component_mesh() {
  Pslg pslg;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    pslg.points.push_back({0.6 + 4 * std::cos(angle), 4 * std::sin(angle)});
    pslg.segments.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>((i + 1) % 40), 2});
  }
  add_element(pslg, {-0.21, -0.13}, 0.22, 30, 0.16);
  add_element(pslg, {0.03, -0.02}, 0.85, 0, 0.14);
  add_element(pslg, {0.86, -0.05}, 0.34, -32, 0.14);
  const auto size = [](Point2 p) { return 0.025 + 0.12 * std::max(0.0, distance(p, {0.45, -0.05}) - 0.6); };
  return delaunay::mesh_pslg(pslg, {.min_angle_deg = 28, .size = size}).mesh;
}

const TriangleMesh& flap_mesh() {
  static const TriangleMesh mesh = multi_component_mesh();
  return mesh;
}

graph::CsrGraph flap_graph() { return graph::vertex_graph(flap_mesh(), mesh::build_edges(flap_mesh())); }

const draw::View close_up{draw::Box{{-0.45, -0.65}, {1.55, 0.6}}};

void steiner_triangulation(const std::filesystem::path& file, const std::string& title) {
  draw::draw_mesh(file, flap_mesh(), {.view = close_up, .title = title, .legend = draw::LegendPlace::none});
}

void draw_matrix(const std::filesystem::path& file, const std::string& title,
                 const std::vector<std::uint32_t>& order, const std::string& name) {
  const graph::CsrGraph graph = flap_graph();
  std::vector<std::uint32_t> offsets{0}, links;
  for (std::uint32_t v = 0; v < graph::vertex_count(graph); ++v) {
    const auto row = graph::neighbours(graph, v);
    links.insert(links.end(), row.begin(), row.end());
    offsets.push_back(static_cast<std::uint32_t>(links.size()));
  }
  const graph::OrderingCost cost = graph::ordering_cost(graph, order);
  const draw::MatrixPattern pattern{
      .offsets = offsets,
      .links = links,
      .order = order,
      .title = name,
      .subtitle = std::to_string(order.size()) + " rows, bandwidth " + std::to_string(cost.bandwidth)};
  draw::draw_pattern(file, {&pattern, 1}, title, {1000, 1080});
}

void natural_matrix(const std::filesystem::path& file, const std::string& title) {
  draw_matrix(file, title, graph::natural_order(flap_graph()), "natural order");
}
void cuthill_mckee_matrix(const std::filesystem::path& file, const std::string& title) {
  draw_matrix(file, title, graph::cuthill_mckee(flap_graph()), "Cuthill-McKee");
}

// ---- 2.3: partitions and communication ----

std::vector<Point2> centroids(const TriangleMesh& mesh) {
  std::vector<Point2> points;
  for (const TriangleId t : mesh.corners.ids()) points.push_back(centroid(corners(mesh, t)));
  return points;
}

void draw_parts(const std::filesystem::path& file, const std::string& title, const graph::Partition& parts) {
  draw::draw_partition(file, flap_mesh(), parts.part_of, parts.parts, {.view = close_up, .title = title});
}
void coordinate_bisection(const std::filesystem::path& file, const std::string& title) {
  draw_parts(file, title, graph::recursive_coordinate_bisection(centroids(flap_mesh()), 16));
}
void spectral_partitioning(const std::filesystem::path& file, const std::string& title) {
  draw_parts(file, title, graph::recursive_spectral_bisection(graph::dual_graph(flap_mesh()), 16));
}

const std::array<draw::Colour, 4> part_colours{
    {{0.98, 0.90, 0.80}, {0.84, 0.92, 0.98}, {0.86, 0.95, 0.84}, {0.95, 0.86, 0.94}}};
const std::array<draw::Colour, 4> cycle_colours{{accent, second, {0.13, 0.55, 0.25}, {0.85, 0.55, 0.10}}};

/// A mesh in four parts, and who talks to whom in which cycle.
std::vector<Diagram> communication() {
  const TriangleMesh mesh = delaunay::triangulate(random_sites(70, 3, 0.085)).mesh;
  const graph::CsrGraph dual = graph::dual_graph(mesh);
  const graph::Partition parts = graph::recursive_spectral_bisection(dual, 4);
  Diagram left;
  left.title = "(a) A mesh in four parts";
  std::array<Point2, 4> middle{};
  std::array<double, 4> count{};
  for (const TriangleId t : mesh.corners.ids()) {
    const auto all = corners(mesh, t);
    const std::uint32_t part = parts.part_of[t.index()];
    left.areas.push_back({{all.begin(), all.end()}, part_colours[part]});
    middle[part] = middle[part] + (centroid(all) - Point2{0, 0});
    ++count[part];
  }
  left.add_mesh(mesh, {.colour = faint});
  for (const TriangleId t : mesh.corners.ids())
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto s = mesh.neighbours[t][i]; s && parts.part_of[t.index()] < parts.part_of[(*s).index()])
        left.add_segment(mesh.points[mesh.corners[t][(i + 1) % 3]], mesh.points[mesh.corners[t][(i + 2) % 3]],
                         {.colour = {0.1, 0.1, 0.1}, .width = 2.4});
  Diagram right;
  const graph::CommunicationSchedule schedule =
      graph::communication_schedule(graph::communication_graph(dual, parts));
  right.title = "(b) Communication graph: " + std::to_string(schedule.cycles.size()) + " cycles";
  right.region = draw::Box{{0, 0}, {1, 1}};
  for (std::size_t p = 0; p < 4; ++p) middle[p] = {middle[p].x / count[p], middle[p].y / count[p]};
  for (std::size_t cycle = 0; cycle < schedule.cycles.size(); ++cycle)
    for (const graph::Exchange& exchange : schedule.cycles[cycle]) {
      const Point2 a = middle[exchange.first], b = middle[exchange.second];
      right.add_segment(a, b, {.colour = cycle_colours[cycle % 4], .width = 3});
      right.words.push_back({a + 0.4 * (b - a),
                             "cycle " + std::to_string(cycle + 1) + ": " + std::to_string(exchange.forwards) +
                                 " / " + std::to_string(exchange.backwards),
                             {0, 0.7},
                             cycle_colours[cycle % 4]});
    }
  for (std::size_t p = 0; p < 4; ++p) {
    const std::string name = std::to_string(p + 1);
    left.words.push_back({middle[p], name, {0, 0}, accent});
    right.dots.push_back({middle[p], {0.1, 0.1, 0.1}, 3});
    right.words.push_back({middle[p], name, {1.1, -0.9}, accent});
  }
  return {left, right};
}

}  // namespace

std::vector<Figure> graph_figures() {
  return {
      {"2.1.0", "Orientation with out-degree 3 at most, by reducible boundary vertices", orientation, 5},
      {"2.2.0", "Steiner triangulation about a multi-component airfoil", nullptr, 1, steiner_triangulation},
      {"2.2.1", "Nonzero entries of the Laplacian, natural ordering", nullptr, 1, natural_matrix},
      {"2.2.2", "Nonzero entries of the Laplacian, Cuthill-McKee ordering", nullptr, 1, cuthill_mckee_matrix},
      {"2.3.0", "Four parts and their communication graph, edges coloured by cycles", communication, 2},
      {"2.3.2", "Coordinate bisection, 16 partitions", nullptr, 1, coordinate_bisection},
      {"2.3.4", "Spectral partitioning, 16 partitions", nullptr, 1, spectral_partitioning}};
}

}  // namespace leonhard::notes
