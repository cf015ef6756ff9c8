// SPDX-License-Identifier: MIT
#include "leonhard/app/report/write.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "leonhard/app/report/html.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/report/pictures.hpp"
#include "leonhard/app/report/solve_report.hpp"
#include "leonhard/app/solve/stage_clock.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

void write_field(const SolveRun& run, const std::filesystem::path& path) {
  const Gas gas{run.the_case.flow.gamma};
  const FreeStream free{run.the_case.flow.mach, 0};
  PointField density{"density", 1, {}}, velocity{"velocity", 2, {}}, pressure{"pressure", 1, {}},
      mach{"mach", 1, {}}, cp{"cp", 1, {}}, loss{"total_pressure_loss", 1, {}};
  for (const State<2>& state : run.flow.state) {
    density.values.push_back(state.rho);
    velocity.values.insert(velocity.values.end(), {state.u, state.v});
    pressure.values.push_back(state.p);
    mach.values.push_back(solver::mach_number(gas, state));
    cp.values.push_back(solver::pressure_coefficient(gas, free, state.p));
    loss.values.push_back(1 - solver::total_pressure_ratio(gas, free, state));
  }
  io::write_vtu(path, run.mesh, {density, velocity, pressure, mach, cp, loss});
}

void write_surface(const SolveRun& run, const std::filesystem::path& path) {
  std::string csv = "body,x,y,s,cp,mach\n";
  for (const SurfaceLine& line : run.flow.surface) {
    const std::string& name = run.conditions.at(line.marker).name;
    for (const SurfacePoint& point : line.points) {
      fmt::format_to(std::back_inserter(csv), "{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", name,
                     point.at.x, point.at.y, point.arc_length, point.cp, point.mach);
    }
  }
  io::write_file_atomically(path, csv);
}

void write_history(const SolveRun& run, const std::filesystem::path& path) {
  std::string csv = "iteration,residual_drop_orders,cl,cd,cm,cfl,linear_iterations,seconds\n";
  for (const Iteration& i : run.flow.history) {
    fmt::format_to(std::back_inserter(csv), "{},{:.6f},{:.12g},{:.12g},{:.12g},{:.6g},{},{:.4f}\n", i.number,
                   i.residual_drop_orders, i.cl, i.cd, i.cm, i.cfl, i.linear_iterations, i.seconds);
  }
  io::write_file_atomically(path, csv);
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names{"report.json", "report.html"};
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

Json write_report(SolveRun& run, const std::filesystem::path& folder) {
  std::vector<ReportPicture> pictures;
  {
    StageClock clock(run, "write");
    write_field(run, folder / "field.vtu");
    write_surface(run, folder / "surface.csv");
    write_history(run, folder / "history.csv");
    io::write_mesh(folder / "mesh.su2", run.mesh);
    pictures = draw_pictures(run, folder);
  }
  const SolveReport report{run, peak_memory_bytes(), files_in(folder)};
  Json json = to_json(report);
  io::write_file_atomically(folder / "report.json", json.text() + "\n");
  io::write_file_atomically(folder / "report.html", report_html(report, pictures));
  return json;
}

}  // namespace leonhard::app
