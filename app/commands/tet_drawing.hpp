// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/tet_picture.hpp"
#include "leonhard/mesh/io/file_contents.hpp"

namespace leonhard::app {

/// What `leonhard draw` is asked for, as words, where the mesh is of space.
struct TetDrawing {
  std::string picture;
  std::string what = "mesh";           ///< mesh, markers, regions, quality, partition
  std::string field;                   ///< name of a point field in place of `what`
  std::vector<double> field_values{};  ///< one a vertex
  std::string cut;                     ///< as parse_cut takes it
  bool section = false;                ///< cut tetrahedra in two, not around
  std::vector<double> view;            ///< none, or azimuth and elevation, degrees
  double perspective_deg = 0;
  std::array<int, 2> size{1600, 1000};
  std::string title;
  std::uint32_t parts = 8;
  std::uint64_t seed = 1;
};

/// One value a vertex: those of a field of one component, else the length of each row.
[[nodiscard]] std::vector<double> lengths_of(const PointField& field);

/// Draw the mesh. throws InputError, also for options that are for meshes of the plane; OutputError
void draw_tets(const TetDrawing& drawing, const TetMesh& mesh);

}  // namespace leonhard::app
