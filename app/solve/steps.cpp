// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/app/solve/march.hpp"
#include "leonhard/app/solve/mesh_domain.hpp"
#include "leonhard/app/solve/problem.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "leonhard/mesh/permute.hpp"
#include "leonhard/mesh/split_cells.hpp"
#include "leonhard/solver/periodic.hpp"

namespace leonhard::app {
namespace {

void mesh_the_domain(SolveRun& run, std::stop_token stop) {
  auto refined = mesh_domain(*run.geometry, run.the_case.mesher, -1, stop);
  if (refined.report.outcome == delaunay::RefineOutcome::stopped) throw StoppedEarly{"while meshing"};
  run.warnings = run.geometry->warnings;
  const std::vector<std::string> of_mesher = mesh_warnings(refined.report, run.the_case.mesher);
  run.warnings.insert(run.warnings.end(), of_mesher.begin(), of_mesher.end());
  run.mesh = std::move(refined.mesh);
  run.refinement = std::move(refined.report);
}

/// The ready mesh that the case names. Quadrilaterals stay whole for the solver, and are cut for all that looks at
/// triangles. returns  what it consists of, in words
std::string read_the_mesh(SolveRun& run) {
  const std::filesystem::path& path = run.the_case.mesh_file;
  const auto take_warnings = [&](const std::vector<std::string>& warnings) {
    run.warnings.insert(run.warnings.end(), warnings.begin(), warnings.end());
  };
  const std::vector<std::string>& mixed = io::mixed_mesh_extensions();
  std::vector<std::string> known = io::mesh_extensions();
  known.push_back(".p2dfmt");
  const std::string extension = io::known_extension(path, known, "mesh");
  if (extension != ".p2dfmt" && std::find(mixed.begin(), mixed.end(), extension) == mixed.end()) {
    MeshFile file = io::read_mesh(path);
    take_warnings(file.warnings);
    run.mesh = std::move(file.mesh);
    return fmt::format("{} triangles", grouped(run.mesh.triangle_count()));
  }
  const MixedMeshFile<2> file = io::read_mixed_mesh<2>(path);
  take_warnings(file.warnings);
  const std::size_t quadrilaterals = file.mesh.count_of(CellKind::quadrilateral);
  if (quadrilaterals == 0) {
    run.mesh = mesh::simplex_mesh_of(file.mesh);
    return fmt::format("{} triangles", grouped(run.mesh.triangle_count()));
  }
  run.mesh = mesh::split_cells(file.mesh).mesh;
  run.dual = mesh::build_dual(file.mesh);
  run.warnings.push_back(fmt::format("the solver takes the {} quadrilaterals whole; account, quality, partition, pictures "
                                     "and field.vtu show them cut into triangles",
                                     grouped(quadrilaterals)));
  const std::string whole = grouped(quadrilaterals) + " quadrilaterals";
  const std::size_t triangles = file.mesh.count_of(CellKind::triangle);
  return triangles == 0 ? whole : fmt::format("{}, {} triangles", whole, grouped(triangles));
}

/// What the boundary conditions of the case mean on this mesh's markers.
void match_markers(SolveRun& run, const std::string& source) {
  std::set<Marker> used;
  for (const MarkedEdge& edge : run.mesh.boundary) used.insert(edge.marker);
  run.conditions = match_conditions(run.the_case, {used.begin(), used.end()}, run.mesh.marker_names, source);
  for (const auto& [marker, condition] : run.conditions) run.mesh.marker_names[marker] = condition.name;
}

/// The polygon's area is that of its constrained Delaunay triangulation without new points, in rationals.
AreaAccount area_account(const SolveRun& run) {
  delaunay::TriangulateOptions options;
  options.crossings = run.the_case.mesher.crossings;
  const mpq_class polygon2 = mesh::exact_area2(delaunay::triangulate(run.geometry->pslg, options).mesh);
  const mpq_class mesh2 = mesh::exact_area2(run.mesh);
  const mpq_class difference2 = mesh2 - polygon2;
  return {mesh2.get_d() / 2, polygon2.get_d() / 2, difference2 == 0, difference2.get_d() / 2};
}

}  // namespace

std::string step_geometry(SolveRun& run) {
  if (!run.the_case.mesh_file.empty()) return "none: the case names a mesh";
  run.geometry = make_domain(run.the_case);
  if (!run.the_case.domain_file.empty()) name_markers(run.the_case, run.geometry->pslg);
  const auto& pslg = run.geometry->pslg;
  return fmt::format("{} points, {} segments, {} bodies", grouped(pslg.points.size()),
                     grouped(pslg.segments.size()), run.geometry->body_names.size());
}

std::string step_mesh(SolveRun& run, std::stop_token stop) {
  std::string source, cells;
  if (run.geometry) {
    mesh_the_domain(run, stop);
    source = run.geometry->pslg.source;
    cells = fmt::format("{} triangles", grouped(run.mesh.triangle_count()));
  } else {
    cells = read_the_mesh(run);
    source = run.the_case.mesh_file.string();
  }
  match_markers(run, source);
  return fmt::format("{} vertices, {}", grouped(run.mesh.vertex_count()), cells);
}

std::string step_account(SolveRun& run) {
  run.edges = mesh::build_edges(run.mesh);
  run.euler = mesh::euler_account(run.mesh, run.edges);
  for (const auto& formula : run.euler.formulas) {
    if (formula.holds()) continue;
    throw InputError(
        run.the_case.file.string(),
        fmt::format("Euler's account of the mesh does not balance: {}: {} on the left, {} on the right",
                    formula.words, formula.lhs, formula.rhs),
        "if the mesh came from a file, check its cells; if Leonhard made it, please report the case");
  }
  run.quality = mesh::quality(run.mesh);
  run.fingerprint = mesh::fingerprint(run.mesh);
  if (run.geometry) run.area = area_account(run);
  std::string periodic;
  if (solver::is_periodic(run.conditions)) {
    if (!run.dual) run.dual = mesh::build_dual(run.mesh);
    run.dual->marker_names = run.mesh.marker_names;
    periodic = match_periodic(run.the_case, run.conditions, *run.dual);
  }
  return fmt::format("Euler's account balances; angles {:.1f}° to {:.1f}°; fingerprint {}{}",
                     run.quality.min_angle_deg, run.quality.max_angle_deg, run.fingerprint.hex(), periodic);
}

std::string step_order(SolveRun& run) {
  run.vertex_graph = graph::vertex_graph(run.mesh, run.edges);
  run.numberings.push_back(
      numbering("as meshed", *run.vertex_graph, graph::natural_order(*run.vertex_graph)));
  if (run.the_case.ordering == OrderChoice::none) return "kept as meshed";
  run.numberings.push_back(
      numbering("reverse Cuthill-McKee", *run.vertex_graph, graph::reverse_cuthill_mckee(*run.vertex_graph)));
  const auto new_of_old = graph::invert(run.numberings.back().order);
  PerId<VertexId, VertexId> renumbering(new_of_old.size());
  for (std::size_t old = 0; old < new_of_old.size(); ++old) {
    renumbering[VertexId::from(old)] = VertexId::from(new_of_old[old]);
  }
  run.mesh = mesh::renumber_vertices(run.mesh, renumbering);
  if (run.dual) run.dual = mesh::renumber_vertices(*run.dual, renumbering);
  run.edges = mesh::build_edges(run.mesh);
  return fmt::format("bandwidth {} to {}, fill {} to {}", grouped(run.numberings[0].cost.bandwidth),
                     grouped(run.numberings[1].cost.bandwidth), grouped(run.numberings[0].fill),
                     grouped(run.numberings[1].fill));
}

std::string step_partition(SolveRun& run, std::uint64_t seed, std::stop_token stop) {
  const graph::CsrGraph dual = graph::dual_graph(run.mesh);
  const auto parts = static_cast<std::uint32_t>(std::min(run.the_case.parts, run.mesh.triangle_count()));
  std::vector<Point2> centroids;
  centroids.reserve(run.mesh.triangle_count());
  for (const auto& [a, b, c] : run.mesh.corners) {
    const Point2 p = run.mesh.points[a], q = run.mesh.points[b], r = run.mesh.points[c];
    centroids.push_back({(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3});
  }
  graph::PartitionOptions options;
  options.method = run.the_case.partitioning;
  options.seed = seed;
  options.coordinates = std::span<const Point2>(centroids);
  options.progress.stop = std::move(stop);
  run.triangle_parts = graph::partition_of<TriangleId>(graph::partition(dual, parts, options));
  run.partition_cost = graph::partition_cost(dual, run.triangle_parts);
  return fmt::format("{} parts, {} edges cut, imbalance {:.3f}", parts, grouped(run.partition_cost.cut),
                     run.partition_cost.imbalance);
}

std::string step_march(SolveRun& run, Console& console, std::stop_token stop) {
  SteadyOptions options = options_of(run.the_case, run.threads);
  options.part_of = graph::vertex_partition_from_dual(run.mesh, run.triangle_parts).part_of.flat();
  options.parts = run.triangle_parts.parts;
  MeshDual<2> dual = run.dual ? *run.dual : mesh::build_dual(run.mesh);
  return march(run, problem_of(run.the_case, run.conditions, std::move(dual)), options, console, std::move(stop));
}

}  // namespace leonhard::app
