// SPDX-License-Identifier: MIT
#include "leonhard/kernel/batch.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "leonhard/kernel/batch/batch_filters.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::InputError;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

// Each predicate for one call, for calls by id, and for one against many.
#define LEONHARD_FORMS(NAME, FORMS, POINT, COUNT, FILTER)                            \
  struct FORMS {                                                                     \
    using Point = POINT;                                                             \
    static constexpr std::size_t count = COUNT;                                      \
    template <class... Arguments>                                                    \
    static auto ask(Arguments&&... arguments) {                                      \
      return k::NAME(std::forward<Arguments>(arguments)...);                         \
    }                                                                                \
    static const auto& filter(const k::detail::BatchFilters& f) { return f.FILTER; } \
  }
LEONHARD_FORMS(orient2d, Orient2d, Point2, 3, orient2d);
LEONHARD_FORMS(incircle, Incircle, Point2, 4, incircle);
LEONHARD_FORMS(incircle_perturbed, IncirclePerturbed, Point2, 4, incircle);
LEONHARD_FORMS(orient3d, Orient3d, Point3, 4, orient3d);
LEONHARD_FORMS(insphere, Insphere, Point3, 5, insphere);
LEONHARD_FORMS(insphere_perturbed, InspherePerturbed, Point3, 5, insphere);
#undef LEONHARD_FORMS

template <class P>
struct Batch {
  std::vector<typename P::Point> points;
  std::vector<std::array<std::uint32_t, P::count>> calls;
};

/// Each call about the points of one draw, in their order; the array of points ends with the last one used.
template <class P, class Family>
Batch<P> batch_of(const Family& family, std::size_t calls, Random& random) {
  Batch<P> batch;
  for (std::size_t i = 0; i < calls; ++i) {
    const auto drawn = family.draw(random);
    auto& call = batch.calls.emplace_back();
    for (std::size_t j = 0; j < P::count; ++j) {
      call[j] = static_cast<std::uint32_t>(batch.points.size());
      batch.points.push_back(drawn[j]);
    }
  }
  return batch;
}

template <class P, std::size_t... j>
Sign scalar(const Batch<P>& batch, std::size_t i, std::index_sequence<j...>) {
  return P::ask(batch.points[batch.calls[i][j]]...);
}
template <class P>
std::vector<Sign> scalar(const Batch<P>& batch) {
  std::vector<Sign> signs;
  for (std::size_t i = 0; i < batch.calls.size(); ++i)
    signs.push_back(scalar(batch, i, std::make_index_sequence<P::count>()));
  return signs;
}

/// Against the points of call 0 but its last.
template <class P, std::size_t... j>
void check_one_against_many(const Batch<P>& batch, std::index_sequence<j...>) {
  std::vector<std::uint32_t> ids;
  std::vector<Sign> expected, signs;
  for (std::size_t i = 0; i < batch.points.size(); ++i) {
    ids.push_back(static_cast<std::uint32_t>(batch.points.size() - 1 - i));
    expected.push_back(P::ask(batch.points[j]..., batch.points[ids[i]]));
  }
  signs.resize(ids.size());
  P::ask(batch.points[j]..., std::span(batch.points), ids, signs);
  CHECK(signs == expected);
}

std::vector<const k::detail::BatchFilters*> builds() {
  std::vector<const k::detail::BatchFilters*> all{&k::detail::batch_filters_baseline};
  if (&k::detail::best_batch_filters() != all[0]) all.push_back(&k::detail::best_batch_filters());
  return all;
}

/// How many signs the filter leaves open; a wrong one fails.
std::size_t undecided(const std::vector<Sign>& filtered, const std::vector<Sign>& truth) {
  std::size_t open = 0, wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    open += filtered[i] == Sign::zero;
    wrong += filtered[i] != Sign::zero && filtered[i] != truth[i];
  }
  CHECK(wrong == 0);
  return open;
}

template <class P>
std::vector<Sign> filtered(const k::detail::BatchFilters& build, const Batch<P>& batch) {
  std::vector<Sign> signs(batch.calls.size(), Sign{7});
  P::filter(build).calls(batch.points.data(), batch.calls[0].data(), batch.calls.size(), signs.data());
  return signs;
}

template <class P, class Families>
void check_family_by_family(const Families& families) {
  Random random(301);
  for (const auto& family : families) {
    CAPTURE(family.name);
    for (const std::size_t size : {1, 2, 3, 4, 5, 6, 7, 8, 9, 1000}) {
      const auto batch = batch_of<P>(family, size, random);
      const std::vector<Sign> truth = scalar(batch);
      std::vector<Sign> signs(size, Sign{7});
      P::ask(std::span(batch.points), batch.calls, signs);
      REQUIRE(signs == truth);
      for (const auto* build : builds()) {
        CAPTURE(build->name);
        undecided(filtered(*build, batch), truth);
      }
      check_one_against_many(batch, std::make_index_sequence<P::count - 1>());
    }
  }
}

template <class P>
void check_sizes() {
  std::vector<typename P::Point> points(8);
  std::vector<std::array<std::uint32_t, P::count>> calls(3);
  std::vector<Sign> two(2, Sign::positive), none;
  CHECK_THROWS_AS(P::ask(std::span(points), calls, two), InputError);
  CHECK(two == std::vector<Sign>(2, Sign::positive));
  calls.clear();
  CHECK_THROWS_AS(P::ask(std::span(points), calls, two), InputError);
  P::ask(std::span(points), calls, none);
  points.clear();
  P::ask(std::span(points), calls, none);
}

template <class P>
void check_quality(const auto& family) {
  Random random(302);
  const auto batch = batch_of<P>(family, static_cast<std::size_t>(scaled_calls(100'000)), random);
  const auto truth = scalar(batch);
  for (const auto* build : builds()) CHECK(undecided(filtered(*build, batch), truth) == 0);
}

/// Signs are written for the given calls and nowhere else, wherever the spans begin.
template <class P, class Family>
void check_parts(const Family& family) {
  Random random(303);
  const auto batch = batch_of<P>(family, 20, random);
  const auto truth = scalar(batch);
  for (std::size_t begin = 0; begin < 8; ++begin)
    for (std::size_t end = begin; end < 20; ++end) {
      std::vector<Sign> signs(20, Sign{7});
      const std::size_t count = end - begin;
      P::ask(std::span(batch.points), std::span(batch.calls).subspan(begin, count),
             std::span(signs).subspan(begin, count));
      for (std::size_t i = 0; i < 20; ++i) REQUIRE(signs[i] == (i >= begin && i < end ? truth[i] : Sign{7}));
    }
}

}  // namespace

TEST_CASE("batches_in_the_plane_answer_like_the_predicates") {
  check_family_by_family<Orient2d>(point_families());
  check_family_by_family<Incircle>(point_families());
  check_family_by_family<IncirclePerturbed>(point_families());
}

TEST_CASE("batches_in_space_answer_like_the_predicates") {
  check_family_by_family<Orient3d>(point_families3());
  check_family_by_family<Insphere>(point_families3());
  check_family_by_family<InspherePerturbed>(point_families3());
}

namespace {
struct alignas(k::sphere_record_bytes) Record {
  Point3 point;
  std::uint32_t notes[2];
};
}  // namespace

TEST_CASE("many_spheres_and_one_point_have_the_signs_of_insphere_where_the_filter_can_tell") {
  Random random(303);
  for (const auto& family : point_families3()) {
    CAPTURE(family.name);
    for (const std::size_t size : {1, 2, 3, 4, 5, 9, 500}) {
      const auto batch = batch_of<Insphere>(family, size, random);
      std::vector<Record> points;
      for (const Point3& p : batch.points) points.push_back({p, {7, 4'000'000'000}});
      const Point3 last = batch.points.back();
      std::vector<std::uint32_t> ids;
      std::vector<Sign> truth;
      for (const auto& call : batch.calls) {
        ids.insert(ids.end(), call.begin(), call.begin() + 4);
        truth.push_back(k::insphere(batch.points[call[0]], batch.points[call[1]], batch.points[call[2]],
                                    batch.points[call[3]], last));
      }
      for (const auto* build : builds()) {
        CAPTURE(build->name);
        std::vector<Sign> signs(size, Sign{7});
        build->spheres(last, points.data(), ids.data(), size, signs.data());
        const std::size_t open = undecided(signs, truth);
        if (std::string_view(family.name) == "uniform") CHECK(open < 2 + size / 50);
      }
    }
  }
}

TEST_CASE("the_filters_of_batches_decide_nearly_all_uniform_points") {
  check_quality<Orient2d>(point_families().front());
  check_quality<Incircle>(point_families().front());
  check_quality<Orient3d>(point_families3().front());
  check_quality<Insphere>(point_families3().front());
}

TEST_CASE("batches_write_the_signs_asked_for_and_no_others") {
  check_parts<Orient2d>(point_families().front());
  check_parts<Incircle>(point_families().front());
  check_parts<Orient3d>(point_families3().front());
  check_parts<Insphere>(point_families3().front());
}

TEST_CASE("batches_refuse_spans_whose_sizes_differ") {
  check_sizes<Orient2d>();
  check_sizes<Incircle>();
  check_sizes<Orient3d>();
  check_sizes<Insphere>();
  const std::vector<Point3> points(4);
  const std::vector<std::uint32_t> ids{0, 1, 2};
  std::vector<Sign> two(2);
  CHECK_THROWS_AS(k::orient3d(points[0], points[1], points[2], points, ids, two), InputError);
}
