// SPDX-License-Identifier: MIT
#include <algorithm>

#include "leonhard/delaunay/dynamic/space/vertex_weights.hpp"
#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"

namespace leonhard::delaunay {

TetLocation::Kind DynamicTetrahedralization::find_linear_weights(const Point3& p, Search& search) const {
  const TetLocation at = locate_from(p, search);
  barycentric_weights(points_.flat(), at, p, search.weights);
  return at.kind;
}

/// Whether p, on the hull, lies strictly inside a part of it that is in one plane: on a face, or on an edge between faces
/// in one plane.
bool DynamicTetrahedralization::zone_is_flat_on_hull(const TetConflictZone& zone) const {
  const auto first =
      std::find_if(zone.tets().begin(), zone.tets().end(), [&](TetId t) { return cells_.is_ghost(t); });
  return std::all_of(first, zone.tets().end(), [&](TetId t) {
    for (unsigned i = 1; cells_.is_ghost(t) && i < 4; ++i)
      if (side_of_face(cells_, points_.flat(), *first, 0, points_[cells_.corners[t][i]]) != Sign::zero)
        return false;
    return true;
  });
}

TetLocation::Kind DynamicTetrahedralization::find_natural_weights(const Point3& p, Search& search) const {
  if (!has_tets()) return find_linear_weights(p, search);
  const TetId found = find(p, search);
  const TetLocation at = answer(p, found);
  if (!at.inside() || at.kind == TetLocation::Kind::on_vertex) {
    barycentric_weights(points_.flat(), at, p, search.weights);
    return at.kind;
  }
  search.zone.collect(cells_, points_.flat(), found, p);
  if (!search.zone.has_ghost())
    sibson_weights(cells_, points_.flat(), search.zone, p, search.weights);
  else if (zone_is_flat_on_hull(search.zone))
    sibson_weights_on_hull(cells_, points_.flat(), search.zone, p, search.weights);
  else
    barycentric_weights(points_.flat(), at, p, search.weights);
  return at.kind;
}

}  // namespace leonhard::delaunay
