// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "leonhard/app/report/json.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/fingerprint.hpp"

namespace leonhard::app {

/// Why there is no tetrahedralisation, in words, with what to do; "" where there is one.
[[nodiscard]] std::string why_no_tetrahedra(delaunay::TetrahedralizeOutcome outcome,
                                            std::size_t distinct_points);

/// Points at different places, -0 taken as 0. Cost O(n log n).
[[nodiscard]] std::size_t count_distinct(std::span<const Point3> points);

/// Number of points, duplicates (points at the place of an earlier one), bounding box.
struct Points3Account {
  std::size_t points{}, duplicates{};
  Point3 low, high;  ///< of no points not told
};

/// points    finite
/// distinct  how many places they have
[[nodiscard]] Points3Account points3_account(std::span<const Point3> points, std::size_t distinct);
[[nodiscard]] Json to_json(const Points3Account& account);

/// What `leonhard check` says of points of space: their account, the outcome of their Delaunay tetrahedralisation (whether
/// they lie on one line or in one plane), and where there is one its size and fingerprint.
struct Points3Report {
  struct Hull {
    std::size_t faces{}, points{};
    Fingerprint fingerprint;  ///< of the tetrahedralisation
  };
  Points3Account account;
  delaunay::TetrahedralizeOutcome outcome{};
  std::size_t tetrahedra{};
  std::optional<Hull> hull;  ///< none where there is no tetrahedralisation
};

[[nodiscard]] Points3Report points3_report(std::span<const Point3> points,
                                           const delaunay::TetrahedralizeOptions& options);

/// For people, and for programs.
[[nodiscard]] std::string text_of(const Points3Report& report);
[[nodiscard]] Json to_json(const Points3Report& report);

}  // namespace leonhard::app
