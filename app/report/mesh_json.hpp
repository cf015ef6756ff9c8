// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace leonhard::app
