// SPDX-License-Identifier: MIT
#include "leonhard/kernel/batch.hpp"

#include <cassert>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include "leonhard/kernel/batch/batch_filters.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/spheres_filter.hpp"

namespace leonhard::kernel {

const detail::BatchFilters& detail::best_batch_filters() {
#if defined(LEONHARD_HAS_AVX2_BATCH)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return batch_filters_avx2;
#endif
  return batch_filters_baseline;
}

SpheresFilter spheres_filter() { return detail::best_batch_filters().spheres; }

namespace {

void check(std::size_t point_count, std::span<const std::uint32_t> ids, std::size_t call_count,
           std::size_t sign_count) {
  if (sign_count != call_count)
    throw InputError("signs",
                     std::to_string(sign_count) + " signs for " + std::to_string(call_count) + " calls",
                     "give as many signs as calls");
  for ([[maybe_unused]] const std::uint32_t id : ids) assert(id < point_count);
  static_cast<void>(point_count);
}

/// Asks the predicate where the filter could not tell.
template <class Ask>
void settle(std::span<Sign> signs, Ask ask) {
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const void* undecided = std::memchr(signs.data() + i, static_cast<int>(Sign::zero), signs.size() - i);
    if (undecided == nullptr) return;
    i = static_cast<std::size_t>(static_cast<const Sign*>(undecided) - signs.data());
    signs[i] = ask(i);
  }
}

template <class Point, std::size_t count, class Ask>
void settle_calls(const detail::BatchFilter<Point>& filter, std::span<const Point> points,
                  std::span<const std::array<std::uint32_t, count>> calls, std::span<Sign> signs, Ask ask) {
  static_assert(sizeof(std::array<std::uint32_t, count>) == count * sizeof(std::uint32_t));
  if (calls.empty()) return check(points.size(), {}, 0, signs.size());
  const std::span<const std::uint32_t> ids(calls.front().data(), count * calls.size());
  check(points.size(), ids, calls.size(), signs.size());
  filter.calls(points.data(), ids.data(), calls.size(), signs.data());
  settle(signs, [&](std::size_t i) {
    return [&]<std::size_t... j>(std::index_sequence<j...>) { return ask(points[calls[i][j]]...); }
    (std::make_index_sequence<count>());
  });
}

template <class Point, std::size_t count, class Ask>
void settle_one_against_many(const detail::BatchFilter<Point>& filter, const std::array<Point, count>& one,
                             std::span<const Point> points, std::span<const std::uint32_t> ids,
                             std::span<Sign> signs, Ask ask) {
  check(points.size(), ids, ids.size(), signs.size());
  filter.one_against_many(one.data(), points.data(), ids.data(), ids.size(), signs.data());
  settle(signs, [&](std::size_t i) { return ask(points[ids[i]]); });
}

}  // namespace

void orient2d(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 3>> calls,
              std::span<Sign> signs) {
  settle_calls(detail::best_batch_filters().orient2d, points, calls, signs,
               [](const Point2& a, const Point2& b, const Point2& c) { return orient2d(a, b, c); });
}
void incircle(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 4>> calls,
              std::span<Sign> signs) {
  settle_calls(detail::best_batch_filters().incircle, points, calls, signs,
               [](const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
                 return incircle(a, b, c, d);
               });
}
void incircle_perturbed(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 4>> calls,
                        std::span<Sign> signs) {
  settle_calls(detail::best_batch_filters().incircle, points, calls, signs,
               [](const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
                 return incircle_perturbed(a, b, c, d);
               });
}
void orient3d(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> calls,
              std::span<Sign> signs) {
  settle_calls(detail::best_batch_filters().orient3d, points, calls, signs,
               [](const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
                 return orient3d(a, b, c, d);
               });
}
void insphere(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 5>> calls,
              std::span<Sign> signs) {
  settle_calls(detail::best_batch_filters().insphere, points, calls, signs,
               [](const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
                 return insphere(a, b, c, d, e);
               });
}
void insphere_perturbed(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 5>> calls,
                        std::span<Sign> signs) {
  settle_calls(detail::best_batch_filters().insphere, points, calls, signs,
               [](const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
                 return insphere_perturbed(a, b, c, d, e);
               });
}

void orient2d(const Point2& a, const Point2& b, std::span<const Point2> points,
              std::span<const std::uint32_t> ids, std::span<Sign> signs) {
  settle_one_against_many(detail::best_batch_filters().orient2d, std::array{a, b}, points, ids, signs,
                          [&](const Point2& c) { return orient2d(a, b, c); });
}
void incircle(const Point2& a, const Point2& b, const Point2& c, std::span<const Point2> points,
              std::span<const std::uint32_t> ids, std::span<Sign> signs) {
  settle_one_against_many(detail::best_batch_filters().incircle, std::array{a, b, c}, points, ids, signs,
                          [&](const Point2& d) { return incircle(a, b, c, d); });
}
void incircle_perturbed(const Point2& a, const Point2& b, const Point2& c, std::span<const Point2> points,
                        std::span<const std::uint32_t> ids, std::span<Sign> signs) {
  settle_one_against_many(detail::best_batch_filters().incircle, std::array{a, b, c}, points, ids, signs,
                          [&](const Point2& d) { return incircle_perturbed(a, b, c, d); });
}
void orient3d(const Point3& a, const Point3& b, const Point3& c, std::span<const Point3> points,
              std::span<const std::uint32_t> ids, std::span<Sign> signs) {
  settle_one_against_many(detail::best_batch_filters().orient3d, std::array{a, b, c}, points, ids, signs,
                          [&](const Point3& d) { return orient3d(a, b, c, d); });
}
void insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
              std::span<const Point3> points, std::span<const std::uint32_t> ids, std::span<Sign> signs) {
  settle_one_against_many(detail::best_batch_filters().insphere, std::array{a, b, c, d}, points, ids, signs,
                          [&](const Point3& e) { return insphere(a, b, c, d, e); });
}
void insphere_perturbed(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                        std::span<const Point3> points, std::span<const std::uint32_t> ids,
                        std::span<Sign> signs) {
  settle_one_against_many(detail::best_batch_filters().insphere, std::array{a, b, c, d}, points, ids, signs,
                          [&](const Point3& e) { return insphere_perturbed(a, b, c, d, e); });
}

}  // namespace leonhard::kernel
