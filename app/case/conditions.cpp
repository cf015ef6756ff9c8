// SPDX-License-Identifier: MIT
#include "leonhard/app/case/conditions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "leonhard/app/case/spelling.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

using Sections = std::map<std::string, BoundaryCase>;

/// The section for a marker: by its name first, then by its number.
Sections::const_iterator find_section(const Sections& sections, Marker marker,
                                      const std::map<Marker, std::string>& names) {
  const auto name = names.find(marker);
  if (name != names.end())
    if (const auto found = sections.find(name->second); found != sections.end()) return found;
  return sections.find(std::to_string(marker));
}

std::string marker_words(Marker marker, const std::map<Marker, std::string>& names) {
  const auto name = names.find(marker);
  return name == names.end() ? std::to_string(marker) : name->second;
}

}  // namespace

std::map<Marker, BoundaryCase> match_conditions(const Case& c, const std::vector<Marker>& used,
                                                  const std::map<Marker, std::string>& names,
                                                  const std::string& source) {
  std::map<Marker, BoundaryCase> conditions;
  std::set<std::string> matched;
  std::vector<std::string> marker_names;
  for (const Marker marker : std::set<Marker>(used.begin(), used.end())) {
    marker_names.push_back(marker_words(marker, names));
    const auto section = find_section(c.boundary, marker, names);
    if (section == c.boundary.end()) continue;
    matched.insert(section->first);
    const bool by_number = section->first == std::to_string(marker);
    conditions[marker] = section->second;
    if (!by_number) conditions[marker].name = marker_names.back();
  }
  for (const auto& [name, boundary] : c.boundary)
    if (!matched.contains(name))
      throw InputError(boundary.where, fmt::format("{} has no boundary marker \"{}\"", source, name),
                       suggestion(name, marker_names));
  for (const Marker marker : used)
    if (!conditions.contains(marker))
      throw InputError(
          c.file.string(),
          fmt::format("the boundary marker \"{}\" of {} has no condition", marker_words(marker, names),
                      source),
          fmt::format("add [boundary.{}] with kind = \"slip-wall\" or another", marker_words(marker, names)));
  return conditions;
}

}  // namespace leonhard::app
