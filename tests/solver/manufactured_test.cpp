// SPDX-License-Identifier: MIT
// Orders of accuracy on irregular meshes, by manufactured solutions.
#include <doctest/doctest.h>

#include <cmath>

#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/steady.hpp"
#include "tests/solver/boxes.hpp"
#include "tests/solver/manufactured.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;

struct Errors {
  double l1{}, l2{};
};

/// Mean errors of density and pressure against the field, from the steady state of the problem with its source.
template <int dim>
Errors errors_on(const MeshDual<dim>& dual, double reynolds) {
  FlowProblem<dim> problem{.dual = dual, .free_stream = {0.5}, .vortex_correction = false};
  test::Manufactured<dim> field;
  if (reynolds > 0) {
    problem.viscosity = Viscosity{reynolds, 0.72, -1};
    field.viscous = {1.4, 0.5 / reynolds, -1, 1 / 0.72};
  }
  problem.outer_state = field.state;
  problem.source = [field](const auto& at) { return field.source(at); };
  for (const DualFacet<dim>& facet : dual.boundary) problem.boundary[facet.marker] = BoundaryKind::far_field;
  for (const auto& at : dual.points) problem.initial.push_back(field.state(at));
  SteadyOptions options;
  options.limiter = LimiterKind::none;
  options.residual_drop_orders = 6;
  const SteadyResult<dim> result = solver::solve_steady(problem, options);
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  Errors errors;
  double volume = 0;
  for (const VertexId v : dual.points.ids()) {
    const State<dim> exact = field.state(dual.points[v]), &w = result.state[v];
    const double off[] = {w.rho - exact.rho, w.u - exact.u, w.p - exact.p};
    for (const double e : off) errors.l1 += dual.volume[v] * std::abs(e), errors.l2 += dual.volume[v] * e * e;
    volume += dual.volume[v];
  }
  errors.l1 /= volume, errors.l2 = std::sqrt(errors.l2 / volume);
  return errors;
}

template <class Mesh>
void check_order(const Mesh& mesh_of, double least, double reynolds) {
  const Errors coarse = errors_on(mesh_of(false), reynolds), fine = errors_on(mesh_of(true), reynolds);
  const double l1 = std::log2(coarse.l1 / fine.l1), l2 = std::log2(coarse.l2 / fine.l2);
  MESSAGE("orders in L1 and L2: " << l1 << ", " << l2 << "; errors " << fine.l1 << ", " << fine.l2);
  CHECK(l1 >= least);
  CHECK(l2 >= least);
}

TEST_CASE("second_order_on_irregular_triangles") {
  test::start_petsc();
  const auto triangles = [](bool fine) { return mesh::build_dual(test::shaken_square(fine ? 64 : 32, 0.2, 5)); };
  SUBCASE("Euler") { check_order(triangles, 1.95, 0); }
  SUBCASE("Navier-Stokes") { check_order(triangles, 1.8, 20); }
}

TEST_CASE("second_order_on_irregular_tetrahedra_and_hexahedra") {
  test::start_petsc();
  const auto boxes = [](bool fine, test::BoxCells kind) {
    const std::size_t n = fine ? 16 : 8;
    return mesh::build_dual(test::box_grid({n, n, n}, kind, [&](double s, double t, double u) {
      return test::shaken_cube(s, t, u, 0.1 / static_cast<double>(n));
    }));
  };
  SUBCASE("Euler, tetrahedra") { check_order([&](bool fine) { return boxes(fine, test::BoxCells::tetrahedra); }, 1.9, 0); }
  SUBCASE("Navier-Stokes, tetrahedra") {
    check_order([&](bool fine) { return boxes(fine, test::BoxCells::tetrahedra); }, 1.9, 20);
  }
  SUBCASE("Navier-Stokes, hexahedra") {
    check_order([&](bool fine) { return boxes(fine, test::BoxCells::hexahedra); }, 1.7, 20);
  }
}

}  // namespace
