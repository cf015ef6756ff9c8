// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "leonhard/mesh/draw/canvas/canvas.hpp"
#include "leonhard/mesh/draw/space/camera.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

/// What of a tetrahedral mesh can be seen. Not meant for callers of the room.
namespace leonhard::draw {

enum class FacetKind : std::uint8_t {
  boundary,  ///< of the mesh
  inside,    ///< a face laid bare, the tetrahedron before it being removed
  section,   ///< where the plane cuts a tetrahedron
};

/// How an edge of a facet is drawn.
enum class FacetLine : std::uint8_t {
  thin,
  strong,   ///< a crease, or where one area of colour meets another
  outline,  ///< strong too, with no facet on its other side
};

/// A corner of a facet as it is seen: page x and y once placed, the camera's before.
struct FacetCorner {
  double x{}, y{}, nearness{};
  double value{};  ///< of the field
};

/// Where a corner lies in the mesh: at a vertex (both the same) or on an edge, cut by the plane.
struct CornerPlace {
  VertexId low, high;
  friend bool operator==(const CornerPlace&, const CornerPlace&) = default;
};

/// A convex polygon that faces the viewer: a face, or what a plane leaves of one, or a section of a tetrahedron. At most
/// four corners, counter-clockwise where y is up.
struct Facet {
  std::array<FacetCorner, 4> corners;
  std::array<CornerPlace, 4> places;
  std::array<FacetLine, 4> lines{};  ///< [i]: of the edge from corner i to the next
  Vec3 normal;                       ///< unit length, in the camera's axes
  TetId tet;                         ///< to which it belongs
  std::optional<Marker> marker;      ///< of the boundary or the interface
  std::uint32_t colour = 0;          ///< index of a palette
  std::uint8_t count = 3;            ///< of corners
  FacetKind kind = FacetKind::boundary;
};

/// The arrays of a mesh fit together and its points are finite: all that drawing relies on.
/// throws InputError naming the tetrahedron or vertex
void check_mesh(const TetMesh& mesh);

/// The facets that face the viewer, in the camera's coordinates; hidden ones too.
///
/// plane   not looked at for CutStyle::none
/// values  one a vertex, or none
/// Cost O(tetrahedra).
[[nodiscard]] std::vector<Facet> visible_facets(const TetMesh& mesh, const Camera& camera, CutStyle style,
                                                const CutPlane& plane, std::span<const double> values);

/// Of triangles in space those that are counter-clockwise as the viewer sees them.
/// values  one a vertex, or none
[[nodiscard]] std::vector<Facet> visible_facets(const PerId<VertexId, Point3>& points,
                                                std::span<const std::array<VertexId, 3>> triangles,
                                                const Camera& camera, std::span<const double> values);

/// Tells the edges apart, after the facets have their colours. Strong are edges between facets of different kinds, creases
/// of the boundary beyond 40 degrees, and, if asked for, edges between different colours.
/// Cost O(n log n).
void mark_lines(std::span<Facet> facets, bool between_colours);

/// Moves the facets to the page, as large as `area` allows, in its middle.
void place(std::span<Facet> facets, const Rect& area);

/// How bright a facet is under a light over the viewer's left shoulder, up to 1; sections are 1, so that their colours
/// are those of the colour bar.
[[nodiscard]] double brightness(const Facet& facet);

/// A colour under a light of this brightness.
[[nodiscard]] Colour lit(Colour colour, double brightness);

/// The width in thin lines of an edge of a facet on the page: thinner where the facet is small, so that a fine mesh
/// keeps its shades.
///
/// thin  Canvas::thin()
[[nodiscard]] double line_width(const Facet& facet, std::size_t edge, double thin);

}  // namespace leonhard::draw
