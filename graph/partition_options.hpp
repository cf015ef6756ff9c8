// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::graph {

enum class PartitionMethod {
  coordinate,            ///< recursive_coordinate_bisection
  inertial,              ///< recursive_inertial_bisection
  cuthill_mckee,         ///< recursive_cuthill_mckee_bisection at the median
  cuthill_mckee_levels,  ///< the same at level-set boundaries
  spectral,              ///< recursive_spectral_bisection
  multilevel,            ///< multilevel k-way: coarsen, bisect, refine; the least cut by far
};

/// The methods' names in files and on the command line.
inline constexpr std::array<std::pair<std::string_view, PartitionMethod>, 6> named_partition_methods{{
    {"coordinate", PartitionMethod::coordinate},
    {"inertial", PartitionMethod::inertial},
    {"cuthill-mckee", PartitionMethod::cuthill_mckee},
    {"cuthill-mckee-levels", PartitionMethod::cuthill_mckee_levels},
    {"spectral", PartitionMethod::spectral},
    {"multilevel", PartitionMethod::multilevel},
}};
[[nodiscard]] constexpr std::string_view to_string(PartitionMethod method) {
  for (const auto& known : named_partition_methods) {
    if (known.second == method) return known.first;
  }
  return "";
}

/// How long the multilevel method tries: on meshes, times METIS' k-way method about as long, three times, and a hundred
/// times and more.
enum class Effort { low, normal, high };

struct PartitionOptions {
  PartitionMethod method = PartitionMethod::multilevel;
  double imbalance = 0.03;         ///< no part is heavier than heaviest_allowed() says
  Effort effort = Effort::normal;  ///< of the multilevel method
  std::uint64_t seed = 1;          ///< same graph, options and seed: same partition
  bool connected = false;          ///< try to have every part in one piece

  std::span<const std::uint32_t> vertex_weights{};  ///< one a vertex, positive; empty: all 1
  /// One a directed edge in the graph's sequence, positive, the same in both directions; empty: all 1. Only the
  /// multilevel method looks at them.
  std::span<const std::uint32_t> edge_weights{};
  /// One point a vertex, for the methods coordinate and inertial.
  std::variant<std::span<const Point2>, std::span<const Point3>> coordinates{};
  Progress progress{};
};

}  // namespace leonhard::graph
