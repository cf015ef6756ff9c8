// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/delaunay/constrained/constrained_triangulation.hpp"

namespace leonhard::delaunay {

/// The angles between segments that a refinement starts from.
///
/// Only angles inside the domain count: the sharp trailing edge of an airfoil that is a hole is none.
class InputAngles {
 public:
  /// in  carved, before any vertex is added. Cost O(pieces * degree).
  explicit InputAngles(const ConstrainedTriangulation& in);

  /// Whether two segments meet at v, in the domain, at less than 60 degrees: too sharp for midpoints to end.
  /// Vertices added later are not.
  [[nodiscard]] bool is_acute(VertexId v) const {
    return v.index() < least_cosine_gap_.size() && least_cosine_gap_[v.index()] < 0.5;
  }
  /// By how much, relatively, the shells about v may miss their radii, so that no two segments' parts in the same
  /// shell encroach on each other.
  [[nodiscard]] double shell_tolerance(VertexId v) const;

 private:
  std::vector<double> least_cosine_gap_;  // one an input vertex: 1 - cos of its smallest angle; 2 where none
};

}  // namespace leonhard::delaunay
