// SPDX-License-Identifier: MIT
#include "leonhard/graph/local_flow.hpp"

#include <algorithm>

namespace leonhard::graph::detail {

void LocalFlow::clear() {
  links_.clear();
  first_.clear();
  from_source_.clear();
  to_sink_.clear();
}

void LocalFlow::add_vertex() {
  first_.push_back(unreached);
  from_source_.push_back(0);
  to_sink_.push_back(0);
}

void LocalFlow::add_edge(std::uint32_t earlier, std::int32_t capacity) {
  const auto v = static_cast<std::uint32_t>(first_.size() - 1);
  const auto at = static_cast<std::uint32_t>(links_.size());
  links_.push_back({earlier, at + 1, first_[v], capacity});
  links_.push_back({v, at, first_[earlier], capacity});
  first_[v] = at;
  first_[earlier] = at + 1;
}

/// Breadth first from the source. returns whether the sink is reached
bool LocalFlow::build_levels() {
  std::ranges::fill(level_, unreached);
  queue_.clear();
  for (std::uint32_t v = 0; v < first_.size(); ++v)
    if (from_source_[v] > 0) {
      level_[v] = 0;
      queue_.push_back(v);
    }
  bool reached = false;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const std::uint32_t v = queue_[i];
    reached = reached || to_sink_[v] > 0;
    for (std::uint32_t l = first_[v]; l != unreached; l = links_[l].next)
      if (links_[l].residual > 0 && level_[links_[l].to] == unreached) {
        level_[links_[l].to] = level_[v] + 1;
        queue_.push_back(links_[l].to);
      }
  }
  return reached;
}

/// One path by increasing levels from a vertex that the source feeds. returns what went along it, 0 if there is none
std::int32_t LocalFlow::augment_from(std::uint32_t start) {
  path_.clear();
  std::uint32_t v = start;
  while (to_sink_[v] == 0) {
    std::uint32_t& l = current_[v];
    while (l != unreached && (links_[l].residual == 0 || level_[links_[l].to] != level_[v] + 1))
      l = links_[l].next;
    if (l != unreached) {
      path_.push_back(l);
      v = links_[l].to;
      continue;
    }
    if (path_.empty()) return 0;
    v = links_[links_[path_.back()].back].to;
    path_.pop_back();
    current_[v] = links_[current_[v]].next;
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
  level_.resize(first_.size());
  std::int64_t flow = 0;
  while (flow < enough && build_levels()) {
    current_ = first_;
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
  std::vector<char> reaches(first_.size(), 0);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t v = 0; v < first_.size(); ++v)
    if (to_sink_[v] > 0) {
      reaches[v] = 1;
      stack.push_back(v);
    }
  while (!stack.empty()) {
    const std::uint32_t v = stack.back();
    stack.pop_back();
    for (std::uint32_t l = first_[v]; l != unreached; l = links_[l].next) {
      const Link& link = links_[l];
      if (reaches[link.to] || links_[link.back].residual == 0) continue;
      reaches[link.to] = 1;
      stack.push_back(link.to);
    }
  }
  return reaches;
}

}  // namespace leonhard::graph::detail
