// SPDX-License-Identifier: MIT
// The predicates of weighted points against rational arithmetic, in the plane and in space, and what the
// symbolic perturbation promises.
#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/power.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Sign;
using leonhard::WeightedPoint2;
using leonhard::WeightedPoint3;

namespace {

/// Prints points and weights as C++ and ends the program.
template <class Points>
[[noreturn]] void report(const char* broken, const Points& points) {
  std::fprintf(stderr, "\nweights ");
  std::vector<decltype(points[0].point)> coordinates;
  for (const auto& p : points) {
    std::fprintf(stderr, "%a, ", p.weight);
    coordinates.push_back(p.point);
  }
  leonhard::fuzzing::report(broken, coordinates);
}

template <class Points>
bool distinct(const Points& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (points[i].point == points[j].point) return false;
  return true;
}

/// flat  the points but for the last lie on a line or plane
template <class Points, class Perturbed>
void check_perturbed(const Points& points, Sign truth, bool flat, Perturbed perturbed) {
  const Sign broken_tie = perturbed(points);
  if (truth != Sign::zero && broken_tie != truth) report("perturbation overrules power_test", points);
  if (broken_tie == Sign::zero && distinct(points) && !flat) report("perturbation leaves a tie", points);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      Points swapped = points;
      std::swap(swapped[i], swapped[j]);
      if (perturbed(swapped) != -broken_tie) report("perturbation is not antisymmetric", points);
    }
}

void check(const std::array<WeightedPoint2, 4>& points) {
  const auto& [a, b, c, d] = points;
  const Sign truth = k::exact::power_test(a, b, c, d);
  if (k::power_test(a, b, c, d) != truth) report("power_test is wrong", points);
  if (k::power_test_exact(a, b, c, d) != truth) report("power_test_exact is wrong", points);
  const Sign nearer = k::exact::compare_power_distance(a.point, b, c);
  if (k::compare_power_distance(a.point, b, c) != nearer) report("compare_power_distance is wrong", points);
  check_perturbed(points, truth, k::orient2d(a.point, b.point, c.point) == Sign::zero,
                  [](const auto& q) { return k::power_test_perturbed(q[0], q[1], q[2], q[3]); });
}

void check(const std::array<WeightedPoint3, 5>& points) {
  const auto& [a, b, c, d, e] = points;
  const Sign truth = k::exact::power_test(a, b, c, d, e);
  if (k::power_test(a, b, c, d, e) != truth) report("power_test is wrong", points);
  if (k::power_test_exact(a, b, c, d, e) != truth) report("power_test_exact is wrong", points);
  const Sign nearer = k::exact::compare_power_distance(a.point, b, c);
  if (k::compare_power_distance(a.point, b, c) != nearer) report("compare_power_distance is wrong", points);
  check_perturbed(points, truth, k::orient3d(a.point, b.point, c.point, d.point) == Sign::zero,
                  [](const auto& q) { return k::power_test_perturbed(q[0], q[1], q[2], q[3], q[4]); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>(), weight_kind = input.take<std::uint8_t>();
  if (weight_kind % 2 == 0) {
    std::array<WeightedPoint2, 4> points;
    for (WeightedPoint2& p : points) p.point = input.point(kind);
    for (WeightedPoint2& p : points) p.weight = input.coordinate(weight_kind / 2);
    check(points);
  } else {
    std::array<WeightedPoint3, 5> points;
    for (WeightedPoint3& p : points) p.point = input.point3(kind);
    for (WeightedPoint3& p : points) p.weight = input.coordinate(weight_kind / 2);
    check(points);
  }
  return 0;
}
