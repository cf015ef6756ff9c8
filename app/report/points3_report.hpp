// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::app {

/// Why there is no tetrahedralisation, in words, with what to do; "" where there is one.
[[nodiscard]] std::string why_no_tetrahedra(delaunay::TetrahedralizeOutcome outcome,
                                            std::size_t distinct_points);

/// Points at different places, -0 taken as 0. Cost O(n log n).
[[nodiscard]] std::size_t count_distinct(std::span<const Point3> points);

/// Number of points, duplicates (points at the place of an earlier one), bounding box.
///
/// points    finite
/// distinct  how many places they have
[[nodiscard]] Json points3_account(std::span<const Point3> points, std::size_t distinct);

/// What `leonhard check` says of points of space: their account, the outcome of their Delaunay tetrahedralisation, whether
/// they lie on one line or in one plane, and the tetrahedralisation's fingerprint (null where there is none).
[[nodiscard]] Json points3_report(std::span<const Point3> points,
                                  const delaunay::TetrahedralizeOptions& options);

/// The same as text for people.
[[nodiscard]] std::string points3_report_text(const Json& report);

}  // namespace leonhard::app
