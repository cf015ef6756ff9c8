// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/communication_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <vector>

#include "leonhard/app/graphs/graph_picture.hpp"
#include "leonhard/app/graphs/part_places.hpp"
#include "leonhard/mesh/draw/diagram.hpp"

namespace leonhard::app {
namespace {

constexpr draw::Colour dark{0.1, 0.1, 0.1}, pale{0.70, 0.72, 0.76};
constexpr std::size_t most_lengths = 24, most_names = 100, most_legend = 16;

/// Eight colours, then the same dashed, then dotted.
draw::Stroke stroke_of_cycle(std::size_t cycle, double width) {
  constexpr std::array styles{draw::LineStyle::solid, draw::LineStyle::dashed, draw::LineStyle::dotted};
  return {draw::line_colour(cycle), width, styles[cycle / 8 % styles.size()]};
}

/// Triangles in their part's colour, the sides between parts dark.
draw::Diagram triangles_diagram(const TriangleMesh& mesh, const graph::CsrGraph& dual,
                                const graph::Partition& partition, const std::string& title) {
  draw::Diagram diagram;
  diagram.title = title;
  const std::vector<std::uint32_t> colour_of = colours_of_parts(dual, partition);
  const auto part_of = [&](TriangleId t) { return partition.part_of[t.index()]; };
  std::vector<draw::Diagram::Path> borders;
  for (const TriangleId t : mesh.corners.ids()) {
    draw::Diagram::Area area;
    for (const VertexId v : mesh.corners[t]) area.corners.push_back(mesh.points[v]);
    area.colour = draw::area_colour(colour_of[part_of(t)]);
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto across = mesh.neighbours[t][i]; across && part_of(t) < part_of(*across))
        borders.push_back({{area.corners[(i + 1) % 3], area.corners[(i + 2) % 3]}, {dark, 2}});
    diagram.areas.push_back(std::move(area));
  }
  diagram.add_mesh(mesh, {.colour = pale, .width = mesh.triangle_count() > 5000 ? 0.3 : 0.6});
  std::ranges::move(borders, std::back_inserter(diagram.paths));
  return diagram;
}

/// The communication graph, its parts at given places.
class ExchangesDiagram {
 public:
  ExchangesDiagram(const Communication& communication, std::vector<Point2> places)
      : communication_(communication), places_(std::move(places)) {}

  [[nodiscard]] draw::Diagram diagram(const std::string& title) const {
    draw::Diagram diagram;
    diagram.title = title;
    const auto& cycles = communication_.schedule.cycles;
    for (std::size_t c = 0; c < cycles.size(); ++c)
      for (const graph::Exchange& exchange : cycles[c]) add(diagram, exchange, c);
    for (std::size_t part = 0; part < places_.size(); ++part) {
      diagram.dots.push_back({places_[part], dark, few_parts() ? 2.6 : 1.2});
      if (few_parts())
        diagram.words.push_back({places_[part], std::to_string(part), outwards(places_[part]), dark});
    }
    if (cycles.size() <= most_legend) add_legend(diagram);
    return diagram;
  }

 private:
  [[nodiscard]] bool few_parts() const { return places_.size() <= most_names; }
  /// A text height and some, away from the middle of all parts.
  [[nodiscard]] Vec2 outwards(Point2 place) const {
    Vec2 sum{};
    for (const Point2 p : places_) sum = sum + (p - Point2{});
    const Vec2 from = (place - Point2{}) - 1 / static_cast<double>(places_.size()) * sum;
    return norm(from) == 0 ? Vec2{0.9, -0.7} : 1.15 / norm(from) * from;
  }
  [[nodiscard]] bool few_exchanges() const {
    return graph::edge_count(communication_.graph.graph) <= most_lengths;
  }

  void add(draw::Diagram& diagram, const graph::Exchange& exchange, std::size_t cycle) const {
    const Point2 a = places_[exchange.first], b = places_[exchange.second];
    const draw::Stroke stroke = stroke_of_cycle(cycle, few_parts() ? 2.6 : 1.2);
    diagram.add_segment(a, b, stroke);
    if (few_exchanges())
      diagram.words.push_back({.at = emptiest_place(diagram.words, a, b),
                               .words = fmt::format("{} / {}", exchange.forwards, exchange.backwards),
                               .colour = stroke.colour,
                               .on_white = true});
  }

  /// The place on a line, not near its ends, that is farthest from the words so far. These are wider than high, so that a
  /// distance across counts less.
  [[nodiscard]] static Point2 emptiest_place(std::span<const draw::Diagram::Words> words, Point2 a,
                                             Point2 b) {
    Point2 best = a + 0.5 * (b - a);
    double farthest = -1;
    for (const double share : {0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74}) {
      const Point2 place = a + share * (b - a);
      double nearest = std::numeric_limits<double>::max();
      for (const auto& other : words)
        nearest = std::min(nearest, std::hypot(0.3 * (place.x - other.at.x), place.y - other.at.y));
      if (nearest > farthest) farthest = nearest, best = place;
    }
    return best;
  }

  /// One line a cycle to the right of the graph: a piece of its line, its number and its longest message.
  void add_legend(draw::Diagram& diagram) const {
    Point2 low = places_.front(), high = low;
    for (const Point2 p : places_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    double side = std::max(high.x - low.x, high.y - low.y);
    if (side == 0) side = 1;
    const double x = high.x + 0.12 * side;
    const auto& cycles = communication_.schedule.cycles;
    for (std::size_t c = 0; c < cycles.size(); ++c) {
      const double y = high.y - 0.06 * side * static_cast<double>(c);
      std::uint64_t longest = 0;
      for (const graph::Exchange& exchange : cycles[c])
        longest = std::max({longest, exchange.forwards, exchange.backwards});
      diagram.add_segment({x, y}, {x + 0.08 * side, y}, stroke_of_cycle(c, 2.6));
      diagram.words.push_back({.at = {x + 0.1 * side, y},
                               .words = fmt::format("cycle {}, up to {}", c + 1, longest),
                               .colour = dark,
                               .across = 0});
    }
    if (!cycles.empty())
      diagram.region = draw::Box{low + -0.08 * side * Vec2{1, 1}, high + side * Vec2{0.66, 0.08}};
  }

  const Communication& communication_;
  std::vector<Point2> places_;
};

std::string exchanges_title(const Communication& communication) {
  return fmt::format("Communication graph, {} cycles", communication.cost.cycles);
}

}  // namespace

void draw_communication(const std::filesystem::path& path, const AnyGraph& input, GraphOf which,
                        const graph::Partition& partition, const Communication& communication,
                        const std::string& title) {
  const std::vector<Point3> places = places_on_page(input);
  if (places.empty()) {
    const ExchangesDiagram exchanges(communication, parts_in_a_circle(partition.parts));
    return draw::draw_diagram(path, exchanges.diagram(exchanges_title(communication)));
  }
  const std::string parts_title = fmt::format("{} parts", partition.parts);
  const TriangleMesh* triangles = which == GraphOf::cells ? input.triangles() : nullptr;
  const std::array panels{triangles ? triangles_diagram(*triangles, input.graph, partition, parts_title)
                                    : graph_diagram(input, places, partition, parts_title),
                          ExchangesDiagram(communication, places_of_parts(places, partition))
                              .diagram(exchanges_title(communication))};
  draw::draw_diagrams(path, panels, 2, title, {2000, 1000});
}

}  // namespace leonhard::app
