// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/io/surface_account.hpp"

namespace leonhard::app {

/// What `leonhard check` says of a surface, for people and for programs.
[[nodiscard]] std::string text_of(const SurfaceAccount& account);
[[nodiscard]] Json to_json(const SurfaceAccount& account);

}  // namespace leonhard::app
