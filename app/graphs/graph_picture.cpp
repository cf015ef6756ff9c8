// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/graph_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/communication.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/colour.hpp"

namespace leonhard::app {
namespace {

constexpr draw::Colour cut_colour{0.08, 0.08, 0.10};
constexpr std::size_t most_dots = 2000;

/// Lines thinner the more of them share the page.
double line_width(std::size_t edges) {
  constexpr double page = 1100;  // pixels, about the side of a square of the picture's area
  return std::clamp(page / std::sqrt(static_cast<double>(edges) / 3 + 1) / 14, 0.2, 1.6);
}

class GraphPicture {
 public:
  GraphPicture(const AnyGraph& input, const std::vector<Point3>& places, const graph::Partition& partition)
      : graph_(input.graph),
        part_of_(partition.part_of),
        places_(places),
        is_of_space_(input.dimension == 3),
        width_(line_width(graph::edge_count(input.graph))),
        colour_of_(colours_of_parts(input.graph, partition)) {}

  [[nodiscard]] draw::Diagram diagram(const std::string& title) const {
    draw::Diagram diagram;
    diagram.title = title;
    add_edges(diagram);
    add_dots(diagram);
    return diagram;
  }

 private:
  using Edge = std::array<std::uint32_t, 2>;

  [[nodiscard]] bool is_cut(const Edge& edge) const { return part_of_[edge[0]] != part_of_[edge[1]]; }
  [[nodiscard]] draw::Colour colour(std::uint32_t vertex) const {
    return draw::line_colour(colour_of_[part_of_[vertex]]);
  }
  [[nodiscard]] Point2 at(std::uint32_t vertex) const { return {places_[vertex].x, places_[vertex].y}; }

  /// In space the far ones first; in the plane the cut ones last.
  void add_edges(draw::Diagram& diagram) const {
    std::vector<Edge> edges = graph::edges_of(graph_);
    const auto rank = [&](const Edge& edge) {
      return is_of_space_ ? places_[edge[0]].z / 2 + places_[edge[1]].z / 2 : is_cut(edge) ? 1.0 : 0.0;
    };
    std::ranges::stable_sort(edges, {}, rank);
    for (const Edge& edge : edges) {
      if (is_cut(edge))
        diagram.add_segment(at(edge[0]), at(edge[1]), {.colour = cut_colour, .width = 1.5 * width_});
      else
        diagram.add_segment(at(edge[0]), at(edge[1]), {.colour = colour(edge[0]), .width = width_});
    }
  }

  /// Of a large graph only the vertices without an edge, which would not be seen otherwise.
  void add_dots(draw::Diagram& diagram) const {
    const bool all = places_.size() <= most_dots;
    const double size = std::clamp(width_, 0.5, 1.4);
    for (std::uint32_t v = 0; v < places_.size(); ++v)
      if (all || graph::degree(graph_, v) == 0) diagram.dots.push_back({at(v), colour(v), size});
  }

  const graph::CsrGraph& graph_;
  const std::vector<std::uint32_t>& part_of_;
  const std::vector<Point3>& places_;
  bool is_of_space_;
  double width_;
  std::vector<std::uint32_t> colour_of_;  ///< one a part
};

}  // namespace

std::vector<Point3> places_on_page(const AnyGraph& input, const draw::View3& view) {
  std::vector<Point3> places = input.coordinates;
  if (input.dimension == 3)
    for (Point3& p : places) p = draw::seen_from(view, p);
  return places;
}

std::vector<std::uint32_t> colours_of_parts(const graph::CsrGraph& graph, const graph::Partition& partition) {
  return graph::colour_vertices(graph::communication_graph(graph, partition).graph).colour_of;
}

draw::Diagram graph_diagram(const AnyGraph& input, const std::vector<Point3>& places,
                            const graph::Partition& partition, const std::string& title) {
  return GraphPicture(input, places, partition).diagram(title);
}

void check_drawable(const AnyGraph& input, const std::string& source) {
  if (!input.coordinates.empty()) return;
  const std::string beside = std::filesystem::path(source).replace_extension(".xyz").string();
  throw InputError(source, "its vertices have no coordinates to draw them at",
                   "put them into " + beside + ", two or three numbers a line, or write .txt");
}

}  // namespace leonhard::app
