// SPDX-License-Identifier: MIT
// How the triangulation algorithms grow, as Markdown: time a point for each of them from 10^3 points to 10^N;
// the structural changes of Barth's figure 3.3.8 in its bad order and in random ones; the scopes of the
// triangles that randomised insertion makes, expected and measured.
//
//   bench_growth [N [SECONDS]]
//
// N is 5 unless told. An algorithm is not run where it would take longer than SECONDS, 60 unless told, by its
// growth so far.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "bench/point_sets.hpp"
#include "leonhard/delaunay/delaunay_tree.hpp"
#include "leonhard/delaunay/order/insertion_order.hpp"
#include "leonhard/delaunay/plane/green_sibson.hpp"
#include "leonhard/delaunay/plane/watson.hpp"
#include "leonhard/delaunay/scopes.hpp"
#include "leonhard/delaunay/triangulate.hpp"

namespace benching = leonhard::benching;
namespace d = leonhard::delaunay;
using benching::Points;
using benching::PointSet;

namespace {

double seconds(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The shortest of the runs that fit into a fifth of a second, one at least.
double shortest(const std::function<void()>& work) {
  double best = seconds(work);
  for (double left = 0.2 - best; left > 0;) {
    const double next = seconds(work);
    best = std::min(best, next);
    left -= next;
  }
  return best;
}

// ---- time a point ----

/// The time that a run ten times as large would take, by the growth of the last two.
double next_time(const std::vector<double>& times) {
  if (times.size() < 2) return 0;
  const double last = times[times.size() - 1], before = times[times.size() - 2];
  return last * std::max(10.0, last / before);
}

void print_times(const d::NamedAlgorithm& named, const PointSet& set, unsigned max_exponent, double limit) {
  std::printf("| %s | %s |", set.name, std::string(named.name).c_str());
  d::TriangulateOptions options;
  options.algorithm = named.algorithm;
  std::vector<double> times;
  for (unsigned exponent = 3; exponent <= max_exponent; ++exponent) {
    if (next_time(times) > limit) {
      std::printf(" cut |");
      continue;
    }
    const Points points = set.points(static_cast<std::size_t>(std::pow(10, exponent) + 0.5));
    times.push_back(shortest([&] { (void)d::triangulate(points, options); }));
    std::printf(" %.3f |", 1e6 * times.back() / static_cast<double>(points.size()));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_growth(unsigned max_exponent, double limit) {
  std::printf("Microseconds a point, from points to mesh, one thread; cut: would take longer than %g s.\n\n",
              limit);
  std::printf("| points | algorithm |");
  for (unsigned exponent = 3; exponent <= max_exponent; ++exponent) std::printf(" 10^%u |", exponent);
  std::printf("\n|---|---|");
  for (unsigned exponent = 3; exponent <= max_exponent; ++exponent) std::printf("---:|");
  std::printf("\n");
  for (const PointSet& set : benching::point_sets)
    for (const d::NamedAlgorithm& named : d::named_algorithms) print_times(named, set, max_exponent, limit);
}

// ---- figure 3.3.8 ----

/// Figure 3.3.8: a column, then a row to its right that comes nearer and nearer.
Points column_and_row(std::size_t n) {
  Points points;
  const auto step = [&](std::size_t i) { return 2 * static_cast<double>(i) / static_cast<double>(n); };
  for (std::size_t i = 0; i < n / 2; ++i) points.push_back({0, 2 * step(i) - 1});
  for (std::size_t i = 0; i < n / 2; ++i) points.push_back({3 - step(i), 0});
  return points;
}

std::vector<std::uint32_t> as_given(std::size_t n) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

void print_row(std::size_t n, const char* words, const std::function<std::size_t()>& insert) {
  std::size_t changes = 0;
  const double time = shortest([&] { changes = insert(); });
  std::printf("| %zu | %s | %zu | %.2f | %.2f |\n", n, words, changes,
              static_cast<double>(changes) / static_cast<double>(n), 1e6 * time / static_cast<double>(n));
  std::fflush(stdout);
}

void print_figure_3_3_8() {
  std::printf(
      "\nFigure 3.3.8: triangles made, ghost triangles and those of intermediate swaps included.\n\n");
  std::printf(
      "| points | algorithm and order | triangles | a point | us a point |\n|---:|---|---:|---:|---:|\n");
  for (const std::size_t n : {1000, 2000, 4000, 8000}) {
    const Points points = column_and_row(n);
    print_row(n, "Watson, as given",
              [&] { return d::insert_watson(points, as_given(n)).structural_changes; });
    print_row(n, "Watson, random",
              [&] { return d::insert_watson(points, d::random_order(n, 1)).structural_changes; });
    print_row(n, "Green and Sibson, as given",
              [&] { return d::insert_green_sibson(points, as_given(n)).structural_changes; });
    print_row(n, "Green and Sibson, random",
              [&] { return d::insert_green_sibson(points, d::random_order(n, 1)).structural_changes; });
    print_row(n, "Delaunay tree, as given",
              [&] { return d::DelaunayTree(points, as_given(n)).structural_changes(); });
    print_row(n, "Delaunay tree, random",
              [&] { return d::DelaunayTree(points, d::random_order(n, 1)).structural_changes(); });
  }
}

// ---- scopes ----

void print_scopes() {
  constexpr std::size_t n = 60, draws = 1000;
  const Points sites = benching::uniform_points(n);
  const std::vector<std::size_t> existing = d::triangles_of_scope(sites);
  std::vector<double> seen(existing.size(), 0);
  for (std::uint64_t seed = 1; seed <= draws; ++seed)
    d::for_each_delaunay_ever(d::DelaunayTree(sites, d::random_order(n, seed)),
                              [&](const d::Corners& corners) {
                                if (corners[0] != d::GhostTriangulation::ghost)
                                  seen[d::scope(sites, corners)] += 1.0 / draws;
                              });
  std::printf(
      "\nTriangles of scope j that are ever Delaunay: %zu uniform sites, mean of %zu random orders.\n\n", n,
      draws);
  std::printf("| j | triangles T_j | 3! j! / (j + 3)! | expected | measured |\n|---:|---:|---:|---:|---:|\n");
  double all_expected = 0;
  for (std::size_t j = 0; j < existing.size(); ++j) {
    const double probability = d::appearance_probability(j),
                 expected = probability * static_cast<double>(existing[j]);
    all_expected += expected;
    if (j <= 10 || j % 10 == 0)
      std::printf("| %zu | %zu | %.6f | %.3f | %.3f |\n", j, existing[j], probability, expected, seen[j]);
  }
  std::printf("| all | | | %.3f | %.3f |\n", all_expected, std::accumulate(seen.begin(), seen.end(), 0.0));
}

}  // namespace

int main(int argc, char** argv) {
  const int max_exponent = argc > 1 ? std::atoi(argv[1]) : 5;
  const double limit = argc > 2 ? std::atof(argv[2]) : 60;
  if (max_exponent < 3 || max_exponent > 8 || !(limit > 0)) {
    std::fprintf(stderr, "usage: %s [N [SECONDS]]  with 3 <= N <= 8\n", argv[0]);
    return 2;
  }
  print_growth(static_cast<unsigned>(max_exponent), limit);
  print_figure_3_3_8();
  print_scopes();
}
