// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "leonhard/solver/steady_result.hpp"

namespace leonhard::app {

/// Where the friction along a no-slip wall changes its sign: the flow along it meets and leaves it (separation) or comes to
/// it and parts (attachment; of a body's nose as well).
struct FrictionZero {
  enum class Kind { separation, attachment };
  Kind kind{};
  Marker marker{};       ///< of the wall
  Point2 at;             ///< between two vertices, by linear interpolation
  double arc_length{};   ///< as SurfacePoint has it
};

[[nodiscard]] constexpr std::string_view to_string(FrictionZero::Kind kind) {
  return kind == FrictionZero::Kind::separation ? "separation" : "attachment";
}

/// All of them, wall by wall in the order of their arc lengths. Edges at a vertex where the wall turns by more than a right
/// angle are left out: a sharp trailing edge is no separation.
[[nodiscard]] std::vector<FrictionZero> friction_zeros(const SteadyResult<2>& flow);

/// Smallest and largest y+ of the first cells on no-slip walls; in laminar flow the root of their Reynolds number.
struct WallHeights {
  double least{}, most{};
};
/// none where there is no such wall
template <int dim>
[[nodiscard]] std::optional<WallHeights> wall_heights(const SteadyResult<dim>& flow) {
  std::optional<WallHeights> heights;
  for (const auto& stress : flow.stresses) {
    if (!heights) heights = WallHeights{stress.y_plus, stress.y_plus};
    heights->least = std::min(heights->least, stress.y_plus), heights->most = std::max(heights->most, stress.y_plus);
  }
  return heights;
}

}  // namespace leonhard::app
