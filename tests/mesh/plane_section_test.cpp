// SPDX-License-Identifier: MIT
#include "leonhard/mesh/plane_section.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

constexpr SpaceAxis axes[] = {SpaceAxis::x, SpaceAxis::y, SpaceAxis::z};

double area_of(const TriangleMesh& mesh) {
  double doubled = 0;
  for (const auto& [a, b, c] : mesh.corners)
    doubled += cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  return doubled / 2;
}

/// A value that is linear over all of space, and what it is on a section.
double linear(const Point3& p) { return 2 + 3 * p.x - 5 * p.y + 7 * p.z; }
Point3 lifted(Point2 p, SpaceAxis axis, double position) {
  if (axis == SpaceAxis::x) return {position, p.x, p.y};
  return axis == SpaceAxis::y ? Point3{p.x, position, p.y} : Point3{p.x, p.y, position};
}

}  // namespace

TEST_CASE("a_section_covers_its_plane_once_counter_clockwise_between_and_on_vertices") {
  const TetMesh box = tet_shelf::box(3, 4, 5);
  const double area[] = {20, 15, 12};
  std::vector<double> values;
  for (const Point3& p : box.points) values.push_back(linear(p));
  for (std::size_t i = 0; i < 3; ++i)
    for (const double position : {0.25, 0.5, 1.0, 2.0, 2.75}) {  // 1 and 2: planes of vertices
      CAPTURE(i);
      CAPTURE(position);
      const PlaneSection section = mesh::plane_section(box, axes[i], position);
      CHECK(area_of(section.mesh) == doctest::Approx(area[i]).epsilon(1e-12));
      CHECK_FALSE(mesh::validate(section.mesh).has_value());
      for (const auto& [a, b, c] : section.mesh.corners)
        CHECK(kernel::orient2d(section.mesh.points[a], section.mesh.points[b], section.mesh.points[c]) == Sign::positive);
      REQUIRE(section.vertices.size() == section.mesh.vertex_count());
      for (const VertexId v : section.mesh.points.ids())
        CHECK(section.vertices[v].of(values) ==
              doctest::Approx(linear(lifted(section.mesh.points[v], axes[i], position))).epsilon(1e-12));
    }
}

TEST_CASE("the_boundary_of_a_section_goes_round_the_body_and_its_hole") {
  const PlaneSection section = mesh::plane_section(tet_shelf::hollow_torus(), SpaceAxis::z, 0.5);
  CHECK(section.mesh.triangle_count() > 0);
  CHECK_FALSE(mesh::validate(section.mesh).has_value());
}

TEST_CASE("a_shaken_mesh_has_a_sound_section_too") {
  const TetMesh box = tet_shelf::shaken_box(4, 7);
  for (const SpaceAxis axis : axes) {
    const PlaneSection section = mesh::plane_section(box, axis, 1.98);
    CHECK_FALSE(mesh::validate(section.mesh).has_value());
    CHECK(area_of(section.mesh) == doctest::Approx(16).epsilon(0.05));
  }
}

TEST_CASE("a_plane_beside_the_mesh_cuts_nothing_and_one_that_touches_it_covers_a_side_at_most_once") {
  const TetMesh box = tet_shelf::box(2, 2, 2);
  CHECK(mesh::plane_section(box, SpaceAxis::x, -0.5).mesh.corners.empty());
  CHECK(mesh::plane_section(box, SpaceAxis::x, 2.5).mesh.corners.empty());
  CHECK(mesh::plane_section(box, SpaceAxis::x, 0).mesh.corners.empty());
  CHECK(area_of(mesh::plane_section(box, SpaceAxis::x, 2).mesh) == 4);
}

TEST_CASE("a_surface_is_cut_in_segments_that_go_round_it_once") {
  const TetMesh box = tet_shelf::box(2, 3, 1);
  std::vector<std::array<VertexId, 3>> triangles;
  for (const MarkedFace& face : box.boundary) triangles.push_back(face.corners);
  std::vector<double> y, z;
  for (const Point3& p : box.points) y.push_back(p.y), z.push_back(p.z);
  for (const double position : {0.5, 1.0}) {
    double length = 0;
    for (const auto& [a, b] : mesh::plane_section(box.points, triangles, SpaceAxis::x, position))
      length += std::hypot(b.of(y) - a.of(y), b.of(z) - a.of(z));
    CAPTURE(position);
    CHECK(length == doctest::Approx(8));
  }
}

TEST_CASE("a_vertex_that_is_not_there_is_named") {
  TetMesh box = tet_shelf::box(1, 1, 1);
  box.corners[TetId{2}][1] = VertexId{99};
  CHECK_THROWS_WITH_AS((void)mesh::plane_section(box, SpaceAxis::x, 0.5), doctest::Contains("tetrahedron 2 names vertex 99"),
                       InputError);
}
