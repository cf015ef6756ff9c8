// SPDX-License-Identifier: MIT
// Mach 2 against a ramp of 10 degrees, compared with the exact oblique shock.
#include <cmath>
#include <leonhard/solver/linear_solver.hpp>
#include <leonhard/solver/steady.hpp>
#include <numbers>

#include "check.hpp"
#include "grid.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  const TriangleMesh mesh = grid(24, 20, [](double s, double t) {
    const double x = 1.2 * s, floor = x > 0.2 ? (x - 0.2) * std::tan(10 * std::numbers::pi / 180) : 0;
    return Point2{x, floor + t * (1 - floor)};
  });
  const PetscSession petsc;
  const FlowProblem<2> problem{.dual = mesh::build_dual(mesh),
                             .free_stream = {.mach = 2},
                             .boundary = {{1, BoundaryKind::slip_wall},
                                          {2, BoundaryKind::supersonic_outflow},
                                          {3, BoundaryKind::supersonic_outflow},
                                          {4, BoundaryKind::supersonic_inflow}}};
  const SteadyResult<2> flow = solver::solve_steady(problem, {.residual_drop_orders = 6});
  claim(flow.verdict == Verdict::converged || flow.verdict == Verdict::settled, flow.words.c_str());
  claim(flow.surface.size() == 1, "there is one wall");
  if (flow.surface.empty()) return claim.failed();
  for (const SurfacePoint& p : flow.surface[0].points) {
    if (p.at.x > 0.9) claim(std::abs(flow.state[p.vertex].p * 1.4 / 1.706579 - 1) < 0.02, "the pressure behind the shock");
  }
  return claim.failed();
}
