// SPDX-License-Identifier: MIT
// Predicates on easy and hard points beside the bare determinant, which answers wrongly on the hard ones but sets the
// price to aim at; the oracle of rational numbers as the other end; Hilbert order.
//
// Points are reached through random indices, as a mesher reaches them, from a set that fits the second-level cache.
// The counter `filtered` says which share of calls the filter decided; `times_bare` the time of a call over the bare
// determinant's, measured turn and turn about in the same benchmark: the figure to quote.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/exact.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Sign;
using leonhard::Vec2;

namespace {

using Random = std::mt19937_64;
constexpr std::size_t point_count = 4096;  // a power of two
constexpr std::size_t call_count = 4096;

struct Input {
  std::vector<Point2> points;
  std::vector<std::array<std::uint32_t, 4>> calls;  // indices of the four points
};

template <class Draw>
Input random_calls(Draw draw) {
  Random random(1);
  Input input;
  for (std::size_t i = 0; i < point_count; ++i) input.points.push_back(draw(random));
  std::uniform_int_distribution<std::uint32_t> any(0, point_count / 4 - 1);
  for (std::size_t i = 0; i < call_count; ++i)  // four different points: one of each quarter
    input.calls.push_back({4 * any(random), 4 * any(random) + 1, 4 * any(random) + 2, 4 * any(random) + 3});
  return input;
}

double unit(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

Input uniform() {
  return random_calls([](Random& r) { return Point2{unit(r), unit(r)}; });
}
Input line() {
  return random_calls([](Random& r) {
    const double t = unit(r);
    return Point2{t, 0.1 * t};
  });
}
Input circle() {
  return random_calls([](Random& r) {
    const double angle_rad = 6.283185307179586 * unit(r);
    return Point2{std::cos(angle_rad), std::sin(angle_rad)};
  });
}

/// Cells of a 64 x 64 grid of the given spacing: each call asks about the four corners of one cell, always a tie.
Input grid(double origin, double spacing) {
  Input input;
  for (std::uint32_t row = 0; row < 64; ++row)
    for (std::uint32_t column = 0; column < 64; ++column)
      input.points.push_back({origin + spacing * column, origin + spacing * row});
  for (std::uint32_t row = 0; row + 1 < 64; ++row)
    for (std::uint32_t column = 0; column + 1 < 64; ++column) {
      const std::uint32_t first = row * 64 + column;
      input.calls.push_back({first, first + 1, first + 65, first + 64});
    }
  return input;
}

Sign rounded_sign(double x) { return leonhard::sign_of(x); }

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

template <class Function>
int run_all(const Input& input, Function function) {
  int sum = 0;
  for (const auto& [a, b, c, d] : input.calls)
    sum += static_cast<int>(function(input.points[a], input.points[b], input.points[c], input.points[d]));
  return sum;
}

template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(work());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Times the predicate; in turns with it, outside the reported time, the bare determinant. The shortest turn of each
/// makes the ratio, which so survives a busy machine.
template <class P>
void bench_predicate(benchmark::State& state, const Input& input) {
  double shortest = 1e9, shortest_bare = 1e9;
  for (auto _ : state) {
    const double seconds = seconds_of([&] { return run_all(input, P::predicate); });
    const double bare = seconds_of([&] { return run_all(input, P::bare); });
    shortest = std::min(shortest, seconds);
    shortest_bare = std::min(shortest_bare, bare);
    state.SetIterationTime(seconds);
  }
  const auto calls = static_cast<double>(input.calls.size());
  state.counters["ns_a_call"] = 1e9 * shortest / calls;
  state.counters["times_bare"] = shortest / shortest_bare;
  state.counters["filtered"] = run_all(input, P::filtered) / calls;
}

template <class P>
void bench_oracle(benchmark::State& state, const Input& input) {
  double shortest = 1e9;
  for (auto _ : state) shortest = std::min(shortest, seconds_of([&] { return run_all(input, P::oracle); }));
  state.counters["ns_a_call"] = 1e9 * shortest / static_cast<double>(input.calls.size());
}

template <class P>
void register_predicate(const std::string& name) {
  const std::vector<std::pair<std::string, Input>> inputs{{"uniform", uniform()},
                                                          {"line", line()},
                                                          {"circle", circle()},
                                                          {"integer_grid", grid(0, 1)},
                                                          {"tenths_grid", grid(1.0 / 3, 0.1)},
                                                          {"tiny_grid", grid(0, 0x1p-1074)}};
  for (const auto& [words, input] : inputs) {
    benchmark::RegisterBenchmark((name + "/" + words).c_str(), bench_predicate<P>, input)->UseManualTime();
    benchmark::RegisterBenchmark((name + "_oracle/" + words).c_str(), bench_oracle<P>, input);
  }
}

void bench_hilbert_order(benchmark::State& state) {
  Random random(2);
  std::vector<Point2> points(static_cast<std::size_t>(state.range(0)));
  for (Point2& p : points) p = {unit(random), unit(random)};
  for (auto _ : state) benchmark::DoNotOptimize(k::hilbert_order(points));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(bench_hilbert_order)
    ->Name("hilbert_order")
    ->Arg(10'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);

const bool registered = [] {
  register_predicate<Orient2d>("orient2d");
  register_predicate<Incircle>("incircle");
  register_predicate<IncirclePerturbed>("incircle_perturbed");
  return true;
}();

}  // namespace
