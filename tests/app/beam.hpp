// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

namespace leonhard::test {

/// A beam of n unit cubes along x, six tetrahedra about a diagonal in each (Kuhn), in Medit's format.
inline std::string beam(int n) {
  const auto vertex = [](int x, int y, int z) { return std::to_string(4 * x + 2 * y + z + 1); };
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(4 * (n + 1)) + "\n";
  for (int x = 0; x <= n; ++x)
    for (const char* yz : {"0 0", "0 1", "1 0", "1 1"}) text += std::to_string(x) + " " + yz + " 0\n";
  text += "Tetrahedra\n" + std::to_string(6 * n) + "\n";
  for (int x = 0; x < n; ++x)
    for (const auto& [first, second] : {std::pair{0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}}) {
      int at[3] = {x, 0, 0};
      std::string corners[4] = {vertex(x, 0, 0)};
      int count = 0;
      for (const int axis : {first, second, 3 - first - second}) {
        ++at[axis];
        corners[++count] = vertex(at[0], at[1], at[2]);
      }
      const bool is_odd = (second - first + 3) % 3 != 1;  // of the axes' permutation: turned over
      if (is_odd) std::swap(corners[0], corners[1]);
      text += corners[0] + " " + corners[1] + " " + corners[2] + " " + corners[3] + " 0\n";
    }
  return text + "End\n";
}

}  // namespace leonhard::test
