// SPDX-License-Identifier: MIT
// The 2-D Delaunay triangulation beside CGAL's: same points, turn and turn about; the shortest turn of each counts. Ours
// is the whole way from points in any order to a mesh with neighbours, in the input's numbering; CGAL's is its insertion
// of a range.
//   compare_delaunay2d [POINTS = 1000000] [THREADS = 2] [TURNS = 3]
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

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

void compare(const std::string& name, const Points& points, unsigned threads, int turns) {
  std::vector<Cgal::Point_2> cgal_points;
  for (const Point2 p : points) cgal_points.emplace_back(p.x, p.y);
  double one = 1e9, several = 1e9, cgals = 1e9;
  std::size_t cgal_faces = 0;
  for (int turn = 0; turn < turns; ++turn) {
    one = std::min(one, our_seconds(points, 1));
    several = std::min(several, our_seconds(points, threads));
    CgalTriangulation cgal;
    cgals = std::min(cgals, seconds_of([&] { cgal.insert(cgal_points.begin(), cgal_points.end()); }));
    cgal_faces = cgal.number_of_faces();
  }
  const auto n = static_cast<double>(points.size());
  Points input = points;
  TriangleMesh mesh;
  const double memory =
      static_cast<double>(benching::peak_bytes_of([&] { mesh = ours(std::move(input), 1); })) / n;
  const double cgal_memory = static_cast<double>(benching::peak_bytes_of([&] {
                               CgalTriangulation cgal;
                               cgal.insert(cgal_points.begin(), cgal_points.end());
                             })) /
                             n;
  const bool same = mesh.triangle_count() == cgal_faces &&
                    mesh::fingerprint(mesh) == mesh::fingerprint(ours(points, threads));
  fmt::print("{:<10} {:9.3f} {:9.3f} {:9.3f}   {:9.2f} {:9.2f}   {:9.0f} {:9.0f}   {}\n", name, one, several,
             cgals, one / cgals, several / cgals, memory, cgal_memory, same ? "yes" : "NO");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, long otherwise) { return argc > i ? std::atol(argv[i]) : otherwise; };
  const auto n = static_cast<std::size_t>(argument(1, 1'000'000));
  const auto threads = static_cast<unsigned>(argument(2, 2));
  const int turns = static_cast<int>(argument(3, 3));
  fmt::print("{} points\n{:<10} {:^29}   {:^19}   {:^19}\n", n, "", "seconds", "over CGAL's",
             "bytes a point");
  fmt::print("{:<10} {:>9} {:>9} {:>9}   {:>9} {:>9}   {:>9} {:>9}   {}\n", "points", "1 thread",
             fmt::format("{} threads", threads), "CGAL", "1 thread", fmt::format("{} threads", threads),
             "Leonhard", "CGAL", "same triangle count");
  for (const benching::PointSet& set : benching::point_sets) compare(set.name, set.points(n), threads, turns);

  fmt::print("\nuniform points, 1 thread\n{:>10} {:>12} {:>12}\n", "points", "us a point", "over 10^6's");
  double at_a_million = 0;
  for (const std::size_t size : {std::size_t{1'000'000}, std::size_t{1'000}, std::size_t{10'000},
                                 std::size_t{100'000}, std::size_t{10'000'000}}) {
    if (size > 10 * n) continue;
    const Points points = benching::uniform_points(size);
    double shortest = 1e9;
    for (int turn = 0; turn < turns; ++turn) shortest = std::min(shortest, our_seconds(points, 1));
    const double microseconds = 1e6 * shortest / static_cast<double>(size);
    if (size == 1'000'000) at_a_million = microseconds;
    fmt::print("{:>10} {:>12.3f} {:>12.2f}\n", size, microseconds, microseconds / at_a_million);
    std::fflush(stdout);
  }
}
