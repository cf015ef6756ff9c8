// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/surface_file.hpp"

#include <bit>
#include <filesystem>
#include <fstream>

#include "leonhard/mesh/io/any_contents.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "tests/mesh/io/sample_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

const std::vector<Point3> corner_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// The four faces of a tetrahedron, seen from outside.
std::vector<std::vector<std::size_t>> polygons_of(const SurfaceFile& surface) {
  std::vector<std::vector<std::size_t>> polygons;
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    polygons.emplace_back();
    for (const VertexId v : surface.polygon(i)) polygons.back().push_back(v.index());
  }
  return polygons;
}
const std::vector<std::vector<std::size_t>> corner_faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

const std::string off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string jigsaw =
    "# by hand\nMSHID=3;EUCLIDEAN-MESH\nNDIMS=3\nPOINT=4\n0;0;0;0\n1;0;0;0\n0;1;0;0\n0;0;1;0\n"
    "TRIA3=4\n0;2;1;7\n0;1;3;7\n0;3;2;8\n1;2;3;9\n";
const std::string poly =
    "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n4 1\n1 0 7 # bottom\n3 1 3 2\n1 0 7\n3 1\n 2 4\n"
    "1 1 8\n3 1 4 3\n1 0 0.25 0.25\n1 0 9\n3 2 3 4\n0\n0\n";
const std::string smesh =
    "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n4 1\n3 1 3 2 7\n3 1 2 4 7\n3 1 4 3 8\n3 2 3 4 9\n0\n0\n";
const std::string medit =
    "MeshVersionFormatted 2\nDimension\n3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "Triangles\n4\n1 3 2 7\n1 2 4 7\n1 4 3 8\n2 3 4 9\nEnd\n";
const std::string gmsh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n9 0 0 1\n$EndNodes\n"
    "$Elements\n4\n1 2 2 7 1 1 3 2\n2 2 2 7 1 1 2 9\n3 2 2 8 1 1 9 3\n4 2 2 9 1 2 3 9\n$EndElements\n";

std::string ascii_stl() {
  std::string text = "solid corner\n";
  for (const auto& face : corner_faces) {
    text += " facet normal nan 0 0\n  outer loop\n";
    for (const std::size_t v : face) {
      const Point3& p = corner_points[v];
      text +=
          "   vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid corner\n";
}

template <class Number>
void append_bytes(std::string& bytes, Number number, bool big_endian = false) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (big_endian == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string binary_stl(const std::string& header = "solid is how some binary files begin") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  append_bytes(bytes, std::uint32_t{4});
  for (const auto& face : corner_faces) {
    for (int i = 0; i < 3; ++i) append_bytes(bytes, 0.0F);
    for (const std::size_t v : face)
      for (const double x : {corner_points[v].x, corner_points[v].y, corner_points[v].z})
        append_bytes(bytes, static_cast<float>(x));
    append_bytes(bytes, std::uint16_t{0});
  }
  return bytes;
}

const std::string ply_header =
    "comment made by hand\nelement vertex 4\nproperty uchar red\nproperty double x\nproperty float y\n"
    "property short z\nproperty list uchar short extra\nelement face 4\n"
    "property list uchar int vertex_indices\nproperty char flag\nend_header\n";
const std::string ascii_ply =
    "ply\nformat ascii 1.0\n" + ply_header +
    "255 0 0 0 0\n255 1 0 0 2 7 7\n0 0 1 0 0\n0 0 0 1 0\n3 0 2 1 0\n3 0 1 3 0\n3 0 3 2 0\n3 1 2 3 0\n";

std::string binary_ply(bool big_endian) {
  std::string bytes =
      std::string("ply\nformat binary_") + (big_endian ? "big" : "little") + "_endian 1.0\n" + ply_header;
  for (const Point3& p : corner_points) {
    append_bytes(bytes, std::uint8_t{255});
    append_bytes(bytes, p.x, big_endian);
    append_bytes(bytes, static_cast<float>(p.y), big_endian);
    append_bytes(bytes, static_cast<std::int16_t>(p.z), big_endian);
    append_bytes(bytes, std::uint8_t{1});
    append_bytes(bytes, std::int16_t{-300}, big_endian);
  }
  for (const auto& face : corner_faces) {
    append_bytes(bytes, std::uint8_t{3});
    for (const std::size_t v : face) append_bytes(bytes, static_cast<std::int32_t>(v), big_endian);
    append_bytes(bytes, std::int8_t{-1});
  }
  return bytes;
}

}  // namespace

TEST_CASE("every_surface_format_gives_the_same_corner_of_a_cube") {
  const std::vector<std::pair<const char*, SurfaceFile>> read{
      {"off", io::parse_off(off, "s.off")},
      {"coff",
       io::parse_off("COFF # colours\n\n4 4\n0 0 0 255 0 0 1\n1 0 0 255 0 0 1\n0 1 0 9 9 9 1\n0 0 1 9 9 9 1\n"
                     "3 0 2 1 0.5\n3 0 1 3\n3 0 3 2\n3 1 2 3 1 0 0\n",
                     "s.off")},
      {"obj", io::parse_obj(obj, "s.obj")},
      {"obj with all it may hold",
       io::parse_obj(
           "# c\nmtllib m\nv 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nv 0 0 1\nvn 0 0 nan\no thing\n"
           "f 1/1 3//2 -3\nf 1 2 4\nf 1/9/9 4 3\nf 2 3 4\nl 1 2\n",
           "s.obj")},
      {"jigsaw", io::parse_jigsaw(jigsaw, "s.msh")},
      {"poly", io::parse_surface_poly(poly, std::nullopt, "s.poly")},
      {"smesh", io::parse_smesh(smesh, std::nullopt, "s.smesh")},
      {"medit", io::parse_medit_surface(medit, "s.mesh")},
      {"gmsh", io::parse_gmsh_surface(gmsh, "s.msh")},
      {"ascii stl", io::parse_stl(ascii_stl(), "s.stl")},
      {"binary stl", io::parse_stl(binary_stl(), "s.stl")},
      {"ascii ply", io::parse_ply(ascii_ply, "s.ply")},
      {"little-endian ply", io::parse_ply(binary_ply(false), "s.ply")},
      {"big-endian ply", io::parse_ply(binary_ply(true), "s.ply")}};
  for (const auto& [label, surface] : read) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    if (std::string(name).find("stl") == std::string::npos) {
      CHECK(surface.set.points == corner_points);
      CHECK(polygons_of(surface) == corner_faces);
    } else {  // vertices come in the order of the triangles' corners
      CHECK(surface.set.points.size() == 4);
      CHECK(polygons_of(surface) ==
            std::vector<std::vector<std::size_t>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}});
    }
  }
}

TEST_CASE("surface_markers_and_facets_are_those_of_the_file") {
  const std::vector<Marker> markers{7, 7, 8, 9};
  CHECK(io::parse_jigsaw(jigsaw, "s").markers == markers);
  CHECK(io::parse_surface_poly(poly, std::nullopt, "s").markers == markers);
  CHECK(io::parse_smesh(smesh, std::nullopt, "s").markers == markers);
  CHECK(io::parse_medit_surface(medit, "s").markers == markers);
  CHECK(io::parse_gmsh_surface(gmsh, "s").markers == markers);
  const std::string two_polygons = replaced(poly, "1 0 7 # bottom\n3 1 3 2\n", "2 0 7\n3 1 3 2\n2 1 4\n");
  const SurfaceFile surface = io::parse_surface_poly(two_polygons, std::nullopt, "s");
  CHECK(surface.facets == std::vector<std::size_t>{0, 0, 1, 2, 3});
  CHECK(surface.polygon(1).size() == 2);
}

TEST_CASE("poly_without_points_takes_those_of_the_node_file") {
  const std::string node = poly.substr(0, poly.find("4 1\n1 0 7"));
  const std::string rest = "0 3 0 0\n" + poly.substr(node.size());
  CHECK(io::parse_surface_poly(rest, node, "s.poly").set.points == corner_points);
  CHECK(refusal([&] { (void)io::parse_surface_poly(rest, std::nullopt, "s.poly"); }).find("no .node file") !=
        std::string::npos);
}

TEST_CASE("surface_files_are_told_apart_by_their_names_and_msh_by_its_first_byte") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "leonhard_surface_file_test";
  std::filesystem::create_directories(folder);
  const std::vector<std::pair<const char*, std::string>> files{
      {"a.OFF", off},   {"b.obj", obj},     {"c.STL", binary_stl()}, {"d.ply", ascii_ply}, {"e.mesh", medit},
      {"f.poly", poly}, {"g.smesh", smesh}, {"h.msh", gmsh},         {"i.msh", jigsaw}};
  for (const auto& [label, bytes] : files) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    std::ofstream(folder / name, std::ios::binary) << bytes;
    CHECK(io::read_surface(folder / name).set.points.size() == 4);
  }
  CHECK(refusal([&] { (void)io::read_surface("x.of"); }).find("did you mean \".off\"?") != std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_CASE("off_bad_input_is_refused_with_its_line") {
  check_refused({{"keyword", "OF\n", {"s.off:1", "OFF"}},
                 {"binary", "OFF BINARY\n", {"s.off:1", "binary"}},
                 {"NaN", replaced(off, "0 1 0\n", "0 nan 0\n"), {"s.off:5", "nan", "not finite"}},
                 {"two columns", replaced(off, "0 1 0\n", "0 1\n"), {"s.off:5", "line ends", "z coordinate"}},
                 {"too many", off + "3 0 1 2\n", {"s.off:11", "after the last face"}},
                 {"cut short", off.substr(0, off.rfind("3 1 2 3")), {"s.off:9", "face", "cut short"}},
                 {"count", replaced(off, "4 4 6", "4 400000 6"), {"s.off:2", "cannot hold"}},
                 {"range", replaced(off, "3 1 2 3", "3 1 2 4"), {"s.off:10", "vertex 4", "0 to 3"}},
                 {"negative", replaced(off, "3 1 2 3", "3 1 2 -1"), {"s.off:10", "vertex -1"}},
                 {"no points", "OFF\n0 0 0\n", {"s.off", "no points"}},
                 {"garbage", std::string("OFF\n4 4\n\0\1\2", 11), {"s.off:3", "zero byte"}}},
                [](const std::string& text) { (void)io::parse_off(text, "s.off"); });
}

TEST_CASE("obj_bad_input_is_refused_with_its_line") {
  check_refused({{"infinity", replaced(obj, "v 0 1 0", "v 0 inf 0"), {"s.obj:3", "inf"}},
                 {"two columns", replaced(obj, "v 0 1 0", "v 0 1"), {"s.obj:3", "z coordinate"}},
                 {"vertex 0", replaced(obj, "f 1 2 4", "f 0 2 4"), {"s.obj:6", "vertex 0", "from 1"}},
                 {"range", replaced(obj, "f 1 2 4", "f 1 2 5"), {"s.obj:6", "vertex 5", "1 to 4"}},
                 {"relative", replaced(obj, "f 1 2 4", "f 1 2 -5"), {"s.obj:6", "vertex -5"}},
                 {"letters", replaced(obj, "f 1 2 4", "f 1 b/2 4"), {"s.obj:6", "b/2"}},
                 {"two corners", replaced(obj, "f 1 2 4", "f 1 2"), {"s.obj:6", "2 corners"}},
                 {"nothing", "# empty\n", {"s.obj", "no points"}}},
                [](const std::string& text) { (void)io::parse_obj(text, "s.obj"); });
}

TEST_CASE("stl_bad_input_is_refused") {
  const std::string text = ascii_stl(), bytes = binary_stl("made by hand");
  std::string nan = bytes;
  nan.replace(84 + 12, 4, "\xff\xff\xff\xff");
  check_refused(
      {{"cut text", text.substr(0, text.find("endsolid")), {"s.stl", "file ends", "endsolid"}},
       {"NaN", replaced(text, "vertex 0.000000", "vertex nan"), {"s.stl:4", "nan"}},
       {"two columns", replaced(text, "1.000000 0.000000 0.000000", "1 0"), {"s.stl:6", "z coordinate"}},
       {"four corners", replaced(text, "  endloop", "   vertex 0 0 0\n  endloop"), {"s.stl:7", "endloop"}},
       {"cut bytes", bytes.substr(0, bytes.size() - 1), {"s.stl", "4 triangles", "284 bytes", "has 283"}},
       {"short", "made by hand", {"s.stl", "neither"}},
       {"NaN in bytes", nan, {"s.stl", "triangle 0", "not finite"}},
       {"no triangles", "solid\nendsolid\n", {"s.stl", "no points"}}},
      [](const std::string& t) { (void)io::parse_stl(t, "s.stl"); });
}

TEST_CASE("ply_bad_input_is_refused") {
  const std::string bytes = binary_ply(false);
  std::string nan = bytes;
  nan.replace(bytes.find("end_header\n") + 12, 8, 8, '\xff');
  check_refused(
      {{"no header", "ply\nformat ascii 1.0\n", {"s.ply", "end_header"}},
       {"format", replaced(ascii_ply, "ascii", "binary_middle_endian"), {"s.ply:2", "binary_middle_endian"}},
       {"version", replaced(ascii_ply, "1.0", "1.1"), {"s.ply:2", "1.1"}},
       {"type", replaced(ascii_ply, "property short z", "property half z"), {"s.ply:8", "half"}},
       {"no z", replaced(ascii_ply, "property short z", "property short w"), {"s.ply", "x, y and z"}},
       {"NaN", replaced(ascii_ply, "255 1 0 0", "255 nan 0 0"), {"s.ply:15", "nan"}},
       {"range", replaced(ascii_ply, "3 0 3 2 0", "3 0 9 2 0"), {"s.ply:20", "vertex 9", "0 to 3"}},
       {"cut text", ascii_ply.substr(0, ascii_ply.size() - 6), {"s.ply:21", "cannot hold"}},
       {"count", replaced(ascii_ply, "face 4", "face 400000000"), {"s.ply", "cannot hold"}},
       {"list", replaced(ascii_ply, "3 0 3 2 0", "3000 0 3 2 0"), {"s.ply:20", "3000"}},
       {"cut bytes", bytes.substr(0, bytes.size() - 1), {"s.ply, byte ", "file ends"}},
       {"NaN in bytes", nan, {"s.ply", "vertex 0", "not finite"}},
       {"property of nothing",
        "ply\nformat ascii 1.0\nproperty int x\nend_header\n",
        {"s.ply:3", "property"}}},
      [](const std::string& text) { (void)io::parse_ply(text, "s.ply"); });
}

TEST_CASE("jigsaw_and_tetgen_surfaces_that_are_wrong_are_refused_with_their_line") {
  check_refused({{"plane", replaced(jigsaw, "NDIMS=3", "NDIMS=2"), {"s.msh:3", "NDIMS=2"}},
                 {"NaN", replaced(jigsaw, "1;0;0;0", "nan;0;0;0"), {"s.msh:6", "nan"}},
                 {"range", replaced(jigsaw, "0;3;2;8", "0;4;2;8"), {"s.msh:12", "vertex 4"}},
                 {"cut short", jigsaw.substr(0, jigsaw.rfind("1;2;3")), {"s.msh:9", "cannot hold"}},
                 {"no keyword", "0;0;0;0\n", {"s.msh:1", "keyword"}}},
                [](const std::string& text) { (void)io::parse_jigsaw(text, "s.msh"); });
  check_refused({{"plane", "1 2 0 0\n0 0 0\n", {"s.poly:1", "dimension is 2", "space"}},
                 {"range", replaced(poly, "3 2 3 4", "3 2 3 5"), {"s.poly:16", "vertex 5", "1 to 4"}},
                 {"cut short", poly.substr(0, poly.find("3 2 3 4")), {"s.poly:15", "polygon"}},
                 {"count", replaced(poly, "3 2 3 4", "900 2 3 4"), {"s.poly:16", "900"}}},
                [](const std::string& text) { (void)io::parse_surface_poly(text, std::nullopt, "s.poly"); });
}

TEST_CASE("every_prefix_of_a_surface_with_counts_is_refused") {
  for (const std::string& bytes : {binary_ply(true), binary_stl("x")})
    for (std::size_t length = 0; length < bytes.size(); ++length)
      CHECK_MESSAGE(refusal([&] {
                      bytes[0] == 'p' ? (void)io::parse_ply(bytes.substr(0, length), "s")
                                      : (void)io::parse_stl(bytes.substr(0, length), "s");
                    }) != "accepted",
                    "cut after byte ", length);
}

TEST_CASE("surfaces_come_back_from_every_format_that_is_written") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "leonhard_surface_write_test";
  std::filesystem::create_directories(folder);
  SurfaceFile surface = io::parse_off(off, "s.off");
  surface.set.points[1].x = 1.0 / 3;  // no short decimal
  surface.markers = {7, 0, 8, 9};
  for (const std::string& extension : io::surface_output_extensions()) {
    CAPTURE(extension);
    const std::filesystem::path path = folder / ("s" + extension);
    const bool keeps_markers = extension == ".mesh" || extension == ".msh" || extension == ".vtu";
    CHECK(io::write_surface(path, surface) == (keeps_markers ? "" : "markers of the polygons"));
    const AnyContents contents =
        keeps_markers ? io::read_any_contents(path) : AnyContents(io::read_surface(path));
    const auto* back = std::get_if<SurfaceFile>(&contents);
    REQUIRE(back != nullptr);
    REQUIRE(back->polygon_count() == surface.polygon_count());
    for (std::size_t i = 0; i < surface.polygon_count(); ++i)
      for (std::size_t k = 0; k < 3; ++k)  // STL numbers its vertices anew
        CHECK(back->set.points[back->polygon(i)[k].index()] ==
              surface.set.points[surface.polygon(i)[k].index()]);
    if (keeps_markers) CHECK(back->markers == surface.markers);
  }
  CHECK_THROWS_AS((void)io::write_surface(folder / "s.su2", surface), InputError);
  surface.offsets = {0, 12};  // one polygon of twelve corners
  CHECK_THROWS_AS((void)io::write_surface(folder / "s.mesh", surface), InputError);
  std::filesystem::remove_all(folder);
}
