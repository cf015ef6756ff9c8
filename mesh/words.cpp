// SPDX-License-Identifier: MIT
#include "leonhard/mesh/words.hpp"

#include <array>
#include <charconv>

namespace leonhard::mesh {

std::string words(double value) {
  std::array<char, 32> text{};  // the longest shortest form, -2.2250738585072014e-308, has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string words(Point2 p) { return "(" + words(p.x) + ", " + words(p.y) + ")"; }

std::string words(const TriangleMesh& mesh, VertexId v) {
  std::string text = "vertex " + std::to_string(v.raw);
  if (mesh.points.contains(v)) text += " at " + words(mesh.points[v]);
  return text;
}

std::string words(const TriangleMesh& mesh, VertexId from, VertexId to) {
  std::string text = "edge " + std::to_string(from.raw) + "-" + std::to_string(to.raw);
  if (mesh.points.contains(from) && mesh.points.contains(to)) {
    text += " from " + words(mesh.points[from]) + " to " + words(mesh.points[to]);
  }
  return text;
}

std::string words(const TriangleMesh& mesh, TriangleId t) {
  std::string ids, places;
  for (const VertexId v : mesh.corners[t]) {
    if (!ids.empty()) ids += ", ", places += ", ";
    ids += std::to_string(v.raw);
    places += mesh.points.contains(v) ? words(mesh.points[v]) : std::string("no such vertex");
  }
  return "triangle " + std::to_string(t.raw) + " (vertices " + ids + " at " + places + ")";
}

}  // namespace leonhard::mesh
