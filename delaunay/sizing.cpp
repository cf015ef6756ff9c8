// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/sizing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

constexpr std::uint32_t leaf_size = 4;

/// Without hypot's care for overflow, which costs more than the whole rest of a query.
double length(Vec2 v) { return std::sqrt(dot(v, v)); }

void check_sources(const std::vector<GradedSizing::Source>& sources, double growth, double max_size) {
  if (!(growth >= 0) || !std::isfinite(growth))
    throw InputError("GradedSizing", "growth is " + mesh::words(growth),
                     "give a number that is not negative");
  if (!(max_size > 0))
    throw InputError("GradedSizing", "max_size is " + mesh::words(max_size), "give a positive length");
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (!is_finite(sources[i].at) || !(sources[i].spacing > 0) || !std::isfinite(sources[i].spacing))
      throw InputError("GradedSizing",
                       "source " + std::to_string(i) + " at " + mesh::words(sources[i].at) + " has spacing " +
                           mesh::words(sources[i].spacing),
                       "give finite coordinates and a positive spacing");
}

}  // namespace

GradedSizing::GradedSizing(std::vector<Source> sources, double growth, double max_size)
    : sources_(std::move(sources)), growth_(growth), max_size_(max_size) {
  check_sources(sources_, growth, max_size);
  if (!sources_.empty()) build(0, static_cast<std::uint32_t>(sources_.size()));
}

std::uint32_t GradedSizing::build(std::uint32_t begin, std::uint32_t end) {
  const Source& first = sources_[begin];
  Node node{first.at.x, first.at.y, first.at.x, first.at.y, first.spacing, begin, end, 0};
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    const Source& s = sources_[i];
    node.min_x = std::min(node.min_x, s.at.x);
    node.min_y = std::min(node.min_y, s.at.y);
    node.max_x = std::max(node.max_x, s.at.x);
    node.max_y = std::max(node.max_y, s.at.y);
    node.least_spacing = std::min(node.least_spacing, s.spacing);
  }
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return index;

  const bool along_x = node.max_x - node.min_x >= node.max_y - node.min_y;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      sources_.begin() + begin, sources_.begin() + middle, sources_.begin() + end,
      [along_x](const Source& a, const Source& b) { return along_x ? a.at.x < b.at.x : a.at.y < b.at.y; });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[index].right = right;
  return index;
}

double GradedSizing::operator()(Point2 p) const {
  double best = max_size_;
  if (nodes_.empty()) return best;

  // A hair is taken off each box's bound, so that rounding never prunes the source that holds the minimum.
  const auto bound = [&](const Node& node) {
    const double dx = std::max({node.min_x - p.x, 0.0, p.x - node.max_x});
    const double dy = std::max({node.min_y - p.y, 0.0, p.y - node.max_y});
    return (node.least_spacing + growth_ * length({dx, dy})) * (1 - 1e-14);
  };
  struct Pending {
    std::uint32_t node;
    double bound;
  };
  std::array<Pending, 64> stack;  // the tree halves its sources, so its depth is at most 32
  std::size_t depth = 0;
  stack[depth++] = {0, bound(nodes_[0])};
  while (depth > 0) {
    const Pending top = stack[--depth];
    if (top.bound >= best) continue;
    const Node& node = nodes_[top.node];
    if (node.right == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        best = std::min(best, sources_[i].spacing + growth_ * length(p - sources_[i].at));
      continue;
    }
    Pending near{top.node + 1, bound(nodes_[top.node + 1])};
    Pending far{node.right, bound(nodes_[node.right])};
    if (far.bound < near.bound) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return best;
}

}  // namespace leonhard::delaunay
