// SPDX-License-Identifier: MIT
#include "leonhard/mesh/split_cells.hpp"

#include <doctest/doctest.h>

#include <type_traits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/mixed_shelf.hpp"

using namespace leonhard;
using doctest::Approx;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

double size_of(const TriangleMesh& mesh) { return mesh::exact_area2(mesh).get_d() / 2; }
double size_of(const TetMesh& mesh) { return mesh::exact_volume6(mesh).get_d() / 6; }

}  // namespace

TEST_CASE_TEMPLATE("split_meshes_are_valid_and_fill_the_same_place", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    auto mesh = entry.mesh;
    for (const CellId cell : mesh.kinds.ids()) mesh.regions[cell] = static_cast<double>(cell.index());
    const auto split = mesh::split_cells(mesh);
    CHECK(mesh::validate(split.mesh).value_or("") == "");
    CHECK(mesh::validate_embedding(split.mesh).value_or("") == "");
    CHECK(size_of(split.mesh) == Approx(entry.measure).epsilon(1e-15));
    REQUIRE(split.cell_of.size() == split.mesh.cell_count());
    for (const auto part : split.cell_of.ids()) {
      const auto corners = mesh.corners_of(split.cell_of[part]);
      for (const VertexId v : split.mesh.corners[part])
        CHECK(std::find(corners.begin(), corners.end(), v) != corners.end());
      CHECK(split.mesh.regions[part] == static_cast<double>(split.cell_of[part].index()));
    }
    CHECK(mesh::validate(mesh::split_cells(mixed_shelf::shaken(mesh, 3, 0.05)).mesh).value_or("") == "");
  }
}

TEST_CASE("split_counts_are_those_of_each_kind") {
  const auto parts = [](CellKind kind) {
    return mesh::split_cells(mixed_shelf::single(kind)).mesh.tet_count();
  };
  CHECK(parts(CellKind::tetrahedron) == 1);
  CHECK(parts(CellKind::pyramid) == 2);
  CHECK(parts(CellKind::prism) == 3);
  CHECK(parts(CellKind::hexahedron) == 6);
}

TEST_CASE("cell_that_bends_too_much_to_be_cut_is_named") {
  MixedMesh<3> mesh = mixed_shelf::single(CellKind::hexahedron);
  mesh.points[VertexId{6}] = {-0.1, -0.1, -0.1};
  CHECK_THROWS_AS((void)mesh::split_cells(mesh), InputError);
}
