// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "leonhard/mesh/io/formats/tetgen_files.hpp"
#include "leonhard/mesh/io/formats/triangle_files.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// What the files of Triangle and of TetGen state. throws InputError as read_triangle_files and read_tetgen_files
[[nodiscard]] MeshSoup<2> triangle_soup(const TriangleFileTexts& texts, const std::string& source);
[[nodiscard]] MeshSoup<2> read_triangle_soup(const std::filesystem::path& path);
[[nodiscard]] MeshSoup<3> tetgen_soup(const TetgenFileTexts& texts, const std::string& source);
[[nodiscard]] MeshSoup<3> read_tetgen_soup(const std::filesystem::path& path);

}  // namespace leonhard::io
