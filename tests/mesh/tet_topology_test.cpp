// SPDX-License-Identifier: MIT
#include "leonhard/mesh/topology.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

const std::vector<Point3> five_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
const std::vector<tet_shelf::Corners> two{{0, 1, 2, 3}, {1, 2, 3, 4}};

/// What make_tet_mesh says to these arrays; empty if it takes them.
std::string refusal(std::vector<Point3> points, const std::vector<tet_shelf::Corners>& tets,
                    std::vector<MarkedFace> faces, const mesh::MarkedFacetRules& rules = {}) {
  try {
    (void)mesh::make_tet_mesh(PerId<VertexId, Point3>(std::move(points)), tet_shelf::typed(tets),
                              std::move(faces), {}, "wing.su2", rules);
  } catch (const InputError& error) {
    CHECK(error.where() == "wing.su2");
    CHECK_FALSE(error.remedy().empty());
    return error.problem();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  CAPTURE(text);
  CAPTURE(part);
  const bool found = text.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

MarkedFace face(IdRaw a, IdRaw b, IdRaw c, Marker marker = 1) {
  return {{VertexId{a}, VertexId{b}, VertexId{c}}, marker};
}

}  // namespace

TEST_CASE("boundary_faces_are_those_of_one_tetrahedron_and_point_outwards") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    std::vector<tet_shelf::Corners> tets;
    for (const auto& [a, b, c, d] : entry.mesh.corners)
      tets.push_back({a.index(), b.index(), c.index(), d.index()});
    const auto expected = tet_shelf::lone_faces(tets, 7);  // sorted by smallest, then in their direction
    auto found = mesh::boundary_facets(entry.mesh, 7);
    CHECK(std::is_sorted(found.begin(), found.end(), [](const MarkedFace& f, const MarkedFace& g) {
      auto a = f.corners, b = g.corners;
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      return a < b;
    }));
    std::sort(found.begin(), found.end(),
              [](const MarkedFace& f, const MarkedFace& g) { return f.corners < g.corners; });
    CHECK(found == expected);
  }
}

TEST_CASE("marked_faces_given_inwards_are_turned_and_keep_order_and_marker") {
  const auto single = mesh::make_tet_mesh(
      PerId<VertexId, Point3>(std::vector<Point3>(five_points.begin(), five_points.begin() + 4)),
      tet_shelf::typed({{0, 1, 2, 3}}),
      {face(3, 1, 0, 7), face(1, 2, 3, 8), face(0, 1, 2, 9), face(0, 3, 2, 10)}, {{7, "lid"}});
  CHECK(single.boundary ==
        std::vector<MarkedFace>{face(3, 0, 1, 7), face(1, 2, 3, 8), face(0, 2, 1, 9), face(0, 3, 2, 10)});
  CHECK(single.marker_names.at(7) == "lid");
  CHECK(single.vertex_markers.size() == 4);
  CHECK(single.regions.size() == 1);
  CHECK_FALSE(mesh::validate(single));
}

TEST_CASE("unlisted_boundary_faces_follow_those_listed_with_the_marker_of_the_rule") {
  const auto mesh =
      mesh::make_tet_mesh(PerId<VertexId, Point3>(std::vector<Point3>(five_points)), tet_shelf::typed(two),
                          {face(4, 3, 2, 5), face(0, 1, 2, 6)}, {}, {}, {.unlisted_boundary = 9});
  CHECK(mesh.boundary == std::vector<MarkedFace>{face(4, 2, 3, 5), face(0, 2, 1, 6), face(0, 1, 3, 9),
                                                 face(0, 3, 2, 9), face(1, 2, 4, 9), face(1, 4, 3, 9)});
  CHECK_FALSE(mesh::validate(mesh));
  CHECK(contains(refusal(five_points, two, {face(4, 3, 2, 5)}), "has no marker"));
  CHECK(contains(refusal(five_points, two, {face(1, 2, 3, 5)}, {.unlisted_boundary = 9}),
                 "boundary entry 0, face 1-2-3"));
  CHECK(contains(refusal(five_points, two, {face(2, 3, 4, 5), face(4, 3, 2, 5)}, {.unlisted_boundary = 9}),
                 "there already as entry 0"));
}

TEST_CASE("faces_between_tetrahedra_become_interfaces_where_the_rule_takes_them") {
  auto faces = tet_shelf::lone_faces(two, 1);
  faces.insert(faces.begin() + 2, face(3, 1, 2, 4));
  const auto mesh =
      mesh::make_tet_mesh(PerId<VertexId, Point3>(std::vector<Point3>(five_points)), tet_shelf::typed(two),
                          faces, {}, {}, {.unlisted_boundary = {}, .take_inner_facets = true});
  CHECK(mesh.interfaces == std::vector<MarkedFace>{face(3, 1, 2, 4)});
  CHECK(mesh.boundary == tet_shelf::lone_faces(two, 1));
  CHECK_FALSE(mesh::validate(mesh));
  CHECK(contains(refusal(five_points, two, faces), "boundary entry 2, face 3-1-2"));
  faces.push_back(face(0, 1, 4, 4));
  CHECK(contains(refusal(five_points, two, faces, {.unlisted_boundary = {}, .take_inner_facets = true}),
                 "face 0-1-4"));
}

TEST_CASE("make_tet_mesh_refuses_bad_input_and_names_it") {
  const auto good = tet_shelf::lone_faces(two, 1);
  CHECK(refusal(five_points, two, good).empty());
  auto points = five_points;

  SUBCASE("a coordinate that is not a number") {
    points[2].z = std::numeric_limits<double>::quiet_NaN();
    contains(refusal(points, two, good), "vertex 2 at (0, 1, nan) has a coordinate that is no finite number");
  }
  SUBCASE("a corner out of range") {
    contains(refusal(points, {{0, 1, 2, 3}, {1, 2, 3, 9}}, good),
             "vertex 9 of tetrahedron 1 (vertices 1, 2, 3, 9 at (1, 0, 0), (0, 1, 0), (0, 0, 1), no such "
             "vertex) does "
             "not exist, there are 5 vertices");
  }
  SUBCASE("a corner named twice") {
    contains(refusal(points, {{0, 1, 2, 3}, {1, 2, 4, 2}}, good),
             "tetrahedron 1 (vertices 1, 2, 4, 2 at (1, 0, 0), (0, 1, 0), (1, 1, 1), (0, 1, 0)) has a vertex "
             "twice");
  }
  SUBCASE("a volume of zero, however thin the doubt") {
    points = {{0, 0, 0}, {1, 1, 0.1}, {0, 0.1, 1}, {0.5, 0.5, 0.05}};
    contains(refusal(points, {{0, 1, 2, 3}}, {}), "has volume zero");
    points[3].z = std::nextafter(0.05, 0.0);
    contains(refusal(points, {{0, 1, 2, 3}}, {}), "is turned over: its volume is negative");
    CHECK(refusal(points, {{0, 2, 1, 3}}, tet_shelf::lone_faces({{0, 2, 1, 3}}, 1)).empty());
  }
  SUBCASE("a vertex of no tetrahedron") {
    points.push_back({5, 6, 7});
    contains(refusal(points, two, good), "vertex 5 at (5, 6, 7) belongs to no tetrahedron");
  }
  SUBCASE("a face of three tetrahedra") {
    points.push_back({2, 2, 2});
    contains(
        refusal(points, {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}}, {}),
        "face 1-2-3 at (1, 0, 0), (0, 1, 0), (0, 0, 1) belongs to 3 tetrahedra, among them 0 and 1 and 2");
  }
  SUBCASE("two tetrahedra on one side of a face") {
    points[0] = {2, 2, 2};
    contains(refusal(points, {{1, 2, 3, 0}, {1, 2, 3, 4}}, {}),
             "tetrahedra 0 and 1 lie on the same side of face 1-2-3");
  }
  SUBCASE("a tetrahedron given twice") {
    const std::string text = refusal(points, {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 0, 3}}, {});
    contains(text, "tetrahedron 2");
    contains(text, "has the same vertices as tetrahedron 0");
  }
  SUBCASE("a boundary face without marker") {
    contains(refusal(points, two, {good.begin() + 1, good.end()}),
             "boundary face 0-1-3 at (0, 0, 0), (1, 0, 0), (0, 0, 1) of tetrahedron 0 has no marker");
  }
  SUBCASE("a boundary face marked twice, once from inside") {
    auto faces = good;
    faces.push_back({{good[1].corners[1], good[1].corners[0], good[1].corners[2]}, 3});
    contains(refusal(points, two, faces), "there already as entry 1");
  }
  SUBCASE("marked faces that are none of the mesh") {
    auto faces = good;
    faces.push_back(face(0, 1, 4, 3));
    contains(refusal(points, two, faces), "boundary entry 6, face 0-1-4");
    faces.back() = face(0, 1, 77, 3);
    contains(refusal(points, two, faces), "face 0-1-77 at (0, 0, 0), (1, 0, 0), no such vertex");
    faces.back() = face(1, 1, 3, 3);
    contains(refusal(points, two, faces), "is no boundary face of the mesh");
  }
}
