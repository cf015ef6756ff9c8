// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mesh_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/box_tree.hpp"
#include "leonhard/mesh/structures/barycentric.hpp"
#include "leonhard/mesh/structures/boundary_cells.hpp"
#include "leonhard/mesh/structures/nearest_on_facet.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Cells, vertices or facets in a leaf of a tree.
constexpr std::size_t leaf_size = 4;

std::array<VertexId, 2> vertices_of(const MarkedEdge& edge) { return {edge.from, edge.to}; }
std::array<VertexId, 3> vertices_of(const MarkedFace& face) { return face.corners; }

/// The sign of each barycentric coordinate of a point among a cell's corners.
std::array<Sign, 3> signs_in(const std::array<Point2, 3>& c, const Point2& p) {
  return {kernel::orient2d(c[1], c[2], p), kernel::orient2d(c[2], c[0], p), kernel::orient2d(c[0], c[1], p)};
}
std::array<Sign, 4> signs_in(const std::array<Point3, 4>& c, const Point3& p) {
  std::array<Sign, 4> signs;
  for (unsigned i = 0; i < 4; ++i) {
    const auto& [j, k, l] = tet_face_corners[i];
    signs[i] = kernel::orient3d(c[j], c[l], c[k], p);
    if (signs[i] == Sign::negative) break;  // outside: the others do not matter
  }
  return signs;
}

template <class Point, std::size_t N>
std::array<Point, N> points_of(const PerId<VertexId, Point>& points,
                               const std::array<VertexId, N>& vertices) {
  std::array<Point, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = points[vertices[i]];
  return result;
}

Place place_spanned_by(std::size_t vertices, std::size_t corners) {
  return vertices == corners ? Place::in_cell
         : vertices == 1     ? Place::on_vertex
         : vertices == 2     ? Place::on_edge
                             : Place::on_face;
}

template <class Point>
void need_finite(const Point& p) {
  if (!is_finite(p)) throw InputError("point", words(p) + " is not finite", "ask for points that are");
}

void need_sizes(const char* what, std::size_t got, std::size_t wanted) {
  if (got != wanted)
    throw InputError(what, "there is room for " + std::to_string(got) + " of " + std::to_string(wanted),
                     "give a span of that size");
}

void need_values(std::size_t got, std::size_t components, std::size_t vertices) {
  if (components == 0 || got != components * vertices)
    throw InputError("values",
                     std::to_string(got) + " numbers for " + std::to_string(vertices) + " vertices and " +
                         std::to_string(components) + " components",
                     "give that many numbers a vertex, at least one");
}

/// One component of values that lie vertex after vertex.
struct Component {
  std::span<const double> values;
  std::size_t components, component;
  [[nodiscard]] double operator[](VertexId v) const { return values[v.index() * components + component]; }
};

template <std::size_t N>
void put_values(const VertexWeights<N>& at, std::span<const double> values, std::span<double> result) {
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = at.of(Component{values, result.size(), i});
}

/// The weights of a facet's corners without those that are 0, by ascending vertices.
template <std::size_t N>
VertexWeights<N + 1> weights_among(const std::array<VertexId, N>& vertices,
                                   const std::array<double, N>& weights) {
  VertexWeights<N + 1> result;
  std::array<std::size_t, N> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return vertices[i] < vertices[j]; });
  for (const std::size_t i : order) {
    if (weights[i] == 0) continue;
    result.vertices[result.count] = vertices[i];
    result.weights[result.count++] = weights[i];
  }
  return result;
}

/// A power of two that brings coordinates of at most this size to about 1, so that squares stay in range.
double scale_for(double largest) {
  return largest > 0 ? std::exp2(std::clamp(-std::ilogb(largest), -1023, 1000)) : 1;
}

template <class Point>
double largest_coordinate(const Point& p) {
  double largest = 0;
  for (const auto x : axes_of<Point>) largest = std::max(largest, std::abs(p.*x));
  return largest;
}

}  // namespace

template <class Mesh>
struct MeshLocator<Mesh>::Index {
  using Facet = decltype(vertices_of(std::declval<const Mesh&>().boundary.front()));

  explicit Index(const Mesh& of)
      : mesh(of),
        side_of_facet(boundary_cells(of)),
        cells(checked_cells()),
        vertices(kernel::hilbert_order(of.points.flat())),
        facets(kernel::hilbert_order(facet_centres())),
        cell_tree(boxes(cells.size(), [&](std::size_t i) { return corner_points(cells[i]); })),
        vertex_tree(
            boxes(vertices.size(), [&](std::size_t i) { return std::array{of.points.flat()[vertices[i]]}; })),
        facet_tree(boxes(facets.size(), [&](std::size_t i) { return facet_points(facets[i]); })),
        largest(std::max(largest_coordinate(cell_tree.box().low), largest_coordinate(cell_tree.box().high))) {
  }

  [[nodiscard]] auto corner_points(CellId c) const { return points_of(mesh.points, mesh.corners[c]); }
  [[nodiscard]] auto facet_points(std::size_t f) const {
    return points_of(mesh.points, vertices_of(mesh.boundary[f]));
  }

  /// Calls visit(i) for the cells, vertices or facets of a leaf, by their places in the order along the curve.
  template <class Visit>
  static void for_each_in_leaf(std::size_t leaf, std::size_t count, const Visit& visit) {
    for (std::size_t i = leaf * leaf_size; i < std::min(count, (leaf + 1) * leaf_size); ++i) visit(i);
  }

  const Mesh& mesh;
  std::vector<CellSide<CellId>> side_of_facet;  // to each entry of mesh.boundary
  std::vector<CellId> cells;                    // along a Hilbert curve
  std::vector<std::uint32_t> vertices;          // likewise
  std::vector<std::uint32_t> facets;            // entries of mesh.boundary, likewise
  BoxTree<Point> cell_tree, vertex_tree, facet_tree;
  double largest;  // of the coordinates' sizes

 private:
  template <std::size_t N>
  static Point centre_of(const std::array<Point, N>& points) {
    Point centre{};
    for (const auto x : axes_of<Point>) {
      for (const Point& p : points) centre.*x += p.*x / static_cast<double>(N);
    }
    return centre;
  }

  /// The cells along the curve. throws as the locator's constructor
  [[nodiscard]] std::vector<CellId> checked_cells() const {
    std::vector<Point> centres;
    centres.reserve(mesh.corners.size());
    for (const CellId c : mesh.corners.ids()) {
      for (const VertexId v : mesh.corners[c]) {
        if (!mesh.points.contains(v))
          throw InputError("cell " + std::to_string(c.raw),
                           "its corner " + std::to_string(v.raw) + " is no vertex, the mesh has " +
                               std::to_string(mesh.points.size()),
                           "give a mesh that passes validate");
        if (!is_finite(mesh.points[v]))
          throw InputError("", words(mesh, v) + " is not finite", "give a mesh that passes validate");
      }
      centres.push_back(centre_of(corner_points(c)));
    }
    std::vector<CellId> order;
    order.reserve(centres.size());
    for (const std::uint32_t c : kernel::hilbert_order(centres)) order.push_back(CellId{c});
    return order;
  }

  [[nodiscard]] std::vector<Point> facet_centres() const {
    std::vector<Point> centres;
    centres.reserve(mesh.boundary.size());
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f) centres.push_back(centre_of(facet_points(f)));
    return centres;
  }

  template <class PointsOf>
  static std::vector<Box<Point>> boxes(std::size_t count, const PointsOf& points_of_entry) {
    std::vector<Box<Point>> result((count + leaf_size - 1) / leaf_size);
    for (std::size_t i = 0; i < count; ++i) {
      for (const Point& p : points_of_entry(i)) result[i / leaf_size].include(p);
    }
    return result;
  }
};

template <class Mesh>
MeshLocator<Mesh>::MeshLocator(const Mesh& mesh) : index_(std::make_shared<const Index>(mesh)) {}

template <class Mesh>
auto MeshLocator<Mesh>::locate(const Point& p) const -> Location {
  need_finite(p);
  MaybeId<CellId> cell;
  std::array<Sign, corners_each> signs;
  index_->cell_tree.for_each_meeting({p, p}, [&](std::size_t leaf) {
    index_->for_each_in_leaf(leaf, index_->cells.size(), [&](std::size_t i) {
      const CellId c = index_->cells[i];
      if (cell && *cell < c) return;
      const auto signs_here = signs_in(index_->corner_points(c), p);
      if (std::find(signs_here.begin(), signs_here.end(), Sign::negative) != signs_here.end()) return;
      cell = c;
      signs = signs_here;
    });
  });
  Location location;
  if (!cell) return location;
  location.cell = cell;
  std::array<VertexId, corners_each> vertices;
  std::size_t count = 0;
  for (std::size_t i = 0; i < corners_each; ++i) {
    if (signs[i] == Sign::positive) vertices[count++] = index_->mesh.corners[*cell][i];
  }
  std::sort(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count));
  std::copy_n(vertices.begin(), count, location.vertices.begin());
  location.place = place_spanned_by(count, corners_each);
  return location;
}

template <class Mesh>
MaybeId<VertexId> MeshLocator<Mesh>::nearest_vertex(const Point& p) const {
  need_finite(p);
  const auto& points = index_->mesh.points;
  const ScaledDistance<Point> distance2(p, scale_for(std::max(index_->largest, largest_coordinate(p))));
  MaybeId<VertexId> nearest;
  double least = infinity;
  // Rounded squares of distances are off by less than 2^-50 of themselves and 2^-1070.
  const auto is_farther = [&](double d2) { return d2 > least * (1 + 0x1p-48) + 0x1p-1060; };
  index_->vertex_tree.for_each_near(distance2, is_farther, [&](std::size_t leaf) {
    index_->for_each_in_leaf(leaf, index_->vertices.size(), [&](std::size_t i) {
      const VertexId v{index_->vertices[i]};
      const double d2 = distance2(points[v]);
      if (is_farther(d2)) return;
      if (nearest) {
        const Sign beyond = kernel::compare_distance(p, points[v], points[*nearest]);
        if (beyond == Sign::positive || (beyond == Sign::zero && *nearest < v)) return;
      }
      nearest = v;
      least = d2;
    });
  });
  return nearest;
}

template <class Mesh>
auto MeshLocator<Mesh>::nearest_point(const Point& p) const -> Nearest {
  const std::size_t no_entry = index_->mesh.boundary.size();
  if (const Location location = locate(p); location.inside())
    return {p, 0, location, barycentric_weights(index_->mesh.points, location.vertices, p), no_entry};

  const double scale = scale_for(std::max(index_->largest, largest_coordinate(p)));
  const ScaledDistance<Point> distance2(p, scale);
  OnFacet<Point> best;
  std::size_t entry = no_entry;
  index_->facet_tree.for_each_near(
      distance2, [&](double d2) { return d2 > best.distance2; },
      [&](std::size_t leaf) {
        index_->for_each_in_leaf(leaf, index_->facets.size(), [&](std::size_t i) {
          const std::size_t f = index_->facets[i];
          const OnFacet<Point> here = nearest_on_facet(distance2, index_->facet_points(f));
          if (here.distance2 > best.distance2 || (here.distance2 == best.distance2 && entry < f)) return;
          best = here;
          entry = f;
        });
      });
  Nearest nearest{p, infinity, {}, {}, entry};
  if (entry == no_entry) return nearest;

  const auto vertices = vertices_of(index_->mesh.boundary[entry]);
  nearest.distance = std::sqrt(best.distance2) / scale;
  nearest.location.cell = index_->side_of_facet[entry].cell;
  nearest.weights = weights_among(vertices, best.weights);
  std::copy_n(nearest.weights.vertices.begin(), nearest.weights.count, nearest.location.vertices.begin());
  nearest.location.place = place_spanned_by(nearest.weights.count, corners_each);
  for (const auto x : axes_of<Point>) nearest.point.*x = best.point.*x / scale;
  if (nearest.weights.count == 1) nearest.point = index_->mesh.points[nearest.weights.vertices[0]];
  return nearest;
}

template <class Mesh>
auto MeshLocator<Mesh>::weights_at(const Point& p) const -> Weights {
  return barycentric_weights(index_->mesh.points, locate(p).vertices, p);
}

template <class Mesh>
auto MeshLocator<Mesh>::interpolate(const Point& p, std::span<const double> values,
                                    std::span<double> result) const -> Location {
  need_values(values.size(), result.size(), index_->mesh.points.size());
  const Location location = locate(p);
  if (location.inside())
    put_values(barycentric_weights(index_->mesh.points, location.vertices, p), values, result);
  return location;
}

template <class Mesh>
void MeshLocator<Mesh>::locate(std::span<const Point> points, std::span<Location> locations) const {
  need_sizes("locations", locations.size(), points.size());
  for (const std::uint32_t i : kernel::hilbert_order(points)) locations[i] = locate(points[i]);
}

template <class Mesh>
void MeshLocator<Mesh>::nearest_vertices(std::span<const Point> points,
                                         std::span<MaybeId<VertexId>> vertices) const {
  need_sizes("vertices", vertices.size(), points.size());
  for (const std::uint32_t i : kernel::hilbert_order(points)) vertices[i] = nearest_vertex(points[i]);
}

template <class Mesh>
std::size_t MeshLocator<Mesh>::interpolate(std::span<const Point> points, std::span<const double> values,
                                           std::size_t components, std::span<double> results) const {
  need_values(values.size(), components, index_->mesh.points.size());
  need_sizes("results", results.size(), components * points.size());
  std::size_t outside = 0;
  for (const std::uint32_t i : kernel::hilbert_order(points)) {
    const std::span<double> result = results.subspan(i * components, components);
    if (interpolate(points[i], values, result).inside()) continue;
    std::fill(result.begin(), result.end(), std::numeric_limits<double>::quiet_NaN());
    ++outside;
  }
  return outside;
}

template class MeshLocator<TriangleMesh>;
template class MeshLocator<TetMesh>;

}  // namespace leonhard::mesh
