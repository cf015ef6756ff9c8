// SPDX-License-Identifier: MIT
// Bad input through the installed library: every call ends in an InputError that names the culprit, or in the answer that
// its header promises. Prints each case; exit 1 if any deviates.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <leonhard/delaunay/algorithm.hpp>
#include <leonhard/delaunay/delaunay_tree.hpp>
#include <leonhard/delaunay/dynamic_tetrahedralization.hpp>
#include <leonhard/delaunay/dynamic_triangulation.hpp>
#include <leonhard/delaunay/lawson.hpp>
#include <leonhard/delaunay/properties.hpp>
#include <leonhard/delaunay/refine.hpp>
#include <leonhard/delaunay/scopes.hpp>
#include <leonhard/delaunay/sizing.hpp>
#include <leonhard/delaunay/tetrahedralize.hpp>
#include <leonhard/delaunay/triangulate.hpp>
#include <leonhard/delaunay/voronoi.hpp>
#include <leonhard/delaunay/voronoi_clip.hpp>
#include <leonhard/graph/colouring.hpp>
#include <leonhard/graph/communication.hpp>
#include <leonhard/graph/fiedler.hpp>
#include <leonhard/graph/fill.hpp>
#include <leonhard/graph/mesh_graph.hpp>
#include <leonhard/graph/order.hpp>
#include <leonhard/graph/ordering.hpp>
#include <leonhard/graph/orientation.hpp>
#include <leonhard/graph/partition.hpp>
#include <leonhard/kernel/batch.hpp>
#include <leonhard/kernel/constructions.hpp>
#include <leonhard/kernel/hilbert.hpp>
#include <leonhard/kernel/implicit_point.hpp>
#include <leonhard/kernel/input_error.hpp>
#include <leonhard/kernel/power.hpp>
#include <leonhard/kernel/predicates.hpp>
#include <leonhard/kernel/predicates3.hpp>
#include <leonhard/mesh/centroid_dual.hpp>
#include <leonhard/mesh/dirichlet_dual.hpp>
#include <leonhard/mesh/edges.hpp>
#include <leonhard/mesh/euler.hpp>
#include <leonhard/mesh/exact_area.hpp>
#include <leonhard/mesh/exact_volume.hpp>
#include <leonhard/mesh/faces.hpp>
#include <leonhard/mesh/fingerprint.hpp>
#include <leonhard/mesh/io/mesh_file.hpp>
#include <leonhard/mesh/io/tet_mesh_file.hpp>
#include <leonhard/mesh/io/vtu.hpp>
#include <leonhard/mesh/median_dual.hpp>
#include <leonhard/mesh/permute.hpp>
#include <leonhard/mesh/quality.hpp>
#include <leonhard/mesh/tet_edges.hpp>
#include <leonhard/mesh/tet_euler.hpp>
#include <leonhard/mesh/tet_quality.hpp>
#include <leonhard/mesh/topology.hpp>
#include <leonhard/mesh/validate.hpp>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>
#if defined(OUTSIDE_HAS_DRAW)
#include <leonhard/mesh/draw/draw.hpp>
#endif
#if defined(OUTSIDE_HAS_SOLVER)
#include <leonhard/solver/linear_solver.hpp>
#include <leonhard/solver/steady.hpp>
#endif

using namespace leonhard;

namespace {

// ---- the table ----

constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

int deviations = 0, cases = 0;

void report(const char* name, bool right, const std::string& words) {
  ++cases;
  if (!right) ++deviations;
  std::printf("%s %-60s %s\n", right ? "ok  " : "BAD ", name, words.c_str());
  std::fflush(stdout);
}

/// The call throws InputError, and its message holds the culprit.
template <class Call>
void refuses(const char* name, const char* culprit, const Call& call) {
  std::printf("     %s\r", name);
  std::fflush(stdout);
  try {
    static_cast<void>(call());
    report(name, false, "no exception");
  } catch (const InputError& error) {
    const std::string words = error.what();
    report(name, words.find(culprit) != std::string::npos, words);
  } catch (const std::exception& error) {
    report(name, false, std::string("another exception: ") + error.what());
  }
}

/// The call returns, and `is_right` of what it returns.
template <class Call>
void answers(const char* name, const Call& is_right) {
  std::printf("     %s\r", name);
  std::fflush(stdout);
  try {
    report(name, is_right(), "");
  } catch (const std::exception& error) {
    report(name, false, std::string("exception: ") + error.what());
  }
}

// ---- what the calls are given ----

std::vector<Point2> grid(int side) {
  std::vector<Point2> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.push_back({double(i), double(j)});
  return points;
}
std::vector<Point3> grid3(int side) {
  std::vector<Point3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) points.push_back({double(i), double(j), double(k)});
  return points;
}
TriangleMesh good_mesh(int side = 4) { return delaunay::triangulate(grid(side)).mesh; }
TetMesh good_tets(int side = 3) { return delaunay::tetrahedralize(grid3(side)).mesh; }

Pslg square() {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  pslg.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  return pslg;
}

template <class Mesh>
Mesh with_corner_out_of_range(Mesh mesh) {
  mesh.corners.flat()[0][1] = VertexId::from(4'000'000);
  return mesh;
}

graph::CsrGraph path_graph() {
  const std::vector<std::array<std::uint32_t, 2>> edges{{0, 1}, {1, 2}, {2, 3}};
  return graph::graph_from_edges(4, edges).graph;
}

std::stop_token stopped() {
  std::stop_source source;
  source.request_stop();
  return source.get_token();
}

struct HostError : std::runtime_error {
  HostError() : std::runtime_error("the host's own") {}
};

// ---- kernel ----

void try_kernel() {
  using namespace kernel;
  const Point2 o{0, 0}, x{1, 0}, y{0, 1}, bad{nan_, 0}, far{inf, 1};
  const Point3 o3{0, 0, 0}, x3{1, 0, 0}, y3{0, 1, 0}, z3{0, 0, 1}, bad3{0, nan_, 0};
  refuses("orient2d of NaN", "orient2d", [&] { return orient2d(o, x, bad); });
  refuses("orient2d of infinities", "orient2d", [&] { return orient2d(far, far, far); });
  refuses("incircle of NaN", "point 4", [&] { return incircle(o, x, y, bad); });
  refuses("incircle_perturbed of an infinity", "incircle", [&] { return incircle_perturbed(o, x, y, far); });
  refuses("orient3d of NaN", "orient3d", [&] { return orient3d(o3, x3, y3, bad3); });
  refuses("orient3d of NaN beside a plane of coordinates", "orient3d", [&] {
    return orient3d(o3, x3, y3, Point3{nan_, 3, 0});
  });
  refuses("insphere of NaN", "insphere", [&] { return insphere(o3, x3, y3, z3, bad3); });
  refuses("power_test of a NaN weight", "power_test", [&] {
    return power_test(WeightedPoint2{o, 0}, {x, 0}, {y, nan_}, {{1, 1}, 0});
  });
  refuses("compare_distance of NaN", "compare_distance", [&] { return compare_distance(o, bad, x); });
  refuses("compare_xy of NaN", "compare_xy", [&] { return compare_xy(bad, x); });
  refuses("circumcircle of NaN", "circumcircle", [&] { return circumcircle(o, x, bad); });
  refuses("circumcircle of collinear points", "collinear", [&] { return circumcircle(o, x, Point2{2, 0}); });
  refuses("circumsphere of an infinity", "circumsphere", [&] {
    return circumsphere(o3, x3, y3, {0, 0, inf});
  });
  refuses("off_centre with a NaN reach", "reach", [&] { return off_centre(o, x, y, nan_); });
  refuses("LineCrossing of parallel lines", "parallel", [&] { return LineCrossing(o, x, y, Point2{1, 1}); });
  refuses("LineCrossing of NaN", "finite", [&] { return LineCrossing(o, x, y, bad); });
  refuses("rounded of NaN", "rounded", [&] { return rounded(bad); });
  refuses("hilbert_order of NaN", "point 1", [&] { return hilbert_order(std::vector<Point2>{o, bad}); });
  answers("hilbert_order of nothing", [&] { return hilbert_order(std::vector<Point3>{}).empty(); });
  const std::vector<Point2> points{o, x, bad};
  const std::vector<std::array<std::uint32_t, 3>> calls{{0, 1, 2}};
  std::vector<Sign> signs(1), none;
  refuses("a batch of orient2d of NaN", "orient2d", [&] { return orient2d(points, calls, signs), 0; });
  refuses("a batch with too few signs", "signs", [&] { return orient2d(points, calls, none), 0; });
}

// ---- mesh ----

void try_mesh() {
  using namespace mesh;
  refuses("an id beyond what ids number", "18446744073709551615",
          [] { return VertexId::from(std::numeric_limits<std::size_t>::max()); });
  const TriangleMesh good = good_mesh(), other = good_mesh(5), empty;
  const TetMesh tets = good_tets(), other_tets = good_tets(4), no_tets;
  const EdgeStructure edges = build_edges(good), foreign = build_edges(other);
  const auto wrong = with_corner_out_of_range(good);
  const auto wrong_tets = with_corner_out_of_range(tets);

  refuses("median_dual with edges of another mesh", "edges", [&] { return median_dual(good, foreign); });
  refuses("centroid_dual with edges of another mesh", "edges", [&] { return centroid_dual(good, foreign); });
  refuses("dirichlet_dual with edges of another mesh", "edges",
          [&] { return dirichlet_dual(good, foreign); });
  refuses("euler_account with edges of another mesh", "edge ", [&] { return euler_account(good, foreign); });
  refuses("median_dual of tetrahedra, edges of another mesh", "edges",
          [&] { return median_dual(tets, build_edges(other_tets)); });
  refuses("euler_account of tetrahedra, faces of another mesh", "face",
          [&] { return euler_account(tets, build_faces(other_tets), build_edges(tets)); });
  refuses("euler_account of tetrahedra, edges of another mesh", "edge",
          [&] { return euler_account(tets, build_faces(tets), build_edges(other_tets)); });
  answers("median_dual of an empty mesh",
          [&] { return median_dual(empty, build_edges(empty)).volume.empty(); });
  answers("euler_account of an empty mesh",
          [&] { return euler_account(empty, build_edges(empty)).balances(); });

  refuses("build_edges with a corner out of range", "4000000", [&] { return build_edges(wrong); });
  refuses("build_edges of tetrahedra, a corner out of range", "4000000",
          [&] { return build_edges(wrong_tets); });
  refuses("build_faces with a corner out of range", "4000000", [&] { return build_faces(wrong_tets); });
  refuses("quality with a corner out of range", "4000000", [&] { return quality(wrong); });
  refuses("quality of tetrahedra, a corner out of range", "4000000", [&] { return quality(wrong_tets); });
  refuses("fingerprint with a corner out of range", "4000000", [&] { return fingerprint(wrong); });
  refuses("exact_area2 with a corner out of range", "4000000", [&] { return exact_area2(wrong) > 0; });
  refuses("exact_volume6 with a corner out of range", "4000000",
          [&] { return exact_volume6(wrong_tets) > 0; });
  refuses("build_neighbours with a corner out of range", "4000000", [&] {
    auto copy = wrong;
    return build_neighbours(copy), 0;
  });
  answers("validate names a corner out of range",
          [&] { return validate(wrong).value_or("").find("4000000") != std::string::npos; });
  answers("validate of an empty mesh", [&] { return !validate(empty); });
  refuses("exact_area2 of NaN", "nan", [&] {
    auto copy = good;
    copy.points.flat()[5].x = nan_;
    return exact_area2(copy) > 0;
  });
  answers("quality of an empty mesh",
          [&] { return quality(empty).total_area == 0 && quality(no_tets).total_volume == 0; });
  refuses("quality without neighbours", "neighbours", [&] {
    auto copy = good;
    copy.neighbours.clear();
    return quality(copy);
  });
  refuses("renumber_vertices with a short permutation", "new_of_old",
          [&] { return renumber_vertices(good, PerId<VertexId, VertexId>(3)); });
  refuses("renumber_vertices of a mesh without regions", "regions", [&] {
    auto copy = good;
    copy.regions.clear();
    PerId<VertexId, VertexId> same;
    for (const VertexId v : good.points.ids()) same.push_back(v);
    return renumber_vertices(copy, same);
  });
  refuses("make_triangle_mesh of a clockwise triangle", "triangle", [] {
    PerId<VertexId, Point2> points(std::vector<Point2>{{0, 0}, {0, 1}, {1, 0}});
    PerId<TriangleId, std::array<VertexId, 3>> corners;
    corners.push_back({VertexId{0}, VertexId{1}, VertexId{2}});
    return make_triangle_mesh(points, corners, {});
  });

  const auto folder = std::filesystem::temp_directory_path();
  refuses("write_mesh of a mesh without regions", "regions", [&] {
    auto copy = good;
    copy.regions.clear();
    return io::write_mesh(folder / "leonhard_bad_input.su2", copy), 0;
  });
  refuses("write_tet_mesh with a boundary out of range", "boundary", [&] {
    auto copy = tets;
    copy.boundary[0].corners[0] = VertexId::from(4'000'000);
    return io::write_tet_mesh(folder / "leonhard_bad_input.msh", copy), 0;
  });
  refuses("format_vtu of a field too short", "mach", [&] {
    return io::format_vtu(good, {{"mach", 1, {1, 2, 3}}});
  });
  refuses("format_vtu of a field without components", "mach", [&] {
    return io::format_vtu(good, {{"mach", 0, {}}});
  });
  refuses("read_mesh of no file", "no_such_file.su2", [] { return io::read_mesh("no_such_file.su2"); });
  refuses("read_mesh of an unknown extension", ".xyzzy", [] { return io::read_mesh("mesh.xyzzy"); });
  refuses("parse_vtu of rubbish", "rubbish", [] { return io::parse_vtu("<VTKFile", "rubbish"); });
}

// ---- delaunay ----

void try_delaunay() {
  using namespace delaunay;
  std::vector<Point2> points = grid(4), with_nan = points;
  with_nan[7].y = nan_;
  std::vector<Point3> with_nan3 = grid3(3);
  with_nan3[7].z = inf;
  refuses("triangulate NaN", "7", [&] { return triangulate(with_nan); });
  refuses("tetrahedralize an infinity", "7", [&] { return tetrahedralize(with_nan3); });
  refuses("triangulate_distinct of NaN", "point 7",
          [&] { return triangulate_distinct(with_nan, Algorithm::watson, {}); });
  answers("triangulate nothing",
          [] { return triangulate(std::vector<Point2>{}).outcome == TriangulateOutcome::too_few_points; });
  answers("triangulate one point many times", [] {
    return triangulate(std::vector<Point2>(50, Point2{1, 1})).outcome == TriangulateOutcome::too_few_points;
  });
  answers("triangulate collinear points", [] {
    return triangulate(std::vector<Point2>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}).outcome ==
           TriangulateOutcome::all_collinear;
  });
  answers("tetrahedralize coplanar points", [] {
    return tetrahedralize(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).outcome ==
           TetrahedralizeOutcome::all_coplanar;
  });
  answers("triangulate with 4 thousand million threads", [&] {
    TriangulateOptions options;
    options.threads = 4'000'000'000U;
    return triangulate(points, options).outcome == TriangulateOutcome::done;
  });
  answers("triangulate stopped before it began", [&] {
    TriangulateOptions options;
    options.progress.stop = stopped();
    return triangulate(points, options).outcome != TriangulateOutcome::all_collinear;
  });
  answers("a progress callback that throws", [&] {
    RefineOptions options;
    options.size = [](Point2) { return 0.05; };
    options.progress.report = [](std::string_view, double) { throw HostError(); };
    try {
      static_cast<void>(mesh_pslg(square(), options));
    } catch (const HostError&) {
      return true;
    }
    return false;
  });
  refuses("tetrahedralize with a memory limit too low", "memory", [&] {
    TetrahedralizeOptions options;
    options.memory_limit_bytes = 1;
    return tetrahedralize(grid3(4), options);
  });

  refuses("a segment to a point that is not there", "segment 0", [] {
    Pslg pslg = square();
    pslg.segments[0].to = 99;
    return triangulate(pslg);
  });
  answers("a segment from a point to itself", [] {
    Pslg pslg = square();
    pslg.segments.push_back({2, 2, 7});
    const auto result = triangulate(pslg);
    return result.outcome == TriangulateOutcome::done && result.mesh.triangle_count() == 2;
  });
  refuses("segments that cross", "cross", [] {
    Pslg pslg = square();
    pslg.segments.push_back({0, 2, 5});
    pslg.segments.push_back({1, 3, 6});
    return triangulate(pslg);
  });
  refuses("point markers fewer than points", "point markers", [] {
    Pslg pslg = square();
    pslg.point_markers = {1};
    return triangulate(pslg);
  });
  refuses("a region of NaN area", "region 0", [] {
    Pslg pslg = square();
    pslg.regions.push_back({{0.5, 0.5}, 1, nan_});
    return mesh_pslg(pslg, {});
  });
  refuses("a region of NaN attribute", "region 0", [] {
    Pslg pslg = square();
    pslg.regions.push_back({{0.5, 0.5}, nan_, 1});
    return triangulate(pslg);
  });
  refuses("a hole at infinity", "hole 0", [] {
    Pslg pslg = square();
    pslg.holes = {{inf, 0}};
    return triangulate(pslg);
  });
  refuses("segments that enclose nothing", "enclose nothing", [] {
    Pslg pslg = square();
    pslg.segments.pop_back();
    return triangulate(pslg);
  });
  const auto refine_with = [](auto change) {
    return [change] {
      RefineOptions options;
      change(options);
      return mesh_pslg(square(), options);
    };
  };
  refuses("mesh_pslg to a smallest angle of 90 degrees", "min_angle_deg",
          refine_with([](auto& o) { o.min_angle_deg = 90; }));
  refuses("mesh_pslg to an angle of NaN", "min_angle_deg",
          refine_with([](auto& o) { o.min_angle_deg = nan_; }));
  refuses("mesh_pslg with a NaN area", "max_area", refine_with([](auto& o) { o.max_area = nan_; }));
  refuses("mesh_pslg with a negative shortest edge", "min_edge",
          refine_with([](auto& o) { o.min_edge = -1; }));
  refuses("mesh_pslg with a size of 0", "RefineOptions::size",
          refine_with([](auto& o) { o.size = [](Point2) { return 0.0; }; }));
  refuses("mesh_pslg with a size of NaN", "RefineOptions::size",
          refine_with([](auto& o) { o.size = [](Point2) { return nan_; }; }));
  refuses("mesh_pslg with a negative size", "RefineOptions::size",
          refine_with([](auto& o) { o.size = [](Point2) { return -1.0; }; }));
  answers("mesh_pslg with a budget of no vertices", [] {
    RefineOptions options;
    options.max_vertices = 0;
    options.size = [](Point2) { return 0.01; };
    return mesh_pslg(square(), options).report.outcome == RefineOutcome::vertex_budget_spent;
  });
  refuses("mesh_pslg of no points", "point", [] { return mesh_pslg(Pslg{}, {}); });
  refuses("a sizing source of NaN", "source 0", [] { return GradedSizing({{{0, 0}, nan_}}, 0.1, 1); });
  refuses("a sizing field of negative growth", "growth", [] { return GradedSizing({}, -1, 1); });
  refuses("a sizing field of no largest size", "max_size", [] { return GradedSizing({}, 0, nan_); });

  DynamicTriangulation sites(points);
  const VertexId gone = sites.insert({0.5, 0.25}).vertex;
  sites.remove(gone);
  const VertexId foreign = VertexId::from(4'000'000);
  refuses("DynamicTriangulation::point of a removed vertex", "vertex 16", [&] { return sites.point(gone); });
  refuses("DynamicTriangulation::point of a foreign id", "vertex 4000000",
          [&] { return sites.point(foreign); });
  refuses("DynamicTriangulation::neighbours of a foreign id", "vertex 4000000",
          [&] { return sites.neighbours(foreign); });
  refuses("DynamicTriangulation::remove twice", "vertex 16", [&] { return sites.remove(gone), 0; });
  refuses("DynamicTriangulation::insert NaN", "nan", [&] { return sites.insert({nan_, 0}); });
  refuses("DynamicTriangulation::locate NaN", "nan", [&] { return sites.locate({nan_, 0}); });
  answers("DynamicTriangulation::locate with a dead hint", [&] {
    return sites.locate({0.5, 0.5}, gone).inside();
  });
  refuses("DynamicTriangulation::interpolate_linear, too few values", "values", [&] {
    return sites.interpolate_linear({0.5, 0.5}, std::vector<double>(3));
  });
  answers("DynamicTriangulation::nearest_vertex of nothing", [] {
    return !DynamicTriangulation().nearest_vertex({0, 0}).has_value();
  });
  DynamicTetrahedralization sites3(grid3(3));
  const VertexId gone3 = sites3.insert({0.5, 0.25, 0.125}).vertex;
  sites3.remove(gone3);
  refuses("DynamicTetrahedralization::point of a removed vertex", "vertex 27",
          [&] { return sites3.point(gone3); });
  refuses("DynamicTetrahedralization::point of a foreign id", "vertex 4000000",
          [&] { return sites3.point(foreign); });
  refuses("DynamicTetrahedralization::tets_at of a foreign id", "vertex 4000000",
          [&] { return sites3.tets_at(foreign); });
  refuses("DynamicTetrahedralization::insert NaN", "nan", [&] { return sites3.insert({0, nan_, 0}); });

  refuses("DelaunayTree of NaN", "point 7", [&] { return DelaunayTree(with_nan); });
  refuses("DelaunayTree of equal points", "point", [] {
    return DelaunayTree({{0, 0}, {1, 0}, {0, 1}, {1, 0}});
  });
  refuses("DelaunayTree in an order that is none", "order", [] {
    return DelaunayTree({{0, 0}, {1, 0}, {0, 1}}, std::vector<std::uint32_t>{0, 1, 1});
  });
  refuses("DelaunayTree::locate without triangles", "DelaunayTree", [] {
    return DelaunayTree(std::vector<Point2>{{0, 0}, {1, 0}}).locate({0, 0});
  });
  refuses("DelaunayTree::nearest to NaN", "nan", [&] { return DelaunayTree(points).nearest({nan_, 0}); });

  const auto diagram = voronoi_diagram(points);
  refuses("the Voronoi cell of a site that is not there", "site 4000000",
          [&] { return diagram->cell(foreign).size(); });
  refuses("the Voronoi diagram of NaN", "7", [&] { return voronoi_diagram(with_nan); });
  answers("the Voronoi diagram of nothing",
          [] { return voronoi_diagram(std::vector<Point2>{})->sites.empty(); });
  refuses("the Voronoi diagram of a mesh without boundary", "boundary", [] {
    TriangleMesh mesh = good_mesh();
    mesh.boundary.clear();
    return voronoi_diagram(mesh);
  });
  refuses("the Voronoi diagram of a mesh that lacks a boundary edge", "boundary", [] {
    TriangleMesh mesh = good_mesh();
    mesh.boundary.erase(mesh.boundary.begin() + 2);
    return voronoi_diagram(mesh);
  });
  refuses("a window of two corners", "window", [&] {
    return clip(*diagram, std::vector<Point2>{{0, 0}, {1, 1}});
  });
  refuses("a window of NaN", "window", [&] {
    return clip(*diagram, std::vector<Point2>{{0, 0}, {1, 0}, {nan_, 1}});
  });

  refuses("the scope of collinear corners", "collinear", [&] {
    return scope(points, {VertexId{0}, VertexId{1}, VertexId{2}});
  });
  refuses("the scope of a corner that is not there", "4000000", [&] {
    return scope(points, {VertexId{0}, VertexId{5}, foreign});
  });
  refuses("roughness of NaN", "value 3", [] {
    std::vector<double> values(16, 0.0);
    values[3] = nan_;
    return roughness(good_mesh(), values) > 0;
  });
  refuses("roughness of too few values", "values",
          [] { return roughness(good_mesh(), std::vector<double>(3)) > 0; });
  refuses("validate_min_angle of other points", "other",
          [] { return validate_min_angle(good_mesh(4), good_mesh(5)); });
  refuses("swap_edges by values that are too few", "values", [] {
    TriangleMesh mesh = good_mesh();
    const std::vector<double> values(3);
    return swap_edges(mesh, criterion::MinRoughness{values});
  });
  refuses("swap_edges with a neighbour out of range", "neighbour", [] {
    TriangleMesh mesh = good_mesh();
    mesh.neighbours.flat()[0][0] = TriangleId::from(4'000'000);
    return swap_edges(mesh, criterion::Delaunay{});
  });
}

// ---- graph ----

void try_graph() {
  using namespace graph;
  const CsrGraph path = path_graph(), nothing = graph_from_edges(0, {}).graph;
  refuses("an edge to a vertex that is not there", "9", [] {
    const std::vector<std::array<std::uint32_t, 2>> edges{{0, 9}};
    return graph_from_edges(3, edges).graph;
  });
  refuses("dual_graph without neighbours", "neighbour", [] {
    TriangleMesh mesh = good_mesh();
    mesh.neighbours.clear();
    return dual_graph(mesh);
  });
  for (const NamedOrderMethod& known : named_order_methods) {
    if (known.method == OrderMethod::hilbert) continue;
    OrderOptions options;
    options.method = known.method;
    answers(("order of no vertices, " + std::string(known.name)).c_str(),
            [&] { return order(nothing, options).order.empty(); });
  }
  refuses("order along a curve without coordinates", "", [&] {
    OrderOptions options;
    options.method = OrderMethod::hilbert;
    return order(path, options);
  });
  refuses("rosen from an order that is none", "order", [&] {
    return rosen(path, std::vector<std::uint32_t>{0, 0, 1, 2});
  });
  refuses("invert of an order that is none", "7", [] { return invert(std::vector<std::uint32_t>{0, 7}); });
  refuses("ordering_cost of a short order", "", [&] {
    return ordering_cost(path, std::vector<std::uint32_t>{0, 1});
  });
  refuses("cholesky_fill of a short order", "", [&] {
    return cholesky_fill(path, std::vector<std::uint32_t>{0, 1});
  });
  refuses("pseudo_peripheral_vertex of a vertex that is not there", "9",
          [&] { return pseudo_peripheral_vertex(path, 9); });
  refuses("fiedler of no vertices", "graph", [&] { return fiedler(nothing); });
  refuses("fiedler to a NaN tolerance", "tolerance", [&] {
    FiedlerOptions options;
    options.tolerance = nan_;
    return fiedler(path, options);
  });
  refuses("partition into no parts", "parts", [&] { return partition(path, 0); });
  refuses("partition into more parts than vertices", "parts", [&] { return partition(path, 5); });
  refuses("partition with a NaN imbalance", "imbalance", [&] {
    PartitionOptions options;
    options.imbalance = nan_;
    return partition(path, 2, options);
  });
  refuses("partition with too few weights", "weight", [&] {
    PartitionOptions options;
    const std::vector<std::uint32_t> weights{1, 2};
    options.vertex_weights = weights;
    return partition(path, 2, options);
  });
  answers("partition of no vertices into one part", [&] { return partition(nothing, 1).part_of.empty(); });
  refuses("heaviest_allowed of no parts", "parts", [] { return heaviest_allowed(10, 0, 0.1); });
  refuses("heaviest_allowed with a NaN imbalance", "imbalance", [] { return heaviest_allowed(10, 2, nan_); });
  refuses("coordinate bisection of NaN", "", [] {
    return recursive_coordinate_bisection(std::vector<Point2>{{0, 0}, {nan_, 1}}, 2);
  });
  Partition bad;
  bad.parts = 2;
  bad.part_of = {0, 1, 2, 0};
  refuses("partition_cost of a part out of range", "2", [&] { return partition_cost(path, bad); });
  refuses("communication_graph of a part out of range", "2", [&] { return communication_graph(path, bad); });
  refuses("a partition shorter than the graph", "", [&] {
    bad.part_of.pop_back();
    return partition_cost(path, bad);
  });
  refuses("orient_planar from a vertex that is not there", "9",
          [&] { return orient_planar(path, std::vector<std::uint32_t>{9}); });
  refuses("a message cost of NaN", "", [&] { return communication_cost({}, {nan_, 1}); });
  answers("colours of no edges", [&] { return colour_edges(nothing).colours == 0; });
}

// ---- draw and solver ----

#if defined(OUTSIDE_HAS_DRAW)
void try_draw() {
  using namespace draw;
  const auto path = std::filesystem::temp_directory_path() / "leonhard_bad_input.svg";
  refuses("a picture of no mesh", "triangle", [&] { return draw_mesh(path, TriangleMesh{}), 0; });
  refuses("a picture of an unknown extension", "gif", [&] { return draw_mesh("mesh.gif", good_mesh()), 0; });
  refuses("a field too short", "", [&] { return draw_field(path, good_mesh(), std::vector<double>(3)), 0; });
  refuses("a field of NaN", "",
          [&] { return draw_field(path, good_mesh(), std::vector<double>(16, nan_)), 0; });
  refuses("a picture of no size", "", [&] {
    MeshOptions options;
    options.size.width = 0;
    return draw_mesh(path, good_mesh(), options), 0;
  });
  refuses("a part out of range", "partition",
          [&] { return draw_partition(path, good_mesh(), std::vector<std::uint32_t>(16, 7), 2), 0; });
  refuses("a corner out of range", "4000000",
          [&] { return draw_mesh(path, with_corner_out_of_range(good_mesh())), 0; });
}
#endif

#if defined(OUTSIDE_HAS_SOLVER)
void try_solver() {
  const TriangleMesh mesh = good_mesh();
  FlowProblem<2> problem{mesh::build_dual(mesh), {}, {}, {{1, BoundaryKind::far_field}}, {}, true, {}, {}};
  const auto solve_with = [&](auto change) {
    return [&, change] {
      FlowProblem<2> changed = problem;
      SteadyOptions options;
      options.marching = Marching::explicit_multistage;
      change(changed, options);
      return solver::solve_steady(changed, options);
    };
  };
  refuses("a Mach number of NaN", "mach", solve_with([](auto& p, auto&) { p.free_stream.mach = nan_; }));
  refuses("a gas of gamma 1", "gamma", solve_with([](auto& p, auto&) { p.gas.gamma = 1; }));
  refuses("a marker without a condition", "", solve_with([](auto& p, auto&) { p.boundary.clear(); }));
  refuses("no threads", "threads", solve_with([](auto&, auto& o) { o.threads = 0; }));
  refuses("parts fewer than vertices", "part", solve_with([](auto&, auto& o) {
            o.part_of = {0, 1}, o.parts = 2;
          }));
  answers("a second PetscSession", [] {
    { const PetscSession first; }
    try {
      const PetscSession second;
    } catch (const std::logic_error&) {
      return true;
    }
    return false;
  });
}
#endif

}  // namespace

int main() {
  try_kernel();
  try_mesh();
  try_delaunay();
  try_graph();
#if defined(OUTSIDE_HAS_DRAW)
  try_draw();
#endif
#if defined(OUTSIDE_HAS_SOLVER)
  try_solver();
#endif
  std::printf("%d calls, %d of them not as promised\n", cases, deviations);
  return deviations == 0 ? 0 : 1;
}
