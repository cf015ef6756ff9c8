// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace leonhard::mesh {

/// Classes of the numbers 0 .. count - 1, joined two by two. Union by size with path halving: nearly O(1) a call.
/// (boost::disjoint_sets does not count its classes.)
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count), size_(count, 1), classes_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  [[nodiscard]] std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i), j = find(j);
    if (i == j) return;
    if (size_[i] < size_[j]) std::swap(i, j);
    parent_[j] = i;
    size_[i] += size_[j];
    --classes_;
  }
  [[nodiscard]] std::size_t class_count() const { return classes_; }

 private:
  std::vector<std::size_t> parent_, size_;
  std::size_t classes_;
};

}  // namespace leonhard::mesh
