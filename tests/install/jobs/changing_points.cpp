// SPDX-License-Identifier: MIT
// Points that come and go, and questions in between.
#include <cmath>
#include <leonhard/delaunay/dynamic_triangulation.hpp>
#include <vector>

#include "check.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  std::vector<Point2> places;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) places.push_back({double(i), double(j)});
  delaunay::DynamicTriangulation stations(places);
  const auto [v, is_new] = stations.insert({4.5, 4.5});
  claim(is_new && stations.size() == 101, "a point between four others is new");
  claim(stations.nearest_vertex({4.4, 4.6}) == MaybeId(v), "it is the nearest one there");
  std::vector<double> heights;
  for (std::size_t i = 0; i < stations.id_bound(); ++i) {
    const Point2 p = stations.point(VertexId::from(i));
    heights.push_back(2 * p.x - p.y);
  }
  const auto here = stations.interpolate_natural_neighbour({3.25, 7.5}, heights);
  claim(here.inside() && std::abs(here.value - (2 * 3.25 - 7.5)) < 1e-12, "a linear function comes out exactly");
  stations.remove(v);
  claim(stations.size() == 100 && !stations.contains(v) && !stations.validate(), "it goes again");
  claim(stations.fingerprint() == delaunay::DynamicTriangulation(places).fingerprint(), "and leaves nothing behind");
  return claim.failed();
}
