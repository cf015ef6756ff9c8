// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/mesh_file.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "leonhard/mesh/io/airfoil_dat.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/did_you_mean.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/pslg_file.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "tests/mesh/io/folder.hpp"
#include "tests/mesh/io/sample_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;
namespace fs = std::filesystem;

TEST_CASE("every_mesh_format_is_chosen_by_extension_and_round_trips_through_files") {
  const Folder folder;
  const TriangleMesh mesh = grid_with_hole();
  for (const std::string& extension : io::mesh_extensions()) {
    CAPTURE(extension);
    const fs::path file = folder.path / ("mesh" + extension);
    io::write_mesh(file, mesh);
    const MeshFile back = io::read_mesh(file);
    check_same_mesh(mesh, back.mesh);
    CHECK(back.warnings.empty());
    io::write_mesh(file, mesh);  // over itself
    check_same_mesh(mesh, io::read_mesh(file).mesh);
  }
  io::write_mesh(folder.path / "CAPITALS.SU2", mesh);
  check_same_mesh(mesh, io::read_mesh(folder.path / "CAPITALS.SU2").mesh);
}

TEST_CASE("fields_go_into_the_formats_that_carry_them_and_no_others") {
  const Folder folder;
  const TriangleMesh mesh = grid_with_hole();
  const std::vector<PointField> points{{"t", 1, std::vector<double>(mesh.vertex_count(), 0.1)}};
  const std::vector<CellField> cells{{"v", 3, std::vector<double>(3 * mesh.triangle_count(), 0.2)}};
  std::size_t carrying = 0;
  for (const std::string& extension : io::mesh_extensions()) {
    CAPTURE(extension);
    const fs::path file = folder.path / ("fields" + extension);
    if (!io::carries_fields(file)) {
      CHECK(refusal([&] { io::write_mesh(file, mesh, points); }).find("carry no fields") !=
            std::string::npos);
      CHECK(refusal([&] { io::write_mesh(file, mesh, {}, cells); }).find("carry no fields") !=
            std::string::npos);
      CHECK(!fs::exists(file));
      continue;
    }
    ++carrying;
    io::write_mesh(file, mesh, points, cells);
    const MeshFile back = io::read_mesh(file);
    check_same_mesh(mesh, back.mesh);
    CHECK(back.point_fields == points);
    CHECK(back.cell_fields == cells);
  }
  CHECK(carrying == 2);
  CHECK(io::carries_fields("A.VTU"));
}

TEST_CASE("pslg_with_points_in_a_node_file_is_read_from_files") {
  const Folder folder;
  io::write_mesh(folder.path / "m.ele", grid_with_hole());
  const Pslg pslg = io::read_pslg(folder.path / "m.poly");
  CHECK(pslg.points == grid_with_hole().points.flat());
  CHECK(pslg.segments.size() == grid_with_hole().boundary.size());
  io::write_pslg(folder.path / "again.poly", pslg);
  Pslg again = io::read_pslg(folder.path / "again.poly");
  again.source = pslg.source;
  CHECK(again == pslg);
}

TEST_CASE("poly_file_alone_is_no_mesh") {
  const Folder folder;
  io::write_file_atomically(folder.path / "g.poly", "0 2 0 0\n0 0\n0\n");
  CHECK(refusal([&] {
          static_cast<void>(io::read_mesh(folder.path / "g.poly"));
        }).find("geometry without triangles") != std::string::npos);
}

TEST_CASE("unknown_extensions_are_refused_with_those_known_and_a_suggestion") {
  const auto read = [](const char* path) { return refusal([&] { static_cast<void>(io::read_mesh(path)); }); };
  CHECK(read("a/wing.su").find("a/wing.su: \".su\" is no extension of a mesh file; did you mean \".su2\"?") ==
        0);
  CHECK(read("wing.stl").find("known are .su2, .vtu, .msh, .mesh, .node") != std::string::npos);
  CHECK(read("wing").find("needs an extension") != std::string::npos);
  CHECK(refusal([] { io::write_mesh("wing.vtk", grid_with_hole()); }).find("did you mean \".vtu\"?") !=
        std::string::npos);
  CHECK(refusal([] { static_cast<void>(io::read_pslg("wing.pole")); }).find("did you mean \".poly\"?") !=
        std::string::npos);
  CHECK(refusal([] { io::write_pslg("wing.su2", {}); }).find("known are .poly") != std::string::npos);
}

TEST_CASE("files_that_cannot_be_read_are_refused_with_the_reason") {
  const Folder folder;
  const auto read = [&](const char* name) {
    return refusal([&] { static_cast<void>(io::read_mesh(folder.path / name)); });
  };
  CHECK(read("missing.su2").find("missing.su2: file does not exist") != std::string::npos);
  CHECK(read("no/folder.su2").find("file does not exist") != std::string::npos);
  std::ofstream(folder.path / "empty.vtu").close();
  CHECK(read("empty.vtu").find("empty.vtu: file is empty") != std::string::npos);
  fs::create_directory(folder.path / "folder.su2");
  CHECK(read("folder.su2").find("is a folder") != std::string::npos);
  fs::create_symlink("/dev/zero", folder.path / "endless.su2");
  CHECK(read("endless.su2").find("is a device or a pipe") != std::string::npos);
  fs::create_symlink("loop.su2", folder.path / "loop.su2");
  CHECK(read("loop.su2").find("loop.su2: cannot read file") != std::string::npos);
  CHECK(read("missing.node").find("missing.node: file does not exist") != std::string::npos);
  CHECK(refusal([&] {
          static_cast<void>(io::read_airfoil(folder.path / "a.dat"));
        }).find("a.dat: file does not exist") != std::string::npos);
  if (::geteuid() != 0) {
    std::ofstream(folder.path / "closed.su2") << "NDIME= 2\n";
    fs::permissions(folder.path / "closed.su2", fs::perms::none);
    CHECK(read("closed.su2").find("Permission denied") != std::string::npos);
  }
}

TEST_CASE("write_mesh_to_a_full_device_is_an_output_error") {
  if (!fs::exists("/dev/full")) return;
  const Folder folder;
  fs::create_symlink("/dev/full", folder.path / "full.su2");
  CHECK_THROWS_AS(io::write_mesh(folder.path / "full.su2", grid_with_hole()), OutputError);
  fs::create_symlink("/dev/full", folder.path / "full.vtu");
  CHECK_THROWS_AS(io::write_mesh(folder.path / "full.vtu", grid_with_hole()), OutputError);
}

// ---- text_scanner, did_you_mean ----

TEST_CASE("numbers_are_whole_words_finite_and_to_the_last_bit") {
  double value = 0;
  using io::NumberFault;
  CHECK(io::parse_number("0.1", value) == NumberFault::none);
  CHECK(value == 0.1);
  CHECK(io::parse_number("+1.5E-3", value) == NumberFault::none);
  CHECK(value == 1.5e-3);
  CHECK(io::parse_number("4.9406564584124654e-324", value) == NumberFault::none);
  CHECK(value == 5e-324);
  CHECK(io::parse_number("-1e-999", value) == NumberFault::none);
  CHECK(value == 0);
  CHECK(io::parse_number("1e999", value) == NumberFault::too_large);
  CHECK(io::parse_number("NaN", value) == NumberFault::not_finite);
  CHECK(io::parse_number("-Infinity", value) == NumberFault::not_finite);
  for (const char* word : {"", "+", "-", "+-1", "++1", "1.0x", "x1", "1..0", "1,0", "0x10", "1d0", "."})
    CHECK_MESSAGE(io::parse_number(word, value) == NumberFault::not_a_number, word);
}

TEST_CASE("scanner_counts_lines_through_comments_blanks_and_a_byte_order_mark") {
  io::TextScanner scan("\xEF\xBB\xBF# first\n\n  \t\r\n a b # c\n\n7", "s", {.comment = '#'});
  REQUIRE(scan.next_line());
  CHECK(scan.line() == 4);
  CHECK(scan.word("") == "a");
  CHECK(scan.word("") == "b");
  CHECK(scan.line_done());
  REQUIRE(scan.next_line());
  CHECK(scan.where() == "s:6");
  CHECK(scan.integer("") == 7);
  CHECK_FALSE(scan.next_line());
}

TEST_CASE("long_and_unprintable_words_are_shortened_in_messages") {
  CHECK(io::in_quotes("a\x01"
                      "b") == "\"a?b\"");
  CHECK(io::in_quotes(std::string(100, 'x')) == "\"" + std::string(40, 'x') + "...\"");
}

TEST_CASE("edit_distance_is_a_metric_on_near_words_and_suggestions_are_near") {
  CHECK(io::edit_distance("", "abc") == 3);
  CHECK(io::edit_distance("kitten", "sitting") == 3);
  CHECK(io::edit_distance("mach", "MACH") == 0);
  CHECK(io::edit_distance("amch", "mach") == 1);
  const std::vector<std::string> known{"alpha_deg", "mach", "gamma"};
  CHECK(io::did_you_mean("alpha_dge", known) == "did you mean \"alpha_deg\"?");
  CHECK(io::did_you_mean("mahc", known) == "did you mean \"mach\"?");
  CHECK(io::did_you_mean("viscosity", known).empty());
  CHECK(io::did_you_mean("x", {}).empty());
}
