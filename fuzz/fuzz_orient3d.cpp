// SPDX-License-Identifier: MIT
// The predicates of three and four points of space against rational arithmetic.
#include <array>
#include <cstddef>
#include <utility>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::fuzzing::report;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  std::array<Point3, 4> points;
  for (Point3& p : points) p = input.point3(kind);
  const auto& [a, b, c, d] = points;

  const auto truth = k::exact::orient3d(a, b, c, d);
  if (k::orient3d(a, b, c, d) != truth) report("orient3d is wrong", points);
  if (k::orient3d_exact(a, b, c, d) != truth) report("orient3d_exact is wrong", points);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      std::array<Point3, 4> swapped = points;
      std::swap(swapped[i], swapped[j]);
      if (k::orient3d(swapped[0], swapped[1], swapped[2], swapped[3]) != -truth)
        report("orient3d is not antisymmetric", points);
    }

  const auto inside = k::exact::in_diametral_sphere(a, b, c);
  if (k::in_diametral_sphere(a, b, c) != inside) report("in_diametral_sphere is wrong", points);
  if (k::in_diametral_sphere_exact(a, b, c) != inside) report("in_diametral_sphere_exact is wrong", points);

  const auto farther = k::exact::compare_distance(a, b, c);
  if (k::compare_distance(a, b, c) != farther) report("compare_distance is wrong", points);
  if (k::compare_distance_exact(a, b, c) != farther) report("compare_distance_exact is wrong", points);
  return 0;
}
