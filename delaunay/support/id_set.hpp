// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// A set of numbers: a hash table with room to spare.
class IdSet {
 public:
  void clear();
  /// Whether it was not there yet. Expected O(1).
  bool insert(IdRaw id);
  [[nodiscard]] bool contains(IdRaw id) const { return slots_[slot_of(id)] == id; }

 private:
  static constexpr IdRaw none = std::numeric_limits<IdRaw>::max();
  static constexpr std::size_t first_slots = 128;

  /// Where id is, or would come.
  [[nodiscard]] std::size_t slot_of(IdRaw id) const;
  void grow();

  std::vector<IdRaw> slots_ = std::vector<IdRaw>(first_slots, none);
  std::size_t size_ = 0;
};

}  // namespace leonhard::delaunay
