// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::delaunay {

enum class TriangulateOutcome {
  done,
  too_few_points,  ///< fewer than three distinct points: the mesh is empty
  all_collinear,   ///< three or more distinct points, all on one line: the mesh is empty
  stopped,         ///< a stop was requested: the mesh is empty
};

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
[[nodiscard]] std::optional<Algorithm> algorithm_named(std::string_view name);

struct AlgorithmOptions {
  std::uint64_t seed =
      1;  ///< of the algorithms that draw an order at random; the triangles do not depend on it
  unsigned threads = 1;  ///< 0: as many as there are cores; only some algorithms use more than one
  Progress progress;
};

/// Triangles of a point set as a triangulation of the sphere; corner ids are indices of the points. Empty
/// unless done.
struct [[nodiscard]] PointTriangulation {
  TriangulateOutcome outcome = TriangulateOutcome::done;
  GhostTriangulation triangulation;
};

/// The Delaunay triangulation of distinct, finite points by the algorithm named. That they are distinct is a precondition:
/// triangulate() merges those that are not.
///
/// points  best in an order along a space-filling curve (sort_and_merge), which some algorithms rely on for
///         speed
/// throws  InputError naming the first point that is not finite
PointTriangulation triangulate_distinct(std::span<const Point2> points, Algorithm algorithm,
                                        const AlgorithmOptions& options);

}  // namespace leonhard::delaunay
