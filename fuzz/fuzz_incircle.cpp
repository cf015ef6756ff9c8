// SPDX-License-Identifier: MIT
// incircle against rational arithmetic, and what the symbolic perturbation promises.
#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Sign;
using leonhard::fuzzing::report;

namespace {

using Quadruple = std::array<Point2, 4>;

Sign perturbed(const Quadruple& q) { return k::incircle_perturbed(q[0], q[1], q[2], q[3]); }

bool distinct(Quadruple q) {
  std::ranges::sort(q, [](const Point2& a, const Point2& b) { return a < b; });
  return std::ranges::adjacent_find(q) == q.end();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  Quadruple points;
  for (Point2& p : points) p = input.point(kind);
  const auto [a, b, c, d] = points;

  const Sign truth = k::exact::incircle(a, b, c, d);
  if (k::incircle(a, b, c, d) != truth) report("incircle is wrong", points);
  if (k::incircle_exact(a, b, c, d) != truth) report("incircle_exact is wrong", points);

  const Sign broken_tie = perturbed(points);
  if (truth != Sign::zero && broken_tie != truth) report("perturbation overrules incircle", points);
  if (broken_tie == Sign::zero && distinct(points) && k::orient2d(a, b, c) != Sign::zero)
    report("perturbation leaves a tie", points);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      Quadruple swapped = points;
      std::swap(swapped[i], swapped[j]);
      if (perturbed(swapped) != -broken_tie) report("perturbation is not antisymmetric", points);
    }
  return 0;
}
