// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>

#include "leonhard/app/console.hpp"
#include "leonhard/app/solve/run.hpp"

/// The steps of `leonhard solve`, in the order in which commands/solve.cpp takes them. Each reads what the ones before
/// left in the run, adds its own results, and returns one line about them for the console.
namespace leonhard::app {

/// Thrown where a step was asked to stop before there was anything to write.
struct StoppedEarly {
  std::string where;
};

/// The bodies' outlines and the far field, or the domain file, as a planar straight-line graph.
std::string step_geometry(SolveRun& run);

/// A quality mesh of that graph, or the ready mesh that the case names; then the condition of each marker.
std::string step_mesh(SolveRun& run, std::stop_token stop);

/// Euler's account, quality, fingerprint and exact area. throws InputError if the account does not balance.
std::string step_account(SolveRun& run);

/// The vertex numbering that the case asks for; the mesh is renumbered.
std::string step_order(SolveRun& run);

/// Parts of the dual graph.
std::string step_partition(SolveRun& run, std::uint64_t seed, std::stop_token stop);

/// March to a steady state, a line an iteration on the console.
std::string step_march(SolveRun& run, Console& console, std::stop_token stop);

}  // namespace leonhard::app
