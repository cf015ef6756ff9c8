// SPDX-License-Identifier: MIT
#include "leonhard/solver/steady_result.hpp"

namespace leonhard {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::converged:
      return "converged";
    case Verdict::settled:
      return "settled";
    case Verdict::stalled:
      return "stalled";
    case Verdict::diverged:
      return "diverged";
    case Verdict::iteration_limit:
      return "iteration_limit";
    case Verdict::stopped:
      return "stopped";
  }
  return "";
}

}  // namespace leonhard
