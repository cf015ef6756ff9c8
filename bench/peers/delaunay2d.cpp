// SPDX-License-Identifier: MIT
// The 2-D Delaunay triangulation beside CGAL's: same points, turn and turn about; the shortest turn of each counts. Ours
// is the whole way from points in any order to a mesh with neighbours, in the input's numbering; CGAL's is its insertion
// of a range.
//   compare_delaunay2d [POINTS = 1000000] [THREADS = 2] [TURNS = 3]
#include <CGAL/Delaunay_triangulation_2.h>
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
#include <string>
#include <utility>
#include <vector>

#include "bench/memory.hpp"
#include "bench/point_sets.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/mesh/fingerprint.hpp"

namespace {

using namespace leonhard;
using benching::Points;
using Cgal = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalTriangulation = CGAL::Delaunay_triangulation_2<Cgal>;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TriangleMesh ours(Points points, unsigned threads) {
  delaunay::TriangulateOptions options;
  options.threads = threads;
  return delaunay::triangulate(std::move(points), options).mesh;
}

/// The input is copied before the clock starts: it becomes the mesh's.
double our_seconds(const Points& points, unsigned threads) {
  Points input = points;
  TriangleMesh mesh;
  return seconds_of([&] { mesh = ours(std::move(input), threads); });
}

std::vector<Cgal::Point_2> cgal_points(const Points& points) {
  std::vector<Cgal::Point_2> result;
  for (const Point2 p : points) result.emplace_back(p.x, p.y);
  return result;
}

void compare_times(const char* name, const Points& points, unsigned threads, int turns) {
  const std::vector<Cgal::Point_2> for_cgal = cgal_points(points);
  double one = 1e9, several = 1e9, cgals = 1e9;
  std::size_t cgal_faces = 0;
  for (int turn = 0; turn < turns; ++turn) {
    one = std::min(one, our_seconds(points, 1));
    several = std::min(several, our_seconds(points, threads));
    CgalTriangulation cgal;
    cgals = std::min(cgals, seconds_of([&] { cgal.insert(for_cgal.begin(), for_cgal.end()); }));
    cgal_faces = cgal.number_of_faces();
  }
  const TriangleMesh mesh = ours(points, 1);
  const bool same = mesh.triangle_count() == cgal_faces &&
                    mesh::fingerprint(mesh) == mesh::fingerprint(ours(points, threads));
  fmt::print("{:<10} {:9.3f} {:9.3f} {:9.3f}   {:9.2f} {:9.2f}   {}\n", name, one, several, cgals,
             one / cgals, several / cgals, same ? "yes" : "NO");
  std::fflush(stdout);
}

void compare_memory(const char* name, const Points& points) {
  const std::vector<Cgal::Point_2> for_cgal = cgal_points(points);
  Points input = points;
  TriangleMesh mesh;
  const std::size_t our_bytes = benching::peak_bytes_of([&] { mesh = ours(std::move(input), 1); });
  const std::size_t cgal_bytes = benching::peak_bytes_of([&] {
    CgalTriangulation cgal;
    cgal.insert(for_cgal.begin(), for_cgal.end());
  });
  const auto n = static_cast<double>(points.size());
  fmt::print("{:<10} {:9.0f} {:9.0f}\n", name, static_cast<double>(our_bytes) / n,
             static_cast<double>(cgal_bytes) / n);
}

/// In a process of its own, in which nothing has been allocated before.
void show_memory(std::size_t n) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child > 0) waitpid(child, nullptr, 0);
  if (child != 0) return;
  mallopt(M_MMAP_THRESHOLD, 1 << 17);  // what is freed goes back to the system, however large
  fmt::print("peak memory beyond the input, bytes a point\n{:<10} {:>9} {:>9}\n", "points", "Leonhard",
             "CGAL");
  for (const benching::PointSet& set : benching::point_sets) compare_memory(set.name, set.points(n));
  std::fflush(stdout);
  _exit(0);
}

void show_growth(std::size_t largest, int turns) {
  fmt::print("\nuniform points, 1 thread\n{:>10} {:>12} {:>12}\n", "points", "us a point", "over 10^6's");
  double at_a_million = 0;
  for (const std::size_t n : {std::size_t{1'000'000}, std::size_t{1'000}, std::size_t{10'000},
                              std::size_t{100'000}, std::size_t{10'000'000}}) {
    if (n > largest) continue;
    const Points points = benching::uniform_points(n);
    double shortest = 1e9;
    for (int turn = 0; turn < turns; ++turn) shortest = std::min(shortest, our_seconds(points, 1));
    const double microseconds = 1e6 * shortest / static_cast<double>(n);
    if (n == 1'000'000) at_a_million = microseconds;
    fmt::print("{:>10} {:>12.3f} {:>12.2f}\n", n, microseconds, microseconds / at_a_million);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, long otherwise) { return argc > i ? std::atol(argv[i]) : otherwise; };
  const auto n = static_cast<std::size_t>(argument(1, 1'000'000));
  const auto threads = static_cast<unsigned>(argument(2, 2));
  const int turns = static_cast<int>(argument(3, 3));
  show_memory(n);
  fmt::print("\n{} points\n{:<10} {:^29}   {:^19}\n", n, "", "seconds", "over CGAL's");
  const std::string several = fmt::format("{} threads", threads);
  fmt::print("{:<10} {:>9} {:>9} {:>9}   {:>9} {:>9}   {}\n", "points", "1 thread", several, "CGAL",
             "1 thread", several, "same triangles");
  for (const benching::PointSet& set : benching::point_sets)
    compare_times(set.name, set.points(n), threads, turns);
  show_growth(10 * n, turns);
}
