// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/algorithm.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <stop_token>

#include "leonhard/delaunay/triangulate.hpp"
#include "tests/delaunay/shapes.hpp"

/// Claims that hold for every algorithm of delaunay::named_algorithms.
namespace leonhard {
namespace {

using delaunay::AlgorithmOptions;
using delaunay::named_algorithms;
using delaunay::NamedAlgorithm;
using delaunay::PointTriangulation;
using delaunay::TriangulateOutcome;

std::vector<shapes::NamedPoints> all_sets() {
  std::vector<shapes::NamedPoints> all = shapes::families();
  for (shapes::NamedPoints& set : shapes::distributions()) all.push_back(std::move(set));
  return all;
}

Fingerprint fingerprint_by(const NamedAlgorithm& named, const std::vector<Point2>& points, std::uint64_t seed,
                           unsigned threads = 1) {
  delaunay::TriangulateOptions options;
  options.algorithm = named.algorithm;
  options.seed = seed;
  options.threads = threads;
  return mesh::fingerprint(delaunay::triangulate(points, options).mesh);
}

using Corners = std::array<Point2, 3>;

/// The real triangles by their corners' coordinates, sorted.
std::vector<Corners> real_triangles(const PointTriangulation& of, std::span<const Point2> points) {
  std::vector<Corners> all;
  for (const delaunay::AnyTriangleId t : of.triangulation.triangles()) {
    if (of.triangulation.is_ghost(t)) continue;
    Corners corners;
    for (unsigned k = 0; k < 3; ++k) corners[k] = points[of.triangulation.corner(t, k).index()];
    std::sort(corners.begin(), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST_CASE("every_algorithm_gives_the_same_fingerprint_of_shuffled_points") {
  for (const shapes::NamedPoints& set : all_sets()) {
    CAPTURE(set.name);
    const TriangleMesh mesh = delaunay::triangulate(set.points).mesh;
    shapes::require_valid(mesh);
    const Fingerprint expected = mesh::fingerprint(mesh);
    for (const NamedAlgorithm& named : named_algorithms) {
      CAPTURE(named.name);
      CHECK(fingerprint_by(named, set.points, 1) == expected);
      CHECK(fingerprint_by(named, shapes::shuffled(set.points, 2), 2, 2) == expected);
    }
  }
}

// delaunay::triangulate brings the points into the order of a curve; here the algorithms take them as they
// come.
TEST_CASE("every_algorithm_gives_the_same_triangles_of_points_in_any_order") {
  for (const shapes::NamedPoints& set : all_sets()) {
    CAPTURE(set.name);
    const std::vector<Point2> sorted = shapes::distinct(set.points), shuffled = shapes::shuffled(sorted, 3);
    const std::vector<Corners> expected =
        real_triangles(delaunay::triangulate_distinct(sorted, delaunay::Algorithm::fast, {}), sorted);
    for (const NamedAlgorithm& named : named_algorithms) {
      CAPTURE(named.name);
      for (const std::vector<Point2>& points : {sorted, shuffled}) {
        const PointTriangulation result = delaunay::triangulate_distinct(points, named.algorithm, {});
        REQUIRE(result.outcome == TriangulateOutcome::done);
        CHECK_FALSE(result.triangulation.validate());
        CHECK(real_triangles(result, points) == expected);
      }
    }
  }
}

TEST_CASE("every_algorithm_names_points_that_span_no_triangle") {
  std::vector<Point2> level, upright, steep;
  for (int i = 0; i < 700; ++i) {
    level.push_back({0.1 * i, 0.3});
    upright.push_back({-7, 1e-3 * i});
    steep.push_back({static_cast<double>(3 * i), static_cast<double>(-7 * i)});
  }
  for (const NamedAlgorithm& named : named_algorithms) {
    CAPTURE(named.name);
    const auto outcome = [&](const std::vector<Point2>& points) {
      const PointTriangulation result = delaunay::triangulate_distinct(points, named.algorithm, {});
      CHECK((result.outcome == TriangulateOutcome::done || result.triangulation.triangle_count() == 0));
      return result.outcome;
    };
    CHECK(outcome({}) == TriangulateOutcome::too_few_points);
    CHECK(outcome({{1, 2}}) == TriangulateOutcome::too_few_points);
    CHECK(outcome({{1, 2}, {3, 4}}) == TriangulateOutcome::too_few_points);
    CHECK(outcome({{1, 2}, {3, 4}, {2, 3}}) == TriangulateOutcome::all_collinear);
    for (std::vector<Point2> line : {level, upright, steep}) {
      CHECK(outcome(line) == TriangulateOutcome::all_collinear);
      CHECK(outcome(shapes::shuffled(line, 1)) == TriangulateOutcome::all_collinear);
      line.push_back({20, 20});
      CHECK(outcome(line) == TriangulateOutcome::done);
    }
  }
}

TEST_CASE("every_algorithm_obeys_a_stop_request") {
  const std::vector<Point2> points = shapes::uniform(20'000);
  for (const NamedAlgorithm& named : named_algorithms) {
    CAPTURE(named.name);
    std::stop_source source;
    std::size_t reports = 0;
    AlgorithmOptions options;
    options.progress.stop = source.get_token();
    options.progress.report = [&](std::string_view, double fraction) {
      CHECK((fraction >= 0 && fraction <= 1));
      if (++reports == 2) source.request_stop();
    };
    const PointTriangulation result = delaunay::triangulate_distinct(points, named.algorithm, options);
    CHECK(result.outcome == TriangulateOutcome::stopped);
    CHECK(result.triangulation.triangle_count() == 0);
    CHECK(delaunay::triangulate_distinct(points, named.algorithm, options).outcome ==
          TriangulateOutcome::stopped);
  }
}

TEST_CASE("every_algorithm_has_one_word") {
  for (const NamedAlgorithm& named : named_algorithms) {
    CHECK(delaunay::algorithm_named(named.name) == named.algorithm);
    CHECK(std::count_if(named_algorithms.begin(), named_algorithms.end(), [&](const NamedAlgorithm& other) {
            return other.name == named.name || other.algorithm == named.algorithm;
          }) == 1);
  }
  CHECK_FALSE(delaunay::algorithm_named("quickest"));
}

}  // namespace
}  // namespace leonhard
