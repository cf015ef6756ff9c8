// SPDX-License-Identifier: MIT
#include "leonhard/app/report/vorticity.hpp"

namespace leonhard::app {

std::vector<double> vorticity(const TriangleMesh& mesh, const PerId<VertexId, State<2>>& states) {
  std::vector<double> circulation(mesh.vertex_count()), area(mesh.vertex_count());
  for (const auto& corners : mesh.corners) {
    double around = 0;  // by Stokes: twice the triangle's circulation, the velocity linear along each side
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = corners[i], b = corners[(i + 1) % 3];
      const Vec2 side = mesh.points[b] - mesh.points[a];
      around += (states[a].u + states[b].u) * side.x + (states[a].v + states[b].v) * side.y;
    }
    const double doubled =
        cross(mesh.points[corners[1]] - mesh.points[corners[0]], mesh.points[corners[2]] - mesh.points[corners[0]]);
    for (const VertexId v : corners) circulation[v.index()] += around, area[v.index()] += doubled;
  }
  for (std::size_t v = 0; v < area.size(); ++v) circulation[v] /= area[v];
  return circulation;
}

}  // namespace leonhard::app
