// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::test {

/// A 3 x 3 grid of squares, each cut into two triangles, with the middle square missing: one hole. Outer boundary
/// marker 7 "farfield", hole marker 3 "wall"; coordinates that need all digits.
inline TriangleMesh grid_with_hole() {
  PerId<VertexId, Point2> points;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      points.push_back({column / 3.0 + 0.01 * row, row / 7.0 - 1e-3});
  const auto at = [](std::size_t column, std::size_t row) { return VertexId::from(4 * row + column); };
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      if (row == 1 && column == 1) continue;
      corners.push_back({at(column, row), at(column + 1, row), at(column + 1, row + 1)});
      corners.push_back({at(column, row), at(column + 1, row + 1), at(column, row + 1)});
    }
  std::vector<MarkedEdge> boundary;
  for (std::size_t i = 0; i < 3; ++i) {
    boundary.push_back({at(i, 0), at(i + 1, 0), 7});
    boundary.push_back({at(3, i), at(3, i + 1), 7});
    boundary.push_back({at(i, 3), at(i + 1, 3), 7});
    boundary.push_back({at(0, i), at(0, i + 1), 7});
  }
  boundary.push_back({at(1, 1), at(2, 1), 3});
  boundary.push_back({at(2, 1), at(2, 2), 3});
  boundary.push_back({at(2, 2), at(1, 2), 3});
  boundary.push_back({at(1, 2), at(1, 1), 3});
  return mesh::make_triangle_mesh(std::move(points), std::move(corners), std::move(boundary),
                                  {{3, "wall"}, {7, "farfield"}}, "grid_with_hole");
}

/// The same with everything a TriangleMesh can carry: constraints, regions, vertex markers, a name of no edge.
inline TriangleMesh grid_with_everything() {
  TriangleMesh mesh = grid_with_hole();
  mesh.constraints = {{VertexId{0}, VertexId{5}, 11}, {VertexId{10}, VertexId{15}, 0}};
  mesh.marker_names[11] = "cut & <paste>";
  for (const TriangleId t : mesh.corners.ids()) mesh.regions[t] = 0.1 * static_cast<double>(t.index() % 3);
  for (const VertexId v : mesh.points.ids()) mesh.vertex_markers[v] = static_cast<Marker>(v.index()) - 4;
  REQUIRE_FALSE(mesh::validate(mesh));
  return mesh;
}

inline std::vector<MarkedEdge> sorted(std::vector<MarkedEdge> edges) {
  std::sort(edges.begin(), edges.end(), [](const MarkedEdge& a, const MarkedEdge& b) {
    return std::tie(a.from, a.to, a.marker) < std::tie(b.from, b.to, b.marker);
  });
  return edges;
}

/// Points to the last bit, triangles, neighbours, boundary with markers, and names.
inline void check_same_geometry_and_boundary(const TriangleMesh& a, const TriangleMesh& b) {
  CHECK(a.points == b.points);
  CHECK(a.corners == b.corners);
  CHECK(a.neighbours == b.neighbours);
  CHECK(sorted(a.boundary) == sorted(b.boundary));
  CHECK(a.marker_names == b.marker_names);
  CHECK(mesh::fingerprint(a) == mesh::fingerprint(b));
  CHECK_FALSE(mesh::validate(b));
}

inline void check_same_mesh(const TriangleMesh& a, const TriangleMesh& b) {
  check_same_geometry_and_boundary(a, b);
  CHECK(a.constraints == b.constraints);
  CHECK(a.regions == b.regions);
  CHECK(a.vertex_markers == b.vertex_markers);
}

/// The message of the InputError that a call throws, or "accepted".
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// A bad text and what its refusal must say.
struct BadInput {
  const char* name;
  std::string text;
  std::vector<std::string> message_has;
};

template <class Parse>
void check_refused(const std::vector<BadInput>& table, const Parse& parse) {
  for (const BadInput& bad : table) {
    const std::string message = refusal([&] { parse(bad.text); });
    for (const std::string& part : bad.message_has)
      CHECK_MESSAGE(message.find(part) != std::string::npos, bad.name, ": expected \"", part,
                    "\" in: ", message);
  }
}

/// A text with the first occurrence of one part replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), by);
}

}  // namespace leonhard::test
