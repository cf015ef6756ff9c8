// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// Predicates of many calls at once: filtered some calls at a time, with AVX2 where the processor has it, and what the
/// filter leaves is asked of the predicate. The answers are those of predicates.hpp and predicates3.hpp, whose
/// conventions of sign hold, for every input.
///
/// signs   receives the answers, signs[i] that of the i-th call
/// throws  InputError if there are not as many signs as calls, before any is written; as the predicate if a point that is
///         asked about is not finite, the signs being of no meaning then
///
/// Ids index points: a precondition, which assertions check.
namespace leonhard::kernel {

// ---- Calls of points by id ----
//
// calls   the ids of each call's points, in the order of the predicate's arguments

void orient2d(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 3>> calls,
              std::span<Sign> signs);
void incircle(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 4>> calls,
              std::span<Sign> signs);
void incircle_perturbed(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 4>> calls,
                        std::span<Sign> signs);
void orient3d(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> calls,
              std::span<Sign> signs);
void insphere(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 5>> calls,
              std::span<Sign> signs);
void insphere_perturbed(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 5>> calls,
                        std::span<Sign> signs);

// ---- One line, circle, plane or sphere against many points ----
//
// ids     the predicate's last argument in each call; much cheaper than the calls written out

void orient2d(const Point2& a, const Point2& b, std::span<const Point2> points,
              std::span<const std::uint32_t> ids, std::span<Sign> signs);
void incircle(const Point2& a, const Point2& b, const Point2& c, std::span<const Point2> points,
              std::span<const std::uint32_t> ids, std::span<Sign> signs);
void incircle_perturbed(const Point2& a, const Point2& b, const Point2& c, std::span<const Point2> points,
                        std::span<const std::uint32_t> ids, std::span<Sign> signs);
void orient3d(const Point3& a, const Point3& b, const Point3& c, std::span<const Point3> points,
              std::span<const std::uint32_t> ids, std::span<Sign> signs);
void insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
              std::span<const Point3> points, std::span<const std::uint32_t> ids, std::span<Sign> signs);
void insphere_perturbed(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                        std::span<const Point3> points, std::span<const std::uint32_t> ids,
                        std::span<Sign> signs);

}  // namespace leonhard::kernel
