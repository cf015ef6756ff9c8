// SPDX-License-Identifier: MIT
#include "leonhard/app/report/flow_files.hpp"

#include <fmt/core.h>

#include <iterator>

#include "leonhard/mesh/io/atomic_file.hpp"

namespace leonhard::app {

template <int dim>
std::vector<PointField> flow_fields(const FlowCase& flow, const PerId<VertexId, State<dim>>& states) {
  const Gas gas{flow.gamma};
  const FreeStream free{flow.mach};
  PointField density{"density", 1, {}}, velocity{"velocity", dim, {}}, pressure{"pressure", 1, {}}, mach{"mach", 1, {}},
      cp{"cp", 1, {}}, loss{"total_pressure_loss", 1, {}}, entropy{"entropy", 1, {}};
  for (const State<dim>& state : states) {
    const auto speed = solver::velocity(state);
    density.values.push_back(state.rho);
    velocity.values.insert(velocity.values.end(), speed.begin(), speed.end());
    pressure.values.push_back(state.p);
    mach.values.push_back(solver::mach_number(gas, state));
    cp.values.push_back(solver::pressure_coefficient(gas, free, state.p));
    loss.values.push_back(1 - solver::total_pressure_ratio(gas, free, state));
    entropy.values.push_back(solver::entropy_ratio(gas, state) - 1);
  }
  return {density, velocity, pressure, mach, cp, loss, entropy};
}

template <int dim>
void write_history(const std::vector<Iteration>& history, const std::filesystem::path& path) {
  std::string csv = std::string("iteration,residual_drop_orders,cl,cd,cm,cfl,linear_iterations,seconds") +
                    (dim == 3 ? ",cy\n" : "\n");
  for (const Iteration& i : history) {
    fmt::format_to(std::back_inserter(csv), "{},{:.6f},{:.12g},{:.12g},{:.12g},{:.6g},{},{:.4f}", i.number,
                   i.residual_drop_orders, i.cl, i.cd, i.cm, i.cfl, i.linear_iterations, i.seconds);
    csv += dim == 3 ? fmt::format(",{:.12g}\n", i.cy) : "\n";
  }
  io::write_file_atomically(path, csv);
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names{"report.json", "report.html"};
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

template std::vector<PointField> flow_fields(const FlowCase&, const PerId<VertexId, State<2>>&);
template std::vector<PointField> flow_fields(const FlowCase&, const PerId<VertexId, State<3>>&);
template void write_history<2>(const std::vector<Iteration>&, const std::filesystem::path&);
template void write_history<3>(const std::vector<Iteration>&, const std::filesystem::path&);

}  // namespace leonhard::app
