// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/voronoi.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "leonhard/delaunay/voronoi_clip.hpp"
#include "leonhard/delaunay/voronoi_pieces.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/dirichlet_dual.hpp"
#include "tests/delaunay/shapes.hpp"

using namespace leonhard;
using namespace leonhard::delaunay;

namespace {

VoronoiDiagram diagram_of(const std::vector<Point2>& points) { return voronoi_diagram(points).value(); }

/// Sites whose hull edges begin or end there, by brute force over the triangulation's boundary.
std::set<VertexId> hull_sites(const std::vector<Point2>& points) {
  std::set<VertexId> hull;
  for (const MarkedEdge& edge : triangulate(points).mesh.boundary) hull.insert(edge.from);
  return hull;
}

/// By brute force, exactly.
std::size_t nearest(const VoronoiDiagram& diagram, Point2 p) {
  const auto& sites = diagram.sites.flat();
  return static_cast<std::size_t>(std::min_element(sites.begin(), sites.end(),
                                                   [&](Point2 a, Point2 b) {
                                                     return kernel::compare_distance(p, a, b) ==
                                                            Sign::negative;
                                                   }) -
                                  sites.begin());
}

double distance_to_segment(Point2 a, Point2 b, Point2 p) {
  const Vec2 side = b - a;
  const double length2 = dot(side, side);
  const double t = length2 > 0 ? std::clamp(dot(p - a, side) / length2, 0.0, 1.0) : 0;
  return distance(p, a + t * side);
}

/// How far a point lies outside a polygon, 0 inside; not misled by sides that are all rounding.
double outside_by(std::span<const Point2> polygon, Point2 p) {
  bool inside = false;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    least = std::min(least, distance_to_segment(a, b, p));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside ? 0 : least;
}

double sum(const PerId<VertexId, double>& areas) {
  double total = 0;
  for (const double area : areas) total += area;
  return total;
}

/// Sets whose window is neither lost in underflow nor in overflow.
std::vector<shapes::NamedPoints> families_to_measure() {
  auto all = shapes::families();
  std::erase_if(all, [](const auto& family) {
    return family.name == "subnormal" || family.name == "huge" || family.name == "offset 1e300";
  });
  all.push_back({"offset 2^30", shapes::transformed(shapes::uniform(60, 5), 8, 0x1p30)});
  all.push_back({"line of seven", {{0, 0}, {3, 6}, {1, 2}, {0.5, 1}, {2, 4}, {7, 14}, {-1, -2}}});
  all.push_back({"pair", {{0, 0}, {1, 3}}});
  all.push_back({"one", {{2, 3}, {2, 3}}});
  return all;
}

}  // namespace

TEST_CASE("a_cell_is_a_chain_of_edges_with_its_site_on_the_left") {
  for (const auto& [label, points] : shapes::families()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const VoronoiDiagram d = diagram_of(points);
    REQUIRE(d.first_edge.size() == d.sites.size() + 1);
    std::vector<int> seen(d.edges.size(), 0);
    for (const VertexId site : d.sites.ids()) {
      const auto cell = d.cell(site);
      for (std::size_t i = 0; i < cell.size(); ++i) {
        const VoronoiDiagram::Edge &edge = d.edges[cell[i]], &next = d.edges[cell[(i + 1) % cell.size()]];
        ++seen[cell[i].index()];
        const auto to = edge.ends[edge.sites[0] == site ? 1 : 0],
                   from = next.ends[next.sites[0] == site ? 0 : 1];
        CHECK(to == from);  // none and none where the cell is open to infinity
        CHECK(to.has_value() == !(d.is_unbounded(site) && i + 1 == cell.size()));
      }
    }
    CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 2; }));
  }
}

TEST_CASE("unbounded_cells_are_exactly_those_of_the_hull_sites") {
  for (const auto& [label, points] : shapes::families()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const VoronoiDiagram d = diagram_of(points);
    const std::set<VertexId> hull = hull_sites(points);
    for (const VertexId site : d.sites.ids()) CHECK(d.is_unbounded(site) == hull.contains(site));
  }
}

TEST_CASE("vertices_edges_and_cells_balance_and_vertices_are_as_far_from_their_sites_as_from_no_other") {
  for (const auto& [label, points] : families_to_measure()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const VoronoiDiagram d = diagram_of(points);
    std::size_t lines = 0;
    for (const auto& edge : d.edges) lines += edge.ends[0] || edge.ends[1] ? 0 : 1;
    // Euler's formula on the sphere, all that goes to infinity meeting there.
    if (lines == 0 && d.edges.size() > 0) CHECK(d.vertices.size() + 1 + d.sites.size() == d.edges.size() + 2);
    for (const VertexId site : d.sites.ids())
      for (const VoronoiVertexId v : d.cell_vertices(site)) {
        const double radius = distance(d.vertices[v].at, d.sites[site]);
        const double least =
            distance(d.vertices[v].at, d.sites[VertexId::from(nearest(d, d.vertices[v].at))]);
        const double scale = norm(d.vertices[v].at - Point2{}) + radius;
        CHECK(radius - least <= 4 * d.vertices[v].error + 1e-15 * scale);
      }
  }
}

TEST_CASE("every_point_of_a_window_lies_in_the_cell_of_its_nearest_site") {
  for (const auto& [label, points] : families_to_measure()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const VoronoiDiagram d = diagram_of(points);
    const auto window = window_about(points, 0.3);
    const ClippedVoronoi cells = clip(d, window);
    const double size = distance(window[0], window[2]) + 1e-3 * norm(window[0] - Point2{});
    for (const Point2 unit : shapes::uniform(200, 7)) {
      const Point2 p{window[0].x + unit.x * (window[1].x - window[0].x),
                     window[0].y + unit.y * (window[3].y - window[0].y)};
      CHECK(outside_by(cells.cell(VertexId::from(nearest(d, p))), p) <= 1e-12 * size);
    }
    for (const VertexId site : d.sites.ids())
      CHECK(outside_by(cells.cell(site), d.sites[site]) < 1e-12 * size);
  }
}

TEST_CASE("areas_of_clipped_cells_add_up_to_the_window") {
  const std::vector<Point2> pentagon{{-0.5, 0.1}, {0.3, -0.7}, {1.2, 0}, {1.1, 0.9}, {0.4, 1.6}};
  for (const auto& [label, points] : families_to_measure()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const VoronoiDiagram d = diagram_of(points);
    const auto window = window_about(points, 0.3);
    const double area = (window[1].x - window[0].x) * (window[3].y - window[0].y);
    double shoelace = 0;
    for (std::size_t i = 1; i + 1 < pentagon.size(); ++i)
      shoelace += 0.5 * cross(pentagon[i] - pentagon[0], pentagon[i + 1] - pentagon[0]);
    // Coordinates are rounded to 1e-7 there, and to 1e-10 of the pentagon's size.
    const double tolerance = name == "offset 2^30" ? 1e-6 : name == "clusters" ? 1e-8 : 1e-12;
    CHECK(sum(clip(d, window).area) == doctest::Approx(area).epsilon(tolerance).scale(0));
    CHECK(sum(clip(d, pentagon).area) == doctest::Approx(shoelace).epsilon(tolerance).scale(0));
  }
}

TEST_CASE("clipped_cells_share_their_corners_to_the_last_bit") {
  std::vector<std::pair<std::string, std::vector<Point2>>> sets{{"uniform", shapes::uniform(200, 3)}};
  std::vector<Point2> far;
  for (const Point2 p : shapes::uniform(50, 5)) far.push_back({p.x - 819831.1, p.y - 1007946.473});
  sets.emplace_back("far from the origin", far);
  sets.emplace_back("two sites 1e-13 apart", std::vector<Point2>{{-36.936336898963525, -9.508890876984978},
                                                                 {-36.7320806786612, -9.27520427373948},
                                                                 {-36.93633689896362, -9.508890876985053},
                                                                 {-36.9363441204872, -9.508896761408002},
                                                                 {-36.95085774213237, -9.34734748027729},
                                                                 {-36.92859286275029, -9.491951983474776},
                                                                 {-37.10160515698933, -9.242356362160889}});
  for (const auto& [label, points] : sets) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const VoronoiDiagram d = diagram_of(points);
    const auto window = window_about(points, 0.1);
    const ClippedVoronoi cells = clip(d, window);
    std::map<std::pair<Point2, Point2>, int>
        sides;  // a side inside the window has a cell in either direction
    double area = 0;
    for (const VertexId site : d.sites.ids()) {
      const auto cell = cells.cell(site);
      for (std::size_t i = 0; i < cell.size(); ++i)
        ++sides[{cell[i], cell[i + 1 == cell.size() ? 0 : i + 1]}];
      area += cells.area[site];
    }
    std::size_t alone = 0;
    for (const auto& [side, count] : sides) {
      CHECK(count == 1);
      const bool on_window = std::any_of(window.begin(), window.end(), [&, s = side](const Point2 corner) {
        return (s.first.x == corner.x && s.second.x == corner.x) ||
               (s.first.y == corner.y && s.second.y == corner.y);
      });
      if (!on_window && !sides.contains({side.second, side.first})) ++alone;
    }
    CHECK(alone == 0);
    const double of_window = (window[1].x - window[0].x) * (window[3].y - window[0].y);
    CHECK(area == doctest::Approx(of_window).epsilon(1e-12).scale(0));
  }
}

TEST_CASE("cells_cut_to_a_polygon_that_is_not_convex_cover_it_and_share_their_corners") {
  std::vector<Point2> star, comb{{0.05, 0.05}, {0.95, 0.05}};
  for (int i = 0; i < 16; ++i) {
    const double angle = 0.1 + 0.125 * 3.14159 * i, radius = i % 2 == 0 ? 0.48 : 0.1;
    star.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
  }
  for (int i = 8; i >= 0; --i) comb.push_back({0.05 + 0.1125 * i, i % 2 == 0 ? 0.95 : 0.08});
  const std::vector<Point2> ell{{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}};
  std::vector<Point2> clockwise(ell.rbegin(), ell.rend());
  for (const std::vector<Point2>& polygon : {star, comb, ell, clockwise}) {
    for (const std::vector<Point2>& points :
         {shapes::uniform(300, 3), shapes::grid(9), std::vector<Point2>{{0.4, 0.4}}}) {
      std::vector<Point2> sites = points;
      if (points.size() == 81)
        for (Point2& p : sites) p = {p.x / 8, p.y / 8};
      const VoronoiDiagram d = diagram_of(sites);
      const VoronoiPieces pieces = clip_to_polygon(d, polygon);
      double sum = 0, of_polygon = 0;
      for (const double area : pieces.area) sum += area;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        of_polygon += (a.x * b.y - a.y * b.x) / 2;
      }
      CHECK(sum == doctest::Approx(std::abs(of_polygon)).epsilon(1e-13).scale(0));
      // A side has a cell on its other side, or lies on the polygon's boundary.
      std::set<std::pair<Point2, Point2>> sides;
      for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t k = 0; k < pieces.piece(i).size(); ++k)
          CHECK(sides.insert({pieces.piece(i)[k], pieces.piece(i)[(k + 1) % pieces.piece(i).size()]}).second);
      for (const auto& [from, to] : sides) {
        if (sides.contains({to, from})) continue;
        double least = 1;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
          least = std::min(least, std::max(distance_to_segment(a, b, from), distance_to_segment(a, b, to)));
        }
        CHECK(least < 1e-15);
      }
      // Points of the polygon lie in a piece of the nearest site.
      std::vector<std::vector<std::size_t>> of_site(d.sites.size());
      for (std::size_t i = 0; i < pieces.size(); ++i) of_site[pieces.site[i].index()].push_back(i);
      for (const Point2 p : shapes::uniform(200, 11)) {
        const double beyond = outside_by(polygon, p);
        double least = 1;
        for (const std::size_t i : of_site[nearest(d, p)])
          least = std::min(least, outside_by(pieces.piece(i), p));
        CHECK((beyond == 0 ? least < 1e-14 : least > 0));
      }
    }
  }
}

TEST_CASE("polygons_that_cut_nothing_out_are_refused") {
  const VoronoiDiagram d = diagram_of(shapes::uniform(20, 3));
  for (const std::vector<Point2>& polygon : {std::vector<Point2>{{0, 0}, {1, 0}},
                                             {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
                                             {{0, 0}, {1, 0}, {2, 0}},
                                             {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {0, 1}},
                                             {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}},
                                             {{0, 0}, {1, 0}, {NAN, 1}}})
    CHECK_THROWS_AS((void)clip_to_polygon(d, polygon), InputError);
}

TEST_CASE("cells_of_a_grid_are_exact_squares_with_four_edges_at_each_vertex") {
  const std::vector<Point2> points = shapes::grid(9);
  const VoronoiDiagram d = diagram_of(points);
  CHECK(d.vertices.size() == 64);
  CHECK(d.edges.size() == 2 * 9 * 8);
  const ClippedVoronoi cells = clip(d, box_window({-0.5, -0.5}, {8.5, 8.5}));
  for (const VertexId site : d.sites.ids()) {
    CHECK(cells.area[site] == 1.0);
    std::set<std::pair<double, double>> corners;
    for (const Point2 p : cells.cell(site)) corners.insert({p.x - d.sites[site].x, p.y - d.sites[site].y});
    CHECK(corners == std::set<std::pair<double, double>>{{-0.5, -0.5}, {-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}});
    CHECK(cells.cell(site).size() == 4);
  }
}

TEST_CASE("cocircular_sites_share_one_vertex") {
  const VoronoiDiagram square = diagram_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(square.vertices.size() == 1);
  CHECK(square.vertices[VoronoiVertexId{0}].at == Point2{1, 1});
  CHECK(square.edges.size() == 4);
  const std::vector<Point2> circle = shapes::cocircular();
  const VoronoiDiagram ring = diagram_of(std::vector<Point2>(circle.begin() + 1, circle.end()));
  CHECK(ring.vertices.size() == 1);
  CHECK(ring.vertices[VoronoiVertexId{0}].at == Point2{0, 0});
}

TEST_CASE("one_site_two_and_collinear_ones_have_a_diagram") {
  CHECK(diagram_of({}).sites.empty());
  const VoronoiDiagram one = diagram_of({{2, 3}, {2, 3}});
  CHECK(one.edges.empty());
  CHECK(one.is_unbounded(VertexId{0}));
  CHECK(one.site_of_input == std::vector<VertexId>{VertexId{0}, VertexId{0}});
  const auto window = box_window({0, 0}, {4, 4});
  CHECK(clip(one, window).area[VertexId{0}] == 16.0);

  const VoronoiDiagram two = diagram_of({{3, 1}, {1, 1}});
  REQUIRE(two.edges.size() == 1);
  CHECK(two.anchor(VoronoiEdgeId{0}) == Point2{2, 1});
  CHECK(two.direction(VoronoiEdgeId{0}) == Vec2{0, 1});
  CHECK(two.edges[VoronoiEdgeId{0}].sites ==
        std::array{VertexId{1}, VertexId{0}});  // the left one to the left

  const VoronoiDiagram three = diagram_of({{3, 0}, {1, 0}, {2, 0}, {1, 0}});
  CHECK(three.edges.size() == 2);
  CHECK(three.cell(VertexId{2}).size() == 2);
  CHECK(three.site_of_input.back() == VertexId{1});
  const ClippedVoronoi strips = clip(three, window);
  CHECK(strips.area[VertexId{0}] == 6.0);
  CHECK(strips.area[VertexId{1}] == 6.0);
  CHECK(strips.area[VertexId{2}] == 4.0);
}

TEST_CASE("rays_leave_the_hull_at_right_angles") {
  const VoronoiDiagram d = diagram_of({{0, 0}, {4, 0}, {0, 4}});
  REQUIRE(d.edges.size() == 3);
  for (const VoronoiEdgeId e : d.edges.ids()) {
    const auto& [sites, ends] = d.edges[e];
    const Vec2 side = d.sites[sites[1]] - d.sites[sites[0]];
    CHECK(std::abs(dot(d.direction(e), side)) < 1e-15);
    CHECK(cross(side, d.direction(e)) > 0);
    CHECK(d.anchor(e) == Point2{2, 2});
    CHECK(ends[0].has_value() != ends[1].has_value());
  }
}

TEST_CASE("coordinates_at_the_ends_of_the_range_neither_crash_nor_lose_cells") {
  const double huge = std::numeric_limits<double>::max();
  const std::vector<std::vector<Point2>> sets{
      shapes::transformed(shapes::grid(8), 5e-324, 0),
      shapes::transformed(shapes::uniform(80, 4), 1.7e308, 0),
      {{-huge, -huge}, {huge, -huge}, {huge, huge}, {-huge, huge}, {0, 0}, {5e-324, 0}},
      {{-1e300, 0}, {0, 1e-300}, {1e300, 0}, {0, -5e-324}}};
  for (const auto& points : sets) {
    const VoronoiDiagram d = diagram_of(points);
    for (const auto& vertex : d.vertices) CHECK(is_finite(vertex.at));
    for (const VoronoiEdgeId e : d.edges.ids()) CHECK(norm(d.direction(e)) == doctest::Approx(1));
    const ClippedVoronoi cells = clip(d, window_about(points));
    for (const Point2 corner : cells.corners) CHECK(is_finite(corner));
    std::size_t shown = 0;
    for (const VertexId site : d.sites.ids()) shown += cells.cell(site).empty() ? 0 : 1;
    CHECK(shown + 1 >= d.sites.size());  // 5e-324 beside the largest double may vanish
  }
}

TEST_CASE("a_mesh_that_is_no_delaunay_triangulation_of_its_hull_is_refused") {
  Pslg ring = shapes::nested();
  ring.holes = {{26, 26}};
  CHECK_THROWS_AS((void)voronoi_diagram(triangulate(ring).mesh), InputError);
  Pslg notch;
  shapes::add_loop(notch, {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  CHECK_THROWS_AS((void)voronoi_diagram(triangulate(notch).mesh), InputError);
  Pslg forced;  // the long diagonal of a kite
  forced.points = {{0, 0}, {5, -1}, {10, 0}, {5, 1}};
  forced.segments = {{0, 2, 1}};
  CHECK_THROWS_AS((void)voronoi_diagram(triangulate(forced, {.keep_convex_hull = true}).mesh), InputError);
  CHECK_NOTHROW((void)voronoi_diagram(triangulate(shapes::grid(4)).mesh));
}

TEST_CASE(
    "the_dirichlet_dual_is_the_clipped_voronoi_diagram_where_no_circumcentre_lies_beyond_the_boundary") {
  std::vector<Point2> points;
  for (int i = 0; i < 16; ++i) {  // half a unit apart on the square's sides
    const double t = 0.5 * i;
    points.insert(points.end(), {{t, 0}, {8, t}, {8 - t, 8}, {0, 8 - t}});
  }
  for (const Point2 p : shapes::uniform(90, 11)) points.push_back({0.5 + 7 * p.x, 0.5 + 7 * p.y});
  const TriangleMesh mesh = triangulate(points).mesh;
  const DirichletDual dual = mesh::dirichlet_dual(mesh, mesh::build_edges(mesh));
  CHECK(dual.beyond.empty());
  const ClippedVoronoi cells = clip(voronoi_diagram(mesh), box_window({0, 0}, {8, 8}));
  for (const VertexId v : mesh.points.ids())
    CHECK(dual.volume[v] == doctest::Approx(cells.area[v]).epsilon(1e-12).scale(0));
}

TEST_CASE("bad_windows_are_refused") {
  const VoronoiDiagram d = diagram_of(shapes::grid(3));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Window = std::vector<Point2>;
  for (const Window& window :
       {Window{{0, 0}, {1, 0}}, Window{{0, 0}, {0, 1}, {1, 0}}, Window{{0, 0}, {1, 1}, {2, 2}},
        Window{{0, 0}, {2, 0}, {1, 0.5}, {2, 2}}, Window{{0, 0}, {1, 0}, {nan, 1}},
        Window{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}}})  // a pentagram
    CHECK_THROWS_AS((void)clip(d, window), InputError);
  CHECK_THROWS_AS((void)box_window({0, 0}, {0, 1}), InputError);
  CHECK_THROWS_AS((void)box_window({0, 0}, {1, nan}), InputError);
}

TEST_CASE("a_stop_request_leaves_no_diagram") {
  std::stop_source stop;
  stop.request_stop();
  TriangulateOptions options;
  options.progress.stop = stop.get_token();
  CHECK_FALSE(voronoi_diagram(shapes::uniform(20'000), options).has_value());
}
