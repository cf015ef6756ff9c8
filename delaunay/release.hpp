// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace leonhard::delaunay {

/// Give a vector's memory back. (v = {} would keep its capacity.)
template <class T>
void release(std::vector<T>& v) {
  std::vector<T>().swap(v);
}

}  // namespace leonhard::delaunay
