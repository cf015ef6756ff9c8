// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::app {

/// What the program tells its caller.
enum class ExitCode : int {
  done = 0,
  wrong_usage = 1,
  bad_input = 2,
  goal_not_met = 3,  ///< the run ended properly but, say, did not converge; the report says which goal
  stopped = 4,       ///< by Ctrl-C or a termination signal; what was there has been written
  internal_error = 70,  ///< a fault of the program: EX_SOFTWARE of sysexits.h
};

}  // namespace leonhard::app
