// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/app/command_line/command.hpp"
#include "leonhard/delaunay/crossings.hpp"

namespace leonhard::app {

/// --crossings, what becomes of segments that cross.
[[nodiscard]] inline Option crossings_option(std::string* target) {
  std::vector<std::string> names;
  for (const auto& [name, crossings] : delaunay::named_crossings) names.emplace_back(name);
  return {.names = "--crossings",
          .help = "Segments that cross: a vertex is put there (default), all are named in an error, or the later ones are left out",
          .target = target,
          .choices = names};
}

/// name     one of delaunay::named_crossings, as crossings_option lets pass, or empty
/// fallback where the name is empty
[[nodiscard]] inline delaunay::Crossings crossings_named(const std::string& name, delaunay::Crossings fallback) {
  for (const auto& [known, crossings] : delaunay::named_crossings)
    if (known == name) return crossings;
  return fallback;
}

}  // namespace leonhard::app
