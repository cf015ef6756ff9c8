// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::delaunay {

enum class TetrahedralizeOutcome {
  done,
  too_few_points,  ///< fewer than four distinct points: the mesh is empty
  all_collinear,   ///< four or more distinct points, all on one line: the mesh is empty
  all_coplanar,    ///< four or more distinct points in one plane, not all on one line: the mesh is empty
  stopped,         ///< a stop was requested: the mesh is empty
};

/// The ways to the one Delaunay tetrahedralisation of a point set. All give the same tetrahedra: ties are broken by
/// kernel::insphere_perturbed.
enum class TetAlgorithm {
  insertion,  ///< the default: incremental, cavities of circumspheres (Bowyer 1981, Watson 1981)
  flipping,   ///< incremental: topological flips after each insertion (Joe 1991)
};

/// Every algorithm with the word for it, as the program's --algorithm takes it.
struct NamedTetAlgorithm {
  std::string_view name;
  TetAlgorithm algorithm;
};
inline constexpr std::array named_tet_algorithms{
    NamedTetAlgorithm{"insertion", TetAlgorithm::insertion},
    NamedTetAlgorithm{"flipping", TetAlgorithm::flipping},
};
[[nodiscard]] std::optional<TetAlgorithm> tet_algorithm_named(std::string_view name);

struct TetAlgorithmOptions {
  std::uint64_t seed = 1;  ///< of the random part of the insertion order; the tetrahedra do not depend on it
  unsigned threads = 1;    ///< 0: as many as there are cores; only some algorithms use more than one
  Progress progress;
};

/// Tetrahedra of a point set as a tetrahedralisation of the 3-sphere; corner ids are indices of the points. Empty
/// unless done.
struct [[nodiscard]] PointTetrahedralization {
  TetrahedralizeOutcome outcome = TetrahedralizeOutcome::done;
  GhostTetrahedralization cells;
};

/// The Delaunay tetrahedralisation of distinct, finite points by the algorithm named. That they are distinct is a
/// precondition: tetrahedralize() merges those that are not.
///
/// points  best in an order along a space-filling curve (kernel::hilbert_order), on which speed relies
/// throws  InputError naming the first point that is not finite
PointTetrahedralization tetrahedralize_distinct(std::span<const Point3> points, TetAlgorithm algorithm,
                                                const TetAlgorithmOptions& options);

}  // namespace leonhard::delaunay
