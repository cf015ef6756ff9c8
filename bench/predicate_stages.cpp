// SPDX-License-Identifier: MIT
// Which stage of the predicates answers how often on which points: the table of docs/predicates.md, as Markdown.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/predicate_inputs.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/stage.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::benching::Input;

namespace {

constexpr std::size_t stage_count = static_cast<std::size_t>(k::Stage::rational);  // which these do not reach

struct Orient2d {
  static constexpr const char* name = "orient2d";
  static constexpr std::size_t arity = 3;
  static Sign sign(const Point2& a, const Point2& b, const Point2& c) { return k::orient2d(a, b, c); }
  static k::StagedSign staged(const Point2& a, const Point2& b, const Point2& c) {
    return k::orient2d_staged(a, b, c);
  }
};

struct Incircle {
  static constexpr const char* name = "incircle";
  static constexpr std::size_t arity = 4;
  static Sign sign(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return k::incircle(a, b, c, d);
  }
  static k::StagedSign staged(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return k::incircle_staged(a, b, c, d);
  }
};

struct Orient3d {
  static constexpr const char* name = "orient3d";
  static constexpr std::size_t arity = 4;
  static Sign sign(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return k::orient3d(a, b, c, d);
  }
  static k::StagedSign staged(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return k::orient3d_staged(a, b, c, d);
  }
};

struct Insphere {
  static constexpr const char* name = "insphere";
  static constexpr std::size_t arity = 5;
  static Sign sign(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return k::insphere(a, b, c, d, e);
  }
  static k::StagedSign staged(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                              const Point3& e) {
    return k::insphere_staged(a, b, c, d, e);
  }
};

template <auto function, std::size_t Arity, class Point, class Call>
auto ask(const std::vector<Point>& points, const Call& call) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return function(points[call[I]]...); }
  (std::make_index_sequence<Arity>());
}

/// The shortest of many turns over all calls.
template <class P, class Point, std::size_t Count>
double ns_a_call(const Input<Point, Count>& input) {
  using Clock = std::chrono::steady_clock;
  double shortest = 1e9;
  volatile int sink = 0;
  for (int turn = 0; turn < 50; ++turn) {
    const auto start = Clock::now();
    int sum = 0;
    for (const auto& call : input.calls) sum += static_cast<int>(ask<P::sign, P::arity>(input.points, call));
    sink = sum;
    shortest = std::min(shortest, std::chrono::duration<double>(Clock::now() - start).count());
  }
  (void)sink;
  return 1e9 * shortest / static_cast<double>(input.calls.size());
}

template <class P, class Point, std::size_t Count>
void print_row(const std::string& words, const Input<Point, Count>& input) {
  std::array<int, stage_count> answered{};
  for (const auto& call : input.calls)
    ++answered[static_cast<std::size_t>(ask<P::staged, P::arity>(input.points, call).stage)];
  std::printf("| %s | %s |", P::name, words.c_str());
  for (const int count : answered)
    if (count == 0)
      std::printf(" |");
    else
      std::printf(" %.2f |", 100.0 * count / static_cast<double>(input.calls.size()));
  std::printf(" %.1f |\n", ns_a_call<P>(input));
}

}  // namespace

int main() {
  std::puts(
      "| predicate | points | filter % | small integer % | integer % | double-double % | expansion % | "
      "wide filter % | wide exact % | ns a call |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|");
  for (const auto& [words, input] : leonhard::benching::inputs_of_the_plane()) {
    print_row<Orient2d>(words, input);
    print_row<Incircle>(words, input);
  }
  for (const auto& [words, input] : leonhard::benching::inputs_of_space()) {
    print_row<Orient3d>(words, input);
    print_row<Insphere>(words, input);
  }
}
