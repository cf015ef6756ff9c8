// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/lawson.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "leonhard/delaunay/order/insert_in_order.hpp"
#include "leonhard/delaunay/plane/edge_swapper.hpp"
#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/delaunay/topology/from_quad_edge.hpp"
#include "leonhard/delaunay/topology/interior_edges.hpp"
#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/data_structures.hpp"
#include "leonhard/mesh/ids_in_range.hpp"

namespace leonhard::delaunay {
namespace {

// ---- swapping what is there ----

template <class Criterion>
SwapReport settle(EdgeSwapper<Criterion>& swapper, const SwapOptions& options) {
  constexpr std::size_t poll = 4096;
  for (std::size_t steps = 0; swapper.suspect_count() > 0; ++steps) {
    if (steps % poll == 0) {
      options.progress("swap",
                       static_cast<double>(steps) / static_cast<double>(steps + swapper.suspect_count()));
      if (options.progress.stop_requested()) return {SwapOutcome::stopped, swapper.swaps()};
    }
    if (swapper.swaps() >= options.max_swaps) return {SwapOutcome::swap_limit, swapper.swaps()};
    swapper.step();
  }
  return {SwapOutcome::settled, swapper.swaps()};
}

void require_values(const SwapCriterion& criterion, std::size_t points) {
  const auto require = [&](std::span<const double> values) {
    if (values.size() == points) return;
    throw InputError(
        "criterion",
        "it has " + std::to_string(values.size()) + " values for " + std::to_string(points) + " points",
        "give one a point");
  };
  if (const auto* rough = std::get_if<criterion::MinRoughness>(&criterion)) require(rough->values);
  if (const auto* bent = std::get_if<criterion::AngleBetweenNormals>(&criterion)) require(bent->values);
}

/// Corners and neighbours of a mesh from the real triangles, whose numbers are the mesh's.
void copy_triangles(const GhostTriangulation& in, TriangleMesh& mesh) {
  for (const TriangleId t : mesh.corners.ids()) {
    const AnyTriangleId real{t.raw};
    for (unsigned i = 0; i < 3; ++i) {
      const AnyTriangleId beyond = in.triangle(in.twin(in.side(real, i)));
      mesh.corners[t][i] = in.corner(real, i);
      mesh.neighbours[t][i] =
          in.is_ghost(beyond) ? MaybeId<TriangleId>() : MaybeId<TriangleId>(TriangleId{beyond.raw});
    }
  }
}

// ---- sweeping ----

/// Joins points, from left to right, to what they see of the hull.
class Sweep {
 public:
  Sweep(GhostTriangulation& in, std::span<const Point2> points) : in_(in), points_(points) {}

  /// Insert a point outside the hull. Usually it sees an edge at the point before.
  void insert(VertexId v) {
    while (!sees(v, hull_)) hull_ = in_.triangle(in_.twin(in_.side(hull_, 1)));
    cavity_.start(in_, hull_);
    cavity_.grow(in_, [&](SideId inner) {
      const AnyTriangleId beyond = in_.triangle(in_.twin(inner));
      return in_.is_ghost(beyond) && sees(v, beyond);
    });
    cavity_.fill(in_, v);
    hull_ = ghost_into(v);
  }
  /// The triangles just made.
  [[nodiscard]] const std::vector<AnyTriangleId>& triangles() const { return cavity_.triangles(); }

 private:
  [[nodiscard]] bool sees(VertexId v, AnyTriangleId ghost) const {
    return kernel::orient2d(points_[in_.corner(ghost, 1).index()], points_[in_.corner(ghost, 2).index()],
                            points_[v.index()]) == Sign::positive;
  }
  /// Of the two hull edges at v the one from which the walk along ghosts comes to the other.
  [[nodiscard]] AnyTriangleId ghost_into(VertexId v) const {
    for (const AnyTriangleId t : cavity_.triangles())
      if (in_.is_ghost(t) && in_.corner(t, 2) == v) return t;
    return cavity_.triangles().front();
  }
  GhostTriangulation& in_;
  std::span<const Point2> points_;
  Cavity cavity_;
  AnyTriangleId hull_{1};  // the ghost to look from
};

/// Sweep over the points; after_each(triangles) follows every insertion.
///
/// in  the triangulation to fill, empty; it is moved into the result
template <class AfterEach>
PointTriangulation sweep(std::span<const Point2> points, const Progress& progress, GhostTriangulation& in,
                         const AfterEach& after_each) {
  using Outcome = TriangulateOutcome;
  if (points.size() < 3) return {Outcome::too_few_points, {}};
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; });
  // Points on a line at the beginning wait for the first that is off it, and then see one edge each.
  if (!bring_triangle_to_front(points, order)) return {Outcome::all_collinear, {}};
  in.reserve(2 * points.size() + 4);
  in.start(VertexId{order[0]}, VertexId{order[1]}, VertexId{order[2]});
  Sweep front(in, points);
  for (std::size_t k = 3; k < order.size(); ++k) {
    if (!go_on(progress, k, order.size())) return {Outcome::stopped, {}};
    front.insert(VertexId{order[k]});
    after_each(front.triangles());
  }
  return {Outcome::done, std::move(in)};
}

// ---- inserting ----

/// Joins points to the corners about them, for insert_in_order, and swaps.
template <class Criterion>
class CriterionInserter {
 public:
  CriterionInserter(std::span<const Point2> points, Criterion criterion)
      : points_(points), criterion_(criterion) {}

  void start(GhostTriangulation& in) { swapper_.emplace(in, points_, criterion_); }

  std::size_t insert(GhostTriangulation& in, VertexId v) {
    join(in, v, locate(in, points_, last_, points_[v.index()], coin_));
    const std::size_t swaps_before = swapper_->swaps();
    for (const AnyTriangleId t : cavity_.triangles()) {
      for (unsigned i = 0; i < 3; ++i) swapper_->suspect_around(in.side(t, i));
      if (!in.is_ghost(t)) last_ = t;
    }
    const std::size_t made = cavity_.triangles().size();
    swapper_->run();
    return made + 2 * (swapper_->swaps() - swaps_before);
  }

 private:
  void join(GhostTriangulation& in, VertexId v, const Location& at) {
    if (at.kind == Location::Kind::on_side)
      cavity_.start(in, at.side);
    else
      cavity_.start(in, in.triangle(at.side));
    cavity_.grow(in, [&](SideId inner) {
      const AnyTriangleId beyond = in.triangle(in.twin(inner));
      return at.kind == Location::Kind::outside && in.is_ghost(beyond) &&
             kernel::orient2d(points_[in.corner(beyond, 1).index()], points_[in.corner(beyond, 2).index()],
                              points_[v.index()]) == Sign::positive;
    });
    cavity_.fill(in, v);
  }
  std::span<const Point2> points_;
  Criterion criterion_;
  std::optional<EdgeSwapper<Criterion>> swapper_;
  Cavity cavity_;
  AnyTriangleId last_{0};  // where the next walk starts: real
  Coin coin_;
};

}  // namespace

SwapReport swap_edges(GhostTriangulation& in, std::span<const Point2> points, const SwapCriterion& criterion,
                      const SwapOptions& options) {
  require_values(criterion, points.size());
  std::function<bool(SideId)> is_fixed;
  if (options.is_fixed) is_fixed = [&](SideId s) { return options.is_fixed(in, s); };
  return std::visit(
      [&](const auto& chosen) {
        EdgeSwapper swapper(in, points, chosen, is_fixed);
        swapper.suspect_all();
        return settle(swapper, options);
      },
      criterion);
}

SwapReport swap_edges(TriangleMesh& mesh, const SwapCriterion& criterion, const SwapOptions& options) {
  mesh::require_ids_in_range(mesh);
  GhostTriangulation in = ghost_triangulation(mesh::quad_edge(mesh));
  const ConstraintSet constraints(mesh);
  SwapOptions with_constraints = options;
  // Numbers are the mesh's, and flips exchange triangles of one region only.
  const auto region_of = [&](AnyTriangleId t) { return mesh.regions[TriangleId{t.raw}]; };
  with_constraints.is_fixed = [&](const GhostTriangulation& all, SideId s) {
    const AnyTriangleId t = all.triangle(s), u = all.triangle(all.twin(s));
    return constraints.contains(all.origin(s), all.destination(s)) || region_of(t) != region_of(u) ||
           (options.is_fixed && options.is_fixed(all, s));
  };
  const SwapReport report = swap_edges(in, mesh.points.flat(), criterion, with_constraints);
  copy_triangles(in, mesh);
  return report;
}

PointTriangulation triangulate_by_sweep(std::span<const Point2> points, const AlgorithmOptions& options) {
  GhostTriangulation in;
  return sweep(points, options.progress, in, [](const std::vector<AnyTriangleId>&) {});
}

PointTriangulation triangulate_lawson(std::span<const Point2> points, const AlgorithmOptions& options) {
  GhostTriangulation in;
  EdgeSwapper swapper(in, points, criterion::Delaunay{});
  return sweep(points, options.progress, in, [&](const std::vector<AnyTriangleId>& made) {
    for (const AnyTriangleId t : made)
      for (unsigned i = 0; i < 3; ++i) swapper.suspect(in.side(t, i));
    swapper.run();
  });
}

PointTriangulation triangulate_by_criterion(std::span<const Point2> points, const SwapCriterion& criterion,
                                            const AlgorithmOptions& options) {
  require_values(criterion, points.size());
  return std::visit(
      [&](const auto& chosen) {
        return insert_in_order(points, order_in_rounds(points.size()), options.progress,
                               CriterionInserter(points, chosen))
            .result;
      },
      criterion);
}

}  // namespace leonhard::delaunay
