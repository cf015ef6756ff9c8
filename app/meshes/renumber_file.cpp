// SPDX-License-Identifier: MIT
#include "leonhard/app/meshes/renumber_file.hpp"

#include <algorithm>
#include <utility>

#include "leonhard/mesh/permute.hpp"

namespace leonhard::app {
namespace {

/// Each row at its new place.
template <class Field, class IdT>
std::vector<Field> permuted(std::vector<Field> fields, const PerId<IdT, IdT>& new_of_old) {
  for (Field& field : fields) {
    std::vector<double> values(field.values.size());
    const std::size_t width = field.components;
    for (const IdT old : new_of_old.ids())
      std::copy_n(field.values.begin() + static_cast<std::ptrdiff_t>(old.index() * width), width,
                  values.begin() + static_cast<std::ptrdiff_t>(new_of_old[old].index() * width));
    field.values = std::move(values);
  }
  return fields;
}

}  // namespace

AnyMeshFile renumbered(const AnyMeshFile& file, const std::vector<std::uint32_t>& order) {
  PerId<VertexId, VertexId> new_of_old(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) new_of_old[VertexId::from(order[i])] = VertexId::from(i);
  return std::visit(
      [&](const auto& mesh) {
        auto result = mesh::renumber(mesh, new_of_old);
        return AnyMeshFile{std::move(result.mesh),
                           {},
                           permuted(file.point_fields, new_of_old),
                           permuted(file.cell_fields, result.new_cell)};
      },
      file.mesh);
}

}  // namespace leonhard::app
