// SPDX-License-Identifier: MIT
#include "leonhard/graph/multilevel/local_flow.hpp"

#include <algorithm>

namespace leonhard::graph::detail {

void LocalFlow::clear() {
  edges_.clear();
  start_.clear();
  from_source_.clear();
  to_sink_.clear();
}

void LocalFlow::add_vertex() {
  start_.push_back(0);
  from_source_.push_back(0);
  to_sink_.push_back(0);
}

void LocalFlow::add_edge(std::uint32_t earlier, std::int32_t to_earlier, std::int32_t from_earlier) {
  edges_.push_back({static_cast<std::uint32_t>(start_.size() - 1), earlier, to_earlier, from_earlier});
  ++start_.back();
  ++start_[earlier];
}

void LocalFlow::build_links() {
  std::uint32_t end = 0;  // of a row; its links are put in from behind
  for (std::uint32_t& start : start_) start = end += start;
  start_.push_back(end);
  links_.resize(end);
  for (const auto& [later, earlier, to_earlier, from_earlier] : edges_) {
    const std::uint32_t there = --start_[later], back = --start_[earlier];
    links_[there] = {earlier, back, to_earlier};
    links_[back] = {later, there, from_earlier};
  }
}

/// Breadth first from the source, to the level at which the sink is reached. returns whether it is
bool LocalFlow::build_levels() {
  std::ranges::fill(level_, unreached);
  queue_.clear();
  for (std::uint32_t v = 0; v < level_.size(); ++v)
    if (from_source_[v] > 0) {
      level_[v] = 0;
      queue_.push_back(v);
    }
  std::uint32_t last = unreached - 1;  // vertices of this level are the sink's neighbours
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const std::uint32_t v = queue_[i], next = level_[v] + 1;
    if (to_sink_[v] > 0) last = std::min(last, level_[v]);
    if (next > last) continue;
    for (std::uint32_t l = start_[v]; l < start_[v + std::size_t{1}]; ++l) {
      const Link& link = links_[l];
      if (link.residual == 0 || level_[link.to] != unreached) continue;
      level_[link.to] = next;
      queue_.push_back(link.to);
    }
  }
  return last < unreached - 1;
}

/// One path by increasing levels from a vertex that the source feeds. returns what went along it, 0 if there is none
std::int32_t LocalFlow::augment_from(std::uint32_t start) {
  path_.clear();
  std::uint32_t v = start;
  while (to_sink_[v] == 0) {
    std::uint32_t& l = current_[v];
    const std::uint32_t end = start_[v + std::size_t{1}], next = level_[v] + 1;
    while (l != end && (links_[l].residual == 0 || level_[links_[l].to] != next)) ++l;
    if (l != end) {
      path_.push_back(l);
      v = links_[l].to;
      continue;
    }
    if (path_.empty()) return 0;
    v = links_[links_[path_.back()].back].to;
    path_.pop_back();
    ++current_[v];
  }
  std::int32_t amount = std::min(from_source_[start], to_sink_[v]);
  for (const std::uint32_t l : path_) amount = std::min(amount, links_[l].residual);
  from_source_[start] -= amount;
  to_sink_[v] -= amount;
  for (const std::uint32_t l : path_) {
    links_[l].residual -= amount;
    links_[links_[l].back].residual += amount;
  }
  return amount;
}

std::int64_t LocalFlow::maximum(std::int64_t enough) {
  level_.resize(start_.size());
  build_links();
  std::int64_t flow = 0;
  while (flow < enough && build_levels()) {
    current_.assign(start_.begin(), start_.end() - 1);
    for (const std::uint32_t start : queue_) {
      if (level_[start] > 0) break;
      while (from_source_[start] > 0) {
        const std::int32_t amount = augment_from(start);
        if (amount == 0) break;
        flow += amount;
      }
    }
  }
  return flow;
}

std::vector<char> LocalFlow::reaching_sink() const {
  std::vector<char> reaches(level_.size(), 0);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t v = 0; v < reaches.size(); ++v)
    if (to_sink_[v] > 0) {
      reaches[v] = 1;
      stack.push_back(v);
    }
  while (!stack.empty()) {
    const std::uint32_t v = stack.back();
    stack.pop_back();
    for (std::uint32_t l = start_[v]; l < start_[v + std::size_t{1}]; ++l) {
      const Link& link = links_[l];
      if (reaches[link.to] || links_[link.back].residual == 0) continue;
      reaches[link.to] = 1;
      stack.push_back(link.to);
    }
  }
  return reaches;
}

}  // namespace leonhard::graph::detail
