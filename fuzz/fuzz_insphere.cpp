// SPDX-License-Identifier: MIT
// insphere against rational arithmetic, and what the symbolic perturbation promises.
#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::fuzzing::report;

namespace {

using Quintuple = std::array<Point3, 5>;

Sign perturbed(const Quintuple& q) { return k::insphere_perturbed(q[0], q[1], q[2], q[3], q[4]); }

bool distinct(Quintuple q) {
  std::ranges::sort(q, [](const Point3& a, const Point3& b) { return a < b; });
  return std::ranges::adjacent_find(q) == q.end();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  Quintuple points;
  for (Point3& p : points) p = input.point3(kind);
  const auto& [a, b, c, d, e] = points;

  const Sign truth = k::exact::insphere(a, b, c, d, e);
  if (k::insphere(a, b, c, d, e) != truth) report("insphere is wrong", points);
  if (k::insphere_exact(a, b, c, d, e) != truth) report("insphere_exact is wrong", points);

  const Sign broken_tie = perturbed(points);
  if (truth != Sign::zero && broken_tie != truth) report("perturbation overrules insphere", points);
  if (broken_tie == Sign::zero && distinct(points) && k::orient3d(a, b, c, d) != Sign::zero)
    report("perturbation leaves a tie", points);
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j) {
      Quintuple swapped = points;
      std::swap(swapped[i], swapped[j]);
      if (perturbed(swapped) != -broken_tie) report("perturbation is not antisymmetric", points);
    }
  return 0;
}
