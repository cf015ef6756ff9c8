// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/euler.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/quality.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::app {

/// The boundary edges of one marker.
struct BoundaryPart {
  Marker marker{};
  std::string name;
  std::size_t edges{};
  double length{};
};

/// What `leonhard check` and `leonhard mesh` say of a mesh.
struct MeshReport {
  std::size_t vertices{}, edges{}, triangles{};
  Fingerprint fingerprint;
  std::optional<std::string> invalid;  ///< what is wrong; none: nothing
  EulerAccount euler;
  std::optional<std::string> not_delaunay;  ///< where it is not; of a mesh that is not valid none
  MeshQuality quality;
  double area{};
  std::vector<BoundaryPart> boundary;  ///< by marker

  /// Valid and balanced; the Delaunay property is a figure, not a fault.
  [[nodiscard]] bool is_sound() const { return !invalid && euler.balances(); }
  [[nodiscard]] bool is_delaunay() const { return !invalid && !not_delaunay; }
};

[[nodiscard]] MeshReport mesh_report(const TriangleMesh& mesh);

/// For people, and for programs.
[[nodiscard]] std::string text_of(const MeshReport& report);
[[nodiscard]] Json to_json(const MeshReport& report);

}  // namespace leonhard::app
