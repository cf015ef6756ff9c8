// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/crossings.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "leonhard/delaunay/refine.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"

using namespace leonhard;
using namespace leonhard::delaunay;

namespace {

Pslg graph_of(std::vector<Point2> points, const std::vector<std::pair<std::size_t, std::size_t>>& segments) {
  Pslg pslg;
  pslg.points = std::move(points);
  for (const auto& [from, to] : segments) pslg.segments.push_back({from, to, 0});
  pslg.source = "test.poly";
  return pslg;
}

/// Two ends a segment.
Pslg soup(std::size_t count, const auto& coordinate) {
  Pslg pslg;
  for (std::size_t i = 0; i < count; ++i) {
    pslg.points.push_back({coordinate(), coordinate()});
    pslg.points.push_back({coordinate(), coordinate()});
    pslg.segments.push_back({2 * i, 2 * i + 1, static_cast<Marker>(i + 1)});
  }
  pslg.source = "soup";
  return pslg;
}

Pslg grid_soup(std::mt19937_64& random, std::size_t count, int grid) {
  return soup(count, [&] { return static_cast<double>(random() % static_cast<unsigned>(grid)); });
}
Pslg real_soup(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> unit(0, 1);
  return soup(count, [&] { return unit(random); });
}

/// Twice the signed area of abc in rational numbers.
int turn(Point2 a, Point2 b, Point2 c) {
  const mpq_class ax(a.x), ay(a.y);
  return sgn((mpq_class(b.x) - ax) * (mpq_class(c.y) - ay) - (mpq_class(b.y) - ay) * (mpq_class(c.x) - ax));
}

std::vector<std::array<std::size_t, 2>> crossings_by_force(const Pslg& pslg) {
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < pslg.segments.size(); ++i)
    for (std::size_t j = i + 1; j < pslg.segments.size(); ++j) {
      const Point2 a = pslg.points[pslg.segments[i].from], b = pslg.points[pslg.segments[i].to];
      const Point2 c = pslg.points[pslg.segments[j].from], d = pslg.points[pslg.segments[j].to];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) pairs.push_back({i, j});
    }
  return pairs;
}

TriangulateOptions whole_hull(Crossings crossings) {
  TriangulateOptions options;
  options.keep_convex_hull = true;
  options.crossings = crossings;
  return options;
}

/// Whether marked edges lead from one point of a segment to the other, none farther from it than the tolerance.
bool is_there(const TriangleMesh& mesh, const std::map<VertexId, std::vector<VertexId>>& marked, VertexId from, VertexId to,
              double tolerance) {
  const Point2 a = mesh.points[from], b = mesh.points[to];
  const double length = distance(a, b);
  const auto is_near = [&](Point2 p) {
    const double along = ((b.x - a.x) * (p.x - a.x) + (b.y - a.y) * (p.y - a.y)) / length;
    const double off = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
    return std::abs(off) <= tolerance && along >= -tolerance && along <= length + tolerance;
  };
  std::set<VertexId> seen{from};
  std::vector<VertexId> stack{from};
  while (!stack.empty() && !seen.contains(to)) {
    const VertexId v = stack.back();
    stack.pop_back();
    if (!marked.contains(v)) continue;
    for (const VertexId next : marked.at(v))
      if (is_near(mesh.points[next]) && seen.insert(next).second) stack.push_back(next);
  }
  return seen.contains(to);
}

void check_split(const Pslg& pslg, double tolerance) {
  const Triangulation result = triangulate(pslg, whole_hull(Crossings::split));
  if (result.outcome != TriangulateOutcome::done) return;
  CHECK(!mesh::validate(result.mesh));
  CHECK(!mesh::validate_embedding(result.mesh));
  CHECK(!mesh::validate_delaunay(result.mesh));
  REQUIRE(result.vertex_of_input.size() == pslg.points.size());
  REQUIRE(result.segments.boundary.size() == result.mesh.boundary.size());
  REQUIRE(result.segments.constraints.size() == result.mesh.constraints.size());
  std::map<VertexId, std::vector<VertexId>> marked;
  const auto add = [&](const MarkedEdge& edge, MaybeId<SegmentId> segment) {
    if (!segment) return;
    REQUIRE((*segment).index() < pslg.segments.size());
    marked[edge.from].push_back(edge.to);
    marked[edge.to].push_back(edge.from);
  };
  for (std::size_t i = 0; i < result.mesh.boundary.size(); ++i) add(result.mesh.boundary[i], result.segments.boundary[i]);
  for (std::size_t i = 0; i < result.mesh.constraints.size(); ++i) add(result.mesh.constraints[i], result.segments.constraints[i]);
  for (std::size_t i = 0; i < pslg.points.size(); ++i) CHECK(result.mesh.points[*result.vertex_of_input[i]] == pslg.points[i]);
  for (const Pslg::Segment& s : pslg.segments) {
    const VertexId from = *result.vertex_of_input[s.from], to = *result.vertex_of_input[s.to];
    if (from != to) CHECK(is_there(result.mesh, marked, from, to, tolerance));
  }
}

}  // namespace

TEST_CASE("crossings_are_those_of_rational_arithmetic") {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Pslg pslg = trial % 2 == 0 ? grid_soup(random, 30, 2 + trial % 9) : real_soup(random, 30);
    const std::vector<std::array<std::size_t, 2>> expected = crossings_by_force(pslg);
    const std::vector<Crossing> found = find_crossings(pslg);
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k].one == expected[k][0]);
      CHECK(found[k].other == expected[k][1]);
    }
  }
}

TEST_CASE("two_diagonals_of_a_square_meet_in_a_new_vertex") {
  Pslg pslg = graph_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}});
  pslg.segments[4].marker = 8;
  TriangulateOptions options;
  options.crossings = Crossings::split;
  const Triangulation result = triangulate(pslg, options);
  REQUIRE(result.crossings.size() == 1);
  CHECK(result.crossings[0].one == 4);
  CHECK(result.crossings[0].other == 5);
  CHECK(result.crossings[0].point == Point2{0.5, 0.5});
  CHECK(result.crossings[0].error <= 0x1p-54);
  CHECK(result.mesh.triangle_count() == 4);
  REQUIRE(result.mesh.constraints.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(result.mesh.constraints[i].marker == (result.segments.constraints[i] == SegmentId::from(4) ? 8 : 0));
  CHECK(result.repairs == std::vector<std::string>{"segments 4 and 5 cross at (0.5, 0.5): a point was added there (counted from 0)"});
}

TEST_CASE("segments_of_any_soup_are_in_the_mesh") {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 120; ++trial) {
    check_split(grid_soup(random, 5 + trial % 40, 3 + trial % 7), 1e-13);
    check_split(real_soup(random, 5 + trial % 60), 1e-14);
  }
}

TEST_CASE("segments_through_nearly_one_point_are_in_the_mesh") {
  // Their crossings are nearer to each other than doubles can tell: the rounded pieces cross again.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 40; ++trial) {
    Pslg pslg;
    for (std::size_t i = 0; i < 24; ++i) {
      const double angle = std::numbers::pi * unit(random), reach = 1 + unit(random);
      const Vec2 way{std::cos(angle), std::sin(angle)};
      const Point2 centre{1.0 / 3, 1.0 / 7};
      pslg.points.push_back(centre + reach * way);
      pslg.points.push_back(centre + -reach * way);
      pslg.segments.push_back({2 * i, 2 * i + 1, 0});
    }
    check_split(pslg, 1e-15);
  }
}

TEST_CASE("the_split_mesh_does_not_depend_on_the_order_of_the_segments") {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Pslg pslg = real_soup(random, 40);
    const Fingerprint expected = mesh::fingerprint(triangulate(pslg, whole_hull(Crossings::split)).mesh);
    std::ranges::shuffle(pslg.segments, random);
    for (Pslg::Segment& s : pslg.segments)
      if (random() % 2 == 0) std::swap(s.from, s.to);
    CHECK(mesh::fingerprint(triangulate(pslg, whole_hull(Crossings::split)).mesh) == expected);
  }
}

TEST_CASE("segments_that_cross_are_refused_all_by_name") {
  const Pslg pslg = graph_of({{0, 0}, {4, 0}, {1, -1}, {1, 4}, {3, -1}, {3, 4}}, {{0, 1}, {2, 3}, {4, 5}});
  try {
    (void)triangulate(pslg);
    FAIL("was taken");
  } catch (const InputError& error) {
    CHECK(error.where() == "test.poly");
    CHECK(error.problem() ==
          "segment 0 (point 0 at (0, 0) to point 1 at (4, 0)) and segment 1 (point 2 at (1, -1) to point 3 at (1, 4)) cross at (1, 0), "
          "segment 0 (point 0 at (0, 0) to point 1 at (4, 0)) and segment 2 (point 4 at (3, -1) to point 5 at (3, 4)) cross at (3, 0)");
  }
}

TEST_CASE("of_two_segments_that_cross_the_later_one_is_left_out") {
  // 1 crosses 0 and is left out, 2 crosses 1 alone and stays.
  const Pslg pslg = graph_of({{0, 0}, {4, 0}, {1, -1}, {1, 4}, {0, 2}, {4, 2}}, {{0, 1}, {2, 3}, {4, 5}});
  const Triangulation result = triangulate(pslg, whole_hull(Crossings::skip));
  CHECK(result.repairs == std::vector<std::string>{"segment 1 left out: it crosses an earlier one (counted from 0)"});
  std::vector<std::size_t> there;
  for (const auto& list : {result.segments.boundary, result.segments.constraints})
    for (const MaybeId<SegmentId> s : list)
      if (s) there.push_back((*s).index());
  std::ranges::sort(there);
  CHECK(there == std::vector<std::size_t>{0, 2});
}

TEST_CASE("a_stop_while_crossings_are_looked_for_is_an_outcome") {
  std::mt19937_64 random(9);
  std::stop_source stop;
  TriangulateOptions options = whole_hull(Crossings::split);
  options.progress.stop = stop.get_token();
  options.progress.report = [&](std::string_view stage, double) {
    if (stage == "cross") stop.request_stop();
  };
  const Triangulation result = triangulate(real_soup(random, 60), options);
  CHECK(stop.stop_requested());
  CHECK(result.outcome == TriangulateOutcome::stopped);
}

TEST_CASE("a_pentagram_is_meshed_with_its_crossings_as_vertices") {
  std::vector<Point2> tips;
  for (int i = 0; i < 5; ++i) tips.push_back({std::cos(0.4 * i * std::numbers::pi), std::sin(0.4 * i * std::numbers::pi)});
  const Pslg pslg = graph_of(tips, {{0, 2}, {2, 4}, {4, 1}, {1, 3}, {3, 0}});
  RefineOptions options;
  options.crossings = Crossings::split;
  options.max_area = 0.01;
  const RefinedMesh result = mesh_pslg(pslg, options);
  CHECK(result.crossings.size() == 5);
  CHECK(!mesh::validate(result.mesh));
  CHECK(!mesh::validate_delaunay(result.mesh));
  for (const Crossing& crossing : result.crossings)
    CHECK(std::ranges::count(result.mesh.points, crossing.point) == 1);
  double area = 0;  // (5/2) r R sin(36 degrees) twice: tips at radius 1, crossings at cos(72) / cos(36)
  for (const TriangleId t : result.mesh.corners.ids()) {
    const auto [a, b, c] = result.mesh.corners[t];
    const Point2 p = result.mesh.points[a], q = result.mesh.points[b], r = result.mesh.points[c];
    area += 0.5 * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
  }
  const double inner = std::cos(0.4 * std::numbers::pi) / std::cos(0.2 * std::numbers::pi);
  CHECK(area == doctest::Approx(5 * inner * std::sin(0.2 * std::numbers::pi)).epsilon(1e-12));
}
