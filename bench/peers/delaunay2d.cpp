// SPDX-License-Identifier: MIT
// The 2-D Delaunay triangulation beside CGAL's: same points, turn and turn about; the shortest turn of each counts. Ours
// is the whole way from points in any order to a mesh with neighbours, in the input's numbering; CGAL's is its insertion
// of a range.
//   compare_delaunay2d [POINTS = 1000000] [THREADS = 2] [TURNS = 3]
#include <CGAL/Delaunay_triangulation_2.h>

#include <string>

#include "bench/peers/delaunay.hpp"
#include "bench/point_sets.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/mesh/fingerprint.hpp"

namespace {

using namespace leonhard;
using namespace leonhard::peers;
using benching::Points;

struct Plane {
  using Points = benching::Points;
  using Mesh = TriangleMesh;
  using Cgal = CGAL::Delaunay_triangulation_2<CgalKernel>;
  static constexpr const auto& sets = benching::point_sets;
  static constexpr std::size_t largest = 10'000'000;

  static Points uniform(std::size_t n) { return benching::uniform_points(n); }
  static Cgal::Point cgal_point(Point2 p) { return {p.x, p.y}; }
  static Mesh ours(Points points, unsigned threads) {
    delaunay::TriangulateOptions options;
    options.threads = threads;
    return delaunay::triangulate(std::move(points), options).mesh;
  }
};

void compare_times(const char* name, const Points& points, unsigned threads, int turns) {
  const auto for_cgal = cgal_points<Plane>(points);
  double one = 1e9, several = 1e9, cgals = 1e9;
  std::size_t cgal_faces = 0;
  for (int turn = 0; turn < turns; ++turn) {
    one = std::min(one, our_seconds<Plane>(points, 1U));
    several = std::min(several, our_seconds<Plane>(points, threads));
    Plane::Cgal cgal;
    cgals = std::min(cgals, seconds_of([&] { cgal.insert(for_cgal.begin(), for_cgal.end()); }));
    cgal_faces = cgal.number_of_faces();
  }
  const TriangleMesh mesh = Plane::ours(points, 1);
  const bool same = mesh.triangle_count() == cgal_faces &&
                    mesh::fingerprint(mesh) == mesh::fingerprint(Plane::ours(points, threads));
  fmt::print("{:<10} {:9.3f} {:9.3f} {:9.3f}   {:9.2f} {:9.2f}   {}\n", name, one, several, cgals,
             one / cgals, several / cgals, same ? "yes" : "NO");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto [n, threads, turns] = peers::Arguments(argc, argv);
  peers::show_memory<Plane>(n);
  fmt::print("\n{} points\n{:<10} {:^29}   {:^19}\n", n, "", "seconds", "over CGAL's");
  const std::string several = fmt::format("{} threads", threads);
  fmt::print("{:<10} {:>9} {:>9} {:>9}   {:>9} {:>9}   {}\n", "points", "1 thread", several, "CGAL",
             "1 thread", several, "same triangles");
  for (const benching::PointSet& set : Plane::sets) compare_times(set.name, set.points(n), threads, turns);
  peers::show_growth<Plane>(10 * n, turns);
}
