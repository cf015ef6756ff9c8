// SPDX-License-Identifier: MIT
#include "leonhard/mesh/euler.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <random>
#include <set>

#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

EulerAccount account_of(const TriangleMesh& mesh) {
  return mesh::euler_account(mesh, mesh::build_edges(mesh));
}

/// Number of classes of those of `count` things for which in(i), two being joined where touches(i, j). Quadratic.
template <class In, class Touches>
std::size_t class_count(std::size_t count, In in, Touches touches) {
  std::vector<char> seen(count, 0);
  std::size_t classes = 0;
  for (std::size_t start = 0; start < count; ++start) {
    if (!in(start) || seen[start]) continue;
    ++classes;
    std::vector<std::size_t> stack{start};
    seen[start] = 1;
    while (!stack.empty()) {
      const std::size_t i = stack.back();
      stack.pop_back();
      for (std::size_t j = 0; j < count; ++j) {
        if (in(j) && !seen[j] && touches(i, j)) seen[j] = 1, stack.push_back(j);
      }
    }
  }
  return classes;
}

std::size_t common_vertices(const shelf::Corners& s, const shelf::Corners& t) {
  std::size_t count = 0;
  for (const std::size_t v : s) count += static_cast<std::size_t>(std::count(t.begin(), t.end(), v));
  return count;
}

void check_formulas_hold(const EulerAccount& account) {
  for (const auto& formula : account.formulas) {
    CAPTURE(formula.name);
    CHECK(formula.lhs == formula.rhs);
    CHECK_FALSE(formula.words.empty());
  }
  CHECK(account.balances());
}

const EulerAccount::Formula& formula(const EulerAccount& account, const std::string& name) {
  for (const auto& f : account.formulas) {
    if (f.name == name) return f;
  }
  FAIL("no formula ", name);
  return account.formulas.front();
}

}  // namespace

TEST_CASE("account_of_every_mesh_on_the_shelf_balances_and_counts_what_is_known") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const EulerAccount account = account_of(mesh);
    check_formulas_hold(account);
    CHECK(account.components == entry.components);
    CHECK(account.holes == entry.holes);
    CHECK(account.pinches == entry.pinches);
    CHECK(account.boundary_loops == entry.components + entry.holes);
    CHECK(account.boundary_edges == mesh.boundary.size());
  }
}

TEST_CASE("grid_counts_are_those_of_arithmetic") {
  const EulerAccount account = account_of(shelf::grid(7, 4));
  CHECK(account.vertices == 8 * 5);
  CHECK(account.triangles == 2 * 7 * 4);
  CHECK(account.edges == 7 * 5 + 8 * 4 + 7 * 4);
  CHECK(account.boundary_edges == 2 * (7 + 4));
  CHECK(account.interior_edges == account.edges - account.boundary_edges);
  CHECK(account.fans == account.vertices);
  CHECK(formula(account, "(1.1.3)").lhs == 56);
  CHECK(formula(account, "(1.1.4)").rhs == 3 * 40 - 22 - 3);
}

// Oracle: components by flooding over edges; holes as the components of the complement, squares around the grid
// included, that touch in at least a vertex, less the outside one (opening a pinch joins what touches there);
// pinches by counting boundary edges at each vertex.
TEST_CASE("random_grids_with_random_holes_balance_and_agree_with_flooding") {
  std::mt19937 random(20240517);
  for (int trial = 0; trial < 120; ++trial) {
    const std::size_t n = 6;  // 6 by 6 squares inside a rim of one square that is never kept
    const shelf::Grid g(n + 2, n + 2);
    const auto removed_of_8 = 1 + random() % 6;
    std::vector<bool> keep(g.triangles.size(), false);
    for (std::size_t t = 0; t < keep.size(); ++t) {
      const std::size_t i = t / 2 % (n + 2), j = t / 2 / (n + 2);
      keep[t] = i > 0 && i <= n && j > 0 && j <= n && random() % 8 >= removed_of_8;
    }
    if (std::find(keep.begin(), keep.end(), true) == keep.end()) continue;
    const TriangleMesh mesh = shelf::build_kept(g.points, g.triangles, keep);
    const EulerAccount account = account_of(mesh);
    CAPTURE(trial);
    check_formulas_hold(account);

    const auto touch = [&](std::size_t least) {
      return [&g, least](std::size_t s, std::size_t t) {
        return common_vertices(g.triangles[s], g.triangles[t]) >= least;
      };
    };
    CHECK(account.components == class_count(
                                    keep.size(), [&](std::size_t t) { return bool(keep[t]); }, touch(2)));
    CHECK(account.holes == class_count(
                               keep.size(), [&](std::size_t t) { return !keep[t]; }, touch(1)) -
                               1);

    PerId<VertexId, std::size_t> ends(mesh.vertex_count(), 0);
    for (const auto& edge : mesh.boundary) ++ends[edge.from], ++ends[edge.to];
    std::size_t pinches = 0;
    for (const std::size_t count : ends) pinches += count > 2 ? count / 2 - 1 : 0;
    CHECK(account.pinches == pinches);
  }
}

TEST_CASE("account_does_not_balance_for_a_handle") {
  // A torus of 3 by 3 squares without one of them: an oriented surface, but of no plane domain.
  std::vector<shelf::Corners> triangles;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == 2 && j == 2) continue;
      const std::size_t a = 3 * j + i, b = 3 * j + (i + 1) % 3, c = 3 * ((j + 1) % 3) + (i + 1) % 3,
                        d = 3 * ((j + 1) % 3) + i;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  TriangleMesh torus;
  for (std::size_t v = 0; v < 9; ++v) {
    torus.points.push_back({static_cast<double>(v % 3), static_cast<double>(v / 3)});
  }
  torus.corners = shelf::typed(triangles);
  torus.boundary = shelf::lone_edges(triangles, 1);
  mesh::build_neighbours(torus);
  const EulerAccount account = account_of(torus);
  CHECK_FALSE(account.balances());
  CHECK_FALSE(formula(account, "no handles").holds());
  CHECK(formula(account, "(1.1.2)").holds());
}

TEST_CASE("account_does_not_balance_when_the_boundary_or_a_vertex_is_off") {
  auto mesh = shelf::annulus(8);
  mesh.boundary.pop_back();
  CHECK_FALSE(formula(account_of(mesh), "boundary").holds());
  mesh = shelf::annulus(8);
  mesh.points.push_back({7, 7});
  CHECK_FALSE(formula(account_of(mesh), "vertices").holds());
  mesh = shelf::disc({0, 0}, 1, 8);
  for (Point2& p : mesh.points) p.x = -p.x;  // the loop turned over
  CHECK_FALSE(formula(account_of(mesh), "outer loops").holds());
}

TEST_CASE("account_of_no_triangles_balances_at_zero") {
  const EulerAccount account = account_of({});
  CHECK(account.balances());
  CHECK(account.boundary_loops == 0);
}
