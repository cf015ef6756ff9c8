// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/part_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace leonhard::app {
namespace {

constexpr std::size_t most_in_a_circle = 100;

std::vector<Point2> in_a_circle(const std::vector<std::size_t>& sequence) {
  std::vector<Point2> places(sequence.size());
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sequence.size());
    places[sequence[i]] = {std::sin(angle), std::cos(angle)};
  }
  return places;
}

/// The middle of each part's vertices on the page; of a part without any, the middle of all.
std::vector<Point2> middles(const std::vector<Point3>& places, const graph::Partition& partition) {
  std::vector<Vec2> sum(partition.parts);
  std::vector<double> count(partition.parts, 0);
  Vec2 all{};
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Vec2 place{places[v].x, places[v].y};
    sum[partition.part_of[v]] = sum[partition.part_of[v]] + place;
    ++count[partition.part_of[v]];
    all = all + place;
  }
  std::vector<Point2> result;
  for (std::size_t part = 0; part < sum.size(); ++part) {
    const bool empty = count[part] == 0;
    const double share = 1 / (empty ? static_cast<double>(places.size()) : count[part]);
    result.push_back(Point2{} + share * (empty ? all : sum[part]));
  }
  return result;
}

/// Whether some two are too near to each other to be told apart: as in meshes that are graded.
bool are_crowded(const std::vector<Point2>& places) {
  Point2 low = places.front(), high = low;
  for (const Point2 p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double near = 0.15 * std::max(high.x - low.x, high.y - low.y);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (distance(places[i], places[k]) <= near) return true;
  return false;
}

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Where they are, or, few and crowded, in a circle in the sequence in which they lie about their median.
std::vector<Point2> told_apart(const std::vector<Point2>& places) {
  if (places.size() > most_in_a_circle || !are_crowded(places)) return places;
  std::vector<double> x, y;
  for (const Point2 p : places) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  const Point2 median{middle_of(x), middle_of(y)};
  std::vector<std::size_t> sequence(places.size());
  std::iota(sequence.begin(), sequence.end(), std::size_t{0});
  std::ranges::stable_sort(sequence, {}, [&](std::size_t i) {
    const Vec2 from = places[i] - median;
    return std::atan2(from.x, from.y);  // as in_a_circle runs, from the top clockwise
  });
  return in_a_circle(sequence);
}

}  // namespace

std::vector<Point2> parts_in_a_circle(std::size_t parts) {
  std::vector<std::size_t> sequence(parts);
  std::iota(sequence.begin(), sequence.end(), std::size_t{0});
  return in_a_circle(sequence);
}

std::vector<Point2> places_of_parts(const std::vector<Point3>& places, const graph::Partition& partition) {
  return told_apart(middles(places, partition));
}

}  // namespace leonhard::app
