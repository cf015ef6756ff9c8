// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/formats/gmsh_elements.hpp"

namespace leonhard::io {

/// A cell with the number of the geometry's entity that it lies on, which may have to stand for its group.
struct CellOnEntity {
  GmshCell cell;
  Marker entity = 0;
};

/// The elements of a file while it is read, and what becomes of their groups at its end: parse_gmsh_data says by which rules.
class GmshGroups {
 public:
  /// list  of GmshList
  void add(std::size_t list, const CellOnEntity& cell) { cells_[list].push_back(cell); }
  /// An entity of the dimension is in the group `other` as well.
  void note_several(int dimension, Marker first, Marker other) { several_.insert({dimension, first, other}); }

  /// Into the lists of the data, with warnings.
  ///
  /// lists_repeat  an element in several groups is listed for each of them (formats 1 and 2)
  void finish(GmshData& data, bool lists_repeat) &&;

 private:
  void drop_repeated(std::size_t list);
  void tell_several(GmshData& data) const;
  void number_ungrouped(GmshData& data, int dimension);

  std::set<std::tuple<int, Marker, Marker>> several_;  ///< dimension, the first one, another
  std::array<std::vector<CellOnEntity>, gmsh_elements::list_count> cells_;
};

}  // namespace leonhard::io
