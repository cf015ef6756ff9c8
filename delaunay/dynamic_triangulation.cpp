// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic_triangulation.hpp"

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {

DynamicTriangulation::DynamicTriangulation(std::span<const Point2> points, unsigned threads) {
  insert(points, threads);
}

void DynamicTriangulation::clear() { *this = {}; }

Extent DynamicTriangulation::extent() const {
  if (triangles_.triangle_count() > 0) return Extent::plane;
  return line_.empty() ? Extent::nothing : line_.size() == 1 ? Extent::point : Extent::line;
}

void DynamicTriangulation::require_living(VertexId v) const {
  if (!contains(v))
    throw InputError("vertex " + std::to_string(v.raw), "is not in the triangulation",
                     "give the id of a vertex that was inserted and not removed");
}

NeighbourView DynamicTriangulation::neighbours(VertexId v) const {
  require_living(v);
  if (extent() == Extent::plane) return {triangles_, sides_[v]};
  return NeighbourView(line_.around(points_[v]));
}

DynamicTriangulation::Mesh DynamicTriangulation::to_mesh() const {
  Mesh result;
  result.mesh_vertex.resize(id_bound());
  if (extent() != Extent::plane) return result;
  TriangleMesh& mesh = result.mesh;
  for (const VertexId v : vertices()) result.mesh_vertex[v.index()] = mesh.points.push_back(points_[v]);
  mesh.vertex_markers.resize(mesh.points.size(), 0);

  const auto mesh_vertex = [&](VertexId v) { return *result.mesh_vertex[v.index()]; };
  PerId<AnyTriangleId, MaybeId<TriangleId>> mesh_triangle(triangles_.triangle_count());
  for (const AnyTriangleId t : mesh_triangle.ids())
    if (!triangles_.is_ghost(t))
      mesh_triangle[t] =
          mesh.corners.push_back({mesh_vertex(triangles_.corner(t, 0)), mesh_vertex(triangles_.corner(t, 1)),
                                  mesh_vertex(triangles_.corner(t, 2))});
  mesh.neighbours.resize(mesh.corners.size());
  mesh.regions.resize(mesh.corners.size(), 0);
  for (const AnyTriangleId t : mesh_triangle.ids()) {
    if (!mesh_triangle[t]) continue;
    for (unsigned k = 0; k < 3; ++k)
      mesh.neighbours[*mesh_triangle[t]][k] =
          mesh_triangle[triangles_.triangle(triangles_.twin(triangles_.side(t, k)))];
  }
  const std::vector<VertexId> loop = hull();
  for (std::size_t i = 0; i < loop.size(); ++i)
    mesh.boundary.push_back({mesh_vertex(loop[i]), mesh_vertex(loop[(i + 1) % loop.size()]), 1});
  return result;
}

}  // namespace leonhard::delaunay
