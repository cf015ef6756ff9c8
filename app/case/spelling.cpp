// SPDX-License-Identifier: MIT
#include "leonhard/app/case/spelling.hpp"

#include "leonhard/mesh/io/did_you_mean.hpp"

namespace leonhard::app {

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  if (const std::string near = io::did_you_mean(word, candidates); !near.empty()) return near;
  std::string known;
  for (const std::string& candidate : candidates) known += (known.empty() ? "" : ", ") + candidate;
  return known.empty() ? "remove it" : "known here: " + known;
}

}  // namespace leonhard::app
