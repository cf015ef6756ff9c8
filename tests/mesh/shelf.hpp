// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// A shelf of meshes picked by property, with what is known of each beforehand.
namespace leonhard::shelf {

using Corners = std::array<std::size_t, 3>;

/// The edges that one triangle only passes, in its direction, by a map: what the library finds by sorting.
inline std::vector<MarkedEdge> lone_edges(const std::vector<Corners>& triangles, Marker marker) {
  std::map<std::pair<std::size_t, std::size_t>, int> passes;
  for (const Corners& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++passes[{t[i], t[(i + 1) % 3]}];
  }
  std::vector<MarkedEdge> lone;
  for (const auto& [edge, count] : passes) {
    if (!passes.contains({edge.second, edge.first})) {
      lone.push_back({VertexId::from(edge.first), VertexId::from(edge.second), marker});
    }
  }
  return lone;
}

inline PerId<TriangleId, std::array<VertexId, 3>> typed(const std::vector<Corners>& triangles) {
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  for (const auto& [a, b, c] : triangles) {
    corners.push_back({VertexId::from(a), VertexId::from(b), VertexId::from(c)});
  }
  return corners;
}

inline TriangleMesh build(std::vector<Point2> points, const std::vector<Corners>& triangles) {
  return mesh::make_triangle_mesh(PerId<VertexId, Point2>(std::move(points)), typed(triangles),
                                  lone_edges(triangles, 1), {{1, "wall"}}, "shelf");
}

/// Those triangles of a list that are kept, with the vertices that they need.
inline TriangleMesh build_kept(const std::vector<Point2>& points, const std::vector<Corners>& triangles,
                               const std::vector<bool>& keep) {
  std::map<std::size_t, std::size_t> new_of_old;
  std::vector<Point2> kept_points;
  std::vector<Corners> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!keep[t]) continue;
    Corners corners = triangles[t];
    for (std::size_t& v : corners) {
      const auto [at, is_new] = new_of_old.emplace(v, kept_points.size());
      if (is_new) kept_points.push_back(points[v]);
      v = at->second;
    }
    kept.push_back(corners);
  }
  return build(kept_points, kept);
}

/// A grid of nx by ny unit squares, two triangles each: triangle 2 (j nx + i) and the next one are square (i, j).
struct Grid {
  std::vector<Point2> points;
  std::vector<Corners> triangles;

  Grid(std::size_t nx, std::size_t ny) {
    for (std::size_t j = 0; j <= ny; ++j) {
      for (std::size_t i = 0; i <= nx; ++i)
        points.push_back({static_cast<double>(i), static_cast<double>(j)});
    }
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = c - 1;
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    }
  }
};

inline TriangleMesh grid(std::size_t nx, std::size_t ny) {
  const Grid g(nx, ny);
  return build(g.points, g.triangles);
}

/// A grid of n by n squares without those named (i, j).
inline TriangleMesh grid_without(std::size_t n,
                                 const std::vector<std::pair<std::size_t, std::size_t>>& squares) {
  const Grid g(n, n);
  std::vector<bool> keep(g.triangles.size(), true);
  for (const auto& [i, j] : squares) keep[2 * (j * n + i)] = keep[2 * (j * n + i) + 1] = false;
  return build_kept(g.points, g.triangles, keep);
}

/// A grid whose points are moved at random by at most 0.2 in each direction, then scaled and shifted. Twice a
/// triangle's area is at least 0.6 * 0.6 - 0.4 * 0.4 > 0.
inline TriangleMesh shaken_grid(std::size_t n, unsigned seed, double scale = 1, Vec2 shift = {}) {
  Grid g(n, n);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-0.2, 0.2);
  for (Point2& p : g.points) {
    p = Point2{} + (scale * Vec2{p.x + move(random), p.y + move(random)} + shift);
  }
  return build(g.points, g.triangles);
}

inline void add_disc(std::vector<Point2>& points, std::vector<Corners>& triangles, Point2 centre,
                     double radius, std::size_t n) {
  const std::size_t first = points.size();
  points.push_back(centre);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    triangles.push_back({first, first + 1 + i, first + 1 + (i + 1) % n});
  }
}

inline void add_annulus(std::vector<Point2>& points, std::vector<Corners>& triangles, Point2 centre,
                        double inner, double outer, std::size_t n) {
  const std::size_t first = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const Vec2 ray{std::cos(angle), std::sin(angle)};
    points.push_back(centre + inner * ray);
    points.push_back(centre + outer * ray);
    const std::size_t a = first + 2 * i, c = first + 2 * ((i + 1) % n);
    triangles.push_back({a, a + 1, c + 1});
    triangles.push_back({a, c + 1, c});
  }
}

inline TriangleMesh disc(Point2 centre, double radius, std::size_t n) {
  std::vector<Point2> points;
  std::vector<Corners> triangles;
  add_disc(points, triangles, centre, radius, n);
  return build(points, triangles);
}

inline TriangleMesh annulus(std::size_t n) {
  std::vector<Point2> points;
  std::vector<Corners> triangles;
  add_annulus(points, triangles, {0.5, -0.25}, 1, 2, n);
  return build(points, triangles);
}

/// A disc, an annulus about it that it does not touch, and a disc beside both.
inline TriangleMesh nested_components() {
  std::vector<Point2> points;
  std::vector<Corners> triangles;
  add_disc(points, triangles, {0, 0}, 0.9, 7);
  add_annulus(points, triangles, {0, 0}, 1.5, 2.5, 12);
  add_disc(points, triangles, {4, 1}, 1, 5);
  return build(points, triangles);
}

struct Entry {
  std::string name;
  TriangleMesh mesh;
  std::size_t components, holes, pinches;  ///< pinched vertices counted as opened (see EulerAccount)
};

inline std::vector<Entry> all() {
  const std::vector<Point2> bowtie{{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const std::vector<Point2> ring{{0, 0}, {2, 0}, {1, 2}, {1, 0}, {1.5, 1}, {0.5, 1}};
  return {
      {"single triangle", build({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}), 1, 0, 0},
      {"fan about a boundary vertex",
       build({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}},
             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}),
       1, 0, 0},
      {"disc", disc({3, 3}, 2, 11), 1, 0, 0},
      {"structured grid", grid(7, 4), 1, 0, 0},
      {"shaken grid", shaken_grid(9, 1), 1, 0, 0},
      {"annulus", annulus(9), 1, 1, 0},
      {"nested components", nested_components(), 3, 1, 0},
      {"several holes", grid_without(9, {{1, 1}, {1, 5}, {2, 5}, {6, 2}, {6, 3}, {7, 3}}), 1, 3, 0},
      {"two parts that touch at a vertex", build(bowtie, {{0, 1, 2}, {0, 3, 4}}), 2, 0, 1},
      {"two holes that touch at a vertex", grid_without(5, {{1, 1}, {2, 2}}), 1, 1, 1},
      {"a hole that touches the outer boundary", grid_without(4, {{0, 0}, {1, 1}}), 1, 0, 1},
      {"ring of triangles that touch at vertices", build(ring, {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}), 3, 0, 3},
  };
}

}  // namespace leonhard::shelf
