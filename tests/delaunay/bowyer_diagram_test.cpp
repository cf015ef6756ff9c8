// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/bowyer_diagram.hpp"

#include <doctest/doctest.h>

#include <set>

#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::BowyerDiagram;
using delaunay::VoronoiVertexId;

BowyerDiagram diagram_of_first(const std::vector<Point2>& sites, std::size_t count) {
  BowyerDiagram diagram(sites, VertexId{0}, VertexId{1}, VertexId{2});
  for (std::size_t i = 3; i < count; ++i) diagram.insert(VertexId::from(i));
  return diagram;
}

/// A triangle, counter-clockwise, and then sites inside and outside of it.
std::vector<Point2> sites() {
  std::vector<Point2> all{{0, 0}, {0.5, 0}, {0, 0.5}};
  for (const Point2 p : shapes::uniform(200)) all.push_back(p);
  return all;
}

TEST_CASE("a_diagram_of_three_sites_has_one_vertex_and_three_at_infinity") {
  const std::vector<Point2> three{{0, 0}, {4, 0}, {0, 2}};
  const BowyerDiagram diagram(three, VertexId{0}, VertexId{1}, VertexId{2});
  CHECK_FALSE(diagram.validate());
  REQUIRE(diagram.vertex_count() == 4);
  CHECK(diagram.place(VoronoiVertexId{0}).centre == Point2{2, 1});
  for (const VoronoiVertexId end : diagram.vertex(VoronoiVertexId{0}).neighbours)
    CHECK(diagram.is_at_infinity(end));
}

TEST_CASE("a_diagram_stays_whole_after_every_insertion") {
  const std::vector<Point2> all = sites();
  BowyerDiagram diagram(all, VertexId{0}, VertexId{1}, VertexId{2});
  for (std::size_t i = 3; i < all.size(); ++i) {
    const std::size_t before = diagram.vertex_count();
    CHECK(diagram.insert(VertexId::from(i)) >= 3);
    CHECK(diagram.vertex_count() == before + 2);
    REQUIRE_FALSE(diagram.validate());
    REQUIRE_FALSE(diagram.triangulation().validate());
  }
}

TEST_CASE("no_site_lies_closer_to_a_voronoi_vertex_than_those_that_form_it") {
  const std::vector<Point2> all = sites();
  const BowyerDiagram diagram = diagram_of_first(all, all.size());
  for (const VoronoiVertexId v : IdRange<VoronoiVertexId>(diagram.vertex_count())) {
    if (diagram.is_at_infinity(v)) continue;
    const kernel::Circle circle = diagram.place(v);
    const double error = circle.centre_error + circle.radius_error;
    for (const Point2 p : all) REQUIRE(distance(circle.centre, p) >= circle.radius - 2 * error);
  }
}

TEST_CASE("the_corners_of_a_territory_are_formed_by_its_site_and_come_round") {
  const std::vector<Point2> all = sites();
  const BowyerDiagram diagram = diagram_of_first(all, all.size());
  std::size_t corners = 0;
  for (const VertexId site : IdRange<VertexId>(all.size())) {
    const VoronoiVertexId first = diagram.a_corner_of(site);
    VoronoiVertexId corner = first;
    do {
      const auto& forming = diagram.vertex(corner).forming;
      REQUIRE(std::find(forming.begin(), forming.end(), site) != forming.end());
      ++corners;
      corner = diagram.next_corner(corner, site);
    } while (corner != first);
  }
  std::size_t at_infinity = 0;
  for (const VoronoiVertexId v : IdRange<VoronoiVertexId>(diagram.vertex_count()))
    at_infinity += diagram.is_at_infinity(v) ? 1 : 0;
  CHECK(corners == 3 * diagram.vertex_count() - at_infinity);
}

}  // namespace
}  // namespace leonhard
