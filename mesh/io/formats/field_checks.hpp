// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/file_contents.hpp"

namespace leonhard::io {

[[nodiscard]] inline const char* rows_of(const PointField&) { return "vertices"; }
[[nodiscard]] inline const char* rows_of(const CellField&) { return "cells"; }

/// Whether fields can be written: each has a name of its own and as many values as its rows need.
///
/// rows   vertices or cells of the mesh
/// taken  names that the format keeps for itself
/// throws InputError naming the field
template <class Field>
void check_fields(const std::vector<Field>& fields, std::size_t rows,
                  std::initializer_list<const char*> taken) {
  std::set<std::string> names(taken.begin(), taken.end());
  for (const Field& field : fields) {
    const std::string where = "field \"" + field.name + "\"", of = rows_of(field);
    if (field.name.empty()) throw InputError("", "a field of " + of + " has no name", "name each field");
    if (!names.insert(field.name).second) {
      std::string kept;
      for (const char* name : taken) kept += std::string(kept.empty() ? ", not \"" : " or \"") + name + "\"";
      throw InputError(where, "another field of " + of + " has this name",
                       "give each field a name of its own" + kept);
    }
    if (field.components == 0 || field.values.size() != field.components * rows)
      throw InputError(where,
                       std::to_string(field.values.size()) + " values in rows of " +
                           std::to_string(field.components) + " do not fit " + std::to_string(rows) + " " +
                           of,
                       "give one row of values each");
  }
}

}  // namespace leonhard::io
