// SPDX-License-Identifier: MIT
#include "leonhard/mesh/quality.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "tests/mesh/shelf.hpp"

using namespace leonhard;
using doctest::Approx;

TEST_CASE("equilateral_triangle_has_the_best_figures") {
  const auto q = mesh::triangle_quality({0, 0}, {2, 0}, {1, std::sqrt(3.0)});
  CHECK(q.min_angle_deg == Approx(60).epsilon(1e-14));
  CHECK(q.max_angle_deg == Approx(60).epsilon(1e-14));
  CHECK(q.area == Approx(std::sqrt(3.0)).epsilon(1e-14));
  CHECK(q.aspect_ratio == Approx(1).epsilon(1e-14));
  CHECK(q.radius_edge_ratio == Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("right_triangles_have_the_figures_of_the_textbook") {
  const auto half_square = mesh::triangle_quality({0, 0}, {1, 0}, {0, 1});
  CHECK(half_square.min_angle_deg == Approx(45).epsilon(1e-14));
  CHECK(half_square.max_angle_deg == Approx(90).epsilon(1e-14));
  CHECK(half_square.aspect_ratio == Approx((1 + std::sqrt(2.0)) / 2).epsilon(1e-14));
  const auto egyptian = mesh::triangle_quality({0, 0}, {4, 0}, {0, 3});  // circumradius 5/2, inradius 1
  CHECK(egyptian.aspect_ratio == Approx(1.25).epsilon(1e-14));
  CHECK(egyptian.radius_edge_ratio == Approx(2.5 / 3).epsilon(1e-14));
  CHECK(egyptian.area == Approx(6).epsilon(1e-14));
}

TEST_CASE("small_angles_keep_their_digits") {
  const auto needle = mesh::triangle_quality({0, 0}, {1, 0}, {1, 1e-9});
  CHECK(needle.min_angle_deg == Approx(1e-9 * 180 / std::numbers::pi).epsilon(1e-14));
}

TEST_CASE("angles_and_ratios_do_not_depend_on_scale_up_to_the_ends_of_the_doubles") {
  const auto at_scale = [](double s) { return mesh::triangle_quality({-s, 0}, {s, 0}, {0, s}); };
  const auto one = at_scale(1);
  for (const double scale : {1e-320, 1e-300, 1e-160, 1e160, 1.7e308}) {
    CAPTURE(scale);
    const auto q = at_scale(scale);
    CHECK(q.min_angle_deg == Approx(one.min_angle_deg).epsilon(1e-14));
    CHECK(q.max_angle_deg == Approx(one.max_angle_deg).epsilon(1e-14));
    CHECK(q.aspect_ratio == Approx(one.aspect_ratio).epsilon(1e-14));
    CHECK(q.radius_edge_ratio == Approx(one.radius_edge_ratio).epsilon(1e-14));
  }
}

TEST_CASE("area_is_right_where_it_is_a_double_though_a_side_is_none") {
  CHECK(mesh::triangle_quality({-1.6e308, 0}, {1.6e308, 0}, {0, 0.01}).area == Approx(1.6e306).epsilon(1e-9));
  CHECK(mesh::triangle_quality({0, 0}, {1e-160, 0}, {0, 1e-160}).area == Approx(5e-321).epsilon(1e-3).scale(0));
}

TEST_CASE("quality_of_a_grid_is_that_of_its_one_triangle") {
  const auto q = mesh::quality(shelf::grid(5, 3));
  CHECK(q.min_angle_deg == Approx(45));
  CHECK(q.max_angle_deg == Approx(90));
  CHECK(q.mean_min_angle_deg == Approx(45));
  CHECK(q.min_area == 0.5);
  CHECK(q.max_area == 0.5);
  CHECK(q.mean_area == 0.5);
  CHECK(q.total_area == 15);
  CHECK(q.max_size_growth == 1);
  CHECK_FALSE(q.fastest_growth[0]);
}

TEST_CASE("histogram_counts_every_corner_once_in_its_class") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const auto q = mesh::quality(mesh);
    CHECK(std::accumulate(q.angle_histogram.begin(), q.angle_histogram.end(), std::size_t{0}) ==
          3 * mesh.triangle_count());
  }
  const auto flat =
      mesh::quality(shelf::build({{0, 0}, {10, 0}, {5, 0.5}}, {{0, 1, 2}}));  // 5.7, 5.7, 168.6 degrees
  CHECK(flat.angle_histogram[0] == 2);
  CHECK(flat.angle_histogram[16] == 1);
}

TEST_CASE("worst_triangles_come_in_order_and_with_their_place") {
  const auto mesh =
      shelf::build({{0, 0}, {4, 0}, {4, 4}, {0, 1}, {4, 4.5}}, {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}});
  const auto q = mesh::quality(mesh, 2);
  REQUIRE(q.worst.size() == 2);
  CHECK(q.worst[0].triangle == TriangleId{2});
  CHECK(q.worst[0].figures.min_angle_deg == q.min_angle_deg);
  CHECK(q.worst[0].centroid.x == Approx(8.0 / 3));
  CHECK(q.worst[0].centroid.y == Approx(9.5 / 3));
  CHECK(q.worst[1].triangle == TriangleId{1});
  CHECK(mesh::quality(mesh, 99).worst.size() == 3);
}

TEST_CASE("size_growth_is_the_root_of_the_ratio_of_neighbouring_areas") {
  const auto mesh = shelf::build({{0, 0}, {1, 0}, {0, 1}, {-9, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto q = mesh::quality(mesh);
  CHECK(q.max_size_growth == Approx(3).epsilon(1e-14));
  CHECK(q.fastest_growth[0] == MaybeId<TriangleId>(TriangleId{0}));
  CHECK(q.fastest_growth[1] == MaybeId<TriangleId>(TriangleId{1}));
}

TEST_CASE("quality_of_no_triangles_is_zero") {
  const auto q = mesh::quality({});
  CHECK(q.min_angle_deg == 0);
  CHECK(q.worst.empty());
}
