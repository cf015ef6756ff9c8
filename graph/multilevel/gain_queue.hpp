// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace leonhard::graph::detail {

/// Vertices by gain, the largest first; among equals the one whose gain was set last (which suits Fiduccia and
/// Mattheyses' refinement: moves stay together). A binary heap that knows where each vertex is.
class GainQueue {
 public:
  explicit GainQueue(std::uint32_t vertices) : place_(vertices, absent) {}

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  [[nodiscard]] bool contains(std::uint32_t v) const { return place_[v] != absent; }
  [[nodiscard]] std::uint32_t top() const { return heap_.front().vertex; }
  [[nodiscard]] std::int32_t top_gain() const { return static_cast<std::int32_t>(heap_.front().key >> 32); }

  /// The gain of a vertex that is in the queue.
  [[nodiscard]] std::int32_t gain(std::uint32_t v) const {
    return static_cast<std::int32_t>(heap_[place_[v]].key >> 32);
  }

  /// Inserts v or changes its gain.
  void set(std::uint32_t v, std::int32_t gain) {
    const Entry entry{(static_cast<std::int64_t>(gain) << 32) | ++clock_, v};
    std::uint32_t at = place_[v];
    if (at == absent) {
      at = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back(entry);
      rise(at, entry);
    } else if (entry.key > heap_[at].key) {
      rise(at, entry);
    } else {
      sink(at, entry);
    }
  }

  void remove(std::uint32_t v) {
    const std::uint32_t at = place_[v];
    place_[v] = absent;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (last.vertex == v) return;
    if (at > 0 && last.key > heap_[(at - 1) / 2].key)
      rise(at, last);
    else
      sink(at, last);
  }

  std::uint32_t pop() {
    const std::uint32_t v = top();
    remove(v);
    return v;
  }

  void clear() {
    for (const Entry& entry : heap_) place_[entry.vertex] = absent;
    heap_.clear();
    clock_ = 0;
  }

 private:
  struct Entry {
    std::int64_t key;  ///< gain, then time
    std::uint32_t vertex;
  };
  static constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

  void put(std::uint32_t at, const Entry& entry) {
    heap_[at] = entry;
    place_[entry.vertex] = at;
  }
  void rise(std::uint32_t at, const Entry& entry) {
    while (at > 0 && heap_[(at - 1) / 2].key < entry.key) {
      put(at, heap_[(at - 1) / 2]);
      at = (at - 1) / 2;
    }
    put(at, entry);
  }
  void sink(std::uint32_t at, const Entry& entry) {
    const auto size = static_cast<std::uint32_t>(heap_.size());
    while (2 * at + 1 < size) {
      std::uint32_t child = 2 * at + 1;
      if (child + 1 < size && heap_[child + 1].key > heap_[child].key) ++child;
      if (heap_[child].key <= entry.key) break;
      put(at, heap_[child]);
      at = child;
    }
    put(at, entry);
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;  ///< per vertex: its place in the heap, or absent
  std::uint32_t clock_ = 0;
};

}  // namespace leonhard::graph::detail
