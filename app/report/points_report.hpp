// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/fingerprint.hpp"

namespace leonhard::app {

/// Why there is no triangulation, in words, with what to do; "" where there is one.
[[nodiscard]] std::string why_no_triangles(delaunay::TriangulateOutcome outcome, std::size_t distinct_points);

/// Number of points, duplicates (points at the place of an earlier one), bounding box.
struct PointsAccount {
  std::size_t points{}, duplicates{};
  Point2 low, high;  ///< of no points not told

  [[nodiscard]] std::size_t distinct() const { return points - duplicates; }
};

/// points  finite
[[nodiscard]] PointsAccount points_account(std::span<const Point2> points);
[[nodiscard]] Json to_json(const PointsAccount& account);

/// What `leonhard check` says of points: their account, the outcome of their Delaunay triangulation, whether they are
/// collinear, and where there is a triangulation its size and fingerprint.
struct PointsReport {
  struct Hull {
    std::size_t points{};
    Fingerprint fingerprint;  ///< of the triangulation
  };
  PointsAccount account;
  delaunay::TriangulateOutcome outcome{};
  std::size_t triangles{};
  std::optional<Hull> hull;  ///< none where there is no triangulation

  /// One point or two lie on a line as well.
  [[nodiscard]] bool is_collinear() const {
    return !hull && outcome != delaunay::TriangulateOutcome::stopped;
  }
};

[[nodiscard]] PointsReport points_report(std::span<const Point2> points,
                                         const delaunay::AlgorithmOptions& options);

/// For people, and for programs.
[[nodiscard]] std::string text_of(const PointsReport& report);
[[nodiscard]] Json to_json(const PointsReport& report);

}  // namespace leonhard::app
