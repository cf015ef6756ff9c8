// SPDX-License-Identifier: MIT
// hilbert_order of any finite points is a permutation, and repeated points stay together.
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/hilbert.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::fuzzing::report;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  std::vector<Point2> points;
  while (!input.empty()) points.push_back(input.point(kind));

  const std::vector<std::uint32_t> order = k::hilbert_order(points);
  if (order.size() != points.size()) report("hilbert_order has the wrong length", points);
  std::vector<bool> seen(points.size());
  for (const std::uint32_t i : order) {
    if (i >= points.size() || seen[i]) report("hilbert_order is no permutation", points);
    seen[i] = true;
  }
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i]] == points[order[i - 1]] && order[i] < order[i - 1])
      report("hilbert_order takes equal points out of order", points);
  return 0;
}
