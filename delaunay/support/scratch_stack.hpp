// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace leonhard::delaunay {

/// A stack for inner loops that write several elements and keep some: writing beyond the end costs no check and what is
/// cleared keeps its memory.
template <class T>
class ScratchStack {
 public:
  /// Where the next elements go; there is room for that many.
  [[nodiscard]] T* room(std::size_t count) {
    if (size_ + count > memory_.size()) memory_.resize(2 * (size_ + count));
    return memory_.data() + size_;
  }
  /// The stack now ends here, in what room() gave.
  void end_at(const T* end) { size_ = static_cast<std::size_t>(end - memory_.data()); }
  void push(const T& element) {
    *room(1) = element;
    ++size_;
  }
  void clear() { size_ = 0; }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T* begin() { return memory_.data(); }
  [[nodiscard]] T* end() { return memory_.data() + size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return memory_[i]; }

 private:
  std::vector<T> memory_;
  std::size_t size_ = 0;
};

}  // namespace leonhard::delaunay
