// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tet_algorithm.hpp"

#include <cstddef>
#include <string>

#include "leonhard/delaunay/space/tet_flipping.hpp"
#include "leonhard/delaunay/space/tet_insertion.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {

std::optional<TetAlgorithm> tet_algorithm_named(std::string_view name) {
  for (const NamedTetAlgorithm& known : named_tet_algorithms)
    if (known.name == name) return known.algorithm;
  return std::nullopt;
}

PointTetrahedralization tetrahedralize_distinct(std::span<const Point3> points, TetAlgorithm algorithm,
                                                const TetAlgorithmOptions& options) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InputError("point " + std::to_string(i), "is at " + mesh::words(points[i]),
                       "give finite coordinates");
  switch (algorithm) {
    case TetAlgorithm::insertion:
      return tetrahedralize_insertion(points, options);
    case TetAlgorithm::flipping:
      return tetrahedralize_flipping(points, options);
  }
  return {};
}

}  // namespace leonhard::delaunay
