// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// A size field that grows linearly away from sources: min over sources of spacing + growth * distance, at
/// most max_size. Its Lipschitz constant is growth.
///
/// Immutable once made: may be asked from many threads. Copies own their data.
class GradedSizing {
 public:
  struct Source {
    Point2 at{};
    double spacing{};  ///< target edge length at the source, same unit as the coordinates
  };

  /// sources   any number, none included (then the field is max_size everywhere)
  /// growth    size gained per unit of distance, not negative
  /// max_size  positive, may be infinite
  /// throws    InputError: a spacing or max_size not positive, growth negative, a coordinate not finite
  /// Cost O(n log n).
  GradedSizing(std::vector<Source> sources, double growth, double max_size);

  /// Target edge length at p, finite (a precondition): the minimum over all sources, exactly as if each were asked in turn.
  /// Cost O(log n) typically (kd-tree with the least spacing of each subtree as its bound).
  [[nodiscard]] double operator()(Point2 p) const;

 private:
  struct Node {
    double min_x, min_y, max_x, max_y;  // box of the subtree's sources
    double least_spacing;               // over the subtree
    std::uint32_t begin, end;           // its sources
    std::uint32_t right;                // index of the right child, 0 for a leaf; the left one comes next
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<Source> sources_;
  std::vector<Node> nodes_;
  double growth_;
  double max_size_;
};

}  // namespace leonhard::delaunay
