// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bench/predicate_inputs.hpp"
#include "leonhard/kernel/sign.hpp"

/// How predicates are timed beside the bare determinant, which answers wrongly on hard points but sets the price to aim
/// at, and the oracle of rational numbers as the other end.
///
/// Points are reached through random indices, as a mesher reaches them, from a set that fits the second-level cache.
/// The counter `filtered` says which share of calls the filter decided; `times_bare` the time of a call over the bare
/// determinant's, measured turn and turn about in the same benchmark: the figure to quote.
///
/// A predicate is given as a struct of four static functions of its points, all by reference: predicate, bare, filtered
/// and oracle.
namespace leonhard::benching {

inline Sign rounded_sign(double x) { return sign_of(x); }

template <auto function, class Point, std::size_t Count, std::size_t... I>
int run_one(const Input<Point, Count>& input, const std::array<std::uint32_t, Count>& call,
            std::index_sequence<I...>) {
  return static_cast<int>(function(input.points[call[I]]...));
}

template <auto function, class Point, std::size_t Count>
int run_all(const Input<Point, Count>& input) {
  int sum = 0;
  for (const auto& call : input.calls)
    sum += run_one<function>(input, call, std::make_index_sequence<Count>());
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
template <class P, class Inputs>
void bench_predicate(benchmark::State& state, const Inputs& input) {
  double shortest = 1e9, shortest_bare = 1e9;
  for (auto _ : state) {
    const double seconds = seconds_of([&] { return run_all<P::predicate>(input); });
    const double bare = seconds_of([&] { return run_all<P::bare>(input); });
    shortest = std::min(shortest, seconds);
    shortest_bare = std::min(shortest_bare, bare);
    state.SetIterationTime(seconds);
  }
  const auto calls = static_cast<double>(input.calls.size());
  state.counters["ns_a_call"] = 1e9 * shortest / calls;
  state.counters["times_bare"] = shortest / shortest_bare;
  state.counters["filtered"] = run_all<P::filtered>(input) / calls;
}

template <class P, class Inputs>
void bench_oracle(benchmark::State& state, const Inputs& input) {
  double shortest = 1e9;
  for (auto _ : state) shortest = std::min(shortest, seconds_of([&] { return run_all<P::oracle>(input); }));
  state.counters["ns_a_call"] = 1e9 * shortest / static_cast<double>(input.calls.size());
}

/// Registers NAME/WORDS and NAME_oracle/WORDS for each named input.
template <class P, class Inputs>
void register_predicate(const std::string& name, const std::vector<std::pair<std::string, Inputs>>& inputs) {
  for (const auto& [words, input] : inputs) {
    benchmark::RegisterBenchmark((name + "/" + words).c_str(), bench_predicate<P, Inputs>, input)
        ->UseManualTime();
    benchmark::RegisterBenchmark((name + "_oracle/" + words).c_str(), bench_oracle<P, Inputs>, input);
  }
}

}  // namespace leonhard::benching
