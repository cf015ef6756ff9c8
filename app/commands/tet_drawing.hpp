// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/tet_picture.hpp"

namespace leonhard::app {

/// What `leonhard draw` is asked for, as words, where the mesh is of space.
struct TetDrawing {
  std::string mesh_file, picture;
  std::string what = "mesh";  ///< mesh, markers, regions, quality, partition
  std::string field;          ///< a point field of a .vtu in place of `what`
  std::string cut;            ///< as parse_cut takes it
  bool section = false;       ///< cut tetrahedra in two, not around
  std::vector<double> view;   ///< none, or azimuth and elevation, degrees
  double perspective_deg = 0;
  std::array<int, 2> size{1600, 1000};
  std::string title;
  std::uint32_t parts = 8;
  std::uint64_t seed = 1;
};

/// Draw the mesh. throws InputError, also for options that are for meshes of the plane; OutputError
void draw_tets(const TetDrawing& drawing, const TetMesh& mesh);

}  // namespace leonhard::app
