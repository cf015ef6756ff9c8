// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/vtu.hpp"

#include <bit>
#include <cstdint>
#include <cstring>

#include "leonhard/mesh/io/formats/xml.hpp"
#include "tests/mesh/io/sample_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

MeshFile parse(const std::string& bytes) { return io::parse_vtu(bytes, "m.vtu"); }

/// A file as ParaView and meshio write them in ascii: two triangles on the unit square and two marked lines.
const std::string ascii =
    "<?xml version=\"1.0\"?>\n"
    "<!-- a comment with <tags> -->\n"
    "<VTKFile type='UnstructuredGrid' version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\">\n"
    "<PointData><DataArray type=\"Float64\" Name=\"T\" format=\"ascii\"> nan 1 2 3 </DataArray></PointData>\n"
    "<Points>\n"
    "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n"
    "0 0 0  1 0 0\n"
    "1 1 0  0 1 0\n"
    "<InformationKey name=\"L2_NORM_RANGE\" location=\"vtkDataArray\" length=\"1\"><Value "
    "index=\"0\">0</Value></InformationKey>\n"
    "</DataArray>\n"
    "</Points>\n"
    "<Cells>\n"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 2 3 0 1 3 2</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 8 10</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 5 3 3</DataArray>\n"
    "</Cells>\n"
    "<CellData><DataArray type=\"Int32\" Name=\"gmsh:physical\" format=\"ascii\">0 0 4 "
    "9</DataArray></CellData>\n"
    "</Piece>\n"
    "</UnstructuredGrid>\n"
    "</VTKFile>\n";

const char* base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(const std::string& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? base64_digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// Numbers of one type with a header that holds their size, in either byte order.
template <class Header, class Number>
std::string binary(std::initializer_list<double> values, bool swapped) {
  std::string bytes;
  const auto append = [&](auto value) {
    auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
    if (swapped) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  };
  append(static_cast<Header>(values.size() * sizeof(Number)));
  for (const double value : values) append(static_cast<Number>(value));
  return bytes;
}

/// The square of `ascii` with its four arrays stored as VTK's other programs may.
template <class Header>
std::string binary_file(const std::string& format, bool swapped) {
  const std::string arrays[] = {binary<Header, float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, swapped),
                                binary<Header, std::int32_t>({0, 1, 2, 0, 2, 3}, swapped),
                                binary<Header, std::int32_t>({3, 6}, swapped),
                                binary<Header, std::uint8_t>({5, 5}, swapped)};
  const char* heads[] = {"type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"",
                         "type=\"Int32\" Name=\"connectivity\"", "type=\"Int32\" Name=\"offsets\"",
                         "type=\"UInt8\" Name=\"types\""};
  const bool little = (std::endian::native == std::endian::little) != swapped;
  std::string xml = std::string("<VTKFile type=\"UnstructuredGrid\" byte_order=\"") +
                    (little ? "Little" : "Big") + "Endian\" header_type=\"UInt" +
                    (sizeof(Header) == 8 ? "64" : "32") +
                    "\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">";
  std::string appended;
  for (int i = 0; i < 4; ++i) {
    if (i < 2) xml += i == 0 ? "<Points>" : "</Points><Cells>";
    xml += std::string("<DataArray ") + heads[i];
    if (format == "binary") {
      xml += " format=\"binary\">\n  " + base64(arrays[i]) + "\n</DataArray>";
    } else {
      xml += " format=\"appended\" offset=\"" + std::to_string(appended.size()) + "\"/>";
      appended += format == "raw" ? arrays[i] : base64(arrays[i]);
    }
  }
  xml += "</Cells></Piece></UnstructuredGrid>";
  if (format != "binary")
    xml += "<AppendedData encoding=\"" + format + "\">\n _" + appended + "\n</AppendedData>";
  return xml + "</VTKFile>";
}

}  // namespace

TEST_CASE("vtu_has_marked_edges_as_cells_that_other_programs_see") {
  const TriangleMesh mesh = grid_with_everything();
  const std::size_t edges = mesh.boundary.size() + mesh.constraints.size();
  const std::vector<CellField> fields{{"f", 1, std::vector<double>(mesh.triangle_count(), 0.25)}};
  const std::string text = io::format_vtu(mesh, {}, fields);
  CHECK(text.find("NumberOfCells=\"" + std::to_string(mesh.triangle_count() + edges) + "\"") !=
        std::string::npos);
  // As other programs, that know nothing of our own arrays: all edges with their markers, no field for them.
  const MeshFile back = parse(replaced(text, "leonhard_facets", "somebodys_array"));
  CHECK(back.mesh.boundary == mesh.boundary);
  CHECK(back.mesh.constraints == mesh.constraints);
  CHECK(back.mesh.regions == mesh.regions);
  REQUIRE(back.cell_fields.size() == 1);
  CHECK(back.cell_fields[0] == fields[0]);
}

TEST_CASE("vtu_regions_that_are_not_finite_are_refused") {
  TriangleMesh mesh = grid_with_everything();
  mesh.regions[TriangleId{0}] = NAN;
  CHECK(refusal([&] { (void)parse(io::format_vtu(mesh)); }).find("\"region\" holds nan") !=
        std::string::npos);
}

TEST_CASE("vtu_round_trip_keeps_everything_with_fields_beside_it") {
  const TriangleMesh mesh = grid_with_everything();
  const std::vector<double> twos(2 * mesh.vertex_count(), 0.5), ones(mesh.vertex_count(), NAN);
  const MeshFile back = parse(io::format_vtu(mesh, {{"velocity <m/s>", 2, twos}, {"p", 1, ones}}));
  REQUIRE(back.point_fields.size() == 2);
  CHECK(back.point_fields[0] == PointField{"velocity <m/s>", 2, twos});
  CHECK(back.point_fields[1].name == "p");
  CHECK(std::isnan(back.point_fields[1].values.back()));
  CHECK(back.cell_fields.empty());
  check_same_mesh(mesh, back.mesh);
  CHECK(back.mesh.boundary == mesh.boundary);
  CHECK(back.warnings.empty());
  check_same_mesh(grid_with_hole(), parse(io::format_vtu(grid_with_hole())).mesh);
}

TEST_CASE("vtu_fields_of_vertices_and_cells_come_back_to_the_last_bit") {
  const TriangleMesh mesh = grid_with_everything();
  std::vector<PointField> points;
  std::vector<CellField> cells;
  std::uint64_t bits = 1;
  const auto fill = [&](std::size_t count) {
    std::vector<double> values;
    while (values.size() < count) {
      bits = bits * 6364136223846793005U + 1442695040888963407U;
      values.push_back(std::bit_cast<double>(bits));  // subnormal, huge, NaN: all of them
    }
    return values;
  };
  for (const std::size_t components : {1, 2, 3, 9, 4}) {
    const std::string name = "of " + std::to_string(components) + " <&>";
    points.push_back({name, components, fill(components * mesh.vertex_count())});
    cells.push_back({name, components, fill(components * mesh.triangle_count())});
  }
  points.push_back({"region", 1, fill(mesh.vertex_count())});  // kept for cells only
  cells.push_back({"marker", 1, fill(mesh.triangle_count())});
  const MeshFile back = parse(io::format_vtu(mesh, points, cells));
  check_same_mesh(mesh, back.mesh);
  CHECK(back.warnings.empty());
  const auto check_same = [](const auto& fields, const auto& expected) {
    REQUIRE(fields.size() == expected.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      CHECK(fields[i].name == expected[i].name);
      CHECK(fields[i].components == expected[i].components);
      REQUIRE(fields[i].values.size() == expected[i].values.size());
      CHECK(std::memcmp(fields[i].values.data(), expected[i].values.data(), 8 * fields[i].values.size()) ==
            0);
    }
  };
  check_same(back.point_fields, points);
  check_same(back.cell_fields, cells);
}

TEST_CASE("vtu_halves_of_a_quadrilateral_have_its_values_and_lines_have_none") {
  std::string text = replaced(ascii, "0 1 2 0 2 3 0 1 3 2", "0 1 2 3 0 1 3 2");
  text = replaced(text, "3 6 8 10", "4 6 8");
  text = replaced(text, "5 5 3 3", "9 3 3");
  text = replaced(text, "NumberOfCells=\"4\"", "NumberOfCells=\"3\"");
  text = replaced(text, "0 0 4 9", "7 4 9");
  text = replaced(text, "</CellData>",
                  "<DataArray type=\"Float32\" Name=\"v\" NumberOfComponents=\"2\" format=\"ascii\">"
                  "1 -inf 2 2 3 3</DataArray>"
                  "<DataArray type=\"String\" Name=\"s\" format=\"ascii\">65 0</DataArray>"
                  "<DataArray type=\"Int8\" Name=\"v\" format=\"ascii\">1 2 3</DataArray></CellData>");
  const MeshFile file = parse(text);
  REQUIRE(file.mesh.triangle_count() == 2);
  REQUIRE(file.cell_fields.size() == 1);
  CHECK(file.mesh.regions.flat() == std::vector<double>{7, 7});
  CHECK(file.cell_fields[0] == CellField{"v", 2, {1, -INFINITY, 1, -INFINITY}});
  REQUIRE(file.point_fields.size() == 1);
  CHECK(file.point_fields[0].name == "T");
  CHECK(std::isnan(file.point_fields[0].values[0]));
  CHECK(file.point_fields[0].values[3] == 3);
  const auto warns = [&](const char* words) {
    return std::any_of(file.warnings.begin(), file.warnings.end(),
                       [&](const std::string& w) { return w.find(words) != std::string::npos; });
  };
  CHECK(warns("\"s\" was left out: it holds no numbers"));
  CHECK(warns("\"v\" was left out: another one has this name"));
}

TEST_CASE("vtu_larger_than_one_compressed_block_is_kept") {
  PerId<VertexId, Point2> points;
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  std::vector<MarkedEdge> boundary;
  constexpr std::size_t columns = 9000;  // 18002 points are 432 kB, two blocks
  for (std::size_t i = 0; i <= columns; ++i) {
    const double x = static_cast<double>(i) * 0.1;
    points.push_back({x, 0.0});
    points.push_back({x, 1.0 + static_cast<double>(i * 7919 % 1000)});
  }
  for (std::size_t i = 0; i < columns; ++i) {
    const VertexId a = VertexId::from(2 * i), b = VertexId::from(2 * i + 2), c = VertexId::from(2 * i + 3),
                   d = VertexId::from(2 * i + 1);
    corners.push_back({a, b, c});
    corners.push_back({a, c, d});
    boundary.push_back({a, b, 1});
    boundary.push_back({c, d, 2});
  }
  boundary.push_back({VertexId{1}, VertexId{0}, 3});
  boundary.push_back({VertexId::from(2 * columns), VertexId::from(2 * columns + 1), 4});
  const TriangleMesh mesh = mesh::make_triangle_mesh(points, corners, boundary);
  check_same_mesh(mesh, parse(io::format_vtu(mesh)).mesh);
}

TEST_CASE("vtu_in_ascii_is_read_with_lines_as_marked_boundary_edges") {
  const MeshFile file = parse(ascii);
  CHECK(file.mesh.vertex_count() == 4);
  CHECK(sorted(file.mesh.boundary) == std::vector<MarkedEdge>{{VertexId{0}, VertexId{1}, 4},
                                                              {VertexId{1}, VertexId{2}, 1},
                                                              {VertexId{2}, VertexId{3}, 9},
                                                              {VertexId{3}, VertexId{0}, 1}});
  CHECK(file.mesh.marker_names.at(1) == "unmarked");
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("2 of 4 boundary edges") != std::string::npos);
}

TEST_CASE("vtu_is_read_in_every_encoding_header_size_and_byte_order") {
  const auto expected = mesh::fingerprint(parse(ascii).mesh);
  for (const char* format : {"binary", "base64", "raw"})
    for (const bool swapped : {false, true}) {
      CHECK(mesh::fingerprint(parse(binary_file<std::uint32_t>(format, swapped)).mesh) == expected);
      CHECK(mesh::fingerprint(parse(binary_file<std::uint64_t>(format, swapped)).mesh) == expected);
    }
}

TEST_CASE("every_prefix_of_a_vtu_file_is_refused") {
  const std::string text = io::format_vtu(grid_with_everything());
  for (std::size_t length = 0; length + 2 < text.size(); ++length)
    CHECK_MESSAGE(refusal([&] { parse(text.substr(0, length)); }) != "accepted", "cut after byte ", length);
}

TEST_CASE("vtu_array_of_no_compressed_blocks_is_refused_where_numbers_are_expected") {
  if (io::format_vtu(grid_with_everything()).find("vtkZLibDataCompressor") == std::string::npos)
    return;  // built without zlib
  const std::string compressed = replaced(ascii, "type='UnstructuredGrid'",
                                          "type='UnstructuredGrid' compressor='vtkZLibDataCompressor'");
  const std::string no_blocks = base64(std::string(12, '\0'));  // how many, their size, that of the last
  for (const auto* numbers : {"3 6 8 10", "5 5 3 3"})
    check_refused({{numbers,
                    replaced(compressed, "\"ascii\">" + std::string(numbers), "\"binary\">" + no_blocks),
                    {"holds 0 bytes", "are expected"}}},
                  [](const std::string& text) { parse(text); });
}

TEST_CASE("vtu_bad_input_is_refused_with_line_and_reason") {
  const std::string raw = binary_file<std::uint32_t>("raw", false);
  check_refused(
      {{"no xml", "hello", {"m.vtu:1", "no XML element"}},
       {"other xml", "<html></html>", {"m.vtu:1", "no unstructured grid"}},
       {"other grid",
        replaced(ascii, "type='UnstructuredGrid'", "type='PolyData'"),
        {"m.vtu:3", "no unstructured grid"}},
       {"unclosed", replaced(ascii, "</Cells>", ""), {"m.vtu:20", "</Cells>"}},
       {"no points",
        replaced(replaced(ascii, "<Points>", "<Pts>"), "</Points>", "</Pts>"),
        {"m.vtu:5", "no <Points>"}},
       {"no types", replaced(ascii, "\"types\"", "\"kinds\""), {"m.vtu:14", "no array \"types\""}},
       {"letters", replaced(ascii, "1 1 0", "1 l 0"), {"m.vtu:10", "\"l\""}},
       {"NaN", replaced(ascii, "1 1 0", "1 nan 0"), {"m.vtu:10", "not finite"}},
       {"too few numbers", replaced(ascii, "1 1 0", "1 1"), {"m.vtu:8", "11 numbers, but 12"}},
       {"out of the plane", replaced(ascii, "1 1 0", "1 1 2"), {"m.vtu:8", "point 2 has z = 2"}},
       {"id out of range",
        replaced(ascii, "0 2 3 0 1", "0 2 4 0 1"),
        {"m.vtu:15", "vertex 4 does not exist", "0 to 3"}},
       {"negative id", replaced(ascii, "0 2 3 0 1", "0 2 -1 0 1"), {"m.vtu:15", "vertex -1 does not exist"}},
       {"offset too large", replaced(ascii, "3 6 8 10", "3 6 8 11"), {"m.vtu:15", "entry 11 of 10"}},
       {"offset back", replaced(ascii, "3 6 8 10", "3 2 8 10"), {"m.vtu:15", "cell 1 ends at entry 2"}},
       {"unknown cell", replaced(ascii, "5 5 3 3", "5 10 3 3"), {"m.vtu:15", "cell 1 has the type 10"}},
       {"wrong corner count", replaced(ascii, "5 5 3 3", "5 9 3 3"), {"cell 1 of type 9 has 3 vertices"}},
       {"marker too large",
        replaced(ascii, "0 0 4 9", "0 0 4 5000000000"),
        {"m.vtu:19", "5000000000", "32 bits"}},
       {"float ids",
        replaced(ascii, "\"Int64\" Name=\"conn", "\"Float64\" Name=\"conn"),
        {"m.vtu:15", "integers are expected"}},
       {"unknown type", replaced(ascii, "Float32", "Float128"), {"m.vtu:8", "\"Float128\""}},
       {"unknown format",
        replaced(ascii, "format=\"ascii\">0 1 2", "format=\"hdf\">0 1 2"),
        {"m.vtu:15", "\"hdf\""}},
       {"count 10^12",
        replaced(ascii, "NumberOfPoints=\"4\"", "NumberOfPoints=\"1000000000000\""),
        {"m.vtu:5", "NumberOfPoints"}},
       {"count 10^9",
        replaced(ascii, "NumberOfPoints=\"4\"", "NumberOfPoints=\"1000000000\""),
        {"m.vtu:8", "3000000000"}},
       {"count of no number",
        replaced(ascii, "NumberOfPoints=\"4\"", "NumberOfPoints=\"four\""),
        {"m.vtu:5", "\"four\""}},
       {"unknown compressor",
        replaced(ascii, "version=\"0.1\"", "compressor=\"vtkBZ2DataCompressor\""),
        {"m.vtu:3", "vtkBZ2DataCompressor"}},
       {"offset beyond the data",
        replaced(raw, "offset=\"52\"", "offset=\"52000\""),
        {"m.vtu:1", "52000 bytes into appended data"}},
       {"size beyond the data",
        replaced(raw, std::string("\x18\0\0\0", 4), std::string("\xff\xff\xff\x7f", 4)),
        {"\"connectivity\"", "2147483647"}},
       {"no underscore", replaced(raw, "\n _", "\n "), {"underscore"}},
       {"bad base64",
        replaced(binary_file<std::uint32_t>("binary", false), "AAAA", "A*AA"),
        {"no base64: \"*\""}}},
      [](const std::string& text) { parse(text); });
}

TEST_CASE("vtu_with_a_damaged_compressed_block_is_refused_or_read_as_it_was") {
  const TriangleMesh mesh = grid_with_everything();
  const std::string text = io::format_vtu(mesh);
  if (text.find("vtkZLibDataCompressor") == std::string::npos) return;  // built without zlib
  std::size_t refused = 0, tried = 0;
  for (std::size_t i = text.find("<AppendedData") + 40; i + 30 < text.size(); ++i, ++tried) {
    std::string damaged = text;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    try {
      const MeshFile file = parse(damaged);  // the size of a block that is not full has no influence
      CHECK(file.mesh.points == mesh.points);
      CHECK(file.mesh.boundary == mesh.boundary);
    } catch (const InputError&) {
      ++refused;
    }
  }
  CHECK(2 * refused > tried);
}

TEST_CASE("vtu_writer_refuses_fields_that_do_not_fit") {
  const TriangleMesh mesh = grid_with_hole();
  const std::vector<double> values(mesh.vertex_count());
  const auto write = [&](std::vector<PointField> fields) {
    return refusal([&] { static_cast<void>(io::format_vtu(mesh, fields)); });
  };
  CHECK(write({{"mach", 1, {1.0, 2.0}}}).find("field \"mach\": 2 values") == 0);
  CHECK(write({{"v", 0, {}}}).find("field \"v\"") == 0);
  CHECK(write({{"a", 1, values}, {"a", 1, values}}).find("another field of vertices has this name") !=
        std::string::npos);
  CHECK(write({{"marker", 1, values}}).find("marker") != std::string::npos);
  CHECK(write({{"", 1, values}}).find("no name") != std::string::npos);
  const auto write_cells = [&](std::vector<CellField> fields) {
    return refusal([&] { static_cast<void>(io::format_vtu(mesh, {}, fields)); });
  };
  CHECK(write_cells({{"part", 1, {1.0}}}).find("field \"part\": 1 values") == 0);
  CHECK(write_cells({{"region", 1, std::vector<double>(mesh.triangle_count())}}).find("region") !=
        std::string::npos);
}

TEST_CASE("xml_escapes_are_undone_by_the_parser") {
  const std::string name = "a<b & \"c\" 'd' >";
  const std::string document = "<x n=\"" + io::xml_escaped(name) + "\"/>";
  CHECK(io::parse_xml(document, "x", "").attribute("n") == name);
}

TEST_CASE("xml_nested_too_deep_is_refused") {
  std::string document;
  for (int i = 0; i < 100000; ++i) document += "<a>";
  CHECK(refusal([&] { static_cast<void>(io::parse_xml(document, "x", "")); }).find("deeper than 32") !=
        std::string::npos);
}
