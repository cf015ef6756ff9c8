// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::app {

/// What `leonhard check` and `leonhard tetrahedralize` say of a tetrahedral mesh: counts, Euler's account with components,
/// handles and cavities, validity, Delaunay property, whether it fills its convex hull, quality, volume by its tetrahedra
/// and by its boundary in rational arithmetic, fingerprint, and each marker's faces and area.
///
/// Words that need a valid mesh are null where it is not.
[[nodiscard]] Json tet_mesh_report(const TetMesh& mesh);

/// The same as text for people.
[[nodiscard]] std::string tet_mesh_report_text(const Json& report);

/// Valid, balanced, and both volumes equal; the Delaunay property is a figure, not a fault.
[[nodiscard]] bool is_sound_in_space(const Json& report);

}  // namespace leonhard::app
