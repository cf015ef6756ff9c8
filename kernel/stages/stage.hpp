// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// Which stage of a predicate answers. For measurements and tests: the predicates themselves are in predicates.hpp and
/// predicates3.hpp, and give the same signs.
namespace leonhard::kernel {

/// From the cheapest to the dearest; each predicate asks them in this order.
enum class Stage {
  filter,         // the determinant in floating point, if a proven error bound lets it tell
  small_integer,  // the same without a bound, if the points lie on a coarse grid and nothing is rounded
  integer,        // integers of a fixed width, if the coordinates are multiples of a common power of two
  double_double,  // the determinant in about 106 bits, with its error bound
  expansion,      // exact sums of doubles, if the exponents are safe from overflow and underflow
  wide_filter,    // the determinant in floating point whose exponents stand apart, with its error bound
  wide_exact,     // the exact sum of its terms, the largest first
  rational,       // GMP: predicates of implicit points alone
};

struct StagedSign {
  Sign sign;
  Stage stage;
};

[[nodiscard]] StagedSign orient2d_staged(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] StagedSign incircle_staged(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
[[nodiscard]] StagedSign orient3d_staged(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
[[nodiscard]] StagedSign insphere_staged(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                         const Point3& e);

}  // namespace leonhard::kernel
