// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mixed_euler.hpp"

#include <doctest/doctest.h>

#include <set>
#include <type_traits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/tet_euler.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/mixed_shelf.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;
using mixed_shelf::Filling;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

void check_balance(const MixedEulerAccount& account) {
  for (const auto& formula : account.formulas) {
    CAPTURE(formula.name);
    CHECK(formula.lhs == formula.rhs);
    CHECK_FALSE(formula.words.empty());
  }
  CHECK(account.balances());
}

std::set<std::string> broken(const MixedEulerAccount& account) {
  std::set<std::string> names;
  for (const auto& formula : account.formulas)
    if (!formula.holds()) names.insert(formula.name);
  return names;
}

/// A box of cubes, every second one a star, without those for which `is_out` says so.
template <class IsOut>
MixedMesh<3> box_without(std::size_t n, IsOut is_out) {
  return mixed_shelf::Box(n, n, n,
                          [is_out](std::size_t i, std::size_t j, std::size_t k) {
                            if (is_out(i, j, k)) return Filling::nothing;
                            return (i + j + k) % 2 == 0 ? Filling::star : Filling::hexahedron;
                          })
      .mesh();
}

}  // namespace

TEST_CASE_TEMPLATE("account_of_every_mesh_of_mixed_cells_balances", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    const MixedEulerAccount account = mesh::euler_account(entry.mesh);
    check_balance(account);
    CHECK(account.components == 1);
    CHECK(account.cavities == 0);
    CHECK(account.handles == 0);
    CHECK(account.vertex_pinches == 0);
    CHECK(account.characteristic(Dim::value) == 1);
    CHECK(account.boundary_facets == entry.mesh.boundary.size());
    check_balance(mesh::euler_account(mixed_shelf::shaken(entry.mesh, 2)));
  }
}

TEST_CASE("account_of_triangles_is_that_of_the_triangle_mesh") {
  for (const auto& entry : shelf::all()) {
    CAPTURE(entry.name);
    const EulerAccount expected = mesh::euler_account(entry.mesh, mesh::build_edges(entry.mesh));
    const MixedEulerAccount account = mesh::euler_account(mesh::mixed_mesh_of(entry.mesh));
    check_balance(account);
    CHECK(account.stars == expected.fans);
    CHECK(account.vertex_pinches == entry.pinches);
    CHECK(account.components == entry.components);
    CHECK(account.cavities == entry.holes);
    CHECK(account.shells == expected.boundary_loops);
    CHECK(account.edges == expected.edges);
  }
}

TEST_CASE("account_of_tetrahedra_is_that_of_the_tetrahedral_mesh") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const TetEulerAccount expected =
        mesh::euler_account(entry.mesh, mesh::build_faces(entry.mesh), mesh::build_edges(entry.mesh));
    const MixedEulerAccount account = mesh::euler_account(mesh::mixed_mesh_of(entry.mesh));
    check_balance(account);
    CHECK(account.facets == expected.faces);
    CHECK(account.stars == expected.stars);
    CHECK(account.fans == expected.fans);
    CHECK(account.vertex_pinches == entry.vertex_pinches);
    CHECK(account.edge_pinches == entry.edge_pinches);
    CHECK(account.boundary_vertices == expected.sheets);
    CHECK(account.components == entry.components);
    CHECK(account.cavities == entry.cavities);
    CHECK(account.handles == entry.handles);
    CHECK(account.characteristic(3) == expected.characteristic());
  }
}

TEST_CASE("counts_of_a_box_of_cubes_are_those_of_arithmetic") {
  const std::size_t x = 3, y = 2, z = 4;
  const MixedEulerAccount account = mesh::euler_account(mixed_shelf::box(x, y, z, Filling::hexahedron));
  CHECK(account.vertices == (x + 1) * (y + 1) * (z + 1));
  CHECK(account.cells == x * y * z);
  CHECK(account.edges == x * (y + 1) * (z + 1) + (x + 1) * y * (z + 1) + (x + 1) * (y + 1) * z);
  CHECK(account.facets == x * y * (z + 1) + x * (y + 1) * z + (x + 1) * y * z);
  CHECK(account.boundary_facets == 2 * (x * y + y * z + x * z));
}

TEST_CASE("handles_cavities_and_pinches_of_mixed_cells_are_counted") {
  const MixedEulerAccount torus = mesh::euler_account(
      box_without(3, [](std::size_t i, std::size_t j, std::size_t) { return i == 1 && j == 1; }));
  check_balance(torus);
  CHECK(torus.handles == 1);
  CHECK(torus.characteristic(3) == 0);

  const MixedEulerAccount hollow = mesh::euler_account(
      box_without(3, [](std::size_t i, std::size_t j, std::size_t k) { return i == 1 && j == 1 && k == 1; }));
  check_balance(hollow);
  CHECK(hollow.cavities == 1);
  CHECK(hollow.shells == 2);
  CHECK(hollow.characteristic(3) == 2);

  // Two cubes at opposite corners of a box of eight, and two that have an edge in common.
  const MixedEulerAccount corners = mesh::euler_account(
      box_without(2, [](std::size_t i, std::size_t j, std::size_t k) { return i != j || j != k; }));
  check_balance(corners);
  CHECK(corners.components == 2);
  CHECK(corners.vertex_pinches == 1);
  const MixedEulerAccount edge = mesh::euler_account(
      box_without(2, [](std::size_t i, std::size_t j, std::size_t k) { return i != j || k != 0; }));
  check_balance(edge);
  CHECK(edge.components == 2);
  CHECK(edge.edge_pinches == 1);
  CHECK(edge.vertex_pinches == 2);
}

TEST_CASE("account_of_a_broken_mesh_does_not_balance_and_says_where") {
  MixedMesh<3> mesh = mixed_shelf::mixture();
  mesh.boundary.pop_back();
  CHECK(broken(mesh::euler_account(mesh)) == std::set<std::string>{"boundary"});
  mesh = mixed_shelf::single(CellKind::hexahedron);
  mesh.points.push_back({9, 9, 9});
  mesh.vertex_markers.push_back(0);
  CHECK(broken(mesh::euler_account(mesh)) == std::set<std::string>{"vertices"});
  mesh = mixed_shelf::single(CellKind::hexahedron);
  for (Point3& p : mesh.points) p.x = -p.x;
  CHECK(broken(mesh::euler_account(mesh)).contains("outer shells"));
  mesh.corners[0][3] = mesh.corners[0][4];
  CHECK_THROWS_AS((void)mesh::euler_account(mesh), InputError);
}
