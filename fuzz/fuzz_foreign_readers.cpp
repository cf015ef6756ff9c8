// SPDX-License-Identifier: MIT
// Readers of what other programs write, from the files of tests/data/formats: whatever the text, they return a valid mesh that
// comes back from .vtu, a surface that can be accounted for, airfoils and edge tables that hold together, or throw InputError.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "fuzz/fuzz_text.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/mesh/io/airfoil_dat.hpp"
#include "leonhard/mesh/io/formats/gmsh_soup.hpp"
#include "leonhard/mesh/io/formats/medit_soup.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/su2_soup.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/formats/surface_write.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/points3_file.hpp"
#include "leonhard/mesh/io/points_file.hpp"
#include "leonhard/mesh/io/soup/simple_polygon.hpp"
#include "leonhard/mesh/io/surface_account.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "leonhard/mesh/split_cells.hpp"
#include "leonhard/mesh/validate.hpp"

using namespace leonhard;
using fuzzing::report;

namespace {

template <int Dim>
void check_file(const MixedMeshFile<Dim>& file, std::string_view text) {
  if (const auto broken = mesh::validate(file.mesh))
    report("a reader returned an invalid mesh: " + *broken, text);
  for (const PointField& field : file.point_fields)
    if (field.values.size() != field.components * file.mesh.vertex_count())
      report("a field does not fit the vertices", text);
  for (const CellField& field : file.cell_fields)
    if (field.values.size() != field.components * file.mesh.cell_count())
      report("a field does not fit the cells", text);
  if (io::parse_mixed_vtu<Dim>(io::format_vtu(file.mesh), "again").mesh != file.mesh)
    report("a mesh changed on its way through .vtu", text);
}

template <int Dim>
void try_soup(io::MeshSoup<Dim> soup, std::string_view text) {
  io::ReadOptions options;
  if (text.size() % 3 == 0) options.weld = text.size() % 2 == 0 ? 0 : 0.3;
  try {
    const SimplexMeshFile<Dim> simplices = io::assemble_simplices(soup, options);
    if (const auto broken = mesh::validate(simplices.mesh))
      report("an invalid mesh of simplices: " + *broken, text);
  } catch (const InputError&) {
  }
  check_file(io::assemble_mixed(std::move(soup), options), text);
}

void try_grid(io::VtkGrid grid, std::string_view text) {
  if (io::dimension_of(grid) == 2) return try_soup(io::vtk_soup<2>(std::move(grid), "fuzz"), text);
  try_soup(io::vtk_soup<3>(std::move(grid), "fuzz"), text);
}

void try_vtu(const std::string& text) { try_grid(io::parse_vtu_grid(text, "fuzz"), text); }
void try_legacy(const std::string& text) { try_grid(io::parse_legacy_vtk(text, "fuzz"), text); }

void try_gmsh(const std::string& text) {
  io::GmshData data = io::parse_gmsh_data(text, "fuzz");
  if (io::dimension_of(data) == 2) return try_soup(io::gmsh_soup<2>(std::move(data), "fuzz"), text);
  try_soup(io::gmsh_soup<3>(std::move(data), "fuzz"), text);
}

void try_medit(const std::string& text) {
  io::MeditData data = io::parse_medit_data(text, "fuzz");
  if (io::dimension_of(data) == 2) return try_soup(io::medit_soup<2>(std::move(data), "fuzz"), text);
  try_soup(io::medit_soup<3>(std::move(data), "fuzz"), text);
}

void try_su2(const std::string& text) {
  const std::size_t zone = text.find("NZONE") == std::string::npos ? 1 : 1 + text.size() % 2;
  if (io::su2_dimension(io::find_su2_zone(text, "fuzz", zone), "fuzz") == 2)
    return try_soup(io::parse_su2_soup<2>(text, "fuzz", zone), text);
  try_soup(io::parse_su2_soup<3>(text, "fuzz", zone), text);
}

void try_surface(SurfaceFile surface, std::string_view text) {
  const SurfaceAccount account = io::surface_account(surface);
  if (account.polygons != surface.polygon_count() || account.open_edges > account.edges)
    report("an account of a surface does not add up", text);
  io::weld(surface, 0);
  if (io::surface_account(surface).repeated_places > 0)
    report("vertices of equal places were not welded", text);
}

/// Written by each format of triangles and quadrilaterals, and read again.
void try_surface_on_its_way(const SurfaceFile& surface, std::string_view text) {
  const bool has_signs = std::ranges::any_of(surface.markers, [](Marker marker) { return marker < 0; });
  const auto check = [&](const SurfaceFile& again) {
    if (again.set.points != surface.set.points || again.corners != surface.corners ||
        again.offsets != surface.offsets)
      report("a surface changed on its way", text);
  };
  check(io::parse_off(io::format_off(surface), "again"));
  check(io::parse_obj(io::format_obj(surface), "again"));
  check(io::parse_ply(io::format_ply(surface), "again"));
  check(io::parse_medit_surface(io::format_medit_surface(surface), "again"));
  if (!has_signs) check(io::parse_gmsh_surface(io::format_gmsh_surface(surface), "again"));
  if (surface.polygon_count() > 0) (void)io::parse_stl(io::format_stl(surface), "again");
  try_surface(surface, text);
}

void try_columns(const std::string& text) {
  if (io::parse_xyz(text, "fuzz").set.points.empty()) report("columns without points", text);
  (void)io::parse_xy(text, "fuzz", true);
}

void try_airfoils(const std::string& text) {
  for (const AirfoilCoordinates& airfoil : io::parse_airfoils(text, "fuzz")) {
    if (airfoil.points.size() < 5) report("an airfoil has too few points", text);
    if (io::edges_that_meet(airfoil.points)) report("an airfoil crosses itself", text);
    if (!io::is_counter_clockwise(airfoil.points)) report("an airfoil runs clockwise", text);
  }
}

void check_graph(const graph::GraphFile& file, std::string_view text) {
  if (const auto broken = graph::validate(file.graph))
    report("a reader returned an invalid graph: " + *broken, text);
}

std::string file(const std::string& name) {
  return io::read_whole_file(std::string(LEONHARD_SOURCE_FOLDER) + "/tests/data/formats/" + name);
}

std::vector<fuzzing::Format> formats() {
  using Text = const std::string&;
  std::vector<fuzzing::Format> all;
  const auto add = [&](std::initializer_list<const char*> names, void (*attempt)(Text)) {
    for (const char* name : names) all.push_back({file(name), attempt});
  };
  add({"opposite_loops.msh", "save_all.msh", "parametric.msh", "several_groups.msh", "version_1.msh",
       "version_4_0.msh", "partitioned.msh", "second_order.msh"},
      try_gmsh);
  add({"lagrange.vtu", "two_pieces.vtu", "apart.vtu", "orphan.vtu", "quadratic.vtu", "voxel.vtu",
       "pixel_strip.vtu", "groups.vtu", "sorted_corners.vtu", "lz4.vtu", "lzma.vtu"},
      try_vtu);
  add({"legacy.vtk", "legacy_5.vtk"}, try_legacy);
  add({"inner_marker.su2", "z_column.su2", "no_markers.su2", "halo.su2", "two_zones.su2"}, try_su2);
  add({"plane.mesh", "flat.mesh", "hexahedron.mesh"}, try_medit);
  add({"faces.mesh"}, [](Text text) { try_surface_on_its_way(io::parse_medit_surface(text, "fuzz"), text); });
  add({"colours.xyz"}, try_columns);
  add({"coloured.stl"}, [](Text text) { try_surface(io::parse_stl(text, "fuzz"), text); });
  add({"glued.off"}, [](Text text) { try_surface(io::parse_off(text, "fuzz"), text); });
  add({"continued.obj"}, [](Text text) { try_surface(io::parse_obj(text, "fuzz"), text); });
  add({"repeated.dat", "numeric_name.dat", "three_columns.dat", "fortran.dat", "semicolons.dat",
       "two_elements.dat", "without_counts.dat", "thick_base.dat"},
      try_airfoils);
  add({"table.csv", "named.csv"}, [](Text text) { check_graph(graph::parse_edge_list(text, "fuzz"), text); });
  add({"constraints.graph"}, [](Text text) { check_graph(graph::parse_metis_graph(text, "fuzz"), text); });
  add({"dense.mtx"}, [](Text text) { check_graph(graph::parse_matrix_market(text, "fuzz"), text); });
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzzing::try_formats(formats, data, size);
}
