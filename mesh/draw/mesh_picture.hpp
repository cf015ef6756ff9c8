// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/field_options.hpp"
#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// Pictures of meshes. The file's extension gives the format: .png, .svg or .pdf, one code for all. What lies
/// outside the mesh but inside a closed boundary (a body) is light grey. SVG and PDF hold areas as
/// vectors up to 20,000 triangles in view and mesh lines up to 60,000; beyond that they are embedded as an image,
/// which keeps the file small, while text, axes, boundaries and contour lines stay vectors. Same arguments, same
/// file, byte for byte.
///
/// All throw, before the file is touched: InputError for another extension, a picture size or view out of range,
/// a mesh without triangles, values that do not fit the mesh; and OutputError, naming the path, if the file
/// cannot be written. No half-written file is left. Cost O(triangles in view + pixels).
namespace leonhard::draw {

enum class MeshFill {
  none,
  quality,  ///< smallest angle of each triangle, with a colour bar
  region    ///< one colour a regional attribute, with a legend
};

struct MeshOptions {
  PictureSize size{};
  View view{};
  std::string title{};
  std::string x_label = "x", y_label = "y";
  MeshFill fill = MeshFill::none;
  bool colour_boundaries = true;  ///< one colour a marker, with a legend of the mesh's names; else all dark
  bool show_vertices = false;
  std::vector<Point2> marks{};  ///< rings about these points
  LegendPlace legend = LegendPlace::automatic;
  /// The cell of which each triangle is a part: no edge is drawn within a cell. Empty: each is a cell of its own.
  std::span<const std::size_t> cell_of{};
};

/// The mesh: edges thin, boundaries thick.
void draw_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const MeshOptions& options = {});

/// A field: filled bands between levels, contour lines over them, a colour bar.
///
/// vertex_values  one finite value a vertex, linear on each triangle (so bands and lines are exact, not sampled)
void draw_field(const std::filesystem::path& path, const TriangleMesh& mesh,
                std::span<const double> vertex_values, const FieldOptions& options = {});

struct PartitionOptions {
  PictureSize size{};
  View view{};
  std::string title{};
  std::string x_label = "x", y_label = "y";
  bool show_mesh = true;
  std::span<const std::size_t> cell_of{};  ///< as of MeshOptions
};

/// A partition, the parts of neighbouring triangles in different colours, the edges between parts dark.
///
/// part_of  one part a triangle or one a vertex, told apart by the length (one a triangle where both are equal);
///          a vertex's part covers its median-dual cell
/// parts    number of parts; each entry is below it
void draw_partition(const std::filesystem::path& path, const TriangleMesh& mesh,
                    std::span<const std::uint32_t> part_of, std::uint32_t parts,
                    const PartitionOptions& options = {});

}  // namespace leonhard::draw
