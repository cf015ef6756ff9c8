// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic/answer_all.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"

namespace leonhard::delaunay {

std::vector<PointLocation> DynamicTriangulation::locate(std::span<const Point2> points,
                                                        unsigned threads) const {
  return answer_all<PointLocation>(points, threads, Search({}),
                                   [&](Point2 p, Search& search) { return locate(p, search); });
}

std::vector<MaybeId<VertexId>> DynamicTriangulation::nearest_vertices(std::span<const Point2> points,
                                                                      unsigned threads) const {
  return answer_all<MaybeId<VertexId>>(points, threads, Search({}),
                                       [&](Point2 p, Search& search) { return nearest_vertex(p, search); });
}

std::vector<Interpolated> DynamicTriangulation::interpolate_linear(std::span<const Point2> points,
                                                                   std::span<const double> values,
                                                                   unsigned threads) const {
  require_values(values);
  return answer_all<Interpolated>(points, threads, Search({}), [&](Point2 p, Search& search) {
    const PointLocation::Kind where = find_linear_weights(p, search);
    return interpolated(where, search.weights, values);
  });
}

std::vector<Interpolated> DynamicTriangulation::interpolate_natural_neighbour(std::span<const Point2> points,
                                                                              std::span<const double> values,
                                                                              unsigned threads) const {
  require_values(values);
  return answer_all<Interpolated>(points, threads, Search({}), [&](Point2 p, Search& search) {
    const PointLocation::Kind where = find_natural_weights(p, search);
    return interpolated(where, search.weights, values);
  });
}

}  // namespace leonhard::delaunay
