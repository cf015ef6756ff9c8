// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/order/insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>
#include <utility>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {
namespace {

/// A well mixed hash of a position: what makes the rounds random.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace

Rounds rounds_of(std::size_t n, std::uint64_t seed) {
  // An eighth of the points comes before the last round, an eighth of these before the round before it, and
  // so on.
  constexpr std::size_t first_round = 500;
  constexpr unsigned bits_a_round = 3;
  const std::uint64_t shift = seed == 0 ? 0 : mixed(seed);
  unsigned last = 0;
  for (std::size_t left = n; left > first_round; left >>= bits_a_round) ++last;
  const auto round_of = [&](std::size_t i) {
    const auto zeros = static_cast<unsigned>(std::countr_zero(mixed(i ^ shift)));
    return last - std::min(last, zeros / bits_a_round);
  };
  Rounds rounds;
  std::vector<std::size_t>& begins = rounds.begins;
  begins.assign(last + 2, 0);
  for (std::size_t i = 0; i < n; ++i) ++begins[round_of(i) + 1];
  for (unsigned r = 0; r <= last; ++r) begins[r + 1] += begins[r];
  std::vector<std::size_t> next = begins;
  rounds.order.resize(n);
  for (std::size_t i = 0; i < n; ++i) rounds.order[next[round_of(i)]++] = static_cast<std::uint32_t>(i);
  return rounds;
}

std::vector<std::uint32_t> random_order(std::size_t n, std::uint64_t seed) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937_64 random(seed);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

bool bring_triangle_to_front(std::span<const Point2> points, std::vector<std::uint32_t>& order) {
  for (std::size_t k = 2; k < order.size(); ++k) {
    const Sign turn = kernel::orient2d(points[order[0]], points[order[1]], points[order[k]]);
    if (turn == Sign::zero) continue;
    // The points skipped keep their order, so that each next one stays close to the one before.
    std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(k),
                order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    if (turn == Sign::negative) std::swap(order[0], order[1]);
    return true;
  }
  return false;
}

}  // namespace leonhard::delaunay
