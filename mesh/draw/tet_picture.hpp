// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/draw/view3.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

/// Pictures of tetrahedral meshes: the boundary as a shaded surface, cut open so that the inside shows. What remains
/// after the cut fills the page. The file's extension gives the format: .png, .svg or .pdf; same arguments, same file,
/// byte for byte. PNG is drawn by a z-buffer, SVG and PDF as vectors from back to front; where more than 20,000 facets
/// would be drawn these hold the z-buffer's image, text staying text. No display is needed.
///
/// All throw, before the file is touched: InputError for another extension, a size, view or cut out of range, a mesh
/// without tetrahedra or whose arrays do not fit together, a cut that leaves nothing; and OutputError, naming the path,
/// if the file cannot be written. Cost O(tetrahedra + pixels); beyond the mesh's own some 40 bytes a vertex, one a
/// tetrahedron and 72 a pixel.
namespace leonhard::draw {

enum class TetFill {
  plain,    ///< one colour for the boundary, one for the inside
  marker,   ///< one colour a boundary marker, with a legend of the mesh's names
  region,   ///< one colour a regional attribute, with a legend
  quality,  ///< smallest angle between faces of each tetrahedron, with a colour bar
};

struct TetPictureOptions {
  PictureSize size{};
  View3 view{};
  std::string title{};
  CutStyle cut = CutStyle::crinkled;
  std::optional<CutPlane> cut_plane{};  ///< default: cut_through_middle of the mesh's box
  bool show_edges = true;
  bool show_axes = true;     ///< three small arrows, x, y and z
  bool show_caption = true;  ///< below: how many tetrahedra, and what the cut removed
  LegendPlace legend = LegendPlace::automatic;
};

/// The mesh.
void draw_tet_mesh(const std::filesystem::path& path, const TetMesh& mesh, TetFill fill = TetFill::plain,
                   const TetPictureOptions& options = {});

/// How the values of a field become colours.
struct TetFieldScale {
  std::string label{};  ///< beside the colour bar, unit included
  ColourMap colour_map = ColourMap::sequential;
  std::optional<Range> range{};  ///< default: the values in view; values beyond get the end colours
  int bands = 20;              ///< about how many, 1 to 200
};

/// A field on the boundary and on the cut: bands between levels, a colour bar.
///
/// vertex_values  one finite value a vertex, linear on each tetrahedron
void draw_tet_field(const std::filesystem::path& path, const TetMesh& mesh,
                    std::span<const double> vertex_values, const TetFieldScale& scale = {},
                    const TetPictureOptions& options = {});

/// A field on a surface in space: of its triangles those that are counter-clockwise as the viewer sees them, so that of a body's
/// wall the side that the flow sees is drawn. The options of cuts play no part.
///
/// vertex_values  one finite value a point, those that no triangle uses too
/// throws         InputError for an id out of range, no triangle, none that faces the viewer
void draw_surface_field(const std::filesystem::path& path, const PerId<VertexId, Point3>& points,
                        std::span<const std::array<VertexId, 3>> triangles, std::span<const double> vertex_values,
                        const TetFieldScale& scale = {}, const TetPictureOptions& options = {});

/// A partition of the tetrahedra, touching parts in different colours.
///
/// part_of  one part a tetrahedron, each below `parts`
void draw_tet_partition(const std::filesystem::path& path, const TetMesh& mesh,
                        std::span<const std::uint32_t> part_of, std::uint32_t parts,
                        const TetPictureOptions& options = {});

}  // namespace leonhard::draw
