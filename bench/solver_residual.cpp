// SPDX-License-Identifier: MIT
// bench_solver MESH.su2 [mach alpha_deg]: what the solver's claims rest on, one thread.
//   microseconds a vertex of a second-order residual with Venkatakrishnan's limiter, of a three-stage explicit
//   iteration, and the time and iterations of an implicit march to ten orders.
// Markers whose name holds "far" are far field, all others slip walls. The vertices are renumbered as the program does.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <string>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/permute.hpp"
#include "leonhard/solver/linear_solver.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady.hpp"

namespace {

using namespace leonhard;

TriangleMesh reordered(const TriangleMesh& mesh) {
  const auto order = graph::reverse_cuthill_mckee(graph::vertex_graph(mesh, mesh::build_edges(mesh)));
  PerId<VertexId, VertexId> new_of_old(mesh.vertex_count());
  for (std::size_t i = 0; i < order.size(); ++i) new_of_old[VertexId::from(order[i])] = VertexId::from(i);
  return mesh::renumber_vertices(mesh, new_of_old);
}

template <class Work>
double least_seconds(int repeats, Work&& work) {
  double least = 1e300;
  for (int i = 0; i < repeats; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return least;
}

void time_residual(const FlowProblem<2>& problem) {
  solver::FlowResidual<2> residual(problem, {});
  const PerId<VertexId, State<2>> state(problem.dual.vertex_count(),
                                     solver::free_stream_state<2>(problem.gas, problem.free_stream));
  std::vector<double> out, blocks(16 * residual.plan().block_count());
  const double scale = 1e6 / static_cast<double>(problem.dual.vertex_count());
  std::cout << "inner loops: " << residual.kernels().name << "\n";
  std::cout << "residual: " << scale * least_seconds(200, [&] { residual.evaluate(state, out); })
            << " us a vertex\n";
  std::cout << "first-order Jacobian: "
            << scale * least_seconds(50, [&] { residual.jacobian(state, blocks); }) << " us a vertex\n";
}

void time_explicit(const FlowProblem<2>& problem) {
  SteadyOptions options;
  options.marching = Marching::explicit_multistage;
  options.max_iterations = 400;
  const SteadyResult<2> result = solver::solve_steady(problem, options);
  double least = 1e300;
  for (std::size_t i = 1; i < result.history.size(); ++i)
    least = std::min(least, result.history[i].seconds - result.history[i - 1].seconds);
  std::cout << "explicit three-stage iteration: "
            << 1e6 * least / static_cast<double>(problem.dual.vertex_count()) << " us a vertex ("
            << result.words << ")\n";
}

void time_implicit(const FlowProblem<2>& problem) {
  SteadyOptions options;
  options.residual_drop_orders = 10;
  for (int run = 0; run < 3; ++run) {
    const SteadyResult<2> result = solver::solve_steady(problem, options);
    int linear = 0;
    for (const Iteration& i : result.history) linear += i.linear_iterations;
    std::cout << "implicit: " << result.words << ", " << linear << " linear iterations, "
              << result.history.back().seconds << " s; CL " << result.forces.cl << " CD " << result.forces.cd
              << " CM " << result.forces.cm << "\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::cerr << "usage: bench_solver MESH.su2 [mach alpha_deg]\n";
    return 1;
  }
  try {
    const PetscSession petsc;
    const TriangleMesh mesh = reordered(io::read_mesh(argv[1]).mesh);
    FlowProblem<2> problem{mesh::build_dual(mesh), {}, {argc == 4 ? std::atof(argv[2]) : 0.8, 0}, {}, {}, true, {0.25, 0}, {}};
    problem.free_stream.alpha_rad = (argc == 4 ? std::atof(argv[3]) : 1.25) * std::numbers::pi / 180;
    for (const auto& [marker, name] : mesh.marker_names)
      problem.boundary[marker] =
          name.find("far") != std::string::npos ? BoundaryKind::far_field : BoundaryKind::slip_wall;
    time_residual(problem);
    time_explicit(problem);
    time_implicit(problem);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return 0;
}
