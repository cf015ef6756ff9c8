// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/sizing.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::GradedSizing;

std::vector<GradedSizing::Source> random_sources(std::size_t n) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> spacing(1e-4, 0.3);
  std::vector<GradedSizing::Source> sources;
  for (const Point2 p : shapes::uniform(n, 12)) sources.push_back({p, spacing(random)});
  return sources;
}

double brute_force(const std::vector<GradedSizing::Source>& sources, double growth, double max_size,
                   Point2 p) {
  double best = max_size;
  for (const GradedSizing::Source& s : sources) best = std::min(best, s.spacing + growth * norm(p - s.at));
  return best;
}

TEST_CASE("the_field_is_the_minimum_over_all_sources") {
  const std::vector<GradedSizing::Source> sources = random_sources(500);
  for (const double growth : {0.0, 0.05, 0.3, 4.0}) {
    const GradedSizing field(sources, growth, 0.4);
    for (const Point2 q : shapes::transformed(shapes::uniform(400, 13), 3, -1))
      CHECK(field(q) == doctest::Approx(brute_force(sources, growth, 0.4, q)).epsilon(1e-14));
  }
}

TEST_CASE("a_field_without_sources_is_its_largest_size") {
  CHECK(GradedSizing({}, 0.2, 7.5)({1, 2}) == 7.5);
  CHECK(GradedSizing({{{0, 0}, 0.5}}, 0.2, std::numeric_limits<double>::infinity())({3, 4}) ==
        doctest::Approx(1.5));
}

TEST_CASE("sources_at_one_place_are_fine") {
  const GradedSizing field(std::vector<GradedSizing::Source>(1000, {{1, 1}, 0.25}), 1, 10);
  CHECK(field({1, 1}) == 0.25);
}

TEST_CASE("impossible_sizes_are_refused") {
  CHECK_THROWS_AS(GradedSizing({}, -1, 1), InputError);
  CHECK_THROWS_AS(GradedSizing({}, 0.1, 0), InputError);
  CHECK_THROWS_WITH_AS(GradedSizing({{{0, 0}, 1}, {{2, 3}, -1}}, 0.1, 1),
                       doctest::Contains("source 1 at (2, 3)"), InputError);
}

}  // namespace
}  // namespace leonhard
