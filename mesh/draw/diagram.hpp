// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/curves.hpp"
#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// Diagrams of plane geometry: areas, lines, circles, points and words. Format, errors and determinism as in
/// mesh_picture.hpp.
namespace leonhard::draw {

/// How a line is drawn; width 1 is the thinnest that prints well.
struct Stroke {
  Colour colour{0.22, 0.27, 0.36};
  double width = 1;
  LineStyle style = LineStyle::solid;
};

/// Shapes in one plane, drawn in this order: areas, paths, circles, dots, words. Coordinates are the plane's.
struct Diagram {
  struct Area {
    std::vector<Point2> corners{};
    Colour colour{1, 1, 1};
    std::optional<double> value{};  ///< colours the area by the diagram's scale instead
  };
  struct Path {
    std::vector<Point2> points{};
    Stroke stroke{};
    bool closed = false;
  };
  struct Circle {
    Point2 centre{};
    double radius{};
    Stroke stroke{};
  };
  struct Dot {
    Point2 at{};
    Colour colour{0.1, 0.1, 0.1};
    double size = 1;  ///< of a vertex's dot
  };
  struct Words {
    Point2 at{};
    std::string words{};
    Vec2 shift{};  ///< in text heights, to the right and up: away from what it names
    Colour colour{0.1, 0.1, 0.1};
    double across = 0.5;    ///< where `at` is: 0 left end, 0.5 middle, 1 right end
    bool on_white = false;  ///< lines below do not show through
  };

  std::string title{};
  std::optional<Box> region{};  ///< what is shown at least; default: all but circles, with a little air
  bool axes = false;
  std::string scale_label{};  ///< beside the colour bar of the areas' values
  std::vector<Area> areas{};
  std::vector<Path> paths{};
  std::vector<Circle> circles{};
  std::vector<Dot> dots{};
  std::vector<Words> words{};

  void add_segment(Point2 a, Point2 b, const Stroke& stroke = {});
  /// An arrow from a to b: the segment and its head.
  void add_arrow(Point2 a, Point2 b, const Stroke& stroke = {});
  /// Every edge of a mesh once.
  void add_mesh(const TriangleMesh& mesh, const Stroke& stroke = {});
  /// A dot and its name beside it.
  void add_named_dot(Point2 at, const std::string& name, Vec2 shift = {0.7, 0.7},
                     Colour colour = {0.1, 0.1, 0.1});
};

/// One diagram. throws also InputError for one without any shape
void draw_diagram(const std::filesystem::path& path, const Diagram& diagram, const PictureSize& size = {});

/// Several diagrams in one picture, row by row, `columns` in a row.
void draw_diagrams(const std::filesystem::path& path, std::span<const Diagram> panels, int columns,
                   const std::string& title = {}, const PictureSize& size = {});

}  // namespace leonhard::draw
