// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>
#include <string_view>

namespace leonhard::graph {

enum class FiedlerMethod {
  multilevel,  ///< Davidson's method preconditioned by a multilevel cycle: tens of iterations at any size
  lanczos      ///< Lanczos with full reorthogonalisation: some hundreds of iterations and stored vectors
};

enum class FiedlerOutcome { converged, iteration_limit, stopped };

/// The word for it, e.g. "converged".
[[nodiscard]] constexpr std::string_view to_string(FiedlerOutcome outcome) {
  switch (outcome) {
    case FiedlerOutcome::converged:
      return "converged";
    case FiedlerOutcome::iteration_limit:
      return "iteration_limit";
    case FiedlerOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct FiedlerOptions {
  FiedlerMethod method = FiedlerMethod::multilevel;
  double tolerance = 1e-6;             ///< converged when residual <= tolerance * value
  std::uint32_t max_iterations = 600;  ///< products with the Laplacian
  std::uint64_t seed = 1;              ///< of the random start vectors
  std::stop_token stop{};
};

}  // namespace leonhard::graph
