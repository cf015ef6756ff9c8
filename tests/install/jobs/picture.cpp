// SPDX-License-Identifier: MIT
// Draws a mesh and a field on it.
#include <filesystem>
#include <leonhard/mesh/draw/draw.hpp>
#include <vector>

#include "check.hpp"
#include "grid.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "leonhard_picture_job";
  std::filesystem::create_directories(folder);
  const TriangleMesh mesh = grid(8, 8, [](double s, double t) { return Point2{s, t}; });
  std::vector<double> values;
  for (const Point2 p : mesh.points) values.push_back(p.x * p.y);
  draw::draw_mesh(folder / "mesh.svg", mesh, {.title = "eight by eight"});
  draw::draw_field(folder / "field.png", mesh, values, {.size = {.width = 400, .height = 300}, .show_mesh = true});
  for (const char* name : {"mesh.svg", "field.png"})
    claim(std::filesystem::exists(folder / name) && std::filesystem::file_size(folder / name) > 1000, name);
  std::filesystem::remove_all(folder);
  return claim.failed();
}
