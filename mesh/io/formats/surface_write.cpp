// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/surface_write.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/number_text.hpp"

namespace leonhard::io {
namespace {

/// Lines of words and numbers parted by blanks.
class SurfaceText {
 public:
  template <class Number>
  SurfaceText& operator<<(Number value) {
    part();
    append_number(text_, value);
    return *this;
  }
  SurfaceText& operator<<(const char* word) {
    part();
    text_ += word;
    return *this;
  }
  SurfaceText& operator<<(const Point3& p) { return *this << p.x << p.y << p.z; }
  void end_line() {
    text_ += '\n';
    begins_ = true;
  }
  [[nodiscard]] std::string finish() && { return std::move(text_); }

 private:
  void part() {
    if (!begins_) text_ += ' ';
    begins_ = false;
  }
  std::string text_;
  bool begins_ = true;
};

Marker marker_of(const SurfaceFile& surface, std::size_t polygon) {
  return surface.markers.empty() ? 0 : surface.markers[polygon];
}

void append_points(SurfaceText& text, const SurfaceFile& surface) {
  for (const Point3& p : surface.set.points) {
    text << p;
    text.end_line();
  }
}

/// The numbers of the polygons of three corners, and of four.
std::array<std::vector<std::size_t>, 2> triangles_and_quadrilaterals(const SurfaceFile& surface) {
  std::array<std::vector<std::size_t>, 2> lists;
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const std::size_t corners = surface.polygon(i).size();
    if (corners != 3 && corners != 4)
      throw InputError("polygon " + std::to_string(i), "it has " + std::to_string(corners) + " corners",
                       "this format has triangles and quadrilaterals; write .off, .obj, .ply or .stl");
    lists[corners - 3].push_back(i);
  }
  return lists;
}

void append_polygons(SurfaceText& text, const SurfaceFile& surface) {
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    text << surface.polygon(i).size();
    for (const VertexId v : surface.polygon(i)) text << v.index();
    text.end_line();
  }
}

}  // namespace

std::string format_off(const SurfaceFile& surface) {
  SurfaceText text;
  text << "OFF";
  text.end_line();
  text << surface.set.points.size() << surface.polygon_count() << 0;
  text.end_line();
  append_points(text, surface);
  append_polygons(text, surface);
  return std::move(text).finish();
}

std::string format_obj(const SurfaceFile& surface) {
  SurfaceText text;
  for (const Point3& p : surface.set.points) {
    text << "v" << p;
    text.end_line();
  }
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    text << "f";
    for (const VertexId v : surface.polygon(i)) text << v.index() + 1;
    text.end_line();
  }
  return std::move(text).finish();
}

std::string format_ply(const SurfaceFile& surface) {
  SurfaceText text;
  const auto line = [&](const std::string& words) {
    text << words.c_str();
    text.end_line();
  };
  line("ply");
  line("format ascii 1.0");
  line("element vertex " + std::to_string(surface.set.points.size()));
  for (const char* axis : {"x", "y", "z"}) line(std::string("property double ") + axis);
  line("element face " + std::to_string(surface.polygon_count()));
  line("property list int int vertex_indices");
  line("end_header");
  append_points(text, surface);
  append_polygons(text, surface);
  return std::move(text).finish();
}

std::string format_stl(const SurfaceFile& surface) {
  SurfaceText text;
  const auto word = [&](const char* words) {
    text << words;
    text.end_line();
  };
  word("solid surface");
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const auto polygon = surface.polygon(i);
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const std::array<Point3, 3> corners{surface.set.points[polygon[0].index()],
                                          surface.set.points[polygon[k].index()],
                                          surface.set.points[polygon[k + 1].index()]};
      const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
      const double length = norm(normal);
      const bool has_normal = length > 0 && std::isfinite(length);
      text << "facet normal";
      text << (has_normal ? normal.x / length : 0.0) << (has_normal ? normal.y / length : 0.0)
           << (has_normal ? normal.z / length : 0.0);
      text.end_line();
      word("outer loop");
      for (const Point3& corner : corners) {
        text << "vertex" << corner;
        text.end_line();
      }
      word("endloop");
      word("endfacet");
    }
  }
  word("endsolid surface");
  return std::move(text).finish();
}

std::string format_medit_surface(const SurfaceFile& surface) {
  const auto lists = triangles_and_quadrilaterals(surface);
  SurfaceText text;
  const auto word = [&](const char* words) {
    text << words;
    text.end_line();
  };
  word("MeshVersionFormatted 2");
  word("Dimension 3");
  word("Vertices");
  text << surface.set.points.size();
  text.end_line();
  for (std::size_t v = 0; v < surface.set.points.size(); ++v) {
    text << surface.set.points[v] << (surface.set.markers.empty() ? 0 : surface.set.markers[v]);
    text.end_line();
  }
  for (std::size_t kind = 0; kind < 2; ++kind) {
    if (lists[kind].empty()) continue;
    word(kind == 0 ? "Triangles" : "Quadrilaterals");
    text << lists[kind].size();
    text.end_line();
    for (const std::size_t i : lists[kind]) {
      for (const VertexId v : surface.polygon(i)) text << v.index() + 1;
      text << marker_of(surface, i);
      text.end_line();
    }
  }
  word("End");
  return std::move(text).finish();
}

}  // namespace leonhard::io
