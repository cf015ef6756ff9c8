// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/diagram.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// The figures of Barth's notes, each drawn from what the library's algorithms give for the sites.
namespace leonhard::notes {

struct Figure {
  std::string number;  ///< "3.3.5"
  std::string title;
  std::vector<draw::Diagram> (*make)();
  int columns = 1;
  /// Draws a figure that is no diagram, such as a whole mesh or a matrix; make is then not used.
  void (*draw)(const std::filesystem::path& file, const std::string& title) = nullptr;
};

[[nodiscard]] std::vector<Figure> polyhedron_figures();     ///< 1.1.0
[[nodiscard]] std::vector<Figure> dual_figures();           ///< 1.2.0, 1.3.0, 3.1.0
[[nodiscard]] std::vector<Figure> orientation_figures();    ///< 2.1.0
[[nodiscard]] std::vector<Figure> ordering_figures();       ///< 2.2.0 to 2.2.2
[[nodiscard]] std::vector<Figure> communication_figures();  ///< 2.3.0, 2.3.1
[[nodiscard]] std::vector<Figure> partition_figures();      ///< 2.3.2 to 2.3.6
[[nodiscard]] std::vector<Figure> property_figures();       ///< 3.2.0 to 3.2.3
[[nodiscard]] std::vector<Figure> algorithm_figures();      ///< 3.3.0 to 3.3.8

// ---- what the figures share ----

inline constexpr draw::Colour accent{0.78, 0.16, 0.12}, second{0.10, 0.42, 0.72}, faint{0.70, 0.72, 0.76},
    shade{1.0, 0.90, 0.80};
inline constexpr draw::Stroke thin{.width = 1}, strong{.colour = accent, .width = 2.2},
    light{.colour = faint}, dashed{.colour = accent, .width = 1.6, .style = draw::LineStyle::dashed};

/// Sites in the unit square, no two nearer than `apart`.
[[nodiscard]] std::vector<Point2> random_sites(std::size_t count, std::uint64_t seed, double apart = 0.08);

/// A diagram of a mesh with its vertices.
[[nodiscard]] draw::Diagram diagram_of(const TriangleMesh& mesh, const std::string& title = {},
                                       const draw::Stroke& stroke = thin);

/// The mesh's vertex at a point of its own, and the corners of a triangle.
[[nodiscard]] VertexId vertex_at(const TriangleMesh& mesh, Point2 p);
[[nodiscard]] std::array<Point2, 3> corners(const TriangleMesh& mesh, TriangleId t);
/// The triangle that holds a point; by search.
[[nodiscard]] TriangleId triangle_at(const TriangleMesh& mesh, Point2 p);
/// The third corner of a triangle that has the vertices a and b.
[[nodiscard]] VertexId apex(const TriangleMesh& mesh, TriangleId t, VertexId a, VertexId b);
[[nodiscard]] Point2 centroid(std::span<const Point2> points);

}  // namespace leonhard::notes
