// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic/answer_all.hpp"
#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"

namespace leonhard::delaunay {

std::vector<SpaceLocation> DynamicTetrahedralization::locate(std::span<const Point3> points,
                                                             unsigned threads) const {
  return answer_all<SpaceLocation>(points, threads, Search({}),
                                   [&](const Point3& p, Search& search) { return locate(p, search); });
}

std::vector<MaybeId<VertexId>> DynamicTetrahedralization::nearest_vertices(std::span<const Point3> points,
                                                                           unsigned threads) const {
  return answer_all<MaybeId<VertexId>>(points, threads, Search({}), [&](const Point3& p, Search& search) {
    return nearest_vertex(p, search);
  });
}

}  // namespace leonhard::delaunay
