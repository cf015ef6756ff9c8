// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::app {

/// Why there is no triangulation, in words, with what to do; "" where there is one.
[[nodiscard]] std::string why_no_triangles(delaunay::TriangulateOutcome outcome, std::size_t distinct_points);

/// Number of points, duplicates (points at the place of an earlier one), bounding box.
///
/// points  finite, at least one
[[nodiscard]] Json points_account(std::span<const Point2> points);

/// What `leonhard check` says of points: their account, the outcome of their Delaunay triangulation, whether they are
/// collinear, and the triangulation's fingerprint (null where there is none).
[[nodiscard]] Json points_report(std::span<const Point2> points, const delaunay::AlgorithmOptions& options);

/// The same as text for people.
[[nodiscard]] std::string points_report_text(const Json& report);

}  // namespace leonhard::app
