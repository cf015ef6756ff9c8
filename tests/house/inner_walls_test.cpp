// SPDX-License-Identifier: MIT
// The rooms' arrows and inner walls, read off the includes: a room includes only the rooms that it may know, and of another
// room only what is public there.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/test_files.hpp"

namespace {

namespace fs = std::filesystem;

/// A room and the rooms that it may include.
struct Room {
  std::string_view name;
  std::vector<std::string_view> may_know;
};
const std::array rooms{
    Room{"kernel", {}},
    Room{"mesh", {"kernel"}},
    Room{"delaunay", {"kernel", "mesh"}},
    Room{"graph", {"kernel", "mesh"}},
    Room{"solver", {"kernel", "mesh", "graph"}},
    Room{"app", {"kernel", "mesh", "delaunay", "graph", "solver"}},
    Room{"examples", {"kernel", "mesh", "delaunay", "graph", "solver"}},
};

/// Folders within a room that are public as its root is.
const std::array<std::string_view, 2> public_folders{"mesh/io", "mesh/draw"};

/// "mesh/io/vtu.hpp" of #include "leonhard/mesh/io/vtu.hpp", with either kind of quotes; empty for other lines.
std::string_view included(std::string_view line) {
  constexpr std::string_view include = "#include ", leonhard = "leonhard/";
  if (!line.starts_with(include)) return {};
  line.remove_prefix(include.size());
  if (line.empty() || (line.front() != '"' && line.front() != '<')) return {};
  line.remove_prefix(1);
  if (!line.starts_with(leonhard)) return {};
  line.remove_prefix(leonhard.size());
  return line.substr(0, line.find_first_of("\">"));
}

/// What is wrong with a file of a room, in words, a line each.
std::vector<std::string> broken_walls(const Room& room, const std::string& file, const std::string& text) {
  std::vector<std::string> problems;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (room.name != "kernel" && line.find("kernel::detail") != std::string::npos)
      problems.push_back(file + " uses kernel::detail, which is the kernel's own");
    const std::string_view header = included(line);
    if (header.empty()) continue;
    const std::string_view of = header.substr(0, header.find('/')),
                           folder = header.substr(0, header.rfind('/'));
    if (of == room.name) continue;
    if (std::find(room.may_know.begin(), room.may_know.end(), of) == room.may_know.end())
      problems.push_back(file + " includes " + std::string(header) + ", a room that it may not know");
    else if (folder != of &&
             std::find(public_folders.begin(), public_folders.end(), folder) == public_folders.end())
      problems.push_back(file + " includes " + std::string(header) + ", which is internal to " +
                         std::string(of));
  }
  return problems;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("a_room_includes_rooms_above_it_alone_and_of_these_what_is_public") {
  std::size_t files = 0;
  for (const Room& room : rooms) {
    for (const auto& entry : fs::recursive_directory_iterator(leonhard::test::source_folder() / room.name)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      ++files;
      for (const std::string& problem : broken_walls(room, entry.path().string(), text_of(entry.path())))
        FAIL_CHECK(problem);
    }
  }
  CHECK(files > 500);
}

TEST_CASE("the_check_of_walls_tells_arrows_down_folders_and_details") {
  const Room &kernel = rooms[0], &mesh = rooms[1], &delaunay = rooms[2];
  CHECK(broken_walls(mesh, "f", "#include \"leonhard/kernel/point.hpp\"\n#include <vector>\n").empty());
  CHECK(broken_walls(mesh, "f", "#include \"leonhard/mesh/check/invariants.hpp\"\n").empty());
  CHECK(broken_walls(delaunay, "f", "#include \"leonhard/mesh/io/vtu.hpp\"\n").empty());
  CHECK(broken_walls(kernel, "f", "kernel::detail::x();\n").empty());
  CHECK(broken_walls(mesh, "f", "#include \"leonhard/delaunay/refine.hpp\"\n").size() == 1);
  CHECK(broken_walls(kernel, "f", "#include <leonhard/mesh/id.hpp>\n").size() == 1);
  CHECK(broken_walls(delaunay, "f", "#include \"leonhard/mesh/io/formats/su2.hpp\"\n").size() == 1);
  CHECK(broken_walls(delaunay, "f", "#include \"leonhard/kernel/stages/exact.hpp\"\n").size() == 1);
  CHECK(broken_walls(delaunay, "f", "  kernel::detail::x();\n").size() == 1);
}
