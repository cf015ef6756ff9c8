// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/mixed_euler.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard::app {

/// The boundary facets of one marker.
struct BoundaryFacets {
  Marker marker{};
  std::string name;
  std::size_t facets{};
  double size{};  ///< length or area
};

/// What `leonhard check` says of a mesh of mixed cells.
struct MixedReport {
  int dimension{};
  std::size_t vertices{}, cells{};
  std::array<std::size_t, cell_kind_count> of_kind{};
  std::optional<std::string> invalid;  ///< what is wrong; none: nothing
  Fingerprint fingerprint;
  MixedEulerAccount euler;
  double size{};             ///< area or volume: the sum of the median dual's
  double smallest_volume{};  ///< of a vertex's control volume
  std::vector<BoundaryFacets> boundary;

  /// Valid and balanced.
  [[nodiscard]] bool is_sound() const { return !invalid && euler.balances(); }
};

/// mesh  passes mesh::validate, or what is wrong is what is reported
template <int Dim>
[[nodiscard]] MixedReport mixed_report(const MixedMesh<Dim>& mesh);

/// For people, and for programs.
[[nodiscard]] std::string text_of(const MixedReport& report);
[[nodiscard]] Json to_json(const MixedReport& report);

}  // namespace leonhard::app
