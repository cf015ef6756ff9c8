// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

/// Vectors of tens of megabytes: how they come and go takes a tenth of the time of a large triangulation.
namespace leonhard::delaunay {

/// Ask the system for large pages for memory not yet written to, where it has them; otherwise without effect.
void prefer_large_pages(void* memory, std::size_t bytes);

/// Write to every page of memory that nobody uses yet, so that the system provides it: by several threads this is much
/// faster than one by one when it is used.
void touch_pages(void* memory, std::size_t bytes, unsigned threads);

/// n elements made from nothing, on large pages where the system has them: touching 50 MB of small ones for the first
/// time takes some 15 ms.
template <class T>
[[nodiscard]] std::vector<T> large_vector(std::size_t n) {
  std::vector<T> v;
  v.reserve(n);
  prefer_large_pages(v.data(), n * sizeof(T));
  v.resize(n);
  return v;
}

/// Give a vector's memory back. (v = {} would keep its capacity.)
template <class T>
void release(std::vector<T>& v) {
  std::vector<T>().swap(v);
}

}  // namespace leonhard::delaunay
