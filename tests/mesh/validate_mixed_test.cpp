// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/mixed_invariants.hpp"
#include "leonhard/mesh/mixed_topology.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/mixed_shelf.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;
using mixed_shelf::Filling;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

/// What validate says of a mesh of the shelf after something was done to it.
template <int Dim>
std::string problem_of(MixedMesh<Dim> mesh, const std::function<void(MixedMesh<Dim>&)>& spoil) {
  spoil(mesh);
  return mesh::validate(mesh).value_or("");
}
std::string problem_of_box(const std::function<void(MixedMesh<3>&)>& spoil) {
  return problem_of<3>(mixed_shelf::box(2, 1, 1, Filling::hexahedron), spoil);
}
std::string problem_of_grid(const std::function<void(MixedMesh<2>&)>& spoil) {
  return problem_of<2>(mixed_shelf::plane_grid(2, 2, [](std::size_t i, std::size_t) { return i == 1; }),
                       spoil);
}

bool begins(const std::string& text, const std::string& with) {
  CAPTURE(text);
  CHECK(text.substr(0, with.size()) == with);
  return text.substr(0, with.size()) == with;
}

template <int Dim>
std::string refusal_of(const MixedMesh<Dim>& mesh, const mesh::MarkedFacetRules& rules = {}) {
  try {
    (void)mesh::make_mixed_mesh(mesh, "box", rules);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Two cubes, one above the other, of which the upper one is two prisms: their faces do not conform.
MixedMesh<3> cube_below_prisms() {
  const MixedMesh<3> cubes = mixed_shelf::box(1, 1, 2, Filling::hexahedron);
  return mixed_shelf::build<3>(cubes.points.flat(), {{CellKind::hexahedron, {0, 1, 3, 2, 4, 5, 7, 6}},
                                                     {CellKind::prism, {4, 5, 7, 8, 9, 11}},
                                                     {CellKind::prism, {4, 7, 6, 8, 11, 10}}});
}

}  // namespace

TEST_CASE_TEMPLATE("meshes_of_the_mixed_shelf_are_valid_and_so_if_shaken", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    CHECK(mesh::validate(entry.mesh).value_or("") == "");
    CHECK(mesh::validate(mixed_shelf::shaken(entry.mesh, 4)).value_or("") == "");
    CHECK(mesh::make_mixed_mesh(entry.mesh) == entry.mesh);
  }
}

TEST_CASE_TEMPLATE("simplices_are_valid_as_mixed_cells_where_they_are_on_their_own", Mesh, TriangleMesh,
                   TetMesh) {
  for (const auto& entry : shelves::all<Mesh>()) {
    CAPTURE(entry.name);
    CHECK(mesh::validate(mesh::mixed_mesh_of(entry.mesh)).value_or("") == "");
  }
}

TEST_CASE("every_broken_invariant_of_a_mesh_of_space_is_named_with_ids_and_places") {
  const auto far = std::numeric_limits<double>::quiet_NaN();
  CHECK(begins(problem_of_box([](auto& m) { m.regions.resize(5); }), "regions has 5 entries for 2 cells"));
  CHECK(begins(problem_of_box([](auto& m) { m.kinds[CellId{1}] = CellKind::triangle; }),
               "cell 1 is a triangle, which is no cell of space"));
  CHECK(begins(problem_of_box([&](auto& m) { m.points[VertexId{4}].y = far; }),
               "vertex 4 at (1, nan, 0) has a coordinate that is no finite number"));
  CHECK(begins(problem_of_box([](auto& m) { m.corners[1][2] = VertexId{1}; }),
               "hexahedron 1 (vertices 1, 2, 1, 4, 7, 8, 11, 10 at (1, 0, 0), (2, 0, 0), (1, 0, 0), "));
  CHECK(begins(problem_of_box([](auto& m) {
                 m.points.push_back({9, 9, 8.5});
                 m.vertex_markers.push_back(0);
               }),
               "vertex 12 at (9, 9, 8.5) belongs to no cell"));
  CHECK(begins(problem_of_box([](auto& m) { std::swap(m.boundary[1].corners[0], m.boundary[1].corners[2]); }),
               "boundary entry 1, face "));
  CHECK(begins(problem_of_box([](auto& m) { m.boundary.pop_back(); }), "boundary face "));
  CHECK(problem_of_box([](auto& m) { m.boundary.pop_back(); }).find(" of hexahedron 1 has no marker") !=
        std::string::npos);
  CHECK(problem_of_box([](auto& m) {
          m.boundary.push_back(m.boundary[2]);
        }).find(" is there already as entry 2") != std::string::npos);
  CHECK(begins(
      problem_of_box([](auto& m) {
        m.boundary.push_back({{VertexId{0}, VertexId{1}, VertexId{4}}, 8});
      }),
      "boundary entry 10, face 0-1-4 at (0, 0, 0), (1, 0, 0), (1, 1, 0), marker 8, is no face of a cell"));
  CHECK(begins(
      problem_of_box([](auto& m) {
        m.boundary.push_back({{VertexId{1}, VertexId{4}, VertexId{10}, VertexId{7}}, 8});
      }),
      "boundary entry 10, face 1-4-10-7 at (1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1), marker 8, is no "
      "boundary face: it lies between two cells"));
  CHECK(begins(problem_of_box([](auto& m) {
                 m.boundary.push_back({{VertexId{1}, VertexId{4}, VertexId{1}, VertexId{7}}, 8});
               }),
               "boundary entry 10, face 1-4-1-7 at "));
  CHECK(begins(problem_of_box([](auto& m) { m.inner_facets.push_back(m.boundary[0]); }),
               "inner_facets entry 0, face "));
  CHECK(problem_of_box([](auto& m) {
          m.inner_facets.push_back({{VertexId{7}, VertexId{1}, VertexId{4}, VertexId{10}}, 8});
        }).empty());
}

TEST_CASE("cells_of_space_that_are_turned_over_flat_or_tangled_are_named") {
  CHECK(
      begins(problem_of_box([](auto& m) {
               std::swap_ranges(m.corners[1].begin(), m.corners[1].begin() + 4, m.corners[1].begin() + 4);
             }),
             "hexahedron 1 (vertices 7, 8, 11, 10, 1, 2, 5, 4 at (1, 0, 1), (2, 0, 1), (2, 1, 1), (1, 1, 1), "
             "(1, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0)) is turned over: its volume is negative"));
  CHECK(problem_of_box([](auto& m) {
          m.points[VertexId{6}] = {0, 0, 0};
        }).find("is tangled: the tetrahedron of vertex 0 at (0, 0, 0) and its neighbours has volume zero") !=
        std::string::npos);
  CHECK(
      problem_of_box([](auto& m) {
        m.points[VertexId{6}] = {0, 0, -0.5};
      })
          .find(
              "is tangled: the tetrahedron of vertex 0 at (0, 0, 0) and its neighbours has negative volume, "
              "unlike most") != std::string::npos);
  // One ulp decides.
  const double below = std::nextafter(0.0, -1.0), above = std::nextafter(0.0, 1.0);
  CHECK(!problem_of_box([&](auto& m) { m.points[VertexId{6}].z = below; }).empty());
  CHECK(problem_of_box([&](auto& m) { m.points[VertexId{6}].z = above; }).empty());
  for (const CellKind kind :
       {CellKind::tetrahedron, CellKind::pyramid, CellKind::prism, CellKind::hexahedron}) {
    CAPTURE(shape_of(kind).name);
    const MixedMesh<3> cell = mixed_shelf::single(kind);
    const auto mirrored = [](MixedMesh<3>& m) {
      for (Point3& p : m.points) p.x = -p.x;
    };
    const auto flat = [](MixedMesh<3>& m) {
      for (Point3& p : m.points) p.z = 0;
    };
    CHECK(problem_of<3>(cell, mirrored).find("is turned over: its volume is negative") != std::string::npos);
    CHECK(problem_of<3>(cell, flat).find("volume zero") != std::string::npos);
    // Each corner in turn is drawn through the face of its neighbours, but the apex of a pyramid.
    const std::size_t corners = kind == CellKind::pyramid ? 4 : cell.vertex_count();
    for (std::size_t i = 0; i < corners; ++i) {
      const auto drawn_through = [&](MixedMesh<3>& m) {
        Vec3 middle;
        std::size_t others = 0;
        mesh::for_each_edge_of(m, CellId{0}, [&](VertexId a, VertexId b) {
          if (a.index() != i && b.index() != i) return;
          middle += m.points[a.index() == i ? b : a] - Point3{};
          ++others;
        });
        Point3& p = m.points[VertexId::from(i)];
        p = p + 1.25 * (Point3{} + middle / static_cast<double>(others) - p);
      };
      CAPTURE(i);
      CHECK(!problem_of<3>(cell, drawn_through).empty());
    }
  }
}

TEST_CASE("cells_of_space_that_do_not_conform_are_named") {
  CHECK(begins(
      mesh::validate(cube_below_prisms()).value_or(""),
      "face 4-5-7-6 at (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1) of hexahedron 0 meets face 4-7-5 at (0, "
      "0, 1), (1, 1, 1), (1, 0, 1) of prism 1, which has three of its vertices: the cells do not "
      "conform"));
  MixedMesh<3> twice = mixed_shelf::single(CellKind::prism);
  twice.add_cell(CellKind::prism, mixed_shelf::typed({0, 1, 2, 3, 4, 5}));
  CHECK(mesh::validate(twice).value_or("").find(" has the same vertices as prism 0") != std::string::npos);
  CHECK(problem_of_box([](auto& m) {
          m.points.push_back({0.5, 0.5, 3});
          m.vertex_markers.push_back(0);
          for (int i = 0; i < 2; ++i) m.add_cell(CellKind::pyramid, mixed_shelf::typed({6, 7, 10, 9, 12}));
        }).find("pyramid 3 (vertices 6, 7, 10, 9, 12 at ") == 0);
  CHECK(begins(problem_of_box([](auto& m) {
                 m.points.push_back({0.5, 0.5, 3});
                 m.points.push_back({0.5, 0.5, 4});
                 m.vertex_markers.resize(14, 0);
                 m.add_cell(CellKind::pyramid, mixed_shelf::typed({6, 7, 10, 9, 12}));
                 m.add_cell(CellKind::pyramid, mixed_shelf::typed({6, 7, 10, 9, 13}));
               }),
               "face 6-7-10-9 at (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1) belongs to 3 cells, among them "
               "hexahedron 0 and pyramid 2 and pyramid 3"));
  CHECK(begins(problem_of_box([](auto& m) {
                 m.points.push_back({0.5, 0.5, -3});
                 m.vertex_markers.push_back(0);
                 m.add_cell(CellKind::pyramid, mixed_shelf::typed({6, 9, 10, 7, 12}));
               }),
               "hexahedron 0 and pyramid 2 lie on the same side of face 6-7-10-9"));
}

TEST_CASE("every_triangle_within_a_face_and_every_other_order_of_it_does_not_conform") {
  const MixedMesh<3> cube = mixed_shelf::single(CellKind::hexahedron);
  const auto problem_beside = [&](CellKind kind, const mixed_shelf::Corners& corners) {
    MixedMesh<3> mesh = cube;
    for (int i = 0; i < 2; ++i) mesh.points.push_back({0.5, 0.5, 2.0 + i});
    mesh.add_cell(kind, mixed_shelf::typed(corners));
    return mesh::unconforming_face(mesh, mesh::MixedSides<3>(mesh)).value_or("");
  };
  for (const mixed_shelf::Corners& half : {mixed_shelf::Corners{4, 5, 6}, {5, 6, 7}, {6, 7, 4}, {7, 4, 5}}) {
    mixed_shelf::Corners tet = half;
    tet.push_back(8);
    CHECK(problem_beside(CellKind::tetrahedron, tet).find(" of tetrahedron 1, which has three of its") !=
          std::string::npos);
  }
  for (const mixed_shelf::Corners& other : {mixed_shelf::Corners{4, 6, 5, 7, 8}, {4, 5, 7, 6, 8}})
    CHECK(problem_beside(CellKind::pyramid, other)
              .find(" of pyramid 1, which has its vertices in another order") != std::string::npos);
  CHECK(problem_beside(CellKind::pyramid, {4, 5, 6, 7, 8}).empty());
  CHECK(problem_beside(CellKind::tetrahedron, {4, 5, 9, 8}).empty());
}

TEST_CASE("broken_meshes_of_the_plane_are_named") {
  CHECK(begins(
      problem_of_grid([](auto& m) { std::swap(m.corners[0][1], m.corners[0][3]); }),
      "quadrilateral 0 (vertices 0, 3, 4, 1 at (0, 0), (0, 1), (1, 1), (1, 0)) is clockwise: its area is "
      "negative"));
  CHECK(begins(
      problem_of_grid([](auto& m) {
        m.points[VertexId{0}] = {0.75, 0.75};
      }),
      "quadrilateral 0 (vertices 0, 1, 4, 3 at (0.75, 0.75), (1, 0), (1, 1), (0, 1)) is not convex: the "
      "triangle of vertex 0 at (0.75, 0.75) and its neighbours has negative area, unlike most"));
  CHECK(problem_of_grid([](auto& m) {
          m.points[VertexId{0}] = {0.5, 0.5};
        }).find("vertex 0 at (0.5, 0.5) and its neighbours has area zero") != std::string::npos);
  CHECK(problem_of_grid([](auto& m) { std::swap(m.corners[0][2], m.corners[0][3]); }).find("not convex") !=
        std::string::npos);
  CHECK(begins(problem_of_grid([](auto& m) { m.points[VertexId{2}] = m.points[VertexId{1}]; }),
               "triangle 1 (vertices 1, 2, 5 at (1, 0), (1, 0), (2, 1)) has area zero"));
  CHECK(begins(problem_of_grid([](auto& m) { m.boundary[0].corners = m.boundary[0].corners.reversed(); }),
               "boundary entry 0, edge 1-0 from (1, 0) to (0, 0), marker 1, has the mesh on its right"));
  CHECK(begins(problem_of_grid([](auto& m) {
                 m.boundary.push_back({{VertexId{3}, VertexId{1}}, 2});
               }),
               "boundary entry 8, edge 3-1 from (0, 1) to (1, 0), marker 2, is no edge of a cell"));
  CHECK(begins(
      problem_of_grid([](auto& m) {
        m.boundary.push_back({{VertexId{1}, VertexId{4}}, 2});
      }),
      "boundary entry 8, edge 1-4 from (1, 0) to (1, 1), marker 2, is no boundary edge: it lies between "
      "two cells"));
}

TEST_CASE("cells_of_the_plane_that_overlap_are_found_where_quadrilaterals_are_among_them") {
  MixedMesh<2> mesh = mixed_shelf::plane_grid(3, 1, [](std::size_t i, std::size_t) { return i == 2; });
  CHECK(!mesh::validate_embedding(mesh));
  // The strip rolled up until its ends overlap.
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = 2.25 * static_cast<double>(i);
    for (const auto& [row, radius] : {std::pair{0, 2.0}, {1, 1.0}})
      mesh.points.flat()[static_cast<std::size_t>(4 * row) + i] = {radius * std::cos(angle),
                                                                   radius * std::sin(angle)};
  }
  REQUIRE(!mesh::validate(mesh));
  const std::string problem = mesh::validate_embedding(mesh).value_or("");
  CHECK(problem.find("triangles are numbered after cells were cut into them") != std::string::npos);
}

TEST_CASE("cells_of_space_that_overlap_are_found") {
  CHECK(!mesh::validate_embedding(mixed_shelf::mixture()));
  // A row of cubes bent to a ring until its ends overlap.
  MixedMesh<3> mesh = mixed_shelf::box(5, 1, 1, Filling::hexahedron);
  for (Point3& p : mesh.points) {
    const double angle = 1.5 * p.x, radius = 2 - p.y;
    p = {radius * std::cos(angle), radius * std::sin(angle), p.z};
  }
  REQUIRE(!mesh::validate(mesh));
  CHECK(mesh::validate_embedding(mesh).value_or("").find("tetrahedra are numbered after cells were cut") !=
        std::string::npos);
  MixedMesh<3> bent = mixed_shelf::single(CellKind::hexahedron);
  bent.points[VertexId{6}] = {-0.1, -0.1, -0.1};
  CHECK(mesh::validate_embedding(bent).value_or("").find("nothing is proved: hexahedron 0 (vertices 0, 1") ==
        0);
}

TEST_CASE("a_mixed_mesh_is_made_of_listed_facets_in_either_direction") {
  const MixedMesh<3> mesh = mixed_shelf::mixture();
  MixedMesh<3> parts = mesh;
  for (std::size_t i = 0; i < parts.boundary.size(); i += 3)
    parts.boundary[i].corners = parts.boundary[i].corners.reversed();
  parts.vertex_markers.clear();
  parts.regions.clear();
  CHECK(mesh::make_mixed_mesh(parts) == mesh);
  CHECK(mesh::boundary_facets(mesh).size() == mesh.boundary.size());

  parts.boundary.resize(3);
  parts.boundary.push_back({{VertexId{1}, VertexId{4}, VertexId{13}, VertexId{10}}, 9});
  CHECK(refusal_of(parts).find("box: boundary entry 3, face 1-4-13-10 at ") == 0);
  CHECK(refusal_of(parts).find(
            " is no boundary face: it lies between two cells; every boundary face needs exactly ") !=
        std::string::npos);
  CHECK(refusal_of(parts, {.take_inner_facets = true}).find("has no marker") != std::string::npos);
  const MixedMesh<3> filled =
      mesh::make_mixed_mesh(parts, "", {.unlisted_boundary = 5, .take_inner_facets = true});
  CHECK(!mesh::validate(filled));
  CHECK(filled.inner_facets.size() == 1);
  CHECK(filled.boundary.size() == mesh.boundary.size());
  CHECK(filled.boundary.back().marker == 5);
  CHECK(refusal_of(cube_below_prisms()).find("put a pyramid between them") != std::string::npos);
}
