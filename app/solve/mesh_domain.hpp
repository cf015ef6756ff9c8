// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "leonhard/app/case/case.hpp"
#include "leonhard/app/geometry/assemble.hpp"
#include "leonhard/delaunay/refine.hpp"

namespace leonhard::app {

/// A quality mesh of a domain, sized by its sources.
///
/// max_area  no triangle larger than this; not positive: no bound
/// throws    InputError as delaunay::mesh_pslg
[[nodiscard]] delaunay::RefinedMesh mesh_domain(const DomainGeometry& domain, const MesherCase& mesher,
                                                double max_area, std::stop_token stop);

/// What a user should know of the meshing: repairs of the input, a budget that was too small.
[[nodiscard]] std::vector<std::string> mesh_warnings(const delaunay::RefineReport& report,
                                                     const MesherCase& mesher);

}  // namespace leonhard::app
