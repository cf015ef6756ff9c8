// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "bench/memory.hpp"

/// What the comparisons of Delaunay triangulations in the plane and in space with CGAL's have in common. `Kind` tells
/// them apart:
///
/// Points, Mesh, Cgal        of the input, of ours and of CGAL's result
/// sets, uniform(n)          the point sets of bench/point_sets.hpp or bench/point_sets3.hpp
/// largest                   of the points whose time show_growth lists
/// ours(points, threads)     the mesh; cgal_point(p) one point for CGAL
namespace leonhard::peers {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The input is copied before the clock starts: it becomes the mesh's.
template <class Kind, class... Options>
double our_seconds(const typename Kind::Points& points, Options... options) {
  typename Kind::Points input = points;
  typename Kind::Mesh mesh;
  return seconds_of([&] { mesh = Kind::ours(std::move(input), options...); });
}

template <class Kind>
std::vector<typename Kind::Cgal::Point> cgal_points(const typename Kind::Points& points) {
  std::vector<typename Kind::Cgal::Point> result;
  for (const auto& p : points) result.push_back(Kind::cgal_point(p));
  return result;
}

template <class Kind>
void compare_memory(const char* name, const typename Kind::Points& points) {
  const auto for_cgal = cgal_points<Kind>(points);
  typename Kind::Points input = points;
  typename Kind::Mesh mesh;
  const std::size_t our_bytes = benching::peak_bytes_of([&] { mesh = Kind::ours(std::move(input), 1); });
  const std::size_t cgal_bytes = benching::peak_bytes_of([&] {
    typename Kind::Cgal cgal;
    cgal.insert(for_cgal.begin(), for_cgal.end());
  });
  const auto n = static_cast<double>(points.size());
  fmt::print("{:<10} {:9.0f} {:9.0f}\n", name, static_cast<double>(our_bytes) / n,
             static_cast<double>(cgal_bytes) / n);
}

/// In a process of its own, in which nothing has been allocated before.
template <class Kind>
void show_memory(std::size_t n) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child > 0) waitpid(child, nullptr, 0);
  if (child != 0) return;
  mallopt(M_MMAP_THRESHOLD, 1 << 17);  // what is freed goes back to the system, however large
  fmt::print("peak memory beyond the input, bytes a point\n{:<10} {:>9} {:>9}\n", "points", "Leonhard",
             "CGAL");
  for (const auto& set : Kind::sets) compare_memory<Kind>(set.name, set.points(n));
  std::fflush(stdout);
  _exit(0);
}

template <class Kind>
void show_growth(std::size_t largest, int turns) {
  fmt::print("\nuniform points, 1 thread\n{:>10} {:>12} {:>12}\n", "points", "us a point", "over 10^6's");
  double at_a_million = 0;
  for (const std::size_t n : {std::size_t{1'000'000}, std::size_t{1'000}, std::size_t{10'000},
                              std::size_t{100'000}, Kind::largest}) {
    if (n > largest) continue;
    const auto points = Kind::uniform(n);
    double shortest = 1e9;
    for (int turn = 0; turn < turns; ++turn) shortest = std::min(shortest, our_seconds<Kind>(points, 1U));
    const double microseconds = 1e6 * shortest / static_cast<double>(n);
    if (n == 1'000'000) at_a_million = microseconds;
    fmt::print("{:>10} {:>12.3f} {:>12.2f}\n", n, microseconds, microseconds / at_a_million);
    std::fflush(stdout);
  }
}

/// The arguments that both comparisons take: [POINTS = 1000000] [THREADS = 2] [TURNS = 3].
struct Arguments {
  std::size_t points;
  unsigned threads;
  int turns;

  Arguments(int argc, char** argv) {
    const auto argument = [&](int i, long otherwise) { return argc > i ? std::atol(argv[i]) : otherwise; };
    points = static_cast<std::size_t>(argument(1, 1'000'000));
    threads = static_cast<unsigned>(argument(2, 2));
    turns = static_cast<int>(argument(3, 3));
  }
};

}  // namespace leonhard::peers
