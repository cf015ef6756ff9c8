// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

namespace leonhard::kernel {

/// The distance in bytes of one record of a SpheresFilter from the next.
inline constexpr std::size_t sphere_record_bytes = 32;

/// The floating-point filter of insphere(a, b, c, d, p) for one p and many tetrahedra a, b, c, d: for constructions that
/// keep notes of their own beside each point.
///
/// records  the first of an array of records of sphere_record_bytes, each of which begins with a Point3; the rest of it is
///          not read. Aligned to as many bytes no record lies in two cache lines
/// ids      four records a tetrahedron, side by side
/// count    of tetrahedra
/// signs    receives one a tetrahedron: insphere's sign, or zero, which says that the filter cannot tell (ask insphere); it
///          never can where a coordinate is NaN or infinite, or two points are equal
/// Ids are a precondition; nothing is checked. Cost: some nanoseconds a tetrahedron.
using SpheresFilter = void (*)(const Point3& p, const void* records, const std::uint32_t* ids,
                               std::size_t count, Sign* signs);

/// The fastest one that this processor runs. Others may differ in which calls they decide, never in a sign.
[[nodiscard]] SpheresFilter spheres_filter();

}  // namespace leonhard::kernel
