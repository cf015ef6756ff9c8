// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::app {

/// What `leonhard check` and `leonhard mesh` say of a mesh: counts, Euler's account, validity, Delaunay property,
/// quality, fingerprint, and the length of each marker's boundary.
[[nodiscard]] Json mesh_report(const TriangleMesh& mesh);

/// The same as text for people.
[[nodiscard]] std::string mesh_report_text(const Json& report);

/// Valid and balanced; the Delaunay property is a figure, not a fault.
[[nodiscard]] bool is_sound(const Json& report);

}  // namespace leonhard::app
