// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// The stage of the predicates that computes with integers: it answers if all coordinates are integers below 2^61 times
/// one power of two, that is, if the lowest bit of each is at most 61 places below the first bit of the largest.
///
/// Most points that lie near each other are of this kind, whatever their exponents: those of any grid, of single
/// precision, of a unit square but for a small part of it. Their determinants have a few hundred bits, which integers
/// of a fixed width find in some ten nanoseconds, ties included; expansions and interval arithmetic take longer.
namespace leonhard::kernel::integer {

[[nodiscard]] std::optional<Sign> orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] std::optional<Sign> incircle(const Point2& a, const Point2& b, const Point2& c,
                                           const Point2& d);
[[nodiscard]] std::optional<Sign> orient3d(const Point3& a, const Point3& b, const Point3& c,
                                           const Point3& d);
[[nodiscard]] std::optional<Sign> insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                           const Point3& e);

}  // namespace leonhard::kernel::integer
