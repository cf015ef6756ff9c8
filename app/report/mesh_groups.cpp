// SPDX-License-Identifier: MIT
#include "leonhard/app/report/mesh_groups.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::app {
namespace {

std::vector<GroupCount> counts_of(const std::map<double, std::size_t>& members,
                                  const std::map<Marker, std::string>& names) {
  std::vector<GroupCount> list;
  for (const auto& [number, count] : members) {
    GroupCount group{number, mesh::words(number), count};
    const bool is_marker =
        std::abs(number) <= std::numeric_limits<Marker>::max() && number == std::floor(number);
    if (is_marker)
      if (const auto name = names.find(static_cast<Marker>(number)); name != names.end())
        group.name = name->second;
    list.push_back(group);
  }
  return list;
}

template <class Mesh>
std::vector<GroupCount> regions_of(const Mesh& mesh) {
  std::map<double, std::size_t> cells;
  for (const double region : mesh.regions) ++cells[region];
  if (cells.size() == 1 && cells.contains(0)) return {};
  return counts_of(cells, mesh.region_names);
}

template <class Mesh>
const auto& inner_facets_in(const Mesh& mesh) {
  if constexpr (requires { mesh.inner_facets(); }) {
    return mesh.inner_facets();
  } else {
    return mesh.inner_facets;
  }
}

template <class Mesh>
std::vector<GroupCount> inner_facets_of(const Mesh& mesh) {
  std::map<double, std::size_t> facets;
  for (const auto& facet : inner_facets_in(mesh)) ++facets[facet.marker];
  return counts_of(facets, mesh.marker_names);
}

template <class Field>
std::vector<std::string> names_of(const std::vector<Field>& fields) {
  std::vector<std::string> names;
  for (const Field& field : fields) names.push_back(field.name);
  return names;
}

Json counts_json(const std::vector<GroupCount>& groups, const char* number, const char* members) {
  Json list = Json::array();
  for (const GroupCount& group : groups)
    list.push_back({{number, group.number}, {"name", group.name}, {members, group.members}});
  return list;
}

}  // namespace

MeshGroups mesh_groups(const AnyMeshFile& file) {
  MeshGroups groups{file.dimension(), {}, {}, names_of(file.point_fields), names_of(file.cell_fields)};
  std::visit(
      [&](const auto& mesh) {
        groups.regions = regions_of(mesh);
        groups.inner_facets = inner_facets_of(mesh);
      },
      file.mesh);
  return groups;
}

std::string text_of(const MeshGroups& groups) {
  std::string text;
  for (const GroupCount& region : groups.regions)
    text += fmt::format("{:<14}{} (region {}): {} cells\n", "region", region.name, mesh::words(region.number),
                        grouped(region.members));
  for (const GroupCount& facets : groups.inner_facets)
    text += fmt::format("{:<14}{} (marker {}): {} {}\n", "inside", facets.name, mesh::words(facets.number),
                        grouped(facets.members), groups.dimension == 2 ? "edges" : "faces");
  const auto add_fields = [&](std::string_view title, const std::vector<std::string>& names) {
    if (names.empty()) return;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    text += fmt::format("{:<14}{}\n", title, list);
  };
  add_fields("point fields", groups.point_fields);
  add_fields("cell fields", groups.cell_fields);
  return text;
}

Json to_json(const MeshGroups& groups) {
  return {
      {"regions", counts_json(groups.regions, "region", "cells")},
      {"inner_facets", counts_json(groups.inner_facets, "marker", groups.dimension == 2 ? "edges" : "faces")},
      {"point_fields", groups.point_fields},
      {"cell_fields", groups.cell_fields}};
}

}  // namespace leonhard::app
