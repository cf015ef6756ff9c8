// SPDX-License-Identifier: MIT
// Writes a mesh in several formats and reads it back; a file with a fault is refused by name and line.
#include <filesystem>
#include <fstream>
#include <leonhard/kernel/input_error.hpp>
#include <leonhard/mesh/fingerprint.hpp>
#include <leonhard/mesh/io/mesh_file.hpp>
#include <leonhard/mesh/io/vtu.hpp>
#include <leonhard/mesh/quality.hpp>
#include <string>

#include "check.hpp"
#include "grid.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "leonhard_files_job";
  std::filesystem::create_directories(folder);
  const TriangleMesh mesh = grid(5, 4, [](double s, double t) { return Point2{s, t}; });
  for (const char* name : {"grid.su2", "grid.vtu", "grid.msh", "grid.node"}) {
    io::write_mesh(folder / name, mesh);
    const TriangleMesh again = io::read_mesh(folder / name).mesh;
    claim(mesh::fingerprint(again) == mesh::fingerprint(mesh), name);
    claim(again.boundary.size() == mesh.boundary.size(), "the boundary comes back");
  }
  claim(mesh::quality(mesh).total_area > 0.999, "the grid covers the unit square");

  PointField height{.name = "height"};
  for (const Point2 p : mesh.points) height.values.push_back(p.x + 2 * p.y);
  io::write_vtu(folder / "field.vtu", mesh, {height});
  claim(io::read_vtu_field(folder / "field.vtu", "height").values == height.values, "a field comes back to the bit");

  std::ofstream(folder / "bad.su2") << "NDIME= 2\nNPOIN= 1\n0 zero 0\n";
  std::string words;
  try {
    static_cast<void>(io::read_mesh(folder / "bad.su2"));
  } catch (const InputError& error) {
    words = error.what();
  }
  claim(words.find("bad.su2:3") != std::string::npos, "the error names file and line");
  std::filesystem::remove_all(folder);
  return claim.failed();
}
