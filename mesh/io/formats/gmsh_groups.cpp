// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/gmsh_groups.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

using namespace gmsh_elements;

namespace {

/// "11 "wall"", or the number alone.
std::string group_words(const GmshData& data, int dimension, Marker group) {
  const auto name = data.names.find({dimension, group});
  return std::to_string(group) + (name == data.names.end() ? "" : " " + in_quotes(name->second));
}

}  // namespace

void GmshGroups::finish(GmshData& data, bool lists_repeat) && {
  for (std::size_t list = 0; lists_repeat && list < list_count; ++list) drop_repeated(list);
  tell_several(data);
  for (int dimension = 1; dimension <= 3; ++dimension) number_ungrouped(data, dimension);
  const std::array<std::vector<GmshCell>*, list_count> lists{
      &data.lines,     &data.triangles, &data.quadrilaterals, &data.tetrahedra,
      &data.hexahedra, &data.prisms,    &data.pyramids};
  for (std::size_t i = 0; i < list_count; ++i) {
    lists[i]->reserve(cells_[i].size());
    for (const CellOnEntity& c : cells_[i]) lists[i]->push_back(c.cell);
    cells_[i] = {};
  }
}

/// An element in several groups is listed several times, with the same nodes.
void GmshGroups::drop_repeated(std::size_t list) {
  auto& cells = cells_[list];
  const auto key_of = [&](std::size_t i) {
    auto key = cells[i].cell.corners;
    std::sort(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(corners_in_list[list]));
    return key;
  };
  std::vector<std::pair<std::array<VertexId, most_cell_corners>, std::size_t>> sorted;
  sorted.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) sorted.emplace_back(key_of(i), i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> dropped(cells.size(), false);
  for (std::size_t i = 1, first = 0; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[first].first) {
      first = i;
      continue;
    }
    const Marker group = cells[sorted[first].second].cell.group, other = cells[sorted[i].second].cell.group;
    if (group == other) continue;  // a repetition that groups do not explain is left to the mesh's checks
    dropped[sorted[i].second] = true;
    several_.insert({dimension_of_list[list], group, other});
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!dropped[i]) cells[next++] = cells[i];
  cells.resize(next);
}

void GmshGroups::tell_several(GmshData& data) const {
  std::string list;
  for (const auto& [dimension, first, other] : several_)
    list += (list.empty() ? "" : "; ") + group_words(data, dimension, first) + ", also in " +
            group_words(data, dimension, other);
  if (!list.empty())
    data.warnings.push_back("elements are in several physical groups, of which the first was taken: " + list);
}

/// Of one dimension: groups that say that there is none become 0, elements in no group get their entity's number.
void GmshGroups::number_ungrouped(GmshData& data, int dimension) {
  std::set<Marker> groups;
  for (const auto& [group, name] : data.names)
    if (group.first == dimension) groups.insert(group.second);
  std::size_t ungrouped = 0;
  const auto for_each_cell = [&](auto visit) {
    for (std::size_t list = 0; list < list_count; ++list)
      if (dimension_of_list[list] == dimension)
        for (CellOnEntity& c : cells_[list]) visit(c);
  };
  for_each_cell([&](const CellOnEntity& c) {
    groups.insert(c.cell.group);
    if (c.cell.group == 0 && c.entity != 0) ++ungrouped;
  });
  if (ungrouped > 0) {
    std::map<Marker, Marker> number_of;
    for_each_cell([&](CellOnEntity& c) {
      if (c.cell.group != 0 || c.entity == 0) return;
      const auto [at, is_new] = number_of.emplace(c.entity, c.entity);
      if (is_new) {
        while (groups.contains(at->second)) ++at->second;
        groups.insert(at->second);
      }
      c.cell.group = at->second;
    });
    const bool changed =
        std::any_of(number_of.begin(), number_of.end(), [](const auto& n) { return n.first != n.second; });
    data.warnings.push_back(std::to_string(ungrouped) + " elements of dimension " +
                            std::to_string(dimension) +
                            " are in no physical group; the numbers of the geometry's entities stand for it" +
                            (changed ? ", the next free ones where a group has that number" : ""));
  }
  for (auto name = data.names.begin(); name != data.names.end();) {
    const bool is_none = name->first.first == dimension && (name->second == gmsh_name_of_none(false) ||
                                                            name->second == gmsh_name_of_none(true));
    if (!is_none) {
      ++name;
      continue;
    }
    for_each_cell([&](CellOnEntity& c) {
      if (c.cell.group == name->first.second) c.cell.group = 0;
    });
    name = data.names.erase(name);
  }
}

}  // namespace leonhard::io
