// SPDX-License-Identifier: MIT
// The figures of section 2.2: a mesh and the pattern of its Laplacian in two orders.
#include <string>

#include "figures.hpp"
#include "flap_mesh.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/pattern.hpp"
#include "leonhard/mesh/edges.hpp"

namespace leonhard::notes {
namespace {

graph::CsrGraph flap_graph() { return graph::vertex_graph(flap_mesh(), mesh::build_edges(flap_mesh())); }

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

}  // namespace

std::vector<Figure> ordering_figures() {
  return {
      {"2.2.0", "Steiner triangulation about a multi-component airfoil", nullptr, 1, steiner_triangulation},
      {"2.2.1", "Nonzero entries of the Laplacian, natural ordering", nullptr, 1, natural_matrix},
      {"2.2.2", "Nonzero entries of the Laplacian, Cuthill-McKee ordering", nullptr, 1,
       cuthill_mckee_matrix}};
}

}  // namespace leonhard::notes
