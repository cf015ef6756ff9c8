// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "leonhard/delaunay/point_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

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
[[nodiscard]] constexpr std::string_view to_string(TetAlgorithm algorithm) {
  for (const auto& known : named_tet_algorithms) {
    if (known.algorithm == algorithm) return known.name;
  }
  return "";
}
[[nodiscard]] std::optional<TetAlgorithm> tet_algorithm_named(std::string_view name);

/// The Delaunay tetrahedralisation of distinct, finite points by the algorithm named. That they are distinct is a
/// precondition: tetrahedralize() merges those that are not.
///
/// points  best in an order along a space-filling curve (kernel::hilbert_order), on which speed relies
/// throws  InputError naming the first point that is not finite
PointTetrahedralization tetrahedralize_distinct(std::span<const Point3> points, TetAlgorithm algorithm,
                                                const TetAlgorithmOptions& options);

}  // namespace leonhard::delaunay
