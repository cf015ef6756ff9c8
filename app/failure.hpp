// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string>

#include "leonhard/app/exit_code.hpp"

namespace leonhard::app {

/// How the program ends where a subcommand threw.
struct Failure {
  ExitCode code{};
  std::string message;
};

/// Bad input, output that cannot be written, what the system refuses, and too little memory are told as such; every other
/// exception is a fault of the program and told as an internal error.
[[nodiscard]] Failure failure_of(std::exception_ptr thrown);

}  // namespace leonhard::app
