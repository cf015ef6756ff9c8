// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "leonhard/app/solve/run.hpp"
#include "leonhard/mesh/io/file_contents.hpp"

/// The files that a run in the plane and one in space both leave.
namespace leonhard::app {

/// density, velocity, pressure, mach, cp, total_pressure_loss (1 less the ratio to the free stream's) and entropy (p / rho^gamma
/// over the free stream's, less 1) of states, in their order.
template <int dim>
[[nodiscard]] std::vector<PointField> flow_fields(const FlowCase& flow, const PerId<VertexId, State<dim>>& states);

/// history.csv: a line an iteration. throws OutputError
template <int dim>
void write_history(const std::vector<Iteration>& history, const std::filesystem::path& path);

/// The names of a folder's files, and of the two that a report writes last.
[[nodiscard]] std::set<std::string> files_in(const std::filesystem::path& folder);

}  // namespace leonhard::app
