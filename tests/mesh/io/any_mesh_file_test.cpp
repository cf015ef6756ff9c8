// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/any_mesh_file.hpp"

#include <fstream>
#include <map>
#include <set>

#include "leonhard/mesh/io/surface_account.hpp"
#include "leonhard/mesh/io/surface_file.hpp"
#include "tests/mesh/io/folder.hpp"
#include "tests/mesh/io/mixed_samples.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"
#include "tests/test_files.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

using Corners = std::vector<VertexId>;

template <class Range>
Corners sorted_corners(const Range& range) {
  Corners corners(range.begin(), range.end());
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// What a mesh says, whatever the order of its cells and facets.
struct Facts {
  Fingerprint fingerprint;
  std::multiset<std::pair<Corners, Marker>> boundary, inner;
  std::map<Corners, double> regions;
  std::map<Marker, std::string> names, region_names;
  std::map<std::string, std::vector<double>> point_fields;
  std::map<std::string, std::map<Corners, double>> cell_fields;
};

template <class Mesh, class CornersOf>
void add_cells(Facts& facts, const AnyMeshFile& file, const Mesh& mesh, CornersOf corners_of) {
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const Corners corners = sorted_corners(corners_of(c));
    facts.regions[corners] = mesh.regions.flat()[c];
    for (const CellField& field : file.cell_fields)
      facts.cell_fields[field.name][corners] = field.values.at(c);
  }
}

template <int Dim>
void add_mesh(Facts& facts, const AnyMeshFile& file, const SimplexMesh<Dim>& mesh) {
  for (const auto& f : mesh.boundary)
    facts.boundary.emplace(sorted_corners(Simplex<Dim>::corners_of(f)), f.marker);
  for (const auto& f : mesh.inner_facets())
    facts.inner.emplace(sorted_corners(Simplex<Dim>::corners_of(f)), f.marker);
  add_cells(facts, file, mesh, [&](std::size_t c) { return mesh.corners.flat()[c]; });
}
template <int Dim>
void add_mesh(Facts& facts, const AnyMeshFile& file, const MixedMesh<Dim>& mesh) {
  for (const auto& f : mesh.boundary) facts.boundary.emplace(sorted_corners(f.corners), f.marker);
  for (const auto& f : mesh.inner_facets) facts.inner.emplace(sorted_corners(f.corners), f.marker);
  add_cells(facts, file, mesh, [&](std::size_t c) { return mesh.corners[c]; });
}

Facts facts_of(const AnyMeshFile& file) {
  Facts facts;
  std::visit(
      [&](const auto& mesh) {
        facts.fingerprint = mesh::fingerprint(mesh);
        add_mesh(facts, file, mesh);
        facts.region_names = mesh.region_names;
        std::set<Marker> used;
        for (const auto& facet : facts.boundary) used.insert(facet.second);
        for (const auto& [marker, name] : mesh.marker_names)
          if (used.contains(marker)) facts.names.emplace(marker, name);
      },
      file.mesh);
  for (const PointField& field : file.point_fields) facts.point_fields[field.name] = field.values;
  return facts;
}

/// Whole regions with names, inner facets and fields.
template <class Mesh>
AnyMeshFile with_fields(Mesh mesh) {
  for (double& region : mesh.regions) region = std::floor(region);
  mesh.region_names = {{1, "steel"}, {2, "air gap"}};
  mesh.marker_names.erase(99);
  for (auto& [marker, name] : mesh.marker_names) std::replace(name.begin(), name.end(), ' ', '_');
  AnyMeshFile file;
  PointField point{"heat", 1, {}};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) point.values.push_back(0.1 * static_cast<double>(v));
  CellField cell{"stress", 1, {}};
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) cell.values.push_back(1 / (1 + static_cast<double>(c)));
  file.mesh = std::move(mesh);
  file.point_fields = {point};
  file.cell_fields = {cell};
  return file;
}

TriangleMesh triangles_with_everything() {
  TriangleMesh mesh = grid_with_hole();
  mesh.constraints = {{VertexId{0}, VertexId{5}, 11}};
  for (const TriangleId t : mesh.corners.ids()) mesh.regions[t] = static_cast<double>(t.index() % 3);
  return mesh;
}

std::vector<std::pair<const char*, AnyMeshFile>> samples() {
  return {{"triangles", with_fields(triangles_with_everything())},
          {"tetrahedra", with_fields(box_with_everything())},
          {"mixed plane",
           with_fields(with_everything(
               mixed_shelf::plane_grid(3, 2, [](std::size_t i, std::size_t j) { return i == j; }), 1, 1))},
          {"mixed space", with_fields(with_everything(mixed_shelf::mixture(), 1, 1))}};
}

bool holds_cells_data(const std::string& extension) { return extension != ".su2"; }
bool holds_fields(const std::string& extension) { return extension == ".vtu" || extension == ".msh"; }

void check_facts(const Facts& a, const Facts& b, bool cells_data, bool fields) {
  CHECK(a.fingerprint == b.fingerprint);
  CHECK(a.boundary == b.boundary);
  CHECK(a.names == b.names);
  if (cells_data) {
    CHECK(a.inner == b.inner);
    CHECK(a.regions == b.regions);
    CHECK(a.region_names == b.region_names);
  }
  if (fields) {
    CHECK(a.point_fields == b.point_fields);
    CHECK(a.cell_fields == b.cell_fields);
  }
}

AnyMeshFile read(const std::string& name) { return io::read_any_mesh(data_file("formats/" + name)); }

bool has(const std::vector<std::string>& warnings, const std::string& part) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("every_pair_of_formats_round_trips_what_both_can_hold") {
  const Folder folder;
  for (const auto& [name, sample] : samples()) {
    const Facts original = facts_of(sample);
    for (const std::string& first : io::any_mesh_output_extensions(sample)) {
      if (first == ".ele" || first == ".poly" || first == ".face" || first == ".neigh")
        continue;  // .node's siblings
      CAPTURE(name);
      CAPTURE(first);
      const auto path = folder.path / ("first" + first);
      io::write_any_mesh(path, sample);
      const AnyMeshFile once = io::read_any_mesh(path);
      CHECK(once.mesh.index() == sample.mesh.index());
      check_facts(original, facts_of(once), holds_cells_data(first), holds_fields(first));
      for (const std::string& second :
           {std::string(".su2"), std::string(".vtu"), std::string(".msh"), std::string(".mesh")}) {
        CAPTURE(second);
        const auto other = folder.path / ("second" + second);
        io::write_any_mesh(other, once);
        check_facts(original, facts_of(io::read_any_mesh(other)),
                    holds_cells_data(first) && holds_cells_data(second),
                    holds_fields(first) && holds_fields(second));
      }
    }
  }
}

TEST_CASE("what_a_format_cannot_hold_is_listed") {
  const AnyMeshFile sample = with_fields(box_with_everything());
  const std::string su2 = io::left_behind("a.su2", sample);
  for (const char* part :
       {"regions (3 different ones)", "inner face", "markers of vertices", "\"heat\"", "\"stress\""})
    CHECK_MESSAGE(su2.find(part) != std::string::npos, part, " in: ", su2);
  CHECK(io::left_behind("a.vtu", sample).empty());
  CHECK(io::left_behind("a.msh", sample) == "markers of vertices");
  CHECK(io::left_behind("a.mesh", sample) == "the field \"heat\", the field \"stress\"");
}

TEST_CASE("negative_markers_get_free_numbers_and_a_name_that_tells_the_old_one") {
  TriangleMesh mesh = grid_with_hole();
  for (MarkedEdge& edge : mesh.boundary)
    if (edge.marker == 3) edge.marker = -3;
  mesh.marker_names = {{-3, "wall"}, {7, "farfield"}};
  mesh.regions[TriangleId{0}] = -1;
  mesh.regions[TriangleId{1}] = 0.5;
  AnyMeshFile file{mesh, {}, {}, {}};
  CHECK(io::renumber_markers(file) == "marker -3 is now 1; region -1 is now 1, 0.5 is now 2");
  const auto& renumbered = std::get<TriangleMesh>(file.mesh);
  CHECK(renumbered.marker_names == std::map<Marker, std::string>{{1, "wall"}, {7, "farfield"}});
  CHECK(renumbered.region_names == std::map<Marker, std::string>{{1, "region_-1"}, {2, "region_0.5"}});
  CHECK(io::renumber_markers(file).empty());
}

TEST_CASE("cells_are_turned_each_by_itself") {
  const AnyMeshFile loops = read("opposite_loops.msh");
  CHECK(std::count(loops.warnings.begin(), loops.warnings.end(),
                   "2 of 4 triangles are clockwise in the file; they were turned over") == 1);
  CHECK_FALSE(mesh::validate(std::get<TriangleMesh>(loops.mesh)));
  CHECK(has(read("sorted_corners.vtu").warnings, "1 of 2 tetrahedra are inverted in the file"));
}

TEST_CASE("a_mesh_that_stays_tangled_when_its_cells_are_turned_is_refused") {
  const Folder folder;
  std::ofstream(folder.path / "fold.su2")
      << "NDIME= 2\nNELEM= 2\n5 0 1 2\n5 1 0 3\nNPOIN= 4\n0 0\n1 0\n0 1\n0.2 0.3\nNMARK= 0\n";
  CHECK(refusal([&] { (void)io::read_any_mesh(folder.path / "fold.su2"); }).find("same side") !=
        std::string::npos);
}

TEST_CASE("vertices_without_cells_are_dropped_with_the_rows_of_their_fields") {
  const AnyMeshFile file = read("orphan.vtu");
  CHECK(std::get<TriangleMesh>(file.mesh).vertex_count() == 4);
  REQUIRE(file.point_fields.size() == 1);
  CHECK(file.point_fields[0].values == std::vector<double>{0, 1, 2, 3});
  CHECK(has(file.warnings, "1 vertex that no cell uses was left out"));
}

TEST_CASE("boundary_without_markers_is_unmarked_in_every_format") {
  for (const char* name : {"no_markers.su2", "apart.vtu", "lagrange.vtu"}) {
    const AnyMeshFile file = read(name);
    const auto& mesh = std::get<TriangleMesh>(file.mesh);
    CHECK(mesh.marker_names == std::map<Marker, std::string>{{1, "unmarked"}});
    CHECK(has(file.warnings, "named unmarked"));
  }
}

TEST_CASE("welding_joins_vertices_of_equal_or_near_places") {
  CHECK(has(read("apart.vtu").warnings, "1 pair of boundary edges lie back to back"));
  io::ReadOptions options;
  options.weld = 0;
  const AnyMeshFile welded = io::read_any_mesh(data_file("formats/apart.vtu"), options);
  CHECK(std::get<TriangleMesh>(welded.mesh).vertex_count() == 6);
  options.weld = 1.25;  // each side of the squares is as long as 1
  CHECK(refusal([&] { (void)io::read_any_mesh(data_file("formats/apart.vtu"), options); }).find("twice") !=
        std::string::npos);
}

TEST_CASE("gmsh_elements_keep_groups_entities_and_what_is_none") {
  const AnyMeshFile save_all = read("save_all.msh");
  const auto& entities = std::get<TriangleMesh>(save_all.mesh);
  CHECK_FALSE(entities.marker_names.empty());
  std::set<Marker> markers;
  for (const MarkedEdge& edge : entities.boundary) markers.insert(edge.marker);
  CHECK(markers.size() == 6);
  const AnyMeshFile several = read("several_groups.msh");
  CHECK(std::get<TriangleMesh>(several.mesh).triangle_count() == 4);
  CHECK(has(several.warnings, "also in 5 \"all\""));
  CHECK(std::get<TriangleMesh>(several.mesh).region_names.at(4) == "fluid");
  const Folder folder;
  AnyMeshFile plain{grid_with_hole(), {}, {}, {}};  // regions 0
  io::write_any_mesh(folder.path / "a.msh", plain);
  CHECK(std::get<TriangleMesh>(io::read_any_mesh(folder.path / "a.msh").mesh) ==
        std::get<TriangleMesh>(plain.mesh));
}

TEST_CASE("a_surface_is_told_closed_or_open_and_its_contacts_are_counted") {
  const SurfaceAccount tet = io::surface_account(io::read_surface(data_file("formats/glued.off")));
  CHECK((tet.is_closed() && tet.is_manifold() && tet.is_oriented()));
  CHECK(tet.volume == doctest::Approx(1.0 / 6));
  CHECK(tet.contacts == 0);
  SurfaceFile crossing = io::read_surface(data_file("formats/glued.off"));
  for (const VertexId v : std::vector<VertexId>(crossing.corners))  // the same again, moved by a quarter
    crossing.corners.push_back(VertexId{v.raw + 4});
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 p = crossing.set.points[i];
    crossing.set.points.push_back({p.x + 0.25, p.y + 0.25, p.z + 0.125});
    crossing.offsets.push_back(crossing.offsets.back() + 3);
  }
  const SurfaceAccount two = io::surface_account(crossing);
  CHECK(two.components == 2);
  CHECK(two.contacts > 0);
  const SurfaceAccount open = io::surface_account(io::read_surface(data_file("formats/continued.obj")));
  CHECK(open.open_edges == 4);
  CHECK_FALSE(open.is_closed());
}
