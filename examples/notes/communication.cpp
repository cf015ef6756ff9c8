// SPDX-License-Identifier: MIT
// The figures of section 2.3 on communication: who talks to whom, and what partitions make of it.
#include <array>
#include <string>

#include "figures.hpp"
#include "leonhard/delaunay/refine.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/communication.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

const std::array<draw::Colour, 4> part_colours{
    {{0.98, 0.90, 0.80}, {0.84, 0.92, 0.98}, {0.86, 0.95, 0.84}, {0.95, 0.86, 0.94}}};
const std::array<draw::Colour, 4> cycle_colours{{accent, second, {0.13, 0.55, 0.25}, {0.85, 0.55, 0.10}}};

using Middles = std::array<Point2, 4>;

Middles middles(const TriangleMesh& mesh, const graph::Partition& parts) {
  Middles middle{};
  std::array<double, 4> count{};
  for (const TriangleId t : mesh.corners.ids()) {
    const std::uint32_t part = parts.part_of[t.index()];
    middle[part] = middle[part] + (centroid(corners(mesh, t)) - Point2{0, 0});
    ++count[part];
  }
  for (std::size_t p = 0; p < 4; ++p) middle[p] = {middle[p].x / count[p], middle[p].y / count[p]};
  return middle;
}

/// Four parts of a mesh's triangles with their numbers, the separators dark.
Diagram parted_mesh(const TriangleMesh& mesh, const graph::Partition& parts, const std::string& title) {
  Diagram diagram;
  diagram.title = title;
  for (const TriangleId t : mesh.corners.ids()) {
    const auto all = corners(mesh, t);
    diagram.areas.push_back({{all.begin(), all.end()}, part_colours[parts.part_of[t.index()]]});
  }
  diagram.add_mesh(mesh, {.colour = faint});
  for (const TriangleId t : mesh.corners.ids())
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto s = mesh.neighbours[t][i]; s && parts.part_of[t.index()] < parts.part_of[(*s).index()])
        diagram.add_segment(mesh.points[mesh.corners[t][(i + 1) % 3]],
                            mesh.points[mesh.corners[t][(i + 2) % 3]],
                            {.colour = {0.1, 0.1, 0.1}, .width = 2.4});
  const Middles middle = middles(mesh, parts);
  for (std::size_t p = 0; p < 4; ++p)
    diagram.words.push_back({middle[p], std::to_string(p + 1), {0, 0}, accent});
  return diagram;
}

/// A mesh in four parts, and who talks to whom in which cycle.
std::vector<Diagram> communication() {
  const TriangleMesh mesh = delaunay::triangulate(random_sites(70, 3, 0.085)).mesh;
  const graph::CsrGraph dual = graph::dual_graph(mesh);
  const graph::Partition parts = graph::recursive_spectral_bisection(dual, 4);
  const graph::CommunicationSchedule schedule =
      graph::communication_schedule(graph::communication_graph(dual, parts));
  const Middles middle = middles(mesh, parts);
  Diagram right;
  right.title = "(b) Communication graph: " + std::to_string(schedule.cycles.size()) + " cycles";
  right.region = draw::Box{{0, 0}, {1, 1}};
  for (std::size_t cycle = 0; cycle < schedule.cycles.size(); ++cycle)
    for (const graph::Exchange& exchange : schedule.cycles[cycle]) {
      const Point2 a = middle[exchange.first], b = middle[exchange.second];
      right.add_segment(a, b, {.colour = cycle_colours[cycle % 4], .width = 3});
      right.words.push_back({a + 0.6 * (b - a),
                             "cycle " + std::to_string(cycle + 1) + ": " + std::to_string(exchange.forwards) +
                                 " / " + std::to_string(exchange.backwards),
                             {0, 0.7},
                             cycle_colours[cycle % 4]});
    }
  for (std::size_t p = 0; p < 4; ++p) {
    right.dots.push_back({middle[p], {0.1, 0.1, 0.1}, 3});
    right.words.push_back({middle[p], std::to_string(p + 1), {1.1, -0.9}, accent});
  }
  return {parted_mesh(mesh, parts, "(a) A mesh in four parts"), right};
}

/// A square with triangles of about one size.
TriangleMesh square_mesh() {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; i < 4; ++i) pslg.segments.push_back({i, (i + 1) % 4, 1});
  return delaunay::mesh_pslg(pslg, {.min_angle_deg = 30, .size = [](Point2) { return 0.055; }}).mesh;
}

/// Four parts side by side: none has more than two neighbours.
graph::Partition strips(const TriangleMesh& mesh) {
  std::vector<Point2> along;
  for (const TriangleId t : mesh.corners.ids()) along.push_back({centroid(corners(mesh, t)).x, 0});
  return graph::recursive_coordinate_bisection(along, 4);
}

std::string counts(const graph::CsrGraph& dual, const graph::Partition& parts) {
  const graph::CommunicationGraph communication = graph::communication_graph(dual, parts);
  std::uint64_t values = 0;
  std::uint32_t most = 0;
  for (const std::uint64_t length : communication.message) values += length;
  for (std::uint32_t p = 0; p < parts.parts; ++p)
    most = std::max(most, graph::degree(communication.graph, p));
  const std::uint64_t messages = communication.message.size(),
                      tenths = (10 * values + messages / 2) / messages;
  return std::to_string(most) + " neighbours at most, messages of " + std::to_string(tenths / 10) + "." +
         std::to_string(tenths % 10) + " on average";
}

/// Few messages, or short ones.
std::vector<Diagram> few_or_short() {
  const TriangleMesh mesh = square_mesh();
  const graph::CsrGraph dual = graph::dual_graph(mesh);
  const graph::Partition few = strips(mesh),
                         brief = graph::partition(dual, 4, {.effort = graph::Effort::high});
  return {parted_mesh(mesh, few, "(a) " + counts(dual, few)),
          parted_mesh(mesh, brief, "(b) " + counts(dual, brief))};
}

}  // namespace

std::vector<Figure> communication_figures() {
  return {
      {"2.3.0", "Four parts and their communication graph, edges coloured by cycles", communication, 2},
      {"2.3.1", "Partitions with the fewest neighbours, and with the shortest messages", few_or_short, 2}};
}

}  // namespace leonhard::notes
