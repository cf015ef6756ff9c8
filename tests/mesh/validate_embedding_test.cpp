// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

std::string embedding_words(const TriangleMesh& mesh) {
  REQUIRE(mesh::validate(mesh).value_or("") == "");  // what is wrong here no local check can see
  return mesh::validate_embedding(mesh).value_or("");
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

using Triangle = std::array<Point2, 3>;

/// Whether the interiors of two counter-clockwise triangles meet: they do unless an edge of one has the other
/// wholly on its right.
bool interiors_meet(const Triangle& s, const Triangle& t) {
  for (const auto& [a, b] : {std::pair(&s, &t), std::pair(&t, &s)}) {
    for (std::size_t i = 0; i < 3; ++i) {
      bool apart = true;
      for (const Point2 p : *b) {
        apart = apart && kernel::orient2d((*a)[i], (*a)[(i + 1) % 3], p) != Sign::positive;
      }
      if (apart) return false;
    }
  }
  return true;
}

/// Whether a corner of t lies inside an edge of s, ends excluded.
bool corner_inside_edge(const Triangle& s, const Triangle& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 a = std::min(s[i], s[(i + 1) % 3]), b = std::max(s[i], s[(i + 1) % 3]);
    for (const Point2 p : t) {
      if (kernel::orient2d(a, b, p) == Sign::zero && a < p && p < b) return true;
    }
  }
  return false;
}

TriangleMesh soup(const std::vector<Triangle>& triangles) {
  std::vector<Point2> points;
  std::vector<shelf::Corners> corners;
  for (const Triangle& t : triangles) {
    corners.push_back({points.size(), points.size() + 1, points.size() + 2});
    points.insert(points.end(), t.begin(), t.end());
  }
  return shelf::build(points, corners);
}

/// A strip of triangles along a spiral of the given number of turns, its radius growing from r0 to r1.
TriangleMesh spiral(double turns, double r0, double r1, double width) {
  std::vector<Point2> points;
  std::vector<shelf::Corners> triangles;
  const std::size_t n = 60;
  for (std::size_t i = 0; i <= n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n);
    const double angle = 2 * std::numbers::pi * turns * s, r = r0 + (r1 - r0) * s;
    for (const double radius : {r, r + width})
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    if (i == n) break;
    triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
    triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
  }
  return shelf::build(points, triangles);
}

}  // namespace

TEST_CASE("embedding_of_every_mesh_on_the_shelf_is_proper") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    CHECK(embedding_words(mesh) == "");
  }
}

TEST_CASE("embedding_sees_a_fan_that_winds_twice") {
  std::vector<Point2> points{{0, 0}};
  std::vector<shelf::Corners> triangles;
  for (std::size_t i = 0; i < 10; ++i) {
    const double angle = 4 * std::numbers::pi * static_cast<double>(i) / 10;
    points.push_back({std::cos(angle), std::sin(angle)});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 10});
  }
  const std::string words = embedding_words(shelf::build(points, triangles));
  CHECK(contains(words, "vertex 0 at (0, 0) overlap"));
}

TEST_CASE("embedding_sees_a_strip_that_runs_over_itself_and_takes_one_that_spirals_past_itself") {
  CHECK(embedding_words(spiral(0.9, 1, 1, 1)) == "");
  CHECK(embedding_words(spiral(2.5, 1, 6, 1)) == "");
  CHECK(embedding_words(spiral(1.4, 1, 1.1, 1)) != "");
  CHECK(embedding_words(spiral(2.5, 1, 4, 1.5)) != "");
}

TEST_CASE("embedding_sees_a_component_that_lies_on_another_without_touching_its_boundary") {
  std::vector<Point2> points;
  std::vector<shelf::Corners> triangles;
  shelf::add_disc(points, triangles, {0, 0}, 10, 6);
  shelf::add_disc(points, triangles, {1, 1}, 0.5, 6);
  CHECK(contains(embedding_words(shelf::build(points, triangles)), "triangles overlap at boundary edge"));
}

TEST_CASE("embedding_names_two_boundary_edges_that_cross") {
  const auto mesh = soup({{{{0, 0}, {4, 0}, {0, 4}}}, {{{-1, 1}, {5, 1}, {-1, 2}}}});
  const std::string words = embedding_words(mesh);
  CHECK(contains(words, "crosses"));
  CHECK(contains(words, "of triangle 0"));
  CHECK(contains(words, "of triangle 1"));
}

TEST_CASE("embedding_takes_slits_and_reports_hanging_nodes") {
  // Two squares side by side whose common edge stands twice in the list of vertices: a slit.
  CHECK(embedding_words(shelf::build({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}},
                                     {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}})) == "");
  // The right square has one vertex more on the common edge.
  const std::string words =
      embedding_words(shelf::build({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}},
                                   {{0, 1, 2}, {0, 2, 3}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}}));
  CHECK(contains(words, "boundary edge 1-2"));
  CHECK(contains(words, "lie on one another"));
  // A triangle whose corner stands on the middle of a square's side.
  CHECK(contains(embedding_words(shelf::build({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0.5}, {2, 0}, {2, 1}},
                                              {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}})),
                 "boundary vertex at (1, 0.5) lies inside boundary edge 1-2"));
}

// Oracle: all pairs. Small integer coordinates make touching, collinear and coinciding edges frequent.
TEST_CASE("embedding_of_random_triangle_soups_agrees_with_all_pairs") {
  std::mt19937 random(7);
  int proper = 0, overlapping = 0, hanging = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const int range = 4 + static_cast<int>(random() % 5);
    std::vector<Triangle> triangles;
    const std::size_t count = 2 + random() % 3;
    while (triangles.size() < count) {
      Triangle t;
      for (Point2& p : t) {
        p = {static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(range))),
             static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(range)))};
      }
      const Sign turn = kernel::orient2d(t[0], t[1], t[2]);
      if (turn == Sign::negative) std::swap(t[1], t[2]);
      if (turn != Sign::zero) triangles.push_back(t);
    }
    bool overlap = false, hang = false;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        overlap = overlap || interiors_meet(triangles[i], triangles[j]);
        hang = hang || corner_inside_edge(triangles[i], triangles[j]) ||
               corner_inside_edge(triangles[j], triangles[i]);
      }
    }
    const std::string words = mesh::validate_embedding(soup(triangles)).value_or("");
    CAPTURE(trial);
    CAPTURE(words);
    REQUIRE((words != "") == (overlap || hang));
    ++(overlap ? overlapping : hang ? hanging : proper);
  }
  CHECK(proper > 1000);
  CHECK(overlapping > 1000);
  CHECK(hanging > 300);
}

TEST_CASE("embedding_of_random_grids_with_holes_is_proper_and_a_shifted_copy_is_not") {
  std::mt19937 random(99);
  for (int trial = 0; trial < 50; ++trial) {
    const shelf::Grid g(8, 8);
    std::vector<bool> keep(g.triangles.size());
    for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = random() % 4 != 0;
    CHECK(embedding_words(shelf::build_kept(g.points, g.triangles, keep)) == "");

    auto points = g.points;
    auto triangles = g.triangles;
    for (const Point2 p : g.points) points.push_back({p.x + 7.25, p.y + 0.125});
    for (const auto& t : g.triangles) {
      triangles.push_back({t[0] + g.points.size(), t[1] + g.points.size(), t[2] + g.points.size()});
    }
    CHECK(embedding_words(shelf::build(points, triangles)) != "");
  }
}
