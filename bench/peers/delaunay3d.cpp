// SPDX-License-Identifier: MIT
// The Delaunay tetrahedralisation beside CGAL's and TetGen's: same points, turn and turn about; the shortest turn of each
// counts. Ours is the whole way from points in any order to a mesh with neighbours, in the input's numbering; CGAL's is
// its insertion of a range, TetGen's its tetrahedralize of points.
//   compare_delaunay3d [POINTS = 1000000] [THREADS = 2] [TURNS = 3] [SET...]
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sys/wait.h>
#define TETLIBRARY  // as Debian builds it: tetrahedralize(switches, in, out)
#include <tetgen.h>
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
#include "bench/point_sets3.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"

namespace {

using namespace leonhard;
using benching::Points3;
using Cgal = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalTriangulation = CGAL::Delaunay_triangulation_3<Cgal>;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TetMesh ours(Points3 points, unsigned threads, bool sorted = true) {
  delaunay::TetrahedralizeOptions options;
  options.threads = threads;
  options.sorted = sorted;
  return delaunay::tetrahedralize(std::move(points), options).mesh;
}

/// The input is copied before the clock starts: it becomes the mesh's.
double our_seconds(const Points3& points, unsigned threads, bool sorted = true) {
  Points3 input = points;
  TetMesh mesh;
  return seconds_of([&] { mesh = ours(std::move(input), threads, sorted); });
}

std::vector<Cgal::Point_3> cgal_points(const Points3& points) {
  std::vector<Cgal::Point_3> result;
  for (const Point3& p : points) result.emplace_back(p.x, p.y, p.z);
  return result;
}

double tetgen_seconds(const Points3& points, std::size_t& tetrahedra) {
  tetgenio in, out;
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[3 * points.size()];  // freed by tetgenio
  for (std::size_t i = 0; i < points.size(); ++i) {
    in.pointlist[3 * i] = points[i].x;
    in.pointlist[3 * i + 1] = points[i].y;
    in.pointlist[3 * i + 2] = points[i].z;
  }
  char switches[] = "Q";
  const double seconds = seconds_of([&] { tetrahedralize(switches, &in, &out); });
  tetrahedra = static_cast<std::size_t>(out.numberoftetrahedra);
  return seconds;
}

void compare_times(const char* name, const Points3& points, unsigned threads, int turns) {
  const std::vector<Cgal::Point_3> for_cgal = cgal_points(points);
  double one = 1e9, unsorted = 1e9, several = 1e9, cgals = 1e9, tetgens = 1e9;
  std::size_t cgal_tets = 0, tetgen_tets = 0;
  for (int turn = 0; turn < turns; ++turn) {
    one = std::min(one, our_seconds(points, 1));
    unsorted = std::min(unsorted, our_seconds(points, 1, false));
    several = std::min(several, our_seconds(points, threads));
    CgalTriangulation cgal;
    cgals = std::min(cgals, seconds_of([&] { cgal.insert(for_cgal.begin(), for_cgal.end()); }));
    cgal_tets = cgal.number_of_finite_cells();
    tetgens = std::min(tetgens, tetgen_seconds(points, tetgen_tets));
  }
  const TetMesh mesh = ours(points, 1);
  fmt::print(
      "{:<10} {:8.3f} {:8.3f} {:9.3f} {:8.3f} {:8.3f}   {:8.2f} {:8.2f} {:9.2f} {:8.2f}   {:9} {:9} {:9}  "
      "{}\n",
      name, one, unsorted, several, cgals, tetgens, one / cgals, unsorted / cgals, several / cgals,
      one / several, mesh.tet_count(), cgal_tets, tetgen_tets, mesh == ours(points, threads) ? "yes" : "NO");
  std::fflush(stdout);
}

void compare_memory(const char* name, const Points3& points) {
  const std::vector<Cgal::Point_3> for_cgal = cgal_points(points);
  Points3 input = points;
  TetMesh mesh;
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
  for (const benching::PointSet3& set : benching::point_sets3) compare_memory(set.name, set.points(n));
  std::fflush(stdout);
  _exit(0);
}

void show_growth(std::size_t largest, int turns) {
  fmt::print("\nuniform points, 1 thread\n{:>10} {:>12} {:>12}\n", "points", "us a point", "over 10^6's");
  double at_a_million = 0;
  for (const std::size_t n : {std::size_t{1'000'000}, std::size_t{1'000}, std::size_t{10'000},
                              std::size_t{100'000}, std::size_t{4'000'000}}) {
    if (n > largest) continue;
    const Points3 points = benching::uniform_points3(n);
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
  const std::vector<std::string> wanted(argv + std::min(argc, 4), argv + argc);
  if (wanted.empty()) show_memory(n);
  fmt::print("\n{} points\n{:<10} {:^46}   {:^36}   {:^29}\n", n, "", "seconds", "over CGAL's; speed-up",
             "tetrahedra");
  const std::string several = fmt::format("{} threads", threads);
  fmt::print("{:<10} {:>8} {:>8} {:>9} {:>8} {:>8}   {:>8} {:>8} {:>9} {:>8}   {:>9} {:>9} {:>9}  {}\n",
             "points", "1 thread", "unsorted", several, "CGAL", "TetGen", "1 thread", "unsorted", several,
             "speed-up", "Leonhard", "CGAL", "TetGen", "same bits");
  for (const benching::PointSet3& set : benching::point_sets3)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), set.name) != wanted.end())
      compare_times(set.name, set.points(n), threads, turns);
  if (wanted.empty()) show_growth(4 * n, turns);
}
