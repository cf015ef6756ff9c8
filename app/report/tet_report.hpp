// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/tet_euler.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/tet_quality.hpp"

namespace leonhard::app {

/// The boundary faces of one marker.
struct BoundaryFaces {
  Marker marker{};
  std::string name;
  std::size_t faces{};
  double area{};
};

/// What can be said of a valid tetrahedral mesh only.
struct ValidTetReport {
  Fingerprint fingerprint;
  TetEulerAccount euler;
  std::optional<std::string> not_delaunay;  ///< where it is not
  bool fills_convex_hull{};
  TetMeshQuality quality;
  double volume{};                  ///< of its tetrahedra, from rational arithmetic
  double volume_within_boundary{};  ///< likewise
  bool volumes_equal{};             ///< as rational numbers
  std::vector<BoundaryFaces> boundary;
};

/// What `leonhard check` and `leonhard tetrahedralize` say of a tetrahedral mesh.
struct TetReport {
  std::size_t vertices{}, tetrahedra{};
  std::optional<std::string> invalid;   ///< what is wrong; none: nothing
  std::optional<ValidTetReport> valid;  ///< none, where something is

  /// Valid, balanced, and both volumes equal; the Delaunay property is a figure, not a fault.
  [[nodiscard]] bool is_sound() const { return valid && valid->euler.balances() && valid->volumes_equal; }
};

[[nodiscard]] TetReport tet_mesh_report(const TetMesh& mesh);

/// For people.
[[nodiscard]] std::string text_of(const TetReport& report);

/// For programs. Words that need a valid mesh are null where it is not.
[[nodiscard]] Json to_json(const TetReport& report);

}  // namespace leonhard::app
