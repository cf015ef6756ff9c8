// SPDX-License-Identifier: MIT
#include "leonhard/kernel/insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "leonhard/kernel/hilbert.hpp"

namespace leonhard::kernel {
namespace {

/// Random bits of a number: the output function of splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t scrambled(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// Stable sort of an order into rounds: a point is in the last one with probability 1/2, else in the last but one with
/// probability 1/2, and so on; the first round takes what is left.
std::vector<std::uint32_t> in_rounds(const std::vector<std::uint32_t>& order, std::uint64_t seed) {
  const auto rounds = static_cast<unsigned>(std::bit_width(order.size()));
  const auto round_of = [=](std::uint32_t index) {
    const std::uint64_t coins = scrambled(scrambled(seed) + (std::uint64_t{index} + 1) * 0x9e3779b97f4a7c15);
    return rounds - std::min(rounds, static_cast<unsigned>(std::countr_zero(coins)));
  };
  std::vector<std::size_t> begins(std::size_t{rounds} + 1);
  for (const std::uint32_t index : order) ++begins[round_of(index)];
  std::size_t begin = 0;
  for (std::size_t& count : begins) begin += std::exchange(count, begin);
  std::vector<std::uint32_t> sorted(order.size());
  for (const std::uint32_t index : order) sorted[begins[round_of(index)]++] = index;
  return sorted;
}

}  // namespace

std::vector<std::uint32_t> brio_order(std::span<const Point2> points, std::uint64_t seed) {
  return in_rounds(hilbert_order(points), seed);
}
std::vector<std::uint32_t> brio_order(std::span<const Point3> points, std::uint64_t seed) {
  return in_rounds(hilbert_order(points), seed);
}

}  // namespace leonhard::kernel
