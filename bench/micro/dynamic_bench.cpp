// SPDX-License-Identifier: MIT
// The dynamic triangulation on a million points: what a change and what a query costs. Times are per
// operation.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/predicate_inputs.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"

namespace {

using leonhard::MaybeId;
using leonhard::Point2;
using leonhard::VertexId;
using leonhard::benching::Random;
using leonhard::benching::unit;
using leonhard::delaunay::DynamicTriangulation;

std::vector<Point2> uniform(std::size_t count, std::uint32_t seed) {
  Random random(seed);
  std::vector<Point2> points(count);
  for (Point2& p : points) p = {unit(random), unit(random)};
  return points;
}

const std::vector<Point2>& million() {
  static const std::vector<Point2> points = uniform(1'000'000, 3);
  return points;
}
const std::vector<Point2>& queries() {
  static const std::vector<Point2> points = uniform(100'000, 4);
  return points;
}
const std::vector<double>& values() {
  static const std::vector<double> all(million().size() + queries().size(), 1.0);  // insert makes ids, too
  return all;
}
DynamicTriangulation& sites() {
  static DynamicTriangulation all(million());
  return all;
}

void set_time_each(benchmark::State& state, std::size_t operations) {
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(operations),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void build_at_once(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(DynamicTriangulation(million()).size());
  set_time_each(state, million().size());
}

/// Points at random places come to the million, without a hint, and go.
void insert_then_remove(benchmark::State& state, bool timing_removal) {
  DynamicTriangulation& all = sites();
  std::vector<VertexId> added(queries().size());
  const auto insert = [&] {
    for (std::size_t i = 0; i < added.size(); ++i) added[i] = all.insert(queries()[i]).vertex;
  };
  const auto remove = [&] {
    for (const VertexId v : added) all.remove(v);
  };
  for (auto _ : state) {
    if (timing_removal) state.PauseTiming();
    insert();
    timing_removal ? state.ResumeTiming() : state.PauseTiming();
    remove();
    if (!timing_removal) state.ResumeTiming();
  }
  set_time_each(state, added.size());
}

/// A query of each of 100 000 random points, one by one.
template <class Query>
void ask_each(benchmark::State& state, Query query) {
  for (auto _ : state)
    for (const Point2 p : queries()) benchmark::DoNotOptimize(query(p));
  set_time_each(state, queries().size());
}

/// All of them in one call.
template <class Query>
void ask_batch(benchmark::State& state, Query query) {
  for (auto _ : state) benchmark::DoNotOptimize(query(static_cast<unsigned>(state.range(0))).size());
  set_time_each(state, queries().size());
}

const bool registered = [] {
  const auto add = [](const char* name, auto function) {
    return benchmark::RegisterBenchmark(name, function)->Unit(benchmark::kMillisecond);
  };
  add("build_at_once", build_at_once);
  add("insert", [](benchmark::State& state) { insert_then_remove(state, false); });
  add("remove", [](benchmark::State& state) { insert_then_remove(state, true); });
  add("locate", [](benchmark::State& state) { ask_each(state, [](Point2 p) { return sites().locate(p); }); });
  add("locate_near_hint", [](benchmark::State& state) {
    const std::vector<MaybeId<VertexId>> hints = sites().nearest_vertices(queries());
    std::size_t i = 0;
    ask_each(state, [&](Point2 p) { return sites().locate(p, hints[i++ % hints.size()]); });
  });
  add("nearest_vertex",
      [](benchmark::State& state) { ask_each(state, [](Point2 p) { return sites().nearest_vertex(p); }); });
  add("interpolate_linear", [](benchmark::State& state) {
    ask_each(state, [](Point2 p) { return sites().interpolate_linear(p, values()).value; });
  });
  add("interpolate_natural_neighbour", [](benchmark::State& state) {
    ask_each(state, [](Point2 p) { return sites().interpolate_natural_neighbour(p, values()).value; });
  });
  const auto add_batch = [&](const char* name, auto query) {
    add(name, [query](benchmark::State& state) { ask_batch(state, query); })->UseRealTime()->Arg(1)->Arg(2);
  };
  add_batch("locate_batch", [](unsigned threads) { return sites().locate(queries(), threads); });
  add_batch("nearest_batch", [](unsigned threads) { return sites().nearest_vertices(queries(), threads); });
  add_batch("linear_batch",
            [](unsigned threads) { return sites().interpolate_linear(queries(), values(), threads); });
  add_batch("natural_neighbour_batch", [](unsigned threads) {
    return sites().interpolate_natural_neighbour(queries(), values(), threads);
  });
  return true;
}();

}  // namespace
