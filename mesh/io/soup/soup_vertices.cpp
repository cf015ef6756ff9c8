// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/soup_vertices.hpp"

#include <algorithm>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/soup/places.hpp"
#include "leonhard/mesh/io/soup/soup_checks.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

template <class T>
void keep_rows(std::vector<T>& values, const std::vector<bool>& kept, std::size_t components) {
  if (values.empty()) return;
  std::size_t next = 0;
  for (std::size_t row = 0; row < kept.size(); ++row) {
    if (!kept[row]) continue;
    std::move(values.begin() + static_cast<std::ptrdiff_t>(row * components),
              values.begin() + static_cast<std::ptrdiff_t>((row + 1) * components),
              values.begin() + static_cast<std::ptrdiff_t>(next * components));
    ++next;
  }
  values.resize(next * components);
}

/// Every corner v becomes stands_for[v], and only vertices that stand for themselves and are kept stay.
template <int Dim>
void keep_vertices(MeshSoup<Dim>& soup, const std::vector<bool>& kept,
                   const PerId<VertexId, VertexId>& stands_for) {
  PerId<VertexId, VertexId> new_id(kept.size());
  std::size_t next = 0;
  for (const VertexId v : new_id.ids())
    if (kept[v.index()]) new_id[v] = VertexId::from(next++);
  const auto renumber = [&](VertexId& v) { v = new_id[stands_for[v]]; };
  for (VertexId& v : soup.mesh.corners.links()) renumber(v);
  for (auto& facet : soup.mesh.boundary)
    for (std::size_t i = 0; i < facet.corners.size(); ++i) renumber(facet.corners[i]);
  keep_rows(soup.mesh.points.flat(), kept, 1);
  keep_rows(soup.mesh.vertex_markers.flat(), kept, 1);
  for (PointField& field : soup.point_fields) keep_rows(field.values, kept, field.components);
}

}  // namespace

template <int Dim>
void weld_vertices(MeshSoup<Dim>& soup, double tolerance) {
  const auto stands_for = weld_places(soup.mesh.points, tolerance);
  std::vector<bool> kept(stands_for.size());
  for (const VertexId v : stands_for.ids()) kept[v.index()] = stands_for[v] == v;
  const auto joined = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  if (joined == 0) return;
  keep_vertices(soup, kept, stands_for);
  soup.warnings.push_back(
      std::to_string(joined) + " vertices were joined with others " +
      (tolerance == 0 ? "of equal coordinates" : "no farther away than " + mesh::words(tolerance)));
}

template <int Dim>
void drop_unused_vertices(MeshSoup<Dim>& soup) {
  std::vector<bool> used(soup.mesh.vertex_count(), false);
  for (const VertexId v : soup.mesh.corners.links()) used[v.index()] = true;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  if (count == 0) return;
  for (std::size_t i = 0; i < soup.mesh.boundary.size(); ++i)
    for (const VertexId v : soup.mesh.boundary[i].corners)
      if (!used[v.index()])
        throw InputError(place_in(soup, soup.facet_lines, i),
                         marked_facet_words(soup.mesh.boundary[i]) + " has vertex " +
                             std::to_string(v.index()) + ", which no cell uses",
                         "remove it, or restore the cells about the vertex");
  keep_vertices(soup, used, every_vertex_itself(used.size()));
  const auto first = static_cast<std::size_t>(std::find(used.begin(), used.end(), false) - used.begin());
  soup.warnings.push_back(std::to_string(count) + (count == 1 ? " vertex" : " vertices") +
                          " that no cell uses " + (count == 1 ? "was" : "were") +
                          " left out, and the others renumbered; the first is number " +
                          std::to_string(first));
}

template void weld_vertices(MeshSoup<2>&, double);
template void weld_vertices(MeshSoup<3>&, double);
template void drop_unused_vertices(MeshSoup<2>&);
template void drop_unused_vertices(MeshSoup<3>&);

}  // namespace leonhard::io
