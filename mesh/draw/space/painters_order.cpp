// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/space/painters_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "leonhard/mesh/draw/space/facet_samples.hpp"

namespace leonhard::draw {
namespace {

using Number = std::uint32_t;
constexpr Number none = std::numeric_limits<Number>::max();

struct Samples {
  std::int64_t columns, rows;
  Point2 origin;
  double per_page;
};

Samples samples_on(const Rect& area) {
  constexpr double wanted = 8e6;
  const double per_page = std::min(3.0, std::sqrt(wanted / (area.width * area.height)));
  return {std::max<std::int64_t>(1, std::llround(area.width * per_page)),
          std::max<std::int64_t>(1, std::llround(area.height * per_page)),
          {area.left, area.top},
          per_page};
}

// Calls visit(sample, nearness) for each sample of a facet.
template <class Visit>
void visit_samples(const Facet& facet, const Samples& grid, Visit visit) {
  const FacetSamples samples(facet, grid.origin, grid.per_page, false);
  const PageLinear& nearness = samples.nearness();
  scan_convex(samples.outline(), grid.rows, grid.columns,
              [&](std::int64_t row, std::int64_t first, std::int64_t last) {
                const double y = static_cast<double>(row) + 0.5;
                for (std::int64_t i = first; i < last; ++i) {
                  visit(static_cast<std::size_t>(row * grid.columns + i),
                        nearness.at(static_cast<double>(i) + 0.5, y));
                }
              });
}

// The facet in front at each sample.
std::vector<Number> front_facets(std::span<const Facet> facets, const Samples& grid) {
  const std::size_t count = static_cast<std::size_t>(grid.columns * grid.rows);
  std::vector<Number> front(count, none);
  std::vector<double> nearest(count, -std::numeric_limits<double>::infinity());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    visit_samples(facets[f], grid, [&](std::size_t at, double near) {
      if (near <= nearest[at]) return;
      nearest[at] = near;
      front[at] = static_cast<Number>(f);
    });
  }
  return front;
}

// Pairs (behind, in front) of facets that are seen, each pair once, sorted.
std::vector<std::pair<Number, Number>> overlaps(std::span<const Facet> facets, const Samples& grid,
                                                const std::vector<Number>& front,
                                                const std::vector<char>& is_seen) {
  std::vector<std::pair<Number, Number>> pairs;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (is_seen[f] == 0) continue;
    const auto self = static_cast<Number>(f);
    const std::size_t first = pairs.size();
    Number last = self;
    visit_samples(facets[f], grid, [&](std::size_t at, double) {
      if (front[at] == self || front[at] == last) return;
      last = front[at];
      pairs.emplace_back(self, last);
    });
    const auto own = pairs.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(own, pairs.end());
    pairs.erase(std::unique(own, pairs.end()), pairs.end());
  }
  return pairs;
}

double mean_nearness(const Facet& facet) {
  double sum = 0;
  for (std::size_t i = 0; i < facet.count; ++i) sum += facet.corners[i].nearness;
  return sum / facet.count;
}

}  // namespace

std::vector<std::uint32_t> painters_order(std::span<const Facet> facets, const Rect& area) {
  const Samples grid = samples_on(area);
  const std::vector<Number> front = front_facets(facets, grid);
  std::vector<char> is_seen(facets.size(), 0);
  for (const Number f : front) {
    if (f != none) is_seen[f] = 1;
  }
  const auto pairs = overlaps(facets, grid, front, is_seen);
  std::vector<std::size_t> behind_left(facets.size(), 0);  // that have yet to be painted before this one
  for (const auto& [behind, before] : pairs) ++behind_left[before];

  std::vector<Number> by_distance;
  for (Number f = 0; f < facets.size(); ++f) {
    if (is_seen[f] != 0) by_distance.push_back(f);
  }
  std::vector<double> nearness(facets.size());
  for (const Number f : by_distance) nearness[f] = mean_nearness(facets[f]);
  const auto is_farther = [&](Number a, Number b) {
    return nearness[a] != nearness[b] ? nearness[a] < nearness[b] : a < b;
  };
  std::ranges::sort(by_distance, is_farther);

  const auto is_nearer = [&](Number a, Number b) { return is_farther(b, a); };
  std::priority_queue<Number, std::vector<Number>, decltype(is_nearer)> ready(is_nearer);
  for (const Number f : by_distance) {
    if (behind_left[f] == 0) ready.push(f);
  }
  std::vector<Number> order;
  std::vector<char> is_painted(facets.size(), 0);
  std::size_t next = 0;  // of by_distance, for cycles
  while (order.size() < by_distance.size()) {
    Number f = none;
    if (!ready.empty()) {
      f = ready.top();
      ready.pop();
    } else {
      while (is_painted[by_distance[next]] != 0) ++next;
      f = by_distance[next];
    }
    if (is_painted[f] != 0) continue;
    is_painted[f] = 1;
    order.push_back(f);
    auto pair = std::ranges::lower_bound(pairs, f, {}, &std::pair<Number, Number>::first);
    for (; pair != pairs.end() && pair->first == f; ++pair) {
      if (behind_left[pair->second] > 0 && --behind_left[pair->second] == 0) ready.push(pair->second);
    }
  }
  return order;
}

}  // namespace leonhard::draw
