// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>

#include "leonhard/app/console.hpp"
#include "leonhard/app/solve/space_run.hpp"

/// The steps of `leonhard solve` about a mesh of space, in the order in which commands/solve.cpp takes them; as in steps.hpp.
namespace leonhard::app::space {

/// The mesh that the case names, and the condition of each marker.
std::string step_mesh(SpaceRun& run);

/// Euler's account, the exact volume, quality. throws InputError if an account does not balance
std::string step_account(SpaceRun& run);

/// The dual, in the vertex numbering that the case asks for.
std::string step_order(SpaceRun& run);

/// March to a steady state, a line an iteration on the console.
std::string step_march(SpaceRun& run, Console& console, std::stop_token stop);

}  // namespace leonhard::app::space
