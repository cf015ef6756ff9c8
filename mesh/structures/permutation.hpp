// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "leonhard/mesh/id.hpp"

namespace leonhard::mesh {

/// throws  InputError, naming an entry, if new_of_old does not give each of `count` vertices a number of its own below
///         count
void check_permutation(std::size_t count, const PerId<VertexId, VertexId>& new_of_old);

/// values[v] at its vertex's new number.
template <class T>
[[nodiscard]] PerId<VertexId, T> renumbered(const PerId<VertexId, T>& values,
                                            const PerId<VertexId, VertexId>& new_of_old) {
  PerId<VertexId, T> result(values.size());
  for (const VertexId old : values.ids()) result[new_of_old[old]] = values[old];
  return result;
}

}  // namespace leonhard::mesh
