// SPDX-License-Identifier: MIT
// The four predicates and the Hilbert order beside CGAL, TetGen's packaged predicates and the bare determinant: same
// points, same calls, turn and turn about on one core; the shortest turn of each counts.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>
#include <fmt/format.h>
#include <tetgen.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/predicate_inputs.hpp"
#include "leonhard/kernel/batch.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/insertion_order.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"

// Exported by TetGen's library, though not declared in its header.
double orient2d(double* a, double* b, double* c);
double incircle(double* a, double* b, double* c, double* d);

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::benching::call_count;
using leonhard::benching::Input;
using leonhard::benching::Random;
using leonhard::benching::unit;
using Cgal = CGAL::Exact_predicates_inexact_constructions_kernel;

namespace {

// ---- one predicate in its forms ----

int number(Sign s) { return static_cast<int>(s); }
int number(CGAL::Sign s) { return static_cast<int>(s); }
int number(double x) { return (x > 0) - (x < 0); }

double* tetgen(const Point2& p) { return const_cast<double*>(&p.x); }
double* tetgen(const Point3& p) { return const_cast<double*>(&p.x); }
Cgal::Point_2 cgal(const Point2& p) { return {p.x, p.y}; }
Cgal::Point_3 cgal(const Point3& p) { return {p.x, p.y, p.z}; }

struct Orient2d {
  static constexpr const char* name = "orient2d";
  static constexpr std::size_t arity = 3;
  static void batch(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 3>> calls,
                    std::span<Sign> signs) {
    k::orient2d(points, calls, signs);
  }
  static int ours(const Point2& a, const Point2& b, const Point2& c) { return number(k::orient2d(a, b, c)); }
  static int bare(const Point2& a, const Point2& b, const Point2& c) {
    return number((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
  }
  static int cgals(const Cgal::Point_2& a, const Cgal::Point_2& b, const Cgal::Point_2& c) {
    return number(Cgal().orientation_2_object()(a, b, c));
  }
  static int tetgens(const Point2& a, const Point2& b, const Point2& c) {
    return number(::orient2d(tetgen(a), tetgen(b), tetgen(c)));
  }
};

struct Incircle {
  static constexpr const char* name = "incircle";
  static constexpr std::size_t arity = 4;
  static void batch(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 4>> calls,
                    std::span<Sign> signs) {
    k::incircle(points, calls, signs);
  }
  static int ours(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return number(k::incircle(a, b, c, d));
  }
  static int bare(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const leonhard::Vec2 u = a - d, v = b - d, w = c - d;
    return number(dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v));
  }
  static int cgals(const Cgal::Point_2& a, const Cgal::Point_2& b, const Cgal::Point_2& c,
                   const Cgal::Point_2& d) {
    return number(Cgal().side_of_oriented_circle_2_object()(a, b, c, d));
  }
  static int tetgens(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return number(::incircle(tetgen(a), tetgen(b), tetgen(c), tetgen(d)));
  }
};

struct Orient3d {
  static constexpr const char* name = "orient3d";
  static constexpr std::size_t arity = 4;
  static void batch(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> calls,
                    std::span<Sign> signs) {
    k::orient3d(points, calls, signs);
  }
  static int ours(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return number(k::orient3d(a, b, c, d));
  }
  static int bare(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return number(dot(cross(b - a, c - a), d - a));
  }
  static int cgals(const Cgal::Point_3& a, const Cgal::Point_3& b, const Cgal::Point_3& c,
                   const Cgal::Point_3& d) {
    return number(Cgal().orientation_3_object()(a, b, c, d));
  }
  static int tetgens(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return -number(::orient3d(tetgen(a), tetgen(b), tetgen(c), tetgen(d)));
  }
};

struct Insphere {
  static constexpr const char* name = "insphere";
  static constexpr std::size_t arity = 5;
  static void batch(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 5>> calls,
                    std::span<Sign> signs) {
    k::insphere(points, calls, signs);
  }
  static int ours(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return number(k::insphere(a, b, c, d, e));
  }
  static int bare(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    const leonhard::Vec3 u = a - e, v = b - e, w = c - e, t = d - e;
    const leonhard::Vec3 uv = cross(u, v), wt = cross(w, t);
    return number((dot(u, u) * dot(wt, v) - dot(v, v) * dot(wt, u)) +
                  (dot(w, w) * dot(uv, t) - dot(t, t) * dot(uv, w)));
  }
  static int cgals(const Cgal::Point_3& a, const Cgal::Point_3& b, const Cgal::Point_3& c,
                   const Cgal::Point_3& d, const Cgal::Point_3& e) {
    return number(Cgal().side_of_oriented_sphere_3_object()(a, b, c, d, e));
  }
  static int tetgens(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return -number(::insphere(tetgen(a), tetgen(b), tetgen(c), tetgen(d), tetgen(e)));
  }
};

// ---- timing ----

using Clock = std::chrono::steady_clock;

/// Keeps the compiler from leaving work out.
volatile int sink;

template <class Work>
double seconds_of(Work work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The answers' sum over all calls of the input.
template <auto function, std::size_t Arity, class Point, class Calls>
[[gnu::noinline]] int run_all(const std::vector<Point>& points, const Calls& calls) {
  int sum = 0;
  for (const auto& call : calls) sum += [&]<std::size_t... I>(std::index_sequence<I...>) {
      return function(points[call[I]]...);
    }
  (std::make_index_sequence<Arity>());
  return sum;
}

/// Each predicate's four forms.
enum Form : std::size_t { ours, bare, cgals, tetgens, form_count };

template <class P, class Point, std::size_t Count>
std::array<double, form_count> shortest_turns(const Input<Point, Count>& input) {
  using CgalPoint = decltype(cgal(Point{}));
  std::vector<CgalPoint> cgal_points;
  for (const Point& p : input.points) cgal_points.push_back(cgal(p));
  std::array<double, form_count> shortest;
  shortest.fill(1e9);
  const auto deadline = Clock::now() + std::chrono::milliseconds(400);
  do {
    const std::array<double, form_count> turn{
        seconds_of([&] { sink = run_all<P::ours, P::arity>(input.points, input.calls); }),
        seconds_of([&] { sink = run_all<P::bare, P::arity>(input.points, input.calls); }),
        seconds_of([&] { sink = run_all<P::cgals, P::arity>(cgal_points, input.calls); }),
        seconds_of([&] { sink = run_all<P::tetgens, P::arity>(input.points, input.calls); })};
    for (std::size_t i = 0; i < form_count; ++i) shortest[i] = std::min(shortest[i], turn[i]);
  } while (Clock::now() < deadline);
  return shortest;
}

/// How many calls a form answers otherwise than ours does.
template <class P, auto function, class OurPoint, class Point, class Calls>
std::size_t differences(const std::vector<OurPoint>& our_points, const std::vector<Point>& points,
                        const Calls& calls) {
  std::size_t count = 0;
  for (const auto& call : calls) count += [&]<std::size_t... I>(std::index_sequence<I...>) {
      return P::ours(our_points[call[I]]...) != function(points[call[I]]...);
    }
  (std::make_index_sequence<P::arity>());
  return count;
}

template <class P, class Point, std::size_t Count>
void compare(const std::string& words, const Input<Point, Count>& input) {
  const auto shortest = shortest_turns<P>(input);
  std::vector<decltype(cgal(Point{}))> cgal_points;
  for (const Point& p : input.points) cgal_points.push_back(cgal(p));
  const auto calls = static_cast<double>(input.calls.size());
  const auto ns = [&](Form form) { return 1e9 * shortest[form] / calls; };
  const auto wrong = [&](std::size_t count) { return 100 * static_cast<double>(count) / calls; };
  fmt::print(
      "{:<9} {:<15} {:8.2f} {:8.2f} {:8.2f} {:8.2f}   {:8.2f} {:8.2f} {:8.2f}   {:6.1f} {:6.1f} {:6.1f}\n",
      P::name, words, ns(ours), ns(bare), ns(cgals), ns(tetgens), ns(ours) / ns(bare), ns(ours) / ns(cgals),
      ns(ours) / ns(tetgens), wrong(differences<P, P::bare>(input.points, input.points, input.calls)),
      wrong(differences<P, P::cgals>(input.points, cgal_points, input.calls)),
      wrong(differences<P, P::tetgens>(input.points, input.points, input.calls)));
  std::fflush(stdout);
}

// ---- batches ----

template <class P, class Point, std::size_t Count>
void compare_batch(const char* words, std::vector<Point> points) {
  Random random(3);
  const auto calls =
      leonhard::benching::random_calls<Count>(std::max(points.size(), call_count), points.size(), random);
  std::vector<Sign> signs(calls.size());
  double scalar = 1e9, batch = 1e9;
  const auto deadline = Clock::now() + std::chrono::milliseconds(600);
  do {
    scalar = std::min(scalar, seconds_of([&] { sink = run_all<P::ours, Count>(points, calls); }));
    batch = std::min(batch, seconds_of([&] { P::batch(points, calls, signs); }));
  } while (Clock::now() < deadline);
  const double calls_made = static_cast<double>(calls.size());
  fmt::print("{:<9} {:<15} {:8.2f} {:8.2f}   {:8.2f}\n", P::name, words, 1e9 * scalar / calls_made,
             1e9 * batch / calls_made, scalar / batch);
}

// ---- orders ----

template <class Point>
std::vector<Point> uniform_points(std::size_t count) {
  Random random(2);
  std::vector<Point> points(count);
  for (Point& p : points) {
    p = {unit(random), unit(random)};
    if constexpr (std::is_same_v<Point, Point3>) p.z = unit(random);
  }
  return points;
}

template <std::size_t Size>
void compare_batches(const char* words) {
  compare_batch<Orient2d, Point2, 3>(words, uniform_points<Point2>(Size));
  compare_batch<Incircle, Point2, 4>(words, uniform_points<Point2>(Size));
  compare_batch<Orient3d, Point3, 4>(words, uniform_points<Point3>(Size));
  compare_batch<Insphere, Point3, 5>(words, uniform_points<Point3>(Size));
}

/// Ours gives indices and leaves the points alone, CGAL's sorts the points themselves.
template <class Point>
void compare_orders(const char* words) {
  const auto points = uniform_points<Point>(1'000'000);
  std::vector<decltype(cgal(Point{}))> cgal_points;
  for (const Point& p : points) cgal_points.push_back(cgal(p));
  std::array<double, 4> shortest;
  shortest.fill(1e9);
  for (int turn = 0; turn < 5; ++turn) {
    auto hilbert_sorted = cgal_points, spatially_sorted = cgal_points;
    const std::array<double, 4> seconds{
        seconds_of([&] { sink = static_cast<int>(k::hilbert_order(points)[0]); }),
        seconds_of([&] { sink = static_cast<int>(k::brio_order(points, 1)[0]); }),
        seconds_of([&] { CGAL::hilbert_sort(hilbert_sorted.begin(), hilbert_sorted.end()); }),
        seconds_of([&] { CGAL::spatial_sort(spatially_sorted.begin(), spatially_sorted.end()); })};
    for (std::size_t i = 0; i < seconds.size(); ++i) shortest[i] = std::min(shortest[i], seconds[i]);
  }
  fmt::print("{:<6} {:14.1f} {:14.1f} {:14.1f} {:14.1f}   {:20.2f} {:20.2f}\n", words, 1e3 * shortest[0],
             1e3 * shortest[1], 1e3 * shortest[2], 1e3 * shortest[3], shortest[0] / shortest[3],
             shortest[1] / shortest[3]);
}

}  // namespace

int main() {
  exactinit(0, 0, 0, 2, 2,
            2);  // TetGen's static bounds, for the box of its input; all inputs here fit, but the grids
  fmt::print("{:<25} {:^35}   {:^26}   {:^20}\n", "", "ns a call", "Leonhard's time over",
             "% answered otherwise");
  fmt::print("{:<9} {:<15} {:>8} {:>8} {:>8} {:>8}   {:>8} {:>8} {:>8}   {:>6} {:>6} {:>6}\n", "predicate",
             "points", "Leonhard", "bare", "CGAL", "TetGen", "bare", "CGAL", "TetGen", "bare", "CGAL",
             "TetGen");
  for (const auto& [words, input] : leonhard::benching::inputs_of_the_plane()) {
    compare<Orient2d>(words, input);
    compare<Incircle>(words, input);
  }
  for (const auto& [words, input] : leonhard::benching::inputs_of_space()) {
    compare<Orient3d>(words, input);
    compare<Insphere>(words, input);
  }
  fmt::print("\nby id, one by one and in a batch, ns a call\n{:<9} {:<15} {:>8} {:>8}   {:>8}\n", "predicate",
             "points", "one", "batch", "one over batch");
  compare_batches<500>("500 uniform");  // fit the first-level cache, the next ones the second
  compare_batches<4096>("4096 uniform");
  compare_batches<1'000'000>("10^6 uniform");
  fmt::print("\n10^6 uniform points, ms\n{:<6} {:>14} {:>14} {:>14} {:>14}   {:>20} {:>20}\n", "",
             "hilbert_order", "brio_order", "CGAL hilbert", "CGAL spatial", "hilbert over spatial",
             "brio over spatial");
  compare_orders<Point2>("plane");
  compare_orders<Point3>("space");
}
