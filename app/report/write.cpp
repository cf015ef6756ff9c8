// SPDX-License-Identifier: MIT
#include "leonhard/app/report/write.hpp"

#include <fmt/core.h>

#include <iterator>

#include "leonhard/app/report/flow_files.hpp"
#include "leonhard/app/report/html.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/report/pictures.hpp"
#include "leonhard/app/report/solve_report.hpp"
#include "leonhard/app/report/vorticity.hpp"
#include "leonhard/app/solve/stage_clock.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

void write_field(const SolveRun& run, const std::filesystem::path& path) {
  std::vector<PointField> fields = flow_fields(run.the_case.flow, run.flow.state);
  fields.push_back({"vorticity", 1, vorticity(run.mesh, run.flow.state)});
  io::write_vtu(path, run.mesh, fields);
}

void write_surface(const SolveRun& run, const std::filesystem::path& path) {
  const bool viscous = !run.flow.stresses.empty();
  std::string csv = std::string("body,x,y,s,cp,mach") + (viscous ? ",cf,heat,y_plus\n" : "\n");
  for (const SurfaceLine& line : run.flow.surface) {
    const std::string& name = run.conditions.at(line.marker).name;
    for (const SurfacePoint& point : line.points) {
      fmt::format_to(std::back_inserter(csv), "{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", name,
                     point.at.x, point.at.y, point.arc_length, point.cp, point.mach);
      csv += viscous ? fmt::format(",{:.17g},{:.17g},{:.17g}\n", point.cf, point.heat, point.y_plus) : "\n";
    }
  }
  io::write_file_atomically(path, csv);
}

}  // namespace

Json write_report(SolveRun& run, const std::filesystem::path& folder) {
  std::vector<ReportPicture> pictures;
  {
    StageClock clock(run, "write");
    write_field(run, folder / "field.vtu");
    write_surface(run, folder / "surface.csv");
    write_history<2>(run.flow.history, folder / "history.csv");
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
