// SPDX-License-Identifier: MIT
#include "leonhard/app/meshes/cut_cells.hpp"

#include <fmt/core.h>

#include <utility>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/split_cells.hpp"

namespace leonhard::app {
namespace {

template <int Dim>
CutCells cut(AnyMeshFile& file, const MixedMesh<Dim>& mesh) {
  mesh::SplitMesh<Dim> split = mesh::split_cells(mesh);
  CutCells result;
  std::vector<std::size_t>& cell_of = result.cell_of;
  for (const CellId cell : split.cell_of) cell_of.push_back(cell.index());
  for (CellField& field : file.cell_fields) {
    std::vector<double> values;
    for (const std::size_t cell : cell_of)
      for (std::size_t k = 0; k < field.components; ++k)
        values.push_back(field.values[cell * field.components + k]);
    field.values = std::move(values);
  }
  const std::size_t whole = mesh.count_of(simplex_kind<Dim>);
  result.words =
      fmt::format("{} cells are drawn cut into {}", grouped(mesh.cell_count() - whole), Simplex<Dim>::cells);
  file.mesh = std::move(split.mesh);
  return result;
}

}  // namespace

CutCells cut_cells(AnyMeshFile& file) {
  if (auto* plane = std::get_if<MixedMesh<2>>(&file.mesh)) return cut(file, MixedMesh<2>(std::move(*plane)));
  if (auto* space = std::get_if<MixedMesh<3>>(&file.mesh)) return cut(file, MixedMesh<3>(std::move(*space)));
  return {};
}

}  // namespace leonhard::app
