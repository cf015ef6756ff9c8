// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/voronoi_pieces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "leonhard/delaunay/plane/window_clip.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// The polygon's triangles; their vertices are its corners, so that there are two fewer than these.
TriangleMesh triangles_of(std::span<const Point2> polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) throw InputError("polygon", "a polygon has three corners or more", "give its corners in order");
  Pslg pslg;
  pslg.source = "polygon";
  pslg.points.assign(polygon.begin(), polygon.end());
  for (std::size_t i = 0; i < n; ++i) pslg.segments.push_back({i, (i + 1) % n, 1});
  Triangulation result = triangulate(std::move(pslg));
  const TriangleMesh& mesh = result.mesh;
  const bool is_simple = result.outcome == TriangulateOutcome::done && mesh.vertex_count() == n &&
                         mesh.boundary.size() == n && mesh.triangle_count() == n - 2;
  if (!is_simple)
    throw InputError("polygon", "it touches itself, or all of its corners lie on one line",
                     "give the corners of a simple polygon, each once" +
                         (result.repairs.empty() ? std::string() : ": " + result.repairs.front()));
  return std::move(result.mesh);
}

/// The part of a cell in one triangle.
struct CellPart {
  VertexId site;
  std::vector<Point2> corners;
  double area;
};

std::vector<CellPart> parts_of(const VoronoiDiagram& diagram, const TriangleMesh& triangles) {
  std::vector<CellPart> parts;
  WindowCrossings crossings;
  std::map<std::pair<VertexId, VertexId>, std::size_t> names;
  for (const auto& corners : triangles.corners) {
    std::array<Point2, 3> window;
    std::array<std::size_t, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      window[i] = triangles.points[corners[i]];
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      sides[i] = names.emplace(std::pair(low, high), names.size()).first->second;
    }
    const ClippedVoronoi cells = clip_to_window(diagram, window, sides, crossings);
    for (const VertexId site : diagram.sites.ids())
      if (const auto cell = cells.cell(site); !cell.empty())
        parts.push_back({site, {cell.begin(), cell.end()}, cells.area[site]});
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const CellPart& a, const CellPart& b) { return a.site < b.site; });
  return parts;
}

/// The edges of the parts of one site but for those that two of them share.
class PartJoiner {
 public:
  explicit PartJoiner(std::span<const CellPart> parts) : parts_(parts), groups_(parts.size()) {
    for (std::size_t i = 0; i < parts.size(); ++i) add_edges_of(i);
  }

  void add_pieces(VoronoiPieces& pieces) {
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < parts_.size(); ++i) members[groups_.find(i)].push_back(i);
    for (const auto& [group, list] : members) {
      std::optional<std::vector<Point2>> loop;
      if (list.size() > 1) loop = loop_of(group);
      if (loop) {
        double area = 0;
        for (const std::size_t i : list) area += parts_[i].area;
        pieces.add(parts_[list[0]].site, *loop, area);
      } else {
        for (const std::size_t i : list) pieces.add(parts_[i].site, parts_[i].corners, parts_[i].area);
      }
    }
  }

 private:
  using Edge = std::pair<Point2, Point2>;

  void add_edges_of(std::size_t part) {
    const std::vector<Point2>& corners = parts_[part].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point2 from = corners[k], to = corners[(k + 1) % corners.size()];
      if (const auto other = edges_.find(Edge(to, from)); other != edges_.end()) {
        groups_.join(part, other->second);
        edges_.erase(other);
      } else {
        edges_.emplace(Edge(from, to), part);
      }
    }
  }

  /// The edges that a group is left with, one after another; none if they are more than one loop or meet at a point.
  [[nodiscard]] std::optional<std::vector<Point2>> loop_of(std::size_t group) {
    std::map<Point2, Point2> next;
    for (const auto& [edge, part] : edges_)
      if (groups_.find(part) == group && !next.emplace(edge.first, edge.second).second) return std::nullopt;
    if (next.empty()) return std::nullopt;
    std::vector<Point2> loop;
    Point2 at = next.begin()->first;
    do {
      const auto step = next.find(at);
      if (step == next.end() || loop.size() == next.size()) return std::nullopt;
      loop.push_back(at);
      at = step->second;
    } while (at != loop.front());
    if (loop.size() != next.size() || loop.size() < 3) return std::nullopt;
    return loop;
  }

  std::span<const CellPart> parts_;
  mesh::DisjointSets groups_;
  std::map<Edge, std::size_t> edges_;  ///< and the part of each
};

}  // namespace

void VoronoiPieces::add(VertexId of_site, std::span<const Point2> polygon, double its_area) {
  site.push_back(of_site);
  corners.insert(corners.end(), polygon.begin(), polygon.end());
  first_corner.push_back(corners.size());
  area.push_back(its_area);
}

VoronoiPieces pieces_of(const ClippedVoronoi& cells) {
  VoronoiPieces pieces;
  for (const VertexId site : cells.area.ids())
    if (!cells.cell(site).empty()) pieces.add(site, cells.cell(site), cells.area[site]);
  return pieces;
}

VoronoiPieces clip_to_polygon(const VoronoiDiagram& diagram, std::span<const Point2> polygon) {
  const std::vector<CellPart> parts = parts_of(diagram, triangles_of(polygon));
  VoronoiPieces pieces;
  for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
    while (end < parts.size() && parts[end].site == parts[begin].site) ++end;
    PartJoiner(std::span(parts).subspan(begin, end - begin)).add_pieces(pieces);
  }
  return pieces;
}

}  // namespace leonhard::delaunay
