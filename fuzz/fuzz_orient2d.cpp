// SPDX-License-Identifier: MIT
// The predicates of three points against rational arithmetic.
#include <array>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::fuzzing::report;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  std::array<Point2, 3> points;
  for (Point2& p : points) p = input.point(kind);
  const auto [a, b, c] = points;

  const auto truth = k::exact::orient2d(a, b, c);
  if (k::orient2d(a, b, c) != truth) report("orient2d is wrong", points);
  if (k::orient2d_exact(a, b, c) != truth) report("orient2d_exact is wrong", points);
  if (k::orient2d(b, a, c) != -truth) report("orient2d is not antisymmetric", points);

  const auto inside = k::exact::in_diametral_circle(a, b, c);
  if (k::in_diametral_circle(a, b, c) != inside) report("in_diametral_circle is wrong", points);
  if (k::in_diametral_circle_exact(a, b, c) != inside) report("in_diametral_circle_exact is wrong", points);

  const auto farther = k::exact::compare_distance(a, b, c);
  if (k::compare_distance(a, b, c) != farther) report("compare_distance is wrong", points);
  if (k::compare_distance_exact(a, b, c) != farther) report("compare_distance_exact is wrong", points);
  return 0;
}
