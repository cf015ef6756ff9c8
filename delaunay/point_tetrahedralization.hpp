// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/kernel/progress.hpp"

/// What every algorithm of tet_algorithm.hpp takes and gives.
namespace leonhard::delaunay {

enum class TetrahedralizeOutcome {
  done,
  too_few_points,  ///< fewer than four distinct points: the mesh is empty
  all_collinear,   ///< four or more distinct points, all on one line: the mesh is empty
  all_coplanar,    ///< four or more distinct points in one plane, not all on one line: the mesh is empty
  stopped,         ///< a stop was requested: the mesh is empty
};

/// The word for it, e.g. "done".
[[nodiscard]] constexpr std::string_view to_string(TetrahedralizeOutcome outcome) {
  switch (outcome) {
    case TetrahedralizeOutcome::done:
      return "done";
    case TetrahedralizeOutcome::too_few_points:
      return "too_few_points";
    case TetrahedralizeOutcome::all_collinear:
      return "all_collinear";
    case TetrahedralizeOutcome::all_coplanar:
      return "all_coplanar";
    case TetrahedralizeOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct TetAlgorithmOptions {
  std::uint64_t seed = 1;  ///< of the random part of the insertion order; the tetrahedra do not depend on it
  unsigned threads = 1;    ///< 0: as many as there are cores; only some algorithms use more than one
  Progress progress{};
};

/// Tetrahedra of a point set as a tetrahedralisation of the 3-sphere; corner ids are indices of the points. Empty
/// unless done.
struct [[nodiscard]] PointTetrahedralization {
  TetrahedralizeOutcome outcome = TetrahedralizeOutcome::done;
  GhostTetrahedralization cells;
};

}  // namespace leonhard::delaunay
