// SPDX-License-Identifier: MIT
// Readers of meshes of mixed cells: whatever the text, they return a valid mesh that its own format gives back, or throw
// InputError. A mesh that is returned has a closed dual and an account that balances.
#include <cmath>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "fuzz/fuzz_text.hpp"
#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "leonhard/mesh/io/formats/plot3d.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/mixed_euler.hpp"
#include "leonhard/mesh/validate.hpp"

using namespace leonhard;
using fuzzing::report;

namespace {

// ---- files ----

/// A pyramid on a cube, and a prism beside it.
constexpr const char* space_su2 =
    "NDIME= 3\nNELEM= 3\n12 0 1 2 3 4 5 6 7 0\n14 4 5 6 7 8 1\n13 1 9 2 5 10 6\nNPOIN= 11\n0 0 0\n1 0 0\n1 1 "
    "0\n0 1 0\n0 0 "
    "1\n1 0 1\n1 1 1\n0 1 1\n0.5 0.5 2\n2 0.5 0\n2 0.5 1\nNMARK= 2\nMARKER_TAG= wall\nMARKER_ELEMS= 6\n9 0 1 "
    "2 3\n9 0 1 5 "
    "4\n9 2 3 7 6\n9 3 0 4 7\n9 1 9 10 5\n9 9 2 6 10\nMARKER_TAG= roof\nMARKER_ELEMS= 6\n5 4 5 8\n5 5 6 8\n5 "
    "6 7 8\n5 7 4 "
    "8\n5 1 9 2\n5 5 10 6\n";
constexpr const char* plane_su2 =
    "NDIME= 2\nNELEM= 2\n9 0 1 2 3\n5 1 4 2\nNPOIN= 5\n0 0\n1 0\n1 1\n0 1\n2 0.5\nNMARK= 1\nMARKER_TAG= "
    "wall\nMARKER_ELEMS= 5\n3 0 1\n3 1 4\n3 4 2\n3 2 3\n3 3 0\n";
constexpr const char* space_vtu =
    "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid>\n<Piece "
    "NumberOfPoints=\"9\" "
    "NumberOfCells=\"4\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 "
    "0 1 0 0 1 1 0 0 "
    "1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0.5 2</DataArray></Points>\n<Cells><DataArray type=\"Int64\" "
    "Name=\"connectivity\" "
    "format=\"ascii\">0 1 2 3 4 5 6 7 4 5 6 7 8 0 1 2 3 4 5 8</DataArray>\n<DataArray type=\"Int64\" "
    "Name=\"offsets\" "
    "format=\"ascii\">8 13 17 20</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">12 "
    "14 9 "
    "5</DataArray></Cells>\n</Piece></UnstructuredGrid></VTKFile>\n";
constexpr const char* strip_p2dfmt = "1\n4 2\n0 1 2 3 0 1 2 3\n0 0 0 0\n1 1 1 1\n";
constexpr const char* strip_nmf =
    "1\n1 4 2 1\nwall 1 3 1 4 1 1\nwall 1 4 1 4 1 1\ninlet 1 1 1 2 1 1\noutlet 1 2 1 2 1 1\n";

// ---- properties ----

/// Closed to rounding: parts of the control volumes' surfaces are as large as the largest coordinates squared, or less.
template <int Dim>
void check_dual(const MixedMesh<Dim>& mesh, std::string_view text) {
  const MeshDual<Dim> dual = mesh::build_dual(mesh);
  PerId<VertexId, typename MeshDual<Dim>::Vector> sum(dual.vertex_count());
  PerId<VertexId, double> size(dual.vertex_count());
  const auto add = [&](VertexId v, const typename MeshDual<Dim>::Vector& part) {
    sum[v] += part;
    size[v] += norm(part);
  };
  for (const EdgeId e : dual.edges.ends.ids()) {
    add(dual.edges.ends[e][0], dual.face[e]);
    add(dual.edges.ends[e][1], -dual.face[e]);
  }
  for (const DualFacet<Dim>& facet : dual.boundary)
    for (std::size_t i = 0; i < facet.corners.size(); ++i) add(facet.corners[i], facet.shares[i]);
  double largest = 0;  // a cell of large and small edges has parts that nearly cancel
  for (const VertexId v : size.ids()) largest = std::max(largest, size[v]);
  for (const VertexId v : sum.ids())
    if (std::isfinite(largest) && largest > 1e-300 && !(norm(sum[v]) <= 1e-12 * largest))
      report("a control volume is not closed", text);
}

template <int Dim>
void check_mixed(const MixedMesh<Dim>& mesh, std::string_view text) {
  if (const auto broken = mesh::validate(mesh)) report("a reader returned an invalid mesh: " + *broken, text);
  check_dual(mesh, text);
  for (const auto& formula : mesh::euler_account(mesh).formulas)
    if (!formula.holds() && formula.name != "outer shells" &&
        formula.name != "shells")  // these know overlaps
      report("an account does not balance: " + formula.name, text);
}

template <int Dim>
void try_mixed_su2(const std::string& text) {
  const MixedMesh<Dim> mesh = io::parse_mixed_su2<Dim>(text, "fuzz").mesh;
  check_mixed(mesh, text);
  const MixedMesh<Dim> again = io::parse_mixed_su2<Dim>(io::format_su2(mesh), "again").mesh;
  if (again.points != mesh.points || again.corners != mesh.corners ||
      again.boundary.size() != mesh.boundary.size())
    report("a mesh changed on its way through .su2", text);
}

void try_mixed_vtu(const std::string& text) {
  const MixedMesh<3> mesh = io::parse_mixed_vtu<3>(text, "fuzz").mesh;
  check_mixed(mesh, text);
  if (io::parse_mixed_vtu<3>(io::format_vtu(mesh), "again").mesh != mesh)
    report("a mesh changed on its way through .vtu", text);
}

void try_mixed_gmsh(const std::string& text) {
  const MixedMesh<3> mesh = io::parse_mixed_gmsh<3>(text, "fuzz").mesh;
  check_mixed(mesh, text);
  if (io::parse_mixed_gmsh<3>(io::format_gmsh(mesh), "again").mesh != mesh)
    report("a mesh changed on its way through .msh", text);
}

// ---- inputs ----

std::vector<fuzzing::Format> formats() {
  const MixedMesh<3> mesh = io::parse_mixed_su2<3>(space_su2, "sample").mesh;
  return {
      {space_su2, try_mixed_su2<3>},
      {plane_su2, try_mixed_su2<2>},
      {space_vtu, try_mixed_vtu},
      {io::format_vtu(mesh), try_mixed_vtu},
      {io::format_gmsh(mesh), try_mixed_gmsh},
      {io::format_gmsh(mesh, {io::GmshVersion::v2_2, false}), try_mixed_gmsh},
      {io::format_gmsh(mesh, {io::GmshVersion::v4_1, true}), try_mixed_gmsh},
      {strip_p2dfmt, [](const std::string& text) { check_mixed(io::parse_plot3d(text, "fuzz").mesh, text); }},
      {strip_p2dfmt,
       [](const std::string& text) {
         check_mixed(io::parse_plot3d(text, "fuzz", strip_nmf, "map").mesh, text);
       }},
      {strip_nmf, [](const std::string& text) {
         check_mixed(io::parse_plot3d(strip_p2dfmt, "sample", text, "fuzz").mesh, text);
       }}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzzing::try_formats(formats, data, size);
}
