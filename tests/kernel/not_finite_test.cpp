// SPDX-License-Identifier: MIT
// NaN and infinities are bad input to everything that decides or constructs.
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/batch.hpp"
#include "leonhard/kernel/boost_geometry.hpp"
#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/implicit_point.hpp"
#include "leonhard/kernel/implicit_point3.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/insertion_order.hpp"
#include "leonhard/kernel/power.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/stage.hpp"

namespace k = leonhard::kernel;
using leonhard::InputError;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::WeightedPoint2;
using leonhard::WeightedPoint3;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const std::array bad_numbers{not_a_number, -not_a_number, infinity, -infinity};

template <class Call>
bool is_refused(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const InputError&) {
    return true;
  }
  return false;
}

// ---- points as numbers ----

template <class Point>
struct NumbersOf;
template <>
struct NumbersOf<Point2> {
  static constexpr std::size_t count = 2;
  static double* at(Point2& p, std::size_t i) { return i == 0 ? &p.x : &p.y; }
};
template <>
struct NumbersOf<Point3> {
  static constexpr std::size_t count = 3;
  static double* at(Point3& p, std::size_t i) { return i == 0 ? &p.x : i == 1 ? &p.y : &p.z; }
};
template <>
struct NumbersOf<WeightedPoint2> {
  static constexpr std::size_t count = 3;
  static double* at(WeightedPoint2& p, std::size_t i) {
    return i == 2 ? &p.weight : NumbersOf<Point2>::at(p.point, i);
  }
};
template <>
struct NumbersOf<WeightedPoint3> {
  static constexpr std::size_t count = 4;
  static double* at(WeightedPoint3& p, std::size_t i) {
    return i == 3 ? &p.weight : NumbersOf<Point3>::at(p.point, i);
  }
};

// ---- the claim ----

template <class Point>
void check_refused(const std::string& name, const std::vector<Point>& points,
                   const std::function<void(const std::vector<Point>&)>& call) {
  CAPTURE(name);
  try {
    call(points);
    FAIL_CHECK("no exception");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("finite") != std::string::npos);
  }
}

/// Every number of every point in turn made NaN or infinite; then one number of all points, and all numbers; the rest in
/// general position, on a grid, and all equal.
template <class Point>
void check_refuses(const std::string& name, std::size_t count,
                   const std::function<void(const std::vector<Point>&)>& call) {
  using Numbers = NumbersOf<Point>;
  for (const int family : {0, 1, 2}) {
    std::vector<Point> good(count);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < Numbers::count; ++j) {
        const auto n = static_cast<double>(i * Numbers::count + j);
        *Numbers::at(good[i], j) = family == 0   ? 0.37 * n * n - 1.3 * n + 0.11
                                   : family == 1 ? static_cast<double>((i + j) % 3)
                                                 : 1;
      }
    for (const double bad : bad_numbers) {
      CAPTURE(family);
      CAPTURE(bad);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < Numbers::count; ++j) {
          std::vector<Point> points = good;
          *Numbers::at(points[i], j) = bad;
          CAPTURE(i);
          CAPTURE(j);
          check_refused(name, points, call);
        }
      std::vector<Point> all_bad = good;
      for (std::size_t j = 0; j < Numbers::count; ++j) {
        std::vector<Point> points = good;
        for (std::size_t i = 0; i < count; ++i)
          *Numbers::at(points[i], j) = *Numbers::at(all_bad[i], j) = bad;
        check_refused(name, points, call);
      }
      check_refused(name, all_bad, call);
    }
  }
}

template <class Function>
struct Arity;
template <class Result, class... Arguments>
struct Arity<Result (*)(Arguments...)> {
  static constexpr std::size_t count = sizeof...(Arguments);
};

/// A predicate or construction whose arguments are all of one kind of points.
template <class Point, class Function>
void check_function(const std::string& name, Function function) {
  constexpr std::size_t count = Arity<Function>::count;
  check_refuses<Point>(name, count, [function](const std::vector<Point>& points) {
    [&]<std::size_t... i>(std::index_sequence<i...>) { static_cast<void>(function(points[i]...)); }
    (std::make_index_sequence<count>());
  });
}

using Two = Point2;
using Three = Point3;
using Weighted2 = WeightedPoint2;
using Weighted3 = WeightedPoint3;
template <class P>
using Of3 = Sign (*)(const P&, const P&, const P&);
template <class P>
using Of4 = Sign (*)(const P&, const P&, const P&, const P&);
template <class P>
using Of5 = Sign (*)(const P&, const P&, const P&, const P&, const P&);

template <class Point, std::size_t count>
void check_batch(const std::string& name,
                 void (*batch)(std::span<const Point>, std::span<const std::array<std::uint32_t, count>>,
                               std::span<Sign>)) {
  // More calls than any processor's lanes, the points that are not finite in the last.
  check_refuses<Point>(name, count, [batch](const std::vector<Point>& bad) {
    std::vector<Point> points = bad;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < NumbersOf<Point>::count; ++j)
        *NumbersOf<Point>::at(points.emplace_back(), j) = static_cast<double>(i * i + 3 * j + i * j * j);
    std::vector<std::array<std::uint32_t, count>> calls(11);
    for (auto& call : calls)
      for (std::size_t i = 0; i < count; ++i)
        call[i] = static_cast<std::uint32_t>((&call == &calls.back() ? 0 : count) + i);
    std::vector<Sign> signs(calls.size());
    batch(points, calls, signs);
  });
}

}  // namespace

TEST_CASE("predicates_of_the_plane_refuse_what_is_not_finite") {
  check_function<Two>("orient2d", Of3<Two>(k::orient2d));
  check_function<Two>("orient2d_exact", Of3<Two>(k::orient2d_exact));
  check_function<Two>(
      "orient2d_staged",
      +[](const Two& a, const Two& b, const Two& c) { return k::orient2d_staged(a, b, c); });
  check_function<Two>("incircle", Of4<Two>(k::incircle));
  check_function<Two>("incircle_exact", Of4<Two>(k::incircle_exact));
  check_function<Two>("incircle_perturbed", Of4<Two>(k::incircle_perturbed));
  check_function<Two>("in_diametral_circle", Of3<Two>(k::in_diametral_circle));
  check_function<Two>("angle", Of3<Two>(k::angle));
  check_function<Two>("compare_distance", Of3<Two>(k::compare_distance));
}

TEST_CASE("predicates_of_space_refuse_what_is_not_finite") {
  check_function<Three>("orient3d", Of4<Three>(k::orient3d));
  check_function<Three>("orient3d_exact", Of4<Three>(k::orient3d_exact));
  check_function<Three>("insphere", Of5<Three>(k::insphere));
  check_function<Three>("insphere_exact", Of5<Three>(k::insphere_exact));
  check_function<Three>("insphere_perturbed", Of5<Three>(k::insphere_perturbed));
  check_function<Three>("in_diametral_sphere", Of3<Three>(k::in_diametral_sphere));
  check_function<Three>("angle", Of3<Three>(k::angle));
  check_function<Three>("compare_distance", Of3<Three>(k::compare_distance));
}

TEST_CASE("predicates_of_weighted_points_refuse_what_is_not_finite") {
  check_function<Weighted2>("power_test", Of4<Weighted2>(k::power_test));
  check_function<Weighted2>("power_test_perturbed", Of4<Weighted2>(k::power_test_perturbed));
  check_function<Weighted3>("power_test", Of5<Weighted3>(k::power_test));
  check_function<Weighted3>("power_test_perturbed", Of5<Weighted3>(k::power_test_perturbed));
  check_refuses<Weighted2>("compare_power_distance", 2, [](const std::vector<Weighted2>& p) {
    static_cast<void>(k::compare_power_distance(Point2{0.3, 0.4}, p[0], p[1]));
  });
  check_refuses<Weighted3>("compare_power_distance", 2, [](const std::vector<Weighted3>& p) {
    static_cast<void>(k::compare_power_distance(Point3{0.3, 0.4, 0.5}, p[0], p[1]));
  });
  check_refuses<Two>("compare_power_distance", 1, [](const std::vector<Two>& p) {
    static_cast<void>(k::compare_power_distance(p[0], Weighted2{{0, 0}, 1}, Weighted2{{1, 0}, 1}));
  });
  check_refuses<Three>("compare_power_distance", 1, [](const std::vector<Three>& p) {
    static_cast<void>(k::compare_power_distance(p[0], Weighted3{{0, 0, 0}, 1}, Weighted3{{1, 0, 0}, 1}));
  });
}

TEST_CASE("batches_refuse_what_is_not_finite") {
  check_batch<Two, 3>("orient2d", k::orient2d);
  check_batch<Two, 4>("incircle", k::incircle);
  check_batch<Two, 4>("incircle_perturbed", k::incircle_perturbed);
  check_batch<Three, 4>("orient3d", k::orient3d);
  check_batch<Three, 5>("insphere", k::insphere);
  check_batch<Three, 5>("insphere_perturbed", k::insphere_perturbed);

  const std::vector<std::uint32_t> ids(9, 0);
  std::vector<Sign> signs(ids.size());
  check_refuses<Two>("orient2d of one line", 3, [&](const std::vector<Two>& p) {
    k::orient2d(p[0], p[1], std::span(p).last(1), ids, signs);
  });
  check_refuses<Two>("incircle of one circle", 4, [&](const std::vector<Two>& p) {
    k::incircle(p[0], p[1], p[2], std::span(p).last(1), ids, signs);
  });
  check_refuses<Two>("incircle_perturbed of one circle", 4, [&](const std::vector<Two>& p) {
    k::incircle_perturbed(p[0], p[1], p[2], std::span(p).last(1), ids, signs);
  });
  check_refuses<Three>("orient3d of one plane", 4, [&](const std::vector<Three>& p) {
    k::orient3d(p[0], p[1], p[2], std::span(p).last(1), ids, signs);
  });
  check_refuses<Three>("insphere of one sphere", 5, [&](const std::vector<Three>& p) {
    k::insphere(p[0], p[1], p[2], p[3], std::span(p).last(1), ids, signs);
  });
  check_refuses<Three>("insphere_perturbed of one sphere", 5, [&](const std::vector<Three>& p) {
    k::insphere_perturbed(p[0], p[1], p[2], p[3], std::span(p).last(1), ids, signs);
  });
}

TEST_CASE("constructions_refuse_what_is_not_finite") {
  using Circle3 = k::Circle (*)(const Two&, const Two&, const Two&);
  check_function<Two>("circumcircle", Circle3(k::circumcircle));
  check_function<Two>("containment_circle", Circle3(k::containment_circle));
  check_function<Two>("diametral_circle", k::diametral_circle);
  check_function<Two>(
      "off_centre", +[](const Two& a, const Two& b, const Two& c) { return k::off_centre(a, b, c, 1.5); });
  check_function<Three>(
      "circumcircle", static_cast<k::Sphere (*)(const Three&, const Three&, const Three&)>(k::circumcircle));
  check_function<Three>("circumsphere", k::circumsphere);
}

TEST_CASE("implicit_points_refuse_what_is_not_finite") {
  check_function<Two>(
      "LineCrossing", +[](const Two& a, const Two& b, const Two& c, const Two& d) {
        return k::LineCrossing(a, b, c, d).coordinates()[0].radius;
      });
  check_function<Three>(
      "LinePlaneCrossing",
      +[](const Three& p, const Three& q, const Three& r, const Three& s, const Three& t) {
        return k::LinePlaneCrossing(p, q, r, s, t).coordinates()[0].radius;
      });
  check_refuses<Three>("ThreePlaneCrossing", 9, [](const std::vector<Three>& p) {
    static_cast<void>(k::ThreePlaneCrossing({p[0], p[1], p[2]}, {p[3], p[4], p[5]}, {p[6], p[7], p[8]}));
  });

  const k::LineCrossing crossing({0, 0}, {2, 2}, {0, 2}, {2, 0});  // (1, 1)
  check_refuses<Two>("orient2d", 2, [&](const std::vector<Two>& p) {
    static_cast<void>(k::orient2d(crossing, p[0], p[1]));
  });
  check_refuses<Two>("orient2d", 1, [&](const std::vector<Two>& p) {
    static_cast<void>(k::orient2d(crossing, p[0], crossing));
  });
  check_refuses<Two>("incircle", 3, [&](const std::vector<Two>& p) {
    static_cast<void>(k::incircle(p[0], p[1], crossing, p[2]));
  });
  check_refuses<Two>("rounded", 1, [](const std::vector<Two>& p) { static_cast<void>(k::rounded(p[0])); });

  const k::LinePlaneCrossing pierced({0, 0, -1}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // the origin
  check_refuses<Three>("orient3d", 3, [&](const std::vector<Three>& p) {
    static_cast<void>(k::orient3d(p[0], pierced, p[1], p[2]));
  });
  check_refuses<Three>("insphere", 4, [&](const std::vector<Three>& p) {
    static_cast<void>(k::insphere(p[0], p[1], p[2], p[3], pierced));
  });
  check_refuses<Three>("rounded", 1,
                       [](const std::vector<Three>& p) { static_cast<void>(k::rounded(p[0])); });
}

TEST_CASE("orders_refuse_what_is_not_finite") {
  const auto hilbert = [](const auto& points) { static_cast<void>(k::hilbert_order(points)); };
  const auto brio = [](const auto& points) { static_cast<void>(k::brio_order(points, 1)); };
  check_refuses<Two>("hilbert_order", 5, hilbert);
  check_refuses<Three>("hilbert_order", 5, hilbert);
  check_refuses<Two>("brio_order", 5, brio);
  check_refuses<Three>("brio_order", 5, brio);
}

TEST_CASE("a_nan_that_is_compared_has_no_place_in_the_lexicographic_order") {
  CHECK(is_refused([&] { return k::compare_xy(Point2{not_a_number, 0}, Point2{1, 0}); }));
  CHECK(is_refused([&] { return k::compare_xy(Point2{1, 0}, Point2{1, not_a_number}); }));
  CHECK(is_refused([&] { return k::compare_xyz(Point3{1, 2, not_a_number}, Point3{1, 2, 0}); }));
  CHECK(k::compare_xy({-infinity, 0}, {1, 0}) == Sign::negative);
  CHECK(k::compare_xyz({1, 2, infinity}, {1, 2, infinity}) == Sign::zero);

  const k::LineCrossing crossing({0, 0}, {2, 2}, {0, 2}, {2, 0});  // (1, 1)
  CHECK(is_refused([&] { return k::compare_xy(crossing, Point2{not_a_number, 0}); }));
  CHECK(is_refused([&] { return k::compare_xy(Point2{1, not_a_number}, crossing); }));
  CHECK(is_refused([&] { return k::compare_xy(Point2{infinity, 0}, crossing); }));
}

TEST_CASE("the_strategies_for_boost_geometry_refuse_what_is_not_finite") {
  using Side = int (*)(const Two&, const Two&, const Two&);
  check_function<Two>("ExactSide", Side([](const Two& a, const Two& b, const Two& p) {
                        return k::ExactSide::apply(a, b, p);
                      }));
  for (const double bad : bad_numbers) {
    k::ExactWinding::state_type state;
    CHECK(is_refused([&] { return k::ExactWinding::apply(Two{bad, 0}, Two{0, -1}, Two{0, 1}, state); }));
    CHECK(is_refused([&] { return k::ExactWinding::apply(Two{0, 0}, Two{bad, -1}, Two{0, 1}, state); }));
    CHECK(is_refused([&] { return k::ExactWinding::apply(Two{0, 0}, Two{0, -1}, Two{bad, 1}, state); }));
  }
  k::ExactWinding::state_type state;
  CHECK(is_refused([&] {
    return k::ExactWinding::apply(Two{0, not_a_number}, Two{0, -1}, Two{0, 1}, state);
  }));
  CHECK(is_refused([&] {
    return k::ExactWinding::apply(Two{0, 0}, Two{0, not_a_number}, Two{0, 1}, state);
  }));
}

TEST_CASE("what_is_refused_is_named") {
  try {
    static_cast<void>(k::incircle({0, 0}, {1, 0}, {not_a_number, 1}, {2, 2}));
    FAIL("no exception");
  } catch (const InputError& error) {
    CHECK(error.where() == "incircle");
    CHECK(error.problem() == "point 3 of the call is (nan, 1), which is not finite");
  }
}
