// SPDX-License-Identifier: MIT
// Predicates of the plane on easy and hard points, and insertion orders; predicate_bench.hpp says what is measured.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/micro/predicate_bench.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/insertion_order.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::Vec2;
using leonhard::benching::Random;
using leonhard::benching::rounded_sign;
using leonhard::benching::unit;

namespace {

// Each predicate, the bare determinant, the filter and the oracle in one form: (a, b, c, d).
struct Orient2d {
  static Sign predicate(const Point2& a, const Point2& b, const Point2& c, const Point2&) {
    return k::orient2d(a, b, c);
  }
  static Sign bare(const Point2& a, const Point2& b, const Point2& c, const Point2&) {
    return rounded_sign((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
  }
  static bool filtered(const Point2& a, const Point2& b, const Point2& c, const Point2&) {
    return k::orient2d_filter(a, b, c).is_certain();
  }
  static Sign oracle(const Point2& a, const Point2& b, const Point2& c, const Point2&) {
    return k::exact::orient2d(a, b, c);
  }
};

struct Incircle {
  static Sign predicate(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return k::incircle(a, b, c, d);
  }
  static Sign bare(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const Vec2 u = a - d, v = b - d, w = c - d;
    return rounded_sign(dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v));
  }
  static bool filtered(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return k::incircle_filter(a, b, c, d).is_certain();
  }
  static Sign oracle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return k::exact::incircle(a, b, c, d);
  }
};

struct IncirclePerturbed : Incircle {
  static Sign predicate(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return k::incircle_perturbed(a, b, c, d);
  }
};

template <class Point>
std::vector<Point> uniform_points(std::int64_t count) {
  Random random(2);
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (Point& p : points) {
    p = {unit(random), unit(random)};
    if constexpr (std::is_same_v<Point, Point3>) p.z = unit(random);
  }
  return points;
}

template <class Point>
void bench_hilbert_order(benchmark::State& state) {
  const auto points = uniform_points<Point>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(k::hilbert_order(points));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
template <class Point>
void bench_brio_order(benchmark::State& state) {
  const auto points = uniform_points<Point>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(k::brio_order(points, 1));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void register_order(const char* name, void (*function)(benchmark::State&)) {
  benchmark::RegisterBenchmark(name, function)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  const auto inputs = leonhard::benching::inputs_of_the_plane();
  leonhard::benching::register_predicate<Orient2d>("orient2d", inputs);
  leonhard::benching::register_predicate<Incircle>("incircle", inputs);
  leonhard::benching::register_predicate<IncirclePerturbed>("incircle_perturbed", inputs);
  register_order("hilbert_order", bench_hilbert_order<Point2>);
  register_order("hilbert_order_3d", bench_hilbert_order<Point3>);
  register_order("brio_order", bench_brio_order<Point2>);
  register_order("brio_order_3d", bench_brio_order<Point3>);
  return true;
}();

}  // namespace
