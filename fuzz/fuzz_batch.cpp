// SPDX-License-Identifier: MIT
// Batches answer as the predicates do one by one, which other targets hold against rational arithmetic, and a filter
// says nothing else, whichever build of it runs.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/batch.hpp"
#include "leonhard/kernel/batch/batch_filters.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::fuzzing::report;

namespace {

/// More calls than fill the widest lanes three times.
constexpr std::size_t most_points = 13;

// Each predicate in all its forms.
constexpr auto orient2d = [](const auto&... arguments) { return k::orient2d(arguments...); };
constexpr auto incircle = [](const auto&... arguments) { return k::incircle(arguments...); };
constexpr auto incircle_perturbed = [](const auto&... arguments) {
  return k::incircle_perturbed(arguments...);
};
constexpr auto orient3d = [](const auto&... arguments) { return k::orient3d(arguments...); };
constexpr auto insphere = [](const auto&... arguments) { return k::insphere(arguments...); };
constexpr auto insphere_perturbed = [](const auto&... arguments) {
  return k::insphere_perturbed(arguments...);
};

/// Call i is of points i, i + step, i + 2 step and so on, round and round.
template <std::size_t count>
std::vector<std::array<std::uint32_t, count>> calls_of(std::size_t points, std::size_t step) {
  std::vector<std::array<std::uint32_t, count>> calls(points);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t j = 0; j < count; ++j) calls[i][j] = static_cast<std::uint32_t>((i + j * step) % points);
  return calls;
}

void check_filtered(std::span<const Sign> filtered, std::span<const Sign> truth, const auto& points) {
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (filtered[i] != Sign::zero && filtered[i] != truth[i]) report("a filter of batches is wrong", points);
}

template <class Point, class Predicate, std::size_t... j>
void check(std::span<const Point> points, std::size_t step, Predicate ask,
           k::detail::BatchFilter<Point> k::detail::BatchFilters::*filter, std::index_sequence<j...>) {
  const auto calls = calls_of<sizeof...(j)>(points.size(), step);
  std::vector<Sign> truth, signs(calls.size());
  for (const auto& call : calls) truth.push_back(ask(points[call[j]]...));
  ask(points, std::span(calls), std::span(signs));
  if (signs != truth) report("a batch is wrong", points);
  for (const auto* build : {&k::detail::batch_filters_baseline, &k::detail::best_batch_filters()}) {
    (build->*filter).calls(points.data(), calls[0].data(), calls.size(), signs.data());
    check_filtered(signs, truth, points);
  }
}

/// All but the last point of the first call against all points.
template <class Point, class Predicate, std::size_t... j>
void check_one_against_many(std::span<const Point> points, Predicate ask,
                            k::detail::BatchFilter<Point> k::detail::BatchFilters::*filter,
                            std::index_sequence<j...>) {
  const std::array one{points[j % points.size()]...};
  std::vector<std::uint32_t> ids;
  std::vector<Sign> truth, signs(points.size());
  for (std::size_t i = points.size(); i-- > 0;) {
    ids.push_back(static_cast<std::uint32_t>(i));
    truth.push_back(ask(one[j]..., points[i]));
  }
  ask(one[j]..., points, std::span<const std::uint32_t>(ids), std::span(signs));
  if (signs != truth) report("a batch of one against many is wrong", points);
  for (const auto* build : {&k::detail::batch_filters_baseline, &k::detail::best_batch_filters()}) {
    (build->*filter).one_against_many(one.data(), points.data(), ids.data(), ids.size(), signs.data());
    check_filtered(signs, truth, points);
  }
}

template <std::size_t count, class Point, class Predicate>
void check_forms(std::span<const Point> points, std::size_t step, Predicate ask,
                 k::detail::BatchFilter<Point> k::detail::BatchFilters::*filter) {
  check(points, step, ask, filter, std::make_index_sequence<count>());
  check_one_against_many(points, ask, filter, std::make_index_sequence<count - 1>());
}

/// As a SpheresFilter reads them.
struct alignas(k::sphere_record_bytes) Record {
  Point3 point;
  std::uint32_t notes[2];
};

/// insphere of each call but its last point, and the last point of all.
void check_spheres(std::span<const Point3> points, std::size_t step) {
  const auto calls = calls_of<4>(points.size(), step);
  std::vector<Record> padded;
  for (const Point3& p : points) padded.push_back({p, {~0U, 7}});
  std::vector<Sign> truth, signs(calls.size());
  for (const auto& [a, b, c, d] : calls)
    truth.push_back(k::insphere(points[a], points[b], points[c], points[d], points.back()));
  for (const auto* build : {&k::detail::batch_filters_baseline, &k::detail::best_batch_filters()}) {
    build->spheres(points.back(), padded.data(), calls[0].data(), calls.size(), signs.data());
    check_filtered(signs, truth, points);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leonhard::fuzzing::Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  const std::size_t step = 1 + input.take<std::uint8_t>() % 4U;
  std::vector<Point2> flat;
  std::vector<Point3> solid;
  do {
    const Point3 p = input.point3(kind);
    solid.push_back(p);
    flat.push_back({p.x, p.y});
  } while (!input.empty() && solid.size() < most_points);
  const std::span<const Point2> plane(flat);
  const std::span<const Point3> space(solid);

  using Filters = k::detail::BatchFilters;
  check_forms<3>(plane, step, orient2d, &Filters::orient2d);
  check_forms<4>(plane, step, incircle, &Filters::incircle);
  check_forms<4>(plane, step, incircle_perturbed, &Filters::incircle);
  check_forms<4>(space, step, orient3d, &Filters::orient3d);
  check_forms<5>(space, step, insphere, &Filters::insphere);
  check_forms<5>(space, step, insphere_perturbed, &Filters::insphere);
  check_spheres(space, step);
  return 0;
}
