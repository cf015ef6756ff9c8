// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_euler.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

TetEulerAccount account_of(const TetMesh& mesh) {
  return mesh::euler_account(mesh, mesh::build_faces(mesh), mesh::build_edges(mesh));
}

std::set<std::string> broken(const TetEulerAccount& account) {
  std::set<std::string> names;
  for (const auto& formula : account.formulas) {
    if (!formula.holds()) names.insert(formula.name);
  }
  return names;
}

}  // namespace

TEST_CASE("account_of_every_tetrahedral_mesh_on_the_shelf_balances_and_counts_what_is_known") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const TetEulerAccount account = account_of(entry.mesh);
    for (const auto& formula : account.formulas) {
      CAPTURE(formula.name);
      CHECK(formula.lhs == formula.rhs);
      CHECK_FALSE(formula.words.empty());
    }
    CHECK(account.balances());
    CHECK(account.components == entry.components);
    CHECK(account.handles == entry.handles);
    CHECK(account.cavities == entry.cavities);
    CHECK(account.outer_shells == entry.components);
    CHECK(account.vertex_pinches == entry.vertex_pinches);
    CHECK(account.edge_pinches == entry.edge_pinches);
    CHECK(account.sheet_pinches == entry.extra_sheets);
    CHECK(account.characteristic() == static_cast<std::int64_t>(entry.components + entry.cavities) -
                                          static_cast<std::int64_t>(entry.handles));
    CHECK(account.boundary_faces == entry.mesh.boundary.size());
  }
}

TEST_CASE("box_counts_are_those_of_arithmetic") {
  const int x = 4, y = 3, z = 5;
  const TetEulerAccount account = account_of(tet_shelf::box(x, y, z));
  const auto n = [](int count) { return static_cast<std::size_t>(count); };
  CHECK(account.vertices == n((x + 1) * (y + 1) * (z + 1)));
  CHECK(account.tetrahedra == n(6 * x * y * z));
  CHECK(account.boundary_faces == n(4 * (x * y + y * z + z * x)));
  // A vertex of the box for each lattice point on its surface.
  CHECK(account.sheets == n((x + 1) * (y + 1) * (z + 1) - (x - 1) * (y - 1) * (z - 1)));
  // Edges along the axes, one diagonal a square, one diagonal a cube.
  const int axes = x * (y + 1) * (z + 1) + (x + 1) * y * (z + 1) + (x + 1) * (y + 1) * z;
  const int squares = x * y * (z + 1) + (x + 1) * y * z + x * (y + 1) * z;
  CHECK(account.edges == n(axes + squares + x * y * z));
  // Two triangles a square, six inner ones a cube.
  CHECK(account.faces == n(2 * squares + 6 * x * y * z));
  CHECK(account.stars == account.vertices);
  CHECK(account.fans == account.edges);
}

TEST_CASE("tetrahedral_account_does_not_balance_when_an_independent_count_is_wrong") {
  const auto mesh = tet_shelf::shaken_box(3, 2);
  const auto faces = mesh::build_faces(mesh);
  const auto edges = mesh::build_edges(mesh);
  REQUIRE(mesh::euler_account(mesh, faces, edges).balances());

  auto fewer_edges = edges;
  fewer_edges.ends.flat().pop_back();
  for (IdRaw& first : fewer_edges.first_edge)
    first = std::min(first, static_cast<IdRaw>(fewer_edges.edge_count()));
  CHECK(broken(mesh::euler_account(mesh, faces, fewer_edges)) == std::set<std::string>{"edges"});

  auto fewer_faces = faces;
  fewer_faces.corners.flat().pop_back();
  fewer_faces.sides.flat().pop_back();
  CHECK(broken(mesh::euler_account(mesh, fewer_faces, edges)).contains("(1.1.14)"));
  CHECK(broken(mesh::euler_account(mesh, fewer_faces, edges)).contains("(1.1.6)"));

  auto unlisted = mesh;
  unlisted.boundary.pop_back();
  CHECK(broken(mesh::euler_account(unlisted, faces, edges)) == std::set<std::string>{"boundary"});

  auto unused = mesh;
  unused.points.push_back({9, 9, 9});
  CHECK(broken(mesh::euler_account(unused, mesh::build_faces(unused), mesh::build_edges(unused))) ==
        std::set<std::string>{"vertices"});
  CHECK_THROWS_AS((void)mesh::euler_account(unused, faces, edges), InputError);  // they are of another mesh
}

TEST_CASE("tetrahedral_account_does_not_balance_when_neighbours_are_parted") {
  auto mesh = tet_shelf::shaken_box(3, 2);
  const auto faces = mesh::build_faces(mesh);
  const auto edges = mesh::build_edges(mesh);
  for (const TetId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto n = mesh.neighbours[t][i];
      if (!n || t.index() < 60) continue;
      for (auto& back : mesh.neighbours[*n]) {
        if (back == MaybeId<TetId>(t)) back = {};
      }
      mesh.neighbours[t][i] = {};
      CHECK_FALSE(mesh::euler_account(mesh, faces, edges).balances());
      return;
    }
  }
}

TEST_CASE("tetrahedral_account_is_of_topology_alone_and_balances_where_layers_overlap") {
  // Seven positive tetrahedra of 720/7 degrees about the edge 0-1: two layers, though validate sees nothing.
  std::vector<Point3> points{{0, 0, -1}, {0, 0, 1}};
  std::vector<tet_shelf::Corners> tets;
  for (std::size_t i = 0; i < 7; ++i) {
    const double angle = 4 * std::acos(-1.0) * static_cast<double>(i) / 7;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    tets.push_back({0, 1, 2 + i, 2 + (i + 1) % 7});
  }
  // Topologically that is a ball, so the account balances: overlaps are no business of Euler's formula.
  CHECK(account_of(tet_shelf::build(points, tets)).balances());
}

TEST_CASE("account_of_no_tetrahedra_balances") { CHECK(account_of(TetMesh{}).balances()); }
