// SPDX-License-Identifier: MIT
#include "leonhard/mesh/words.hpp"

#include <charconv>

namespace leonhard::mesh {
namespace {

template <class Mesh>
std::string vertex_words(const Mesh& mesh, VertexId v) {
  std::string text = "vertex " + std::to_string(v.raw);
  if (mesh.points.contains(v)) text += " at " + words(mesh.points[v]);
  return text;
}

template <class Mesh>
std::string edge_words(const Mesh& mesh, VertexId from, VertexId to) {
  std::string text = "edge " + std::to_string(from.raw) + "-" + std::to_string(to.raw);
  if (mesh.points.contains(from) && mesh.points.contains(to)) {
    text += " from " + words(mesh.points[from]) + " to " + words(mesh.points[to]);
  }
  return text;
}

/// "(0, 0), (1, 0)".
template <class Mesh, class Corners>
std::string place_words(const Mesh& mesh, const Corners& corners) {
  std::string places;
  for (const VertexId v : corners) {
    if (!places.empty()) places += ", ";
    places += mesh.points.contains(v) ? words(mesh.points[v]) : std::string("no such vertex");
  }
  return places;
}

template <class Corners>
std::string id_words(const Corners& corners, const char* between) {
  std::string ids;
  for (const VertexId v : corners) {
    if (!ids.empty()) ids += between;
    ids += std::to_string(v.raw);
  }
  return ids;
}

template <class Mesh, class CellId>
std::string cell_words(const Mesh& mesh, const char* cell, CellId t) {
  const auto& corners = mesh.corners[t];
  return cell + std::string(" ") + std::to_string(t.raw) + " (vertices " + id_words(corners, ", ") + " at " +
         place_words(mesh, corners) + ")";
}

}  // namespace

std::string words(double value) {
  std::array<char, 32> text{};  // the longest shortest form, -2.2250738585072014e-308, has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string words(Point2 p) { return "(" + words(p.x) + ", " + words(p.y) + ")"; }
std::string words(const Point3& p) { return "(" + words(p.x) + ", " + words(p.y) + ", " + words(p.z) + ")"; }

std::string words(const TriangleMesh& mesh, VertexId v) { return vertex_words(mesh, v); }
std::string words(const TetMesh& mesh, VertexId v) { return vertex_words(mesh, v); }

std::string words(const TriangleMesh& mesh, VertexId from, VertexId to) { return edge_words(mesh, from, to); }
std::string words(const TetMesh& mesh, VertexId from, VertexId to) { return edge_words(mesh, from, to); }

std::string words(const TetMesh& mesh, const std::array<VertexId, 3>& face) {
  return "face " + id_words(face, "-") + " at " + place_words(mesh, face);
}

std::string words(const TriangleMesh& mesh, TriangleId t) { return cell_words(mesh, "triangle", t); }
std::string words(const TetMesh& mesh, TetId t) { return cell_words(mesh, "tetrahedron", t); }

}  // namespace leonhard::mesh
