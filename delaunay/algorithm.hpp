// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The ways to the one Delaunay triangulation of a point set. All give the same triangles: ties are broken by
/// kernel::incircle_perturbed.
enum class Algorithm {
  fast,                ///< the default
  divide_and_conquer,  ///< halves merged by a rising bubble (Barth's notes 3.3a)
  bowyer,              ///< incremental, on the Voronoi diagram (Barth's notes 3.3b)
  watson,              ///< incremental: cavities of circumcircles (Barth's notes 3.3b)
  green_sibson,        ///< incremental: forward swapping (Barth's notes 3.3b)
  randomized,          ///< incremental in random order, with the Delaunay tree (Barth's notes 3.3c)
  lawson,              ///< edges swapped globally after a sweep (Barth's notes 3.3d); O(n^2) at worst
};

/// Every algorithm with the word for it, as the program's --algorithm takes it.
struct NamedAlgorithm {
  std::string_view name;
  Algorithm algorithm;
};
inline constexpr std::array named_algorithms{
    NamedAlgorithm{"fast", Algorithm::fast},
    NamedAlgorithm{"divide-and-conquer", Algorithm::divide_and_conquer},
    NamedAlgorithm{"bowyer", Algorithm::bowyer},
    NamedAlgorithm{"watson", Algorithm::watson},
    NamedAlgorithm{"green-sibson", Algorithm::green_sibson},
    NamedAlgorithm{"randomized", Algorithm::randomized},
    NamedAlgorithm{"lawson", Algorithm::lawson},
};
[[nodiscard]] constexpr std::string_view to_string(Algorithm algorithm) {
  for (const auto& known : named_algorithms) {
    if (known.algorithm == algorithm) return known.name;
  }
  return "";
}
[[nodiscard]] std::optional<Algorithm> algorithm_named(std::string_view name);

/// The Delaunay triangulation of distinct, finite points by the algorithm named. That they are distinct is a precondition:
/// triangulate() merges those that are not.
///
/// points  best in an order along a space-filling curve (sort_and_merge), which some algorithms rely on for
///         speed
/// throws  InputError naming the first point that is not finite
PointTriangulation triangulate_distinct(std::span<const Point2> points, Algorithm algorithm,
                                        const AlgorithmOptions& options);

}  // namespace leonhard::delaunay
