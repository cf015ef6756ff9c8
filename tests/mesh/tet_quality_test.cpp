// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_quality.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;
using doctest::Approx;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Four points on a sphere about the origin, alternately above and below its equator by h.
TetQuality sliver(double h) { return mesh::tet_quality({1, 0, h}, {0, -1, -h}, {-1, 0, h}, {0, 1, -h}); }

}  // namespace

TEST_CASE("regular_tetrahedron_has_the_best_figures") {
  const auto q = mesh::tet_quality({1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1});
  CHECK(q.min_dihedral_deg == Approx(degrees * std::acos(1.0 / 3)).epsilon(1e-14));
  CHECK(q.max_dihedral_deg == Approx(degrees * std::acos(1.0 / 3)).epsilon(1e-14));
  CHECK(q.volume == Approx(8.0 / 3).epsilon(1e-14));
  CHECK(q.shortest_edge == Approx(2 * std::sqrt(2.0)).epsilon(1e-14));
  CHECK(q.longest_edge == Approx(2 * std::sqrt(2.0)).epsilon(1e-14));
  CHECK(q.aspect_ratio == Approx(1).epsilon(1e-14));
  CHECK(q.radius_edge_ratio == Approx(std::sqrt(6.0) / 4).epsilon(1e-14));
}

TEST_CASE("corner_of_a_cube_has_the_figures_of_the_textbook") {
  const auto q = mesh::tet_quality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  CHECK(q.min_dihedral_deg == Approx(degrees * std::atan(std::sqrt(2.0))).epsilon(1e-14));
  CHECK(q.max_dihedral_deg == Approx(90).epsilon(1e-14));
  CHECK(q.volume == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(q.shortest_edge == Approx(1).epsilon(1e-14));
  CHECK(q.longest_edge == Approx(std::sqrt(2.0)).epsilon(1e-14));
  CHECK(q.radius_edge_ratio == Approx(std::sqrt(3.0) / 2).epsilon(1e-14));
  const double inradius = 3 * (1.0 / 6) / (1.5 + std::sqrt(3.0) / 2);
  CHECK(q.aspect_ratio == Approx(std::sqrt(3.0) / 2 / (3 * inradius)).epsilon(1e-14));
}

TEST_CASE("figures_do_not_depend_on_the_order_of_corners") {
  const std::array<Point3, 4> p{{{0.1, 0.2, 0.3}, {1.4, -0.2, 0.1}, {0.3, 1.7, 0.2}, {0.5, 0.4, 1.1}}};
  const auto one = mesh::tet_quality(p[0], p[1], p[2], p[3]);
  for (const auto& [i, j, k, l] : std::vector<std::array<std::size_t, 4>>{
           {1, 2, 0, 3}, {2, 0, 1, 3}, {1, 0, 3, 2}, {3, 2, 1, 0}, {0, 3, 1, 2}}) {
    const auto q = mesh::tet_quality(p[i], p[j], p[k], p[l]);
    CHECK(q.min_dihedral_deg == Approx(one.min_dihedral_deg).epsilon(1e-13));
    CHECK(q.max_dihedral_deg == Approx(one.max_dihedral_deg).epsilon(1e-13));
    CHECK(q.volume == Approx(one.volume).epsilon(1e-13));
    CHECK(q.aspect_ratio == Approx(one.aspect_ratio).epsilon(1e-13));
    CHECK(q.radius_edge_ratio == Approx(one.radius_edge_ratio).epsilon(1e-13));
  }
}

TEST_CASE("slivers_keep_their_digits") {
  for (const double h : {1e-2, 1e-4, 1e-8, 1e-12, 1e-15}) {
    CAPTURE(h);
    const auto q = sliver(h);
    const auto close = [](double value, double expected) { return std::abs(value / expected - 1) < 1e-13; };
    CHECK(close(q.volume, 4.0 / 3 * h));
    CHECK(close(q.radius_edge_ratio,
                std::sqrt(1 + h * h) / std::sqrt(2 + 4 * h * h)));  // centred at the origin
    CHECK(close(q.shortest_edge, std::sqrt(2 + 4 * h * h)));
    CHECK(q.longest_edge == 2);
    // At a long edge the faces fall by 2 h over a run of 1 to either side.
    CHECK(std::abs(q.max_dihedral_deg - (180 - degrees * 2 * std::atan(2 * h))) < 1e-13);
    // At a short edge meet faces with normals (0, 2 h, 1) and (2 h, 0, -1): the cosine is 1 / (1 + 4 h^2).
    CHECK(close(q.min_dihedral_deg, degrees * std::asin(h * std::sqrt(8 + 16 * h * h) / (1 + 4 * h * h))));
    const double face = std::sqrt(1 + 4 * h * h), inradius = 3 * (4.0 / 3 * h) / (4 * face);
    CHECK(close(q.aspect_ratio, std::sqrt(1 + h * h) / (3 * inradius)));
  }
}

TEST_CASE("angles_and_ratios_of_tetrahedra_do_not_depend_on_scale_up_to_the_ends_of_the_doubles") {
  const auto at_scale = [](double s) {
    return mesh::tet_quality({-s, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s});
  };
  const auto one = at_scale(1);
  for (const double scale : {1e-320, 1e-300, 1e-160, 1e160, 1.7e308}) {
    CAPTURE(scale);
    const auto q = at_scale(scale);
    CHECK(q.min_dihedral_deg == Approx(one.min_dihedral_deg).epsilon(1e-14));
    CHECK(q.max_dihedral_deg == Approx(one.max_dihedral_deg).epsilon(1e-14));
    CHECK(q.aspect_ratio == Approx(one.aspect_ratio).epsilon(1e-14));
    CHECK(q.radius_edge_ratio == Approx(one.radius_edge_ratio).epsilon(1e-14));
  }
  CHECK(at_scale(1e100).volume == Approx(1e300 / 3).epsilon(1e-14));
  CHECK(at_scale(1e-100).shortest_edge == Approx(std::sqrt(2.0) * 1e-100).epsilon(1e-14));
}

TEST_CASE("quality_of_a_box_is_that_of_its_one_tetrahedron") {
  const auto q = mesh::quality(tet_shelf::box(3, 2, 2));
  CHECK(q.min_dihedral_deg == Approx(45));
  CHECK(q.max_dihedral_deg == Approx(90));
  CHECK(q.mean_min_dihedral_deg == Approx(45));
  CHECK(q.min_volume == Approx(1.0 / 6));
  CHECK(q.max_volume == Approx(1.0 / 6));
  CHECK(q.mean_volume == Approx(1.0 / 6));
  CHECK(q.total_volume == Approx(12));
  CHECK(q.shortest_edge == Approx(1));
  CHECK(q.longest_edge == Approx(std::sqrt(3.0)));
  CHECK(q.max_size_growth == Approx(1));
}

TEST_CASE("histogram_counts_every_edge_of_every_tetrahedron_once_in_its_class") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const auto q = mesh::quality(entry.mesh);
    CHECK(std::accumulate(q.dihedral_histogram.begin(), q.dihedral_histogram.end(), std::size_t{0}) ==
          6 * entry.mesh.tet_count());
  }
  const auto q = mesh::quality(
      tet_shelf::build({{1, 0, 0.01}, {0, -1, -0.01}, {-1, 0, 0.01}, {0, 1, -0.01}}, {{0, 1, 2, 3}}));
  CHECK(q.dihedral_histogram[0] == 4);   // the sides of a sliver
  CHECK(q.dihedral_histogram[17] == 2);  // its diagonals
}

TEST_CASE("worst_tetrahedra_come_in_order_and_with_their_place") {
  const auto mesh = tet_shelf::build({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, 0, -1}, {4, 4, 0.25}},
                                     {{0, 1, 2, 3}, {0, 2, 1, 4}, {1, 5, 2, 3}});
  const auto q = mesh::quality(mesh, 2);
  REQUIRE(q.worst.size() == 2);
  CHECK(q.worst[0].figures.min_dihedral_deg == q.min_dihedral_deg);
  CHECK(q.worst[0].figures.min_dihedral_deg < q.worst[1].figures.min_dihedral_deg);
  CHECK(q.worst[0].tet == TetId{1});
  CHECK(q.worst[0].centroid == Point3{1, 1, -0.25});
  CHECK(mesh::quality(mesh, 99).worst.size() == 3);
}

TEST_CASE("size_growth_is_the_cube_root_of_the_ratio_of_neighbouring_volumes") {
  const auto mesh = tet_shelf::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -27}},
                                     {{0, 1, 2, 3}, {0, 2, 1, 4}});
  const auto q = mesh::quality(mesh);
  CHECK(q.max_size_growth == Approx(3).epsilon(1e-14));
  CHECK(q.fastest_growth[0] == MaybeId<TetId>(TetId{0}));
  CHECK(q.fastest_growth[1] == MaybeId<TetId>(TetId{1}));
}

TEST_CASE("quality_of_no_tetrahedra_is_zero") {
  const auto q = mesh::quality(TetMesh{});
  CHECK(q.max_dihedral_deg == 0);
  CHECK(q.worst.empty());
}
