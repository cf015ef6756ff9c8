// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <vector>

#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/sweep/edge_plan.hpp"

namespace leonhard::solver {

/// The force of friction and the heat that a no-slip wall takes up at one vertex.
template <int dim>
struct WallReaction {
  Axes<dim> friction{};  ///< on the wall, in units of rho_inf c_inf^2 times a facet's size
  double heat{};         ///< into the wall, in units of rho_inf c_inf^3 times a facet's size
};

/// A vertex on a no-slip wall.
template <int dim>
struct StrongVertex {
  VertexId vertex;
  Axes<dim> velocity{};                ///< the wall's
  std::optional<double> energy{};      ///< rho E over rho where the wall has a temperature
  double area{};                       ///< of the wall that belongs to the vertex
  std::map<Marker, double> share_of{};  ///< its parts by marker, which add up to 1
};

/// The vertices on no-slip walls with their walls' values, and a part of the area for each marker; in the order of their numbers.
template <int dim>
[[nodiscard]] std::vector<StrongVertex<dim>> strong_vertices(const FlowProblem<dim>& problem);

/// On no-slip walls the velocity, and the temperature where it is given, are held strongly: the momentum equations of a vertex
/// are replaced by m - rho V_wall = 0, scaled by the control volume's surface, and what they would have said is the force of
/// friction on the wall, as exact as the scheme's momentum balance (P. M. Gresho, R. L. Lee and R. L. Sani, Numerical Methods in
/// Laminar and Turbulent Flow, 1981, for the heat likewise). A vertex between two walls takes the velocity of the slower one, and
/// a temperature if one of them has it.
template <int dim>
class StrongWalls {
 public:
  StrongWalls(const FlowProblem<dim>& problem, const EdgePlan<dim>& plan);

  [[nodiscard]] bool empty() const { return vertices_.empty(); }
  [[nodiscard]] const std::vector<StrongVertex<dim>>& vertices() const { return vertices_; }

  /// Give the vertices the velocity and temperature of their wall, at their own density.
  void project(PerId<VertexId, State<dim>>& state) const;

  /// Replace the equations of the vertices of a part in a residual whose fluxes are complete, pressures on the walls
  /// included; take down the reactions.
  void constrain(std::size_t part, const PerId<VertexId, State<dim>>& state, std::vector<double>& residual,
                 std::vector<WallReaction<dim>>& reactions) const;

  /// The same in the Jacobian.
  void constrain_jacobian(std::size_t part, const EdgePlan<dim>& plan, std::span<double> blocks) const;

 private:
  double gamma_;
  std::vector<StrongVertex<dim>> vertices_;
  std::vector<double> surface_;                    ///< of each one's control volume
  std::vector<std::vector<std::size_t>> of_part_;  ///< entries of vertices_
};

}  // namespace leonhard::solver
