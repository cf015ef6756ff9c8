// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/space_steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/app/solve/march.hpp"
#include "leonhard/app/solve/problem.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "leonhard/mesh/permute.hpp"

namespace leonhard::app::space {
namespace {

/// "1,024 tetrahedra, 16 prisms"
std::string cells_in_words(const MixedMesh<3>& mesh) {
  std::string words;
  for (const CellKind kind : kinds_of_space)
    if (const std::size_t count = mesh.count_of(kind); count > 0)
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", grouped(count),
                           count == 1 ? shape_of(kind).name : shape_of(kind).names);
  return words;
}

/// Cells cut into tetrahedra: for the exact volume and for pictures.
void cut_the_cells(SpaceRun& run) {
  if (run.mesh.count_of(CellKind::tetrahedron) == run.mesh.cell_count()) {
    run.tets = mesh::simplex_mesh_of(run.mesh);
    run.quality = mesh::quality(*run.tets);
    return;
  }
  try {
    run.tets = mesh::split_cells(run.mesh).mesh;
  } catch (const InputError& error) {
    run.warnings.push_back(fmt::format("without exact volume and pictures of cuts: the cells cannot be cut into tetrahedra: {}",
                                       error.what()));
  }
}

void check_formulas(const SpaceRun& run) {
  for (const auto& formula : run.euler.formulas)
    if (!formula.holds())
      throw InputError(run.the_case.mesh_file.string(),
                       fmt::format("Euler's account of the mesh does not balance: {}: {} on the left, {} on the right",
                                   formula.words, formula.lhs, formula.rhs),
                       "check the cells of the file");
}

VolumeAccount volume_account(const SpaceRun& run) {
  const mpq_class cells6 = mesh::exact_volume6(*run.tets), enclosed6 = mesh::exact_boundary_volume6(*run.tets);
  VolumeAccount account{cells6.get_d() / 6, enclosed6.get_d() / 6, cells6 == enclosed6};
  const auto [least, most] = std::minmax_element(run.dual->volume.begin(), run.dual->volume.end());
  account.smallest_control = *least, account.largest_control = *most;
  return account;
}

}  // namespace

std::string step_mesh(SpaceRun& run) {
  MixedMeshFile<3> file = io::read_mixed_mesh<3>(run.the_case.mesh_file);
  run.mesh = std::move(file.mesh);
  run.warnings = std::move(file.warnings);
  std::set<Marker> used;
  for (const auto& facet : run.mesh.boundary) used.insert(facet.marker);
  run.conditions = match_conditions(run.the_case, {used.begin(), used.end()}, run.mesh.marker_names,
                                    run.the_case.mesh_file.string());
  for (const auto& [marker, condition] : run.conditions) run.mesh.marker_names[marker] = condition.name;
  return fmt::format("{} vertices, {}", grouped(run.mesh.vertex_count()), cells_in_words(run.mesh));
}

std::string step_account(SpaceRun& run) {
  run.euler = mesh::euler_account(run.mesh);
  check_formulas(run);
  run.dual = mesh::build_dual(run.mesh);
  run.edges = run.dual->edge_count();
  cut_the_cells(run);
  std::string told = "Euler's account balances";
  if (run.tets) {
    run.volume = volume_account(run);
    if (!run.volume->equal)
      throw InputError(run.the_case.mesh_file.string(),
                       fmt::format("its cells have the volume {:.17g}, its boundary encloses {:.17g}", run.volume->cells,
                                   run.volume->enclosed),
                       "check the cells and the boundary of the file");
    told += fmt::format("; volume {:.10g}, equal to the boundary's", run.volume->cells);
  }
  if (run.quality)
    told += fmt::format("; dihedral angles {:.1f}° to {:.1f}°", run.quality->min_dihedral_deg, run.quality->max_dihedral_deg);
  return told + match_periodic(run.the_case, run.conditions, *run.dual);
}

std::string step_order(SpaceRun& run) {
  run.vertex_graph = graph::vertex_graph(run.mesh.vertex_count(), run.dual->edges);
  run.numberings.push_back(numbering("as meshed", *run.vertex_graph, graph::natural_order(*run.vertex_graph)));
  run.solver_vertex = PerId<VertexId, VertexId>(run.mesh.vertex_count());
  if (run.the_case.ordering == OrderChoice::none) {
    for (const VertexId v : run.mesh.points.ids()) run.solver_vertex[v] = v;
    return "kept as meshed";
  }
  run.numberings.push_back(
      numbering("reverse Cuthill-McKee", *run.vertex_graph, graph::reverse_cuthill_mckee(*run.vertex_graph)));
  const auto new_of_old = graph::invert(run.numberings.back().order);
  for (const VertexId v : run.mesh.points.ids()) run.solver_vertex[v] = VertexId::from(new_of_old[v.index()]);
  run.dual = mesh::renumber_vertices(*run.dual, run.solver_vertex);
  return fmt::format("bandwidth {} to {}, fill {} to {}", grouped(run.numberings[0].cost.bandwidth),
                     grouped(run.numberings[1].cost.bandwidth), grouped(run.numberings[0].fill),
                     grouped(run.numberings[1].fill));
}

std::string step_march(SpaceRun& run, Console& console, std::stop_token stop) {
  const FlowProblem<3> problem = problem_of(run.the_case, run.conditions, std::move(*run.dual));
  run.dual.reset();
  return march(run, problem, options_of(run.the_case, run.threads), console, std::move(stop));
}

}  // namespace leonhard::app::space
