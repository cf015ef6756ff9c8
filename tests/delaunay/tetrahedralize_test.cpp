// SPDX-License-Identifier: MIT
// tetrahedralize: from points in any order to a mesh.
#include "leonhard/delaunay/tetrahedralize.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "leonhard/delaunay/order/insertion_order.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/tet_euler.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/delaunay/shapes3.hpp"
#include "tests/delaunay/tet_oracles.hpp"

namespace leonhard {
namespace {

using delaunay::Tetrahedralization;
using delaunay::TetrahedralizeOptions;
using delaunay::TetrahedralizeOutcome;

Tetrahedralization tetrahedralized(const std::vector<Point3>& points, TetrahedralizeOptions options = {}) {
  return delaunay::tetrahedralize(points, options);
}

/// Valid, Delaunay, the whole convex hull; Euler's account balances and the volumes agree.
///
/// has_inside  there is a double strictly inside one of the tetrahedra, which validate_convex needs
void check_proved(const TetMesh& mesh, bool has_inside = true) {
  for (const auto& broken : {mesh::validate(mesh), mesh::validate_delaunay(mesh),
                             has_inside ? mesh::validate_convex(mesh) : std::nullopt}) {
    INFO(broken.value_or(""));
    CHECK_FALSE(broken.has_value());
  }
  CHECK(mesh::euler_account(mesh, mesh::build_faces(mesh), mesh::build_edges(mesh)).balances());
  CHECK(mesh::exact_volume6(mesh) == mesh::exact_boundary_volume6(mesh));
}

std::string error_of(const std::vector<Point3>& points, const TetrahedralizeOptions& options = {}) {
  try {
    static_cast<void>(tetrahedralized(points, options));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST_CASE("every_family_is_tetrahedralised_and_proved") {
  for (const shapes3::NamedPoints& family : shapes3::families()) {
    CAPTURE(family.name);
    const Tetrahedralization made = tetrahedralized(family.points);
    REQUIRE(made.outcome == TetrahedralizeOutcome::done);
    check_proved(made.mesh, family.name != "subnormal");
    for (std::size_t i = 0; i < family.points.size(); ++i)
      REQUIRE(made.mesh.points[*made.vertex_of_input[i]] == family.points[i]);
  }
}

TEST_CASE("order_seed_and_algorithm_of_tetrahedralize_change_no_tetrahedron") {
  for (const shapes3::NamedPoints& family : shapes3::families()) {
    CAPTURE(family.name);
    const TetMesh first = tetrahedralized(family.points).mesh;
    TetrahedralizeOptions options;
    options.seed = 77;
    CHECK(tetrahedralized(family.points, options).mesh == first);
    options.algorithm = delaunay::TetAlgorithm::flipping;
    CHECK(tetrahedralized(family.points, options).mesh == first);
    options = {};
    options.sorted = false;
    const TetMesh unsorted = tetrahedralized(family.points, options).mesh;
    CHECK_FALSE(mesh::validate(unsorted).has_value());
    CHECK(mesh::fingerprint(unsorted) == mesh::fingerprint(first));
    CHECK(mesh::fingerprint(tetrahedralized(shapes3::shuffled(family.points, 5)).mesh) ==
          mesh::fingerprint(first));
  }
}

TEST_CASE("threads_change_no_bit_of_a_tetrahedral_mesh") {
  for (const auto& points :
       {shapes3::uniform(40'000), shapes3::gaussian_clusters(40'000), shapes3::grid(32, 33, 34)}) {
    const TetMesh one = tetrahedralized(shapes3::shuffled(points, 3)).mesh;
    TetrahedralizeOptions options;
    for (const unsigned threads : {2U, 0U}) {
      options.threads = threads;
      CHECK(tetrahedralized(shapes3::shuffled(points, 3), options).mesh == one);
    }
  }
}

/// The point in the middle sees the whole sphere: a cavity too large for the table of pairs.
TEST_CASE("a_cavity_of_a_thousand_vertices_is_filled") {
  std::vector<Point3> points = shapes3::sphere(2000);
  points.push_back({0, 0, 0});
  const std::vector<std::uint32_t> order = kernel::hilbert_order(points);
  const auto middle = static_cast<std::size_t>(std::find(order.begin(), order.end(), 2000U) - order.begin());
  TetrahedralizeOptions options;
  // A seed with which the middle comes in the last round, after half of the others.
  const auto is_late = [&] {
    const delaunay::Rounds rounds = delaunay::rounds_of(points.size(), options.seed);
    const auto last = rounds.round(rounds.count() - 1);
    return std::find(last.begin(), last.end(), middle) != last.end();
  };
  while (!is_late()) ++options.seed;
  const Tetrahedralization made = tetrahedralized(points, options);
  check_proved(made.mesh);
  const VertexId centre = *made.vertex_of_input[2000];
  CHECK(std::count_if(made.mesh.corners.begin(), made.mesh.corners.end(), [&](const auto& c) {
          return std::find(c.begin(), c.end(), centre) != c.end();
        }) > 3000);
}

TEST_CASE("equal_points_share_a_vertex_and_vertices_come_in_the_order_of_the_input") {
  std::vector<Point3> points = shapes3::uniform(50);
  points.insert(points.begin() + 10, points[3]);
  points.push_back({-0.0, 0.5, 0.5});
  points.push_back({0.0, 0.5, 0.5});
  const Tetrahedralization made = tetrahedralized(points);
  CHECK(made.mesh.vertex_count() == 51);
  CHECK(made.vertex_of_input[10] == made.vertex_of_input[3]);
  CHECK(made.vertex_of_input[51] == made.vertex_of_input[52]);
  CHECK(made.vertex_of_input[9] == MaybeId(VertexId{9}));
  CHECK(made.vertex_of_input[11] == MaybeId(VertexId{10}));
  REQUIRE(made.repairs.size() == 1);
  CHECK(made.repairs[0] == "2 points lie at the places of earlier ones and were merged into them");
}

TEST_CASE("points_without_a_tetrahedron_have_a_named_outcome_and_an_empty_mesh") {
  const auto outcome = [](const std::vector<Point3>& points) {
    const Tetrahedralization made = tetrahedralized(points);
    CHECK(made.mesh == TetMesh{});
    CHECK(made.vertex_of_input == std::vector<MaybeId<VertexId>>(points.size()));
    return made.outcome;
  };
  CHECK(outcome({}) == TetrahedralizeOutcome::too_few_points);
  CHECK(outcome({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == TetrahedralizeOutcome::too_few_points);
  CHECK(outcome({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {9, 9, 9}}) ==
        TetrahedralizeOutcome::all_collinear);
  CHECK(outcome(shapes3::grid(4, 5, 1)) == TetrahedralizeOutcome::all_coplanar);
}

TEST_CASE("bad_points_of_space_are_refused_by_name") {
  std::vector<Point3> points = shapes3::uniform(10);
  points[7].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(error_of(points).find("7") != std::string::npos);
  TetrahedralizeOptions options;
  options.memory_limit_bytes = 1'000'000;
  CHECK(error_of(shapes3::uniform(10'000), options) ==
        "points: 10000 of them need about 3000000 bytes of memory, the limit is 1000000; raise the limit or "
        "leave points "
        "out");
  CHECK(error_of(shapes3::uniform(3'000), options) == "no error");
}

TEST_CASE("a_stop_request_ends_tetrahedralize_with_an_empty_mesh") {
  for (const unsigned threads : {1U, 2U}) {
    std::stop_source source;
    TetrahedralizeOptions options;
    options.threads = threads;
    options.progress.stop = source.get_token();
    options.progress.report = [&](std::string_view stage, double fraction) {
      if (stage == "tetrahedralize" && fraction > 0.1) source.request_stop();
    };
    const Tetrahedralization made = tetrahedralized(shapes3::uniform(30'000), options);
    CHECK(made.outcome == TetrahedralizeOutcome::stopped);
    CHECK(made.mesh == TetMesh{});
  }
}

TEST_CASE("progress_of_tetrahedralize_rises_from_0_to_1") {
  double last = 0;
  TetrahedralizeOptions options;
  options.progress.report = [&](std::string_view stage, double fraction) {
    if (stage != "tetrahedralize") return;
    CHECK(fraction >= last);
    last = fraction;
  };
  static_cast<void>(tetrahedralized(shapes3::uniform(5'000), options));
  CHECK(last == 1);
}

/// Dwyer (1991), Miles (1970): 96 pi^2 / 35 + 24 / 35 tetrahedra at a vertex of a Poisson set, so 6.768 a point.
TEST_CASE("uniform_points_have_six_and_three_quarter_tetrahedra_each") {
  const TetMesh mesh = tetrahedralized(shapes3::uniform(20'000)).mesh;
  CHECK(static_cast<double>(mesh.tet_count()) / 20'000 == doctest::Approx(6.768).epsilon(0.03));
}

TEST_CASE("erasing_dead_tetrahedra_keeps_the_others_linked") {
  // A tetrahedron and its four ghosts, with dead numbers before, between and after them.
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto made = delaunay::tetrahedralize_distinct(points, delaunay::TetAlgorithm::insertion, {});
  delaunay::GhostTetrahedralization holey;
  const std::map<IdRaw, IdRaw> at{{0, 1}, {1, 3}, {2, 4}, {3, 6}, {4, 7}};
  holey.corners.resize(9);
  holey.neighbours.resize(9);
  for (const auto& [from, to] : at) {
    holey.corners[TetId{to}] = made.cells.corners[TetId{from}];
    for (unsigned i = 0; i < 4; ++i)
      holey.neighbours[TetId{to}][i] = TetId{at.at((*made.cells.neighbours[TetId{from}][i]).raw)};
  }
  holey.erase({TetId{0}, TetId{2}, TetId{8}, TetId{5}});
  CHECK(holey.tet_count() == 5);
  CHECK_FALSE(holey.validate().has_value());
  CHECK(oracles::tet_set(holey, points) == oracles::tet_set(made.cells, points));
}

}  // namespace
}  // namespace leonhard
