// SPDX-License-Identifier: MIT
// Figure 1.1.0: Euler's formula on a polyhedron and on its embedding in the plane.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "figures.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

/// A cube with one corner cut off: vertices by their places, faces by their corners, counter-clockwise from outside.
struct Polyhedron {
  std::vector<Point3> points{{0, 0, 0},    {1, 0, 0},    {1, 1, 0},   {0, 1, 0}, {0, 0, 1},
                             {0.45, 0, 1}, {1, 0, 0.55}, {1, 0.5, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<std::vector<std::size_t>> faces{{0, 3, 2, 1}, {4, 5, 7, 8, 9}, {0, 1, 6, 5, 4}, {1, 2, 8, 7, 6},
                                              {2, 3, 9, 8}, {3, 0, 4, 9},    {5, 6, 7}};
};

using Edge = std::array<std::size_t, 2>;  ///< the smaller end first

std::set<Edge> edges_of(const Polyhedron& body) {
  std::set<Edge> edges;
  for (const auto& face : body.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [low, high] = std::minmax(face[i], face[(i + 1) % face.size()]);
      edges.insert({low, high});
    }
  return edges;
}

std::string formula(std::size_t vertices, std::size_t edges, std::size_t faces) {
  return std::to_string(vertices) + " vertices - " + std::to_string(edges) + " edges + " + std::to_string(faces) +
         " faces = " + std::to_string(vertices + faces - edges);
}

/// The body as seen along one direction; which faces turn towards the viewer.
class View {
 public:
  [[nodiscard]] static Point2 project(Point3 p) {
    return {p.x * side_x + p.y * side_y, p.x * up_x + p.y * up_y + p.z * up_z};
  }
  [[nodiscard]] static bool sees(const Polyhedron& body, const std::vector<std::size_t>& face) {
    const Point2 a = project(body.points[face[0]]), b = project(body.points[face[1]]),
                 c = project(body.points[face[2]]);
    return cross(b - a, c - a) > 0;
  }

 private:
  // Orthographic, from the front, a little from the right and above.
  static constexpr double side_x = 0.89, side_y = 0.46, up_x = -0.17, up_y = 0.33, up_z = 0.93;
};

Diagram polyhedron(const Polyhedron& body) {
  Diagram diagram;
  diagram.title = "(a) In space: " + formula(body.points.size(), edges_of(body).size(), body.faces.size());
  std::set<Edge> seen;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const auto& face = body.faces[f];
    if (!View::sees(body, face)) continue;
    std::vector<Point2> outline;
    for (std::size_t i = 0; i < face.size(); ++i) {
      outline.push_back(View::project(body.points[face[i]]));
      const auto [low, high] = std::minmax(face[i], face[(i + 1) % face.size()]);
      seen.insert({low, high});
    }
    diagram.areas.push_back({outline, shade});
    diagram.words.push_back({centroid(outline), std::string(1, static_cast<char>('A' + f)), {}, second});
  }
  const draw::Stroke hidden{.colour = faint, .width = 1.4, .style = draw::LineStyle::dashed};
  for (const Edge& edge : edges_of(body))
    diagram.add_segment(View::project(body.points[edge[0]]), View::project(body.points[edge[1]]),
                        seen.contains(edge) ? draw::Stroke{.width = 1.8} : hidden);
  const Point2 middle = View::project({0.5, 0.5, 0.5});
  for (std::size_t v = 0; v < body.points.size(); ++v) {
    const Point2 at = View::project(body.points[v]);
    diagram.add_named_dot(at, std::to_string(v + 1), 0.9 / std::max(0.2, norm(at - middle)) * (at - middle));
  }
  return diagram;
}

/// The vertices in the plane after Tutte (Proceedings of the London Mathematical Society 13, 1963): the outer face on a
/// square, every other vertex at the mean of its neighbours.
std::vector<Point2> tutte_embedding(const Polyhedron& body) {
  std::vector<Point2> at(body.points.size());
  const std::array<Point2, 4> square{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}};
  std::copy(square.begin(), square.end(), at.begin());
  std::vector<std::vector<std::size_t>> neighbours(at.size());
  for (const auto& [a, b] : edges_of(body)) neighbours[a].push_back(b), neighbours[b].push_back(a);
  for (int sweep = 0; sweep < 500; ++sweep)
    for (std::size_t v = square.size(); v < at.size(); ++v) {
      std::vector<Point2> around;
      for (const std::size_t w : neighbours[v]) around.push_back(at[w]);
      at[v] = centroid(around);
    }
  return at;
}

/// The faces of a drawing without crossings, found from the drawing alone: from each directed edge on to the next one
/// clockwise about its head, until it closes.
std::vector<std::vector<std::size_t>> faces_of_drawing(const std::vector<Point2>& at, const std::set<Edge>& edges) {
  std::vector<std::vector<std::size_t>> around(at.size());
  for (const auto& [a, b] : edges) around[a].push_back(b), around[b].push_back(a);
  const auto angle = [&](std::size_t from, std::size_t to) {
    const Vec2 way = at[to] - at[from];
    return std::atan2(way.y, way.x);
  };
  for (std::size_t v = 0; v < at.size(); ++v)
    std::sort(around[v].begin(), around[v].end(),
              [&](std::size_t a, std::size_t b) { return angle(v, a) < angle(v, b); });
  std::set<Edge> open;  // directed
  for (const auto& [a, b] : edges) open.insert({a, b}), open.insert({b, a});
  std::vector<std::vector<std::size_t>> faces;
  while (!open.empty()) {
    std::vector<std::size_t> face;
    for (Edge side = *open.begin(); open.erase(side) > 0;) {
      face.push_back(side[0]);
      const auto& ring = around[side[1]];
      const auto back = std::find(ring.begin(), ring.end(), side[0]);
      side = {side[1], *(back == ring.begin() ? ring.end() - 1 : back - 1)};
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

Diagram embedding(const Polyhedron& body) {
  const std::vector<Point2> at = tutte_embedding(body);
  const std::set<Edge> edges = edges_of(body);
  const auto faces = faces_of_drawing(at, edges);
  Diagram diagram;
  diagram.title = "(b) In the plane, A outside: " + formula(at.size(), edges.size(), faces.size());
  diagram.region = draw::Box{{-0.3, -0.3}, {3.7, 3.3}};
  for (const auto& face : faces) {
    std::vector<std::size_t> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::find_if(body.faces.begin(), body.faces.end(), [&](std::vector<std::size_t> other) {
      std::sort(other.begin(), other.end());
      return other == sorted;
    });
    const std::string name(1, static_cast<char>('A' + (same - body.faces.begin())));
    std::vector<Point2> outline;
    for (const std::size_t v : face) outline.push_back(at[v]);
    const bool outside = same == body.faces.begin();
    diagram.words.push_back({outside ? Point2{3.4, 1.5} : centroid(outline), name, {}, second});
  }
  for (const auto& [a, b] : edges) diagram.add_segment(at[a], at[b], {.width = 1.8});
  for (std::size_t v = 0; v < at.size(); ++v) {
    const Vec2 out = at[v] - Point2{1.5, 1.5};
    diagram.add_named_dot(at[v], std::to_string(v + 1), 0.9 / std::max(0.3, norm(out)) * out);
  }
  return diagram;
}

std::vector<Diagram> body_and_embedding() {
  const Polyhedron body;
  return {polyhedron(body), embedding(body)};
}

}  // namespace

std::vector<Figure> polyhedron_figures() {
  return {{"1.1.0", "Euler's formula on a polyhedron and on its planar embedding", body_and_embedding, 2}};
}

}  // namespace leonhard::notes
