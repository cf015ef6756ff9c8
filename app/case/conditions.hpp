// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "leonhard/app/case/case.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::app {

/// Join the case file's [boundary.NAME] sections to the markers of a mesh.
///
/// used    markers that boundary edges of the mesh carry
/// names   the markers' names as the mesh file gives them; a marker without name is called by its number
/// source  the mesh's file, for messages
/// returns one condition for each marker in `used`, named for reports and pictures
/// throws  InputError on a marker without a condition and on a condition without a marker
[[nodiscard]] std::map<Marker, BoundaryCase> match_conditions(const Case&, const std::vector<Marker>& used,
                                                                const std::map<Marker, std::string>& names,
                                                                const std::string& source);

}  // namespace leonhard::app
