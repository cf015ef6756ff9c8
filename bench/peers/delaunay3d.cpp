// SPDX-License-Identifier: MIT
// The Delaunay tetrahedralisation beside CGAL's and TetGen's: same points, turn and turn about; the shortest turn of each
// counts. Ours is the whole way from points in any order to a mesh with neighbours, in the input's numbering; CGAL's is
// its insertion of a range, TetGen's its tetrahedralize of points.
//   compare_delaunay3d [POINTS = 1000000] [THREADS = 2] [TURNS = 3] [SET...]
#include <CGAL/Delaunay_triangulation_3.h>
#define TETLIBRARY  // as Debian builds it: tetrahedralize(switches, in, out)
#include <tetgen.h>

#include <string>

#include "bench/peers/delaunay.hpp"
#include "bench/point_sets3.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"

namespace {

using namespace leonhard;
using namespace leonhard::peers;
using benching::Points3;

struct Space {
  using Points = Points3;
  using Mesh = TetMesh;
  using Cgal = CGAL::Delaunay_triangulation_3<CgalKernel>;
  static constexpr const auto& sets = benching::point_sets3;
  static constexpr std::size_t largest = 4'000'000;

  static Points uniform(std::size_t n) { return benching::uniform_points3(n); }
  static Cgal::Point cgal_point(const Point3& p) { return {p.x, p.y, p.z}; }
  static Mesh ours(Points points, unsigned threads, bool sorted = true) {
    delaunay::TetrahedralizeOptions options;
    options.threads = threads;
    options.sorted = sorted;
    return delaunay::tetrahedralize(std::move(points), options).mesh;
  }
};

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
  const auto for_cgal = cgal_points<Space>(points);
  double one = 1e9, unsorted = 1e9, several = 1e9, cgals = 1e9, tetgens = 1e9;
  std::size_t cgal_tets = 0, tetgen_tets = 0;
  for (int turn = 0; turn < turns; ++turn) {
    one = std::min(one, our_seconds<Space>(points, 1U));
    unsorted = std::min(unsorted, our_seconds<Space>(points, 1U, false));
    several = std::min(several, our_seconds<Space>(points, threads));
    Space::Cgal cgal;
    cgals = std::min(cgals, seconds_of([&] { cgal.insert(for_cgal.begin(), for_cgal.end()); }));
    cgal_tets = cgal.number_of_finite_cells();
    tetgens = std::min(tetgens, tetgen_seconds(points, tetgen_tets));
  }
  const TetMesh mesh = Space::ours(points, 1);
  fmt::print(
      "{:<10} {:8.3f} {:8.3f} {:9.3f} {:8.3f} {:8.3f}   {:8.2f} {:8.2f} {:9.2f} {:8.2f}   {:9} {:9} {:9}  "
      "{}\n",
      name, one, unsorted, several, cgals, tetgens, one / cgals, unsorted / cgals, several / cgals,
      one / several, mesh.tet_count(), cgal_tets, tetgen_tets,
      mesh == Space::ours(points, threads) ? "yes" : "NO");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto [n, threads, turns] = peers::Arguments(argc, argv);
  const std::vector<std::string> wanted(argv + std::min(argc, 4), argv + argc);
  if (wanted.empty()) peers::show_memory<Space>(n);
  fmt::print("\n{} points\n{:<10} {:^46}   {:^36}   {:^29}\n", n, "", "seconds", "over CGAL's; speed-up",
             "tetrahedra");
  const std::string several = fmt::format("{} threads", threads);
  fmt::print("{:<10} {:>8} {:>8} {:>9} {:>8} {:>8}   {:>8} {:>8} {:>9} {:>8}   {:>9} {:>9} {:>9}  {}\n",
             "points", "1 thread", "unsorted", several, "CGAL", "TetGen", "1 thread", "unsorted", several,
             "speed-up", "Leonhard", "CGAL", "TetGen", "same bits");
  for (const auto& set : Space::sets)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), set.name) != wanted.end())
      compare_times(set.name, set.points(n), threads, turns);
  if (wanted.empty()) peers::show_growth<Space>(4 * n, turns);
}
