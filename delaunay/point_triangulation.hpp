// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/progress.hpp"

/// What every algorithm of algorithm.hpp takes and gives.
namespace leonhard::delaunay {

enum class TriangulateOutcome {
  done,
  too_few_points,  ///< fewer than three distinct points: the mesh is empty
  all_collinear,   ///< three or more distinct points, all on one line: the mesh is empty
  stopped,         ///< a stop was requested: the mesh is empty
};

/// The word for it, e.g. "done".
[[nodiscard]] constexpr std::string_view to_string(TriangulateOutcome outcome) {
  switch (outcome) {
    case TriangulateOutcome::done:
      return "done";
    case TriangulateOutcome::too_few_points:
      return "too_few_points";
    case TriangulateOutcome::all_collinear:
      return "all_collinear";
    case TriangulateOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct AlgorithmOptions {
  std::uint64_t seed =
      1;  ///< of the algorithms that draw an order at random; the triangles do not depend on it
  unsigned threads = 1;  ///< 0: as many as there are cores; only some algorithms use more than one
  Progress progress{};
};

/// Triangles of a point set as a triangulation of the sphere; corner ids are indices of the points. Empty
/// unless done.
struct [[nodiscard]] PointTriangulation {
  TriangulateOutcome outcome = TriangulateOutcome::done;
  GhostTriangulation triangulation;
};

}  // namespace leonhard::delaunay
