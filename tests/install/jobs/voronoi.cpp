// SPDX-License-Identifier: MIT
// The Voronoi diagram of a grid, its cells cut to a box.
#include <leonhard/delaunay/voronoi_clip.hpp>
#include <vector>

#include "check.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  std::vector<Point2> sites;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) sites.push_back({double(i), double(j)});
  const auto diagram = delaunay::voronoi_diagram(sites);
  claim(diagram.has_value(), "nobody stopped it");
  if (!diagram) return claim.failed();
  claim(diagram->vertices.size() == 16, "four cells meet at a vertex");
  const VertexId middle = diagram->site_of_input[12];
  claim(!diagram->is_unbounded(middle) && diagram->cell(middle).size() == 4, "the middle cell is a square");
  const auto cells = delaunay::clip(*diagram, delaunay::box_window({-1, -1}, {5, 5}));
  double area = 0;
  for (const double cell : cells.area) area += cell;
  claim(cells.area[middle] == 1 && area == 36, "areas are those of squares and add up to the box");
  return claim.failed();
}
