// SPDX-License-Identifier: MIT
#include <algorithm>

#include "figures.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

/// Triangle ABC with its circumcircle and D beyond AC; the words are the predicate's.
std::vector<Diagram> incircle_test(Point2 d) {
  const Point2 a{0, 0}, b{1.1, -0.75}, c{1.7, 0.35};
  const kernel::Circle circle = kernel::circumcircle(a, b, c);
  Diagram diagram;
  const bool inside = kernel::incircle(a, b, c, d) == Sign::positive;
  diagram.title = inside ? "incircle(A, B, C, D) is true: AC is swapped for BD"
                         : "incircle(A, B, C, D) is false: AC stays";
  diagram.circles.push_back({circle.centre, circle.radius, light});
  diagram.paths.push_back({{a, b, c, d}, thin, true});
  diagram.add_segment(a, c, thin);
  if (inside) diagram.add_segment(b, d, dashed);
  diagram.add_named_dot(a, "A", {-0.9, 0});
  diagram.add_named_dot(b, "B", {0.3, -1.1});
  diagram.add_named_dot(c, "C", {1, 0.2});
  diagram.add_named_dot(d, "D", {0, 1}, inside ? accent : draw::Colour{0.1, 0.1, 0.1});
  const double room = 1.12 * circle.radius;
  diagram.region = draw::Box{circle.centre + Vec2{-room, -room}, circle.centre + Vec2{room, room}};
  diagram.region->high.y = std::max(diagram.region->high.y, d.y + 0.2);
  return {diagram};
}
std::vector<Diagram> incircle_true() { return incircle_test({0.6, 0.6}); }
std::vector<Diagram> incircle_false() { return incircle_test({0.75, 1.15}); }

/// Segment ab keeps d from seeing ac: the constrained triangulation has the triangle abc although its circle holds d.
std::vector<Diagram> hidden_site() {
  Pslg pslg;
  const Point2 a{0, 0}, b{2.2, 0.5}, c{1.0, 1.2}, d{1.3, -0.15};
  pslg.points = {a, b, c, d, {-0.6, 0.9}, {2.6, 1.3}, {0.4, -0.8}, {2.3, -0.6}};
  pslg.segments = {{0, 1, 1}};
  const TriangleMesh mesh = delaunay::triangulate(pslg, {.keep_convex_hull = true}).mesh;
  Diagram diagram = diagram_of(mesh);
  diagram.add_segment(a, b, {.colour = accent, .width = 3});
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& all = mesh.corners[t];
    const bool is_abc = std::count(all.begin(), all.end(), vertex_at(mesh, a)) +
                            std::count(all.begin(), all.end(), vertex_at(mesh, b)) +
                            std::count(all.begin(), all.end(), vertex_at(mesh, c)) ==
                        3;
    if (!is_abc) continue;
    const auto points = corners(mesh, t);
    diagram.areas.push_back({{points.begin(), points.end()}, shade});
    const kernel::Circle circle = kernel::circumcircle(points[0], points[1], points[2]);
    diagram.circles.push_back({circle.centre, circle.radius, light});
    if (kernel::incircle(points[0], points[1], points[2], d) == Sign::positive)
      diagram.title = "d lies in the circle of abc, hidden behind the constrained edge ab";
  }
  diagram.region = draw::Box{{-0.9, -1.35}, {2.9, 1.55}};
  diagram.words.push_back({a, "a", {-0.9, 0.2}});
  diagram.words.push_back({b, "b", {0.9, 0.5}});
  diagram.words.push_back({c, "c", {0, 1}});
  diagram.words.push_back({d, "d", {0.1, 1}});
  return {diagram};
}

Diagram containment(Point2 a, Point2 b, Point2 c, const std::string& title) {
  const kernel::Circle smallest = kernel::containment_circle(a, b, c),
                       through = kernel::circumcircle(a, b, c);
  Diagram diagram;
  diagram.title = title;
  diagram.paths.push_back({{a, b, c}, thin, true});
  diagram.circles.push_back(
      {through.centre, through.radius, {.colour = faint, .style = draw::LineStyle::dashed}});
  diagram.circles.push_back({smallest.centre, smallest.radius, strong});
  for (const Point2 p : {a, b, c}) diagram.dots.push_back({p});
  diagram.dots.push_back({smallest.centre, accent});
  const double top = std::max(through.centre.y + through.radius, smallest.centre.y + smallest.radius);
  const double bottom = std::min(through.centre.y - through.radius, smallest.centre.y - smallest.radius);
  const double half = 0.53 * (top - bottom), middle = 0.5 * (top + bottom);
  diagram.region =
      draw::Box{{through.centre.x - half, middle - half}, {through.centre.x + half, middle + half}};
  return diagram;
}
std::vector<Diagram> containment_circles() {
  return {containment({0, 0}, {2, 0.1}, {1.1, 1.7}, "Acute: the circumcircle"),
          containment({0, 0}, {2.4, 0}, {1.0, 0.7}, "Obtuse: circle on the longest edge")};
}

}  // namespace

std::vector<Figure> property_figures() {
  return {{"3.2.0", "Incircle test (true)", incircle_true},
          {"3.2.1", "Incircle test (false)", incircle_false},
          {"3.2.2", "Constrained Delaunay triangulation and visibility", hidden_site},
          {"3.2.3", "Containment circles of an acute and an obtuse triangle", containment_circles, 2}};
}

}  // namespace leonhard::notes
