// SPDX-License-Identifier: MIT
#pragma once

// The floating-point filters of batch.hpp, compiled once per instruction set (batch_baseline.cpp, batch_avx2.cpp from
// batch_filters_impl.hpp) and chosen when the program runs. Builds may differ in which calls they decide, for one has
// fused multiply-add, and not in a sign.

#include <cstddef>
#include <cstdint>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/spheres_filter.hpp"

namespace leonhard::kernel::detail {

/// The filters of one predicate, for `count` calls: signs[i] is certainly right, or zero, which says that the filter
/// cannot tell.
template <class Point>
struct BatchFilter {
  /// The ids of a call lie side by side.
  void (*calls)(const Point* points, const std::uint32_t* ids, std::size_t count, Sign* signs);
  /// `one` is the points that all calls have in common; their last point alone is given by id.
  void (*one_against_many)(const Point* one, const Point* points, const std::uint32_t* ids, std::size_t count,
                           Sign* signs);
};

/// One build of the filters.
struct BatchFilters {
  const char* name;
  BatchFilter<Point2> orient2d, incircle;
  BatchFilter<Point3> orient3d, insphere;
  SpheresFilter spheres;
};

extern const BatchFilters batch_filters_baseline;
#if defined(LEONHARD_HAS_AVX2_BATCH)
extern const BatchFilters batch_filters_avx2;
#endif

/// The fastest build that this processor runs.
[[nodiscard]] const BatchFilters& best_batch_filters();

}  // namespace leonhard::kernel::detail
