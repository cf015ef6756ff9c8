// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/space/tet_scene.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "leonhard/mesh/draw/canvas/convex_scan.hpp"
#include "leonhard/mesh/draw/space/painters_order.hpp"
#include "tests/mesh/draw/kuhn_meshes.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

double seen_area(const Facet& facet) {
  double area = 0;
  const FacetCorner& o = facet.corners[0];
  for (std::size_t i = 2; i < facet.count; ++i) {
    const FacetCorner &a = facet.corners[i - 1], &b = facet.corners[i];
    area += ((a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x)) / 2;
  }
  return area;
}

double seen_area(const std::vector<Facet>& facets, FacetKind kind) {
  double sum = 0;
  for (const Facet& facet : facets) sum += facet.kind == kind ? seen_area(facet) : 0;
  return sum;
}

// The cube with all inner vertices moved a little.
TetMesh shaken_cube(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  const double side = static_cast<double>(n);
  return test::kuhn_mesh(
      {n, n, n}, [](Point3) { return true; },
      [&](Point3 p) {
        const auto shaken = [&](double c) { return c > 0 && c < side ? c + move(random) : c; };
        return Point3{shaken(p.x), shaken(p.y), shaken(p.z)};
      });
}

Point3 centre_of(const TetMesh& mesh, TetId t) {
  Vec3 sum;
  for (const VertexId v : mesh.corners[t]) sum = sum + 0.25 * (mesh.points[v] - Point3{});
  return Point3{} + sum;
}

// Nearness of a facet at a point of the page, or none outside: by triangles, with areas.
std::optional<double> nearness_at(const Facet& facet, Point2 p) {
  for (std::size_t i = 2; i < facet.count; ++i) {
    const std::array<FacetCorner, 3> c{facet.corners[0], facet.corners[i - 1], facet.corners[i]};
    std::array<double, 3> share{};
    double all = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const FacetCorner &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
      share[k] = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      all += share[k];
    }
    if (all == 0) continue;
    double sum = 0;
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      inside = inside && share[k] / all >= 0;
      sum += share[k] / all * c[k].nearness;
    }
    if (inside) return sum;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("the_camera_has_x_to_the_right_z_up_and_y_away_and_is_right_handed") {
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  const Camera front(box, {.azimuth_deg = -90, .elevation_deg = 0});
  const auto near = [](const Vec3& a, const Vec3& b) { return norm(a - b) < 1e-15; };
  CHECK(near(front.turn(Vec3{1, 0, 0}), {1, 0, 0}));
  CHECK(near(front.turn(Vec3{0, 1, 0}), {0, 0, -1}));
  CHECK(near(front.turn(Vec3{0, 0, 1}), {0, 1, 0}));
  for (const double azimuth : {-130.0, 0.0, 77.0}) {
    for (const double elevation : {-90.0, -20.0, 0.0, 45.0, 90.0}) {
      const Camera camera(box, {azimuth, elevation, 0});
      const Vec3 x = camera.turn(Vec3{1, 0, 0}), y = camera.turn(Vec3{0, 1, 0}),
                 z = camera.turn(Vec3{0, 0, 1});
      CHECK(norm(cross(x, y) - z) < 1e-14);
      CHECK(z.y >= -1e-15);  // z never points down
      CHECK(norm(camera.turn(towards_viewer({azimuth, elevation, 0})) - Vec3{0, 0, 1}) < 1e-14);
    }
  }
}

TEST_CASE("nearness_is_linear_along_lines_of_the_page_in_perspective_too") {
  const Camera camera({{0, 0, 0}, {1, 2, 3}}, {20, 30, 50});
  const Vec3 a = camera.turn(Point3{0, 0, 0}), b = camera.turn(Point3{1, 2, 3});
  const auto from = camera.see(a), to = camera.see(b);
  CHECK(from.nearness < to.nearness);  // 20 degrees from x, above: the far corner is the nearer one
  for (const double s : {0.2, 0.5, 0.9}) {
    const auto between = camera.see(a + s * (b - a));
    const double along = (between.x - from.x) / (to.x - from.x);
    CHECK(between.y == doctest::Approx(from.y + along * (to.y - from.y)));
    CHECK(between.nearness == doctest::Approx(from.nearness + along * (to.nearness - from.nearness)));
  }
}

TEST_CASE("the_cut_is_through_the_middle_across_the_axis_nearest_to_the_viewer_who_sees_its_face") {
  const Box3 box{{0, 0, 0}, {2, 4, 8}};
  CHECK(cut_through_middle(box, {}) == CutPlane{{0, 2, 0}, {0, -1, 0}});
  CHECK(cut_through_middle(box, {.azimuth_deg = 10, .elevation_deg = 0}) == CutPlane{{1, 0, 0}, {1, 0, 0}});
  CHECK(cut_through_middle(box, {.azimuth_deg = 10, .elevation_deg = 80}) == CutPlane{{0, 0, 4}, {0, 0, 1}});
  CHECK(cut_across(Axis3::z, 3, {.elevation_deg = -10}) == CutPlane{{0, 0, 3}, {0, 0, -1}});
}

TEST_CASE("a_crinkled_cut_shows_the_faces_between_kept_and_removed_and_the_kept_boundary") {
  const TetMesh mesh = shaken_cube(4, 7);
  const CutPlane plane{{2, 2, 2}, {1, -2, 0.5}};
  const View3 view{.azimuth_deg = -50, .elevation_deg = 30};
  const Camera camera(box_of(mesh), view);
  const auto facets = visible_facets(mesh, camera, CutStyle::crinkled, plane, {});
  // By brute force: all faces of kept tetrahedra, those met twice taken out.
  std::map<std::set<VertexId>, int> times;
  const auto is_kept = [&](TetId t) { return dot(centre_of(mesh, t) - plane.point, plane.normal) <= 0; };
  std::map<std::set<VertexId>, Vec3> outwards;
  for (const TetId t : mesh.corners.ids()) {
    if (!is_kept(t)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      std::set<VertexId> face(mesh.corners[t].begin(), mesh.corners[t].end());
      face.erase(mesh.corners[t][i]);
      const std::vector<VertexId> v(face.begin(), face.end());
      Vec3 normal = cross(mesh.points[v[1]] - mesh.points[v[0]], mesh.points[v[2]] - mesh.points[v[0]]);
      if (dot(normal, mesh.points[mesh.corners[t][i]] - mesh.points[v[0]]) > 0) normal = -normal;
      ++times[face];
      outwards[face] = normal;
    }
  }
  std::set<std::set<VertexId>> wanted, found;
  for (const auto& [face, count] : times) {
    if (count == 1 && dot(outwards[face], towards_viewer(view)) > 0) wanted.insert(face);
  }
  for (const Facet& facet : facets) {
    CHECK(is_kept(facet.tet));
    CHECK(facet.marker.has_value() == (facet.kind == FacetKind::boundary));
    std::set<VertexId> face;
    for (const CornerPlace& place : facet.places) face.insert(place.low);
    if (facet.count == 3) face = {facet.places[0].low, facet.places[1].low, facet.places[2].low};
    found.insert(face);
  }
  CHECK(found == wanted);
  CHECK(found.size() == facets.size());
}

TEST_CASE("sections_have_the_area_of_the_plane_in_the_mesh") {
  const View3 view{.azimuth_deg = -60, .elevation_deg = 25};
  for (const TetMesh& mesh : {test::unit_cube(2), test::unit_cube(3), shaken_cube(3, 3)}) {
    const Box3 box = box_of(mesh);
    const double side = box.high.x;
    const Camera camera(box, view);
    const Point3 middle{side / 2, side / 2, side / 2};
    // Lengths in the camera's units: the cube has side 2.
    const auto area = [&](const Vec3& normal) {
      return seen_area(visible_facets(mesh, camera, CutStyle::planar, {middle, normal}, {}),
                       FacetKind::section);
    };
    const auto foreshortening = [&](const Vec3& normal) {
      return dot(normal, towards_viewer(view)) / norm(normal);
    };
    const Vec3 across{0, -1, 0}, hexagon{1, -1, 1};
    CHECK(area(across) == doctest::Approx(4 * foreshortening(across)));
    CHECK(area(hexagon) == doctest::Approx(3 * std::sqrt(3.0) * foreshortening(hexagon)));
    CHECK(area(-across) == 0);  // its face is turned away
  }
}

TEST_CASE("a_planar_cut_trims_the_boundary_at_the_plane") {
  const TetMesh mesh = shaken_cube(3, 5);
  const Camera camera(box_of(mesh), {.azimuth_deg = -90, .elevation_deg = 90});  // from above
  const auto top = [&](const CutPlane& plane) {
    return seen_area(visible_facets(mesh, camera, CutStyle::planar, plane, {}), FacetKind::boundary);
  };
  CHECK(top({{10, 0, 0}, {1, 0, 0}}) == doctest::Approx(4));
  CHECK(top({{1, 0, 0}, {1, 0, 0}}) == doctest::Approx(4.0 / 3));
  CHECK(top({{1.5, 0, 0}, {1, 1, 0}}) == doctest::Approx(0.5));  // a triangle with legs of half the side
}

TEST_CASE("outlines_creases_and_borders_of_colours_are_strong_the_rest_is_thin") {
  const TetMesh mesh = test::unit_cube(2);
  const Camera camera(box_of(mesh), {.azimuth_deg = -60, .elevation_deg = 25});
  auto facets = visible_facets(mesh, camera, CutStyle::none, {}, {});
  const auto count = [&](FacetLine line) {
    std::size_t sum = 0;
    for (const Facet& f : facets) {
      for (std::size_t i = 0; i < f.count; ++i) sum += f.lines[i] == line ? 1 : 0;
    }
    return sum;
  };
  mark_lines(facets, true);
  // Three faces of the cube: their hexagon has 6 sides of 2 edges; 3 creases of 2 edges with 2 facets each.
  CHECK(count(FacetLine::outline) == 12);
  CHECK(count(FacetLine::strong) == 12);
  for (Facet& f : facets) f.colour = f.normal.y > 0.5 ? 1 : 0;
  facets[0].colour = 2;  // one facet of another colour: three edges more, from both sides
  mark_lines(facets, true);
  const std::size_t strong = count(FacetLine::strong) + count(FacetLine::outline);
  CHECK(strong > 24);
  mark_lines(facets, false);
  CHECK(count(FacetLine::strong) == 12);
}

TEST_CASE("samples_belong_to_exactly_one_of_the_polygons_around_them") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 40);
  for (int round = 0; round < 20; ++round) {
    // A square cut into four triangles at any point, some points on samples' centres.
    const Point2 middle = round % 2 == 0
                              ? Point2{place(random), place(random)}
                              : Point2{std::floor(place(random)) + 0.5, std::floor(place(random)) + 0.5};
    const std::array<Point2, 4> corner{{{0.5, 0.5}, {40.5, 0.5}, {40.5, 40.5}, {0.5, 40.5}}};
    std::vector<int> times(std::size_t{41} * 41, 0);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<Point2, 3> triangle{corner[i], corner[(i + 1) % 4], middle};
      scan_convex(triangle, 41, 41, [&](std::int64_t row, std::int64_t first, std::int64_t last) {
        for (std::int64_t k = first; k < last; ++k) ++times[static_cast<std::size_t>(row * 41 + k)];
      });
    }
    CHECK(std::count(times.begin(), times.end(), 1) == 1600);
    CHECK(std::count_if(times.begin(), times.end(), [](int n) { return n > 1; }) == 0);
  }
}

TEST_CASE("painting_in_the_painters_order_shows_the_nearest_facet_everywhere") {
  const TetMesh mesh = shaken_cube(6, 2);
  const Rect area{0, 0, 600, 600};
  for (const double field_of_view : {0.0, 40.0}) {
    const View3 view{.azimuth_deg = -50, .elevation_deg = 35, .field_of_view_deg = field_of_view};
    auto facets =
        visible_facets(mesh, Camera(box_of(mesh), view), CutStyle::crinkled, {{3, 3, 3}, {1, -1, 1}}, {});
    std::mt19937 random(4);
    std::shuffle(facets.begin(), facets.end(), random);
    place(facets, area);
    const auto order = painters_order(facets, area);
    CHECK(order.size() <= facets.size());
    CHECK(std::set<std::uint32_t>(order.begin(), order.end()).size() == order.size());
    std::uniform_real_distribution<double> across(0, 600);
    std::size_t hits = 0, wrong = 0, depths = 0;
    for (int k = 0; k < 2000; ++k) {
      const Point2 p{across(random), across(random)};
      std::optional<double> nearest, painted;
      for (const Facet& facet : facets) {
        const auto near = nearness_at(facet, p);
        if (near && nearest) ++depths;
        if (near && (!nearest || *near > *nearest)) nearest = near;
      }
      for (const std::uint32_t f : order) {
        if (const auto near = nearness_at(facets[f], p)) painted = near;
      }
      if (!nearest) continue;
      ++hits;
      if (!painted || std::abs(*painted - *nearest) > 1e-9) ++wrong;
    }
    CHECK(hits > 1000);
    CHECK(depths > 50);          // facets do hide others
    CHECK(wrong * 200 <= hits);  // what falls between samples
  }
}

TEST_CASE("a_point_seen_from_a_direction_is_turned_and_not_stretched") {
  const auto near = [](const Point3& p, const Point3& q) { return distance(p, q) < 1e-12; };
  CHECK(near(seen_from({.azimuth_deg = 0, .elevation_deg = 0}, {1, 2, 3}), {2, 3, 1}));     // from +x
  CHECK(near(seen_from({.azimuth_deg = -90, .elevation_deg = 0}, {1, 2, 3}), {1, 3, -2}));  // from -y
  CHECK(near(seen_from({.azimuth_deg = -90, .elevation_deg = 90}, {1, 2, 3}), {1, 2, 3}));  // from above
  const Point3 p{0.3, -1.2, 2.5}, q{-4, 0.5, 1};
  CHECK(distance(seen_from({}, p), seen_from({}, q)) == doctest::Approx(distance(p, q)));
}
