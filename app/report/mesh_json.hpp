// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/delaunay/refine.hpp"
#include "leonhard/mesh/euler.hpp"
#include "leonhard/mesh/quality.hpp"

namespace leonhard::app {

/// Euler's account with both sides of each formula.
[[nodiscard]] Json to_json(const EulerAccount& account);
[[nodiscard]] Json to_json(const EulerAccount::Formula& formula);
[[nodiscard]] Json to_json(const MeshQuality& quality);
[[nodiscard]] Json to_json(const delaunay::RefineReport& report);

/// The input points that became one with an earlier one: pairs of their numbers, from 0.
///
/// vertex_of_input  of a Triangulation or a RefinedMesh
[[nodiscard]] Json merged_points_json(const std::vector<MaybeId<VertexId>>& vertex_of_input);

}  // namespace leonhard::app
