// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::vector<std::uint32_t> invert(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> new_of_old(order.size(), none);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t old = order[i];
    if (old >= order.size() || new_of_old[old] != none)
      throw InputError("order",
                       "number " + std::to_string(old) + " at position " + std::to_string(i) +
                           (old >= order.size() ? " is out of range" : " is repeated"),
                       "give each of 0 ... " + std::to_string(order.size() - 1) + " once");
    new_of_old[old] = static_cast<std::uint32_t>(i);
  }
  return new_of_old;
}

void detail::check_order(const CsrGraph& graph, std::span<const std::uint32_t> order) {
  if (order.size() != vertex_count(graph))
    throw InputError(
        "order",
        std::to_string(order.size()) + " numbers for " + std::to_string(vertex_count(graph)) + " vertices",
        "give one a vertex");
  static_cast<void>(invert(order));
}

std::vector<std::uint32_t> detail::better_direction(const CsrGraph& graph, std::vector<std::uint32_t> order) {
  const std::vector<std::uint32_t> new_of_old = invert(order);
  std::uint64_t forwards = 0, backwards = 0;  // envelopes
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    std::uint32_t first = i, last = i;
    for (const std::uint32_t w : neighbours(graph, order[i])) {
      first = std::min(first, new_of_old[w]);
      last = std::max(last, new_of_old[w]);
    }
    forwards += i - first;
    backwards += last - i;
  }
  if (backwards < forwards) std::ranges::reverse(order);
  return order;
}

void detail::append_missing(std::vector<std::uint32_t>& order, std::span<const std::uint32_t> all) {
  if (order.size() == all.size()) return;
  std::vector<char> present(all.size(), 0);
  for (const std::uint32_t v : order) present[v] = 1;
  for (const std::uint32_t v : all)
    if (present[v] == 0) order.push_back(v);
}

OrderingCost ordering_cost(const CsrGraph& graph, std::span<const std::uint32_t> order) {
  const std::uint32_t n = vertex_count(graph);
  if (order.size() != n) detail::check_order(graph, order);
  const std::vector<std::uint32_t> new_of_old = invert(order);
  OrderingCost cost;
  std::vector<std::uint32_t> rows_opened(n, 0);  // per step: the rows whose first column it is
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t first = i;
    for (const std::uint32_t w : neighbours(graph, order[i])) first = std::min(first, new_of_old[w]);
    cost.bandwidth = std::max(cost.bandwidth, i - first);
    cost.envelope += i - first;
    ++rows_opened[first];
  }
  std::uint32_t active = 0;  // each step opens the rows that begin there and closes its own
  double sum_of_squares = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    active += rows_opened[i];
    sum_of_squares += static_cast<double>(active) * active;
    --active;
  }
  cost.rms_wavefront = n == 0 ? 0 : std::sqrt(sum_of_squares / n);
  return cost;
}

std::vector<std::uint32_t> natural_order(const CsrGraph& graph) {
  std::vector<std::uint32_t> order(vertex_count(graph));
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

}  // namespace leonhard::graph
