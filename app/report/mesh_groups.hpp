// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/io/any_mesh_file.hpp"

namespace leonhard::app {

/// Cells of one region, or inner facets of one marker.
struct GroupCount {
  double number{};
  std::string name;
  std::size_t members{};
};

/// What a mesh carries beside its cells and its boundary.
struct MeshGroups {
  int dimension{};
  std::vector<GroupCount> regions;       ///< by number; none where no cell has one but 0
  std::vector<GroupCount> inner_facets;  ///< by marker
  std::vector<std::string> point_fields, cell_fields;
};

[[nodiscard]] MeshGroups mesh_groups(const AnyMeshFile& file);

/// For people, nothing where there are none; for programs, the keys that a report of the mesh gets.
[[nodiscard]] std::string text_of(const MeshGroups& groups);
[[nodiscard]] Json to_json(const MeshGroups& groups);

}  // namespace leonhard::app
