// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/initial_field.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::app {
namespace {

constexpr auto other_mesh = "give the field of a run on this mesh, or leave initial.field out";

std::array<double, 2> coordinates(Point2 p) { return {p.x, p.y}; }
std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// Vertices sorted by their coordinates.
template <class Point>
std::vector<VertexId> by_place(const PerId<VertexId, Point>& points) {
  std::vector<VertexId> order(points.ids().begin(), points.ids().end());
  std::ranges::sort(order, {}, [&](VertexId v) { return coordinates(points[v]); });
  return order;
}

/// For each vertex of a mesh that of the file.
template <class Point>
PerId<VertexId, VertexId> match_vertices(const PerId<VertexId, Point>& points, const PerId<VertexId, Point>& file,
                                         const std::string& source) {
  if (points.size() != file.size())
    throw InputError(source, fmt::format("has {} vertices, the mesh has {}", file.size(), points.size()), other_mesh);
  PerId<VertexId, VertexId> same(points.size());
  for (const VertexId v : points.ids()) same[v] = v;
  if (points == file) return same;
  const std::vector<VertexId> ours = by_place(points), theirs = by_place(file);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Point& p = points[ours[i]];
    if (p != file[theirs[i]]) {
      const Point& first = std::min(p, file[theirs[i]], [](const Point& a, const Point& b) { return coordinates(a) < coordinates(b); });
      throw InputError(source, fmt::format("is of another mesh: only one of the two has a vertex at {}", mesh::words(first)), other_mesh);
    }
    if (i > 0 && p == points[ours[i - 1]])
      throw InputError(source,
                       fmt::format("numbers its vertices otherwise, and two are at {}: which is which cannot be told", mesh::words(p)),
                       "run both cases with the same [order]");
    same[ours[i]] = theirs[i];
  }
  return same;
}

template <int dim>
const std::vector<double>& values_of(const MixedMeshFile<dim>& file, const std::string& name, std::size_t components,
                                     const std::string& source) {
  for (const PointField& field : file.point_fields)
    if (field.name == name && field.components == components) return field.values;
  throw InputError(source, fmt::format("has no point field \"{}\" of {} component(s)", name, components),
                   "give a field.vtu that solve wrote");
}

}  // namespace

template <int dim>
PerId<VertexId, State<dim>> initial_states(const std::filesystem::path& path,
                                           const PerId<VertexId, typename Simplex<dim>::Point>& points) {
  const std::string source = path.string();
  const MixedMeshFile<dim> file = io::read_mixed_mesh<dim>(path);
  const auto there = match_vertices(points, file.mesh.points, source);
  const auto &density = values_of(file, "density", 1, source), &velocity = values_of(file, "velocity", dim, source),
             &pressure = values_of(file, "pressure", 1, source);
  PerId<VertexId, State<dim>> states(points.size());
  for (const VertexId v : points.ids()) {
    const std::size_t k = there[v].index();
    solver::Axes<dim> speed;
    for (std::size_t i = 0; i < dim; ++i) speed[i] = velocity[dim * k + i];
    states[v] = solver::state_with(density[k], speed, pressure[k]);
    if (!solver::is_physical(states[v]))
      throw InputError(source,
                       fmt::format("density {}, pressure {} at {} are no state of a gas", density[k], pressure[k],
                                   mesh::words(points[v])),
                       "give the field of a run that did not diverge");
  }
  return states;
}

template PerId<VertexId, State<2>> initial_states<2>(const std::filesystem::path&, const PerId<VertexId, Point2>&);
template PerId<VertexId, State<3>> initial_states<3>(const std::filesystem::path&, const PerId<VertexId, Point3>&);

}  // namespace leonhard::app
