// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>
#include <set>

#include "figures.hpp"
#include "leonhard/delaunay/voronoi_clip.hpp"
#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/edges.hpp"

namespace leonhard::notes {
namespace {

using draw::Diagram;

TriangleMesh mesh_of(const std::vector<Point2>& sites) { return delaunay::triangulate(sites).mesh; }

// ---- divide and conquer ----

/// The sites of figures 3.3.0 to 3.3.3 with the triangulations of their halves and of all.
struct Halves {
  TriangleMesh left, right, whole;
  double cut{};
  [[nodiscard]] bool is_left(Point2 p) const { return p.x < cut; }
};

Halves halves_of(std::uint64_t seed) {
  std::vector<Point2> sites = random_sites(26, seed, 0.12);
  std::sort(sites.begin(), sites.end());
  const std::size_t half = sites.size() / 2;
  for (Point2& p : sites) p.x *= 1.5;
  for (std::size_t i = half; i < sites.size(); ++i) sites[i].x += 0.12;  // a gap to see the merge in
  const auto at = sites.begin() + static_cast<std::ptrdiff_t>(half);
  return {mesh_of({sites.begin(), at}), mesh_of({at, sites.end()}), mesh_of(sites), sites[half].x};
}

/// The lower edge of the merged hull that joins the halves: left end, right end.
std::array<Point2, 2> lower_common_tangent(const Halves& h) {
  for (const MarkedEdge& edge : h.whole.boundary) {
    const Point2 a = h.whole.points[edge.from], b = h.whole.points[edge.to];
    if (h.is_left(a) && !h.is_left(b)) return {a, b};  // the mesh above it, to its left
  }
  return {};
}

/// The first guess at the tangent: the lowest sites of both halves.
std::array<Point2, 2> first_guess(const Halves& h) {
  const auto lowest = [](const TriangleMesh& mesh) {
    return *std::min_element(mesh.points.begin(), mesh.points.end(),
                             [](Point2 a, Point2 b) { return a.y < b.y; });
  };
  return {lowest(h.left), lowest(h.right)};
}

/// Sites for which the guess is wrong at both ends.
Halves halves() {
  for (std::uint64_t seed = 12;; ++seed) {
    Halves h = halves_of(seed);
    const auto [a, b] = lower_common_tangent(h);
    const auto [c, d] = first_guess(h);
    if (a != c && b != d) return h;
  }
}

std::vector<Diagram> before_merge() {
  const Halves h = halves();
  Diagram diagram = diagram_of(h.left, {}, {.colour = second, .width = 1.2});
  const Diagram right = diagram_of(h.right, {}, {.colour = {0.1, 0.5, 0.25}, .width = 1.2});
  diagram.paths.insert(diagram.paths.end(), right.paths.begin(), right.paths.end());
  diagram.dots.insert(diagram.dots.end(), right.dots.begin(), right.dots.end());
  return {diagram};
}

/// Edges that the merge made are strong, those that it took away dashed.
std::vector<Diagram> after_merge() {
  const Halves h = halves();
  Diagram diagram;
  for (const Point2 p : h.whole.points) diagram.dots.push_back({p});
  std::set<std::array<Point2, 2>> kept;
  const EdgeStructure edges = mesh::build_edges(h.whole);
  for (const auto& [a, b] : edges.ends) {
    const Point2 p = h.whole.points[a], q = h.whole.points[b];
    kept.insert({std::min(p, q), std::max(p, q)});
    diagram.add_segment(p, q, h.is_left(p) == h.is_left(q) ? thin : strong);
  }
  for (const TriangleMesh* half : {&h.left, &h.right})
    for (const auto& [a, b] : mesh::build_edges(*half).ends) {
      const Point2 p = half->points[a], q = half->points[b];
      if (!kept.contains({std::min(p, q), std::max(p, q)}))
        diagram.add_segment(p, q, {.colour = faint, .width = 1.2, .style = draw::LineStyle::dashed});
    }
  return {diagram};
}

std::vector<Diagram> tangent() {
  const Halves h = halves();
  Diagram diagram = diagram_of(h.left, {}, light);
  const Diagram right = diagram_of(h.right, {}, light);
  diagram.paths.insert(diagram.paths.end(), right.paths.begin(), right.paths.end());
  diagram.dots.insert(diagram.dots.end(), right.dots.begin(), right.dots.end());
  for (const TriangleMesh* half : {&h.left, &h.right})
    for (const MarkedEdge& edge : half->boundary)
      diagram.add_segment(half->points[edge.from], half->points[edge.to], thin);
  const auto [c, d] = first_guess(h);
  diagram.add_segment(c, d, dashed);
  diagram.words.push_back({c, "guess", {0.4, 1.2}, accent});
  const auto [a, b] = lower_common_tangent(h);
  diagram.add_segment(a, b, strong);
  diagram.words.push_back({a, "LCT", {1, -1.1}, accent});
  return {diagram};
}

/// A cross edge, from left to right, and the site above it that its bubble meets.
struct Rise {
  Point2 a, b, c;
  kernel::Circle bubble{};
};

/// Of all cross edges the one with the smallest bubble, which shows best.
Rise smallest_rise(const Halves& h) {
  Rise best;
  const EdgeStructure edges = mesh::build_edges(h.whole);
  for (const EdgeId e : edges.ends.ids()) {
    auto [from, to] = edges.ends[e];
    MaybeId<TriangleId> above = edges.sides[e][0];
    if (h.is_left(h.whole.points[from]) == h.is_left(h.whole.points[to])) continue;
    if (h.is_left(h.whole.points[to])) {
      std::swap(from, to);
      above = edges.sides[e][1];
    }
    if (!above) continue;
    const Point2 a = h.whole.points[from], b = h.whole.points[to];
    const Point2 c = h.whole.points[apex(h.whole, *above, from, to)];
    const kernel::Circle bubble = kernel::circumcircle(a, b, c);
    if (best.bubble.radius == 0 || bubble.radius < best.bubble.radius) best = {a, b, c, bubble};
  }
  return best;
}

/// The circle through the ends A, B of a cross edge rises until it meets the next site, C.
std::vector<Diagram> rising_bubble() {
  const Halves h = halves();
  const auto [a, b, c, last] = smallest_rise(h);
  Diagram diagram = diagram_of(h.left, {}, light);
  const Diagram right = diagram_of(h.right, {}, light);
  diagram.paths.insert(diagram.paths.end(), right.paths.begin(), right.paths.end());
  diagram.dots.insert(diagram.dots.end(), right.dots.begin(), right.dots.end());
  const Point2 middle = a + 0.5 * (b - a);
  const Vec2 up{-(b - a).y, (b - a).x};
  for (const double back : {0.35, 0.7, 1.2}) {
    const Point2 centre = last.centre + -back * up;
    diagram.circles.push_back({centre, distance(centre, a), light});
  }
  diagram.circles.push_back({last.centre, last.radius, {.colour = second, .width = 1.6}});
  diagram.add_segment(a, b, strong);
  diagram.add_segment(c, h.is_left(c) ? b : a, dashed);
  diagram.words.push_back({a, "A", {-0.8, -0.7}});
  diagram.words.push_back({b, "B", {0.8, -0.7}});
  diagram.words.push_back({c, "C", {h.is_left(c) ? -0.9 : 0.9, 0.5}, accent});
  const double room = 1.6 * last.radius;
  diagram.region = draw::Box{middle + Vec2{-1.4 * room, -0.8 * room}, middle + Vec2{1.4 * room, 1.2 * room}};
  return {diagram};
}

// ---- insertion of one site ----

const Point2 q{0.57, 0.55};
std::vector<Point2> base_sites() { return random_sites(14, 21, 0.17); }
std::vector<Point2> with_q() {
  std::vector<Point2> sites = base_sites();
  sites.push_back(q);
  return sites;
}

bool dies(const TriangleMesh& mesh, TriangleId t) {
  const auto [a, b, c] = corners(mesh, t);
  return kernel::incircle(a, b, c, q) == Sign::positive;
}

/// The Voronoi diagram before Q, the vertices that Q deletes, and Q's territory in the diagram after.
std::vector<Diagram> territory() {
  const TriangleMesh mesh = mesh_of(base_sites());
  const auto before = delaunay::voronoi_diagram(mesh);
  const auto after = delaunay::voronoi_diagram(mesh_of(with_q()));
  const auto window = delaunay::box_window({-0.06, -0.06}, {1.08, 1.08});
  Diagram diagram;
  diagram.region = draw::Box{window[0], window[2]};
  const auto cells = delaunay::clip(before, window);
  for (const VertexId site : before.sites.ids()) {
    const auto cell = cells.cell(site);
    diagram.paths.push_back({{cell.begin(), cell.end()}, thin, true});
    diagram.dots.push_back({before.sites[site]});
    diagram.words.push_back({before.sites[site], "p" + std::to_string(site.index() + 1), {0.9, 0.6}});
  }
  std::size_t deleted = 0;
  for (const TriangleId t : mesh.corners.ids()) {
    if (!dies(mesh, t)) continue;
    const auto [a, b, c] = corners(mesh, t);
    diagram.add_named_dot(kernel::circumcircle(a, b, c).centre, "v" + std::to_string(++deleted), {0.8, -0.7},
                          second);
  }
  std::vector<Point2> cell;
  const auto site = VertexId::from(after.sites.size() - 1);
  for (const auto v : after.cell_vertices(site)) cell.push_back(after.vertices[v].at);
  diagram.areas.push_back({cell, shade});
  diagram.paths.push_back({cell, dashed, true});
  diagram.add_named_dot(q, "Q", {0.8, 0.6}, accent);
  return {diagram};
}

void shade_cavity(Diagram& diagram, const TriangleMesh& mesh) {
  for (const TriangleId t : mesh.corners.ids()) {
    const auto all = corners(mesh, t);
    if (dies(mesh, t)) diagram.areas.push_back({{all.begin(), all.end()}, shade});
  }
}

/// The edges of a mesh that end at a point of it.
void add_edges_at(Diagram& diagram, const TriangleMesh& mesh, Point2 p, const draw::Stroke& stroke) {
  const VertexId v = vertex_at(mesh, p);
  for (const auto& [a, b] : mesh::build_edges(mesh).ends)
    if (a == v || b == v) diagram.add_segment(mesh.points[a], mesh.points[b], stroke);
}

std::vector<Diagram> watson() {
  const TriangleMesh before = mesh_of(base_sites()), after = mesh_of(with_q());
  Diagram first = diagram_of(before, "(a) The triangles whose circumcircles hold Q");
  shade_cavity(first, before);
  first.add_named_dot(q, "Q", {0.8, 0.6}, accent);
  Diagram then = diagram_of(after, "(b) Their polygon's corners joined to Q");
  shade_cavity(then, before);
  add_edges_at(then, after, q, strong);
  then.add_named_dot(q, "Q", {0.9, 0.6}, accent);
  return {first, then};
}

/// An edge of the triangle about Q that fails the circle test: its ends, and the corner beyond it.
struct Suspect {
  VertexId from, to, beyond;
  TriangleId behind;
};
Suspect failing_suspect(const TriangleMesh& mesh) {
  const TriangleId t = triangle_at(mesh, q);
  for (unsigned i = 0; i < 3; ++i) {
    const MaybeId<TriangleId> behind = mesh.neighbours[t][i];
    const VertexId a = mesh.corners[t][(i + 1) % 3], b = mesh.corners[t][(i + 2) % 3];
    if (behind && dies(mesh, *behind)) return {a, b, apex(mesh, *behind, a, b), *behind};
  }
  return {};
}

Diagram joined_to_q(const TriangleMesh& mesh, const std::string& title) {
  Diagram diagram = diagram_of(mesh, title);
  for (const Point2 corner : corners(mesh, triangle_at(mesh, q))) diagram.add_segment(q, corner, strong);
  diagram.add_named_dot(q, "Q", {-1.0, 0.3}, accent);
  return diagram;
}

/// Take an edge of a mesh out of its diagram.
void take_away(Diagram& diagram, Point2 a, Point2 b) {
  std::erase_if(diagram.paths, [&](const Diagram::Path& path) {
    return path.points == std::vector{a, b} || path.points == std::vector{b, a};
  });
}

std::vector<Diagram> green_sibson() {
  const TriangleMesh mesh = mesh_of(base_sites());
  Diagram first = joined_to_q(mesh, "(a) Q joined to its triangle's corners; suspect edges blue");
  const auto triangle = corners(mesh, triangle_at(mesh, q));
  first.paths.push_back({{triangle.begin(), triangle.end()}, {.colour = second, .width = 2.2}, true});
  Diagram then = joined_to_q(mesh, "(b) A suspect edge fails the circle test and is swapped");
  const Suspect suspect = failing_suspect(mesh);
  const Point2 a = mesh.points[suspect.from], b = mesh.points[suspect.to], c = mesh.points[suspect.beyond];
  const kernel::Circle circle = kernel::circumcircle(a, b, c);
  then.circles.push_back({circle.centre, circle.radius, light});
  take_away(then, a, b);
  then.add_segment(a, b, {.colour = second, .width = 1.8, .style = draw::LineStyle::dashed});
  then.add_segment(q, c, strong);
  then.region = draw::Box{{-0.05, -0.05}, {1.05, 1.05}};
  first.region = then.region;
  return {first, then};
}

/// After a swap the two edges beyond become suspect, those of Q never: propagation goes forward only.
std::vector<Diagram> forward_propagation() {
  const TriangleMesh mesh = mesh_of(base_sites());
  const Suspect suspect = failing_suspect(mesh);
  const Point2 v1 = mesh.points[suspect.from], v3 = mesh.points[suspect.to], v2 = mesh.points[suspect.beyond];
  Diagram diagram = joined_to_q(mesh, {});
  diagram.dots.pop_back();
  diagram.words.clear();
  take_away(diagram, v1, v3);
  diagram.add_segment(v1, v3, {.colour = faint, .width = 1.4, .style = draw::LineStyle::dashed});
  diagram.add_segment(q, v2, strong);
  diagram.add_named_dot(q, "vq", {-1.2, 0.3}, accent);
  const auto name = [&](Point2 p, const std::string& words) {
    const Vec2 out = p - q;
    diagram.words.push_back({p, words, 1.2 / norm(out) * out});
  };
  name(v1, "v1");
  name(v2, "v2");
  name(v3, "v3");
  const EdgeStructure edges = mesh::build_edges(mesh);
  int next = 4;
  for (const VertexId end : {suspect.from, suspect.to}) {
    diagram.add_segment(mesh.points[end], v2, {.colour = second, .width = 2.4});
    for (const MaybeId<TriangleId> t : edges.sides[*edges.find(end, suspect.beyond)])
      if (t && *t != suspect.behind) {
        const Point2 far = mesh.points[apex(mesh, *t, end, suspect.beyond)];
        name(far, "v" + std::to_string(next));
        const Point2 crossed[]{mesh.points[end], v2};
        const Point2 from = centroid(crossed);
        diagram.add_arrow(q + 0.75 * (from - q), from + 0.35 * (far - from), {.colour = second});
      }
    ++next;
  }
  return {diagram};
}

// ---- the quadratic case ----

/// Sites on a vertical line with one far to the right, and `count` sites between to be added.
struct Difficult {
  std::vector<Point2> first, added;  ///< added from right to left
};
Difficult difficult_case(int count) {
  Difficult sites;
  for (int j = 0; j <= count; ++j) sites.first.push_back({0, (j - 0.5 * count) * 1.2 / count});
  sites.first.push_back({3, 0});
  for (int i = count; i > 0; --i) sites.added.push_back({0.3 + 2.4 * i / (count + 1), 0});
  return sites;
}

std::set<std::array<Point2, 3>> triangles(const TriangleMesh& mesh) {
  std::set<std::array<Point2, 3>> all;
  for (const TriangleId t : mesh.corners.ids()) {
    auto sorted = corners(mesh, t);
    std::sort(sorted.begin(), sorted.end());
    all.insert(sorted);
  }
  return all;
}

/// How many triangles come into being while the sites are added one after another.
std::size_t triangles_made(std::vector<Point2> sites, const std::vector<Point2>& added) {
  auto before = triangles(mesh_of(sites));
  std::size_t made = 0;
  for (const Point2 p : added) {
    sites.push_back(p);
    auto after = triangles(mesh_of(sites));
    for (const auto& t : after) made += before.contains(t) ? 0 : 1;
    before = std::move(after);
  }
  return made;
}

std::vector<Diagram> quadratic_case() {
  const Difficult few = difficult_case(6), many = difficult_case(60);
  std::vector<Point2> mixed = many.added;
  std::shuffle(mixed.begin(), mixed.end(), std::mt19937_64(5));
  std::vector<Point2> all = few.first;
  all.insert(all.end(), few.added.begin(), few.added.end());
  Diagram initial = diagram_of(mesh_of(few.first), "(a) Before sites 1 to 6"),
          final = diagram_of(mesh_of(all));
  final.title =
      "(b) After. With 60 in place of 6: " + std::to_string(triangles_made(many.first, many.added)) +
      " triangles made right to left, " + std::to_string(triangles_made(many.first, mixed)) + " at random";
  for (std::size_t i = 0; i < few.added.size(); ++i) {
    final.words.push_back({few.added[i], std::to_string(i + 1), {0.5, 1.1}, accent});
    final.dots.push_back({few.added[i], accent, 1.2});
    initial.dots.push_back({few.added[i], faint});
  }
  return {initial, final};
}

}  // namespace

std::vector<Figure> algorithm_figures() {
  return {{"3.3.0", "Triangulated subdivisions", before_merge},
          {"3.3.1", "Triangulation after merge", after_merge},
          {"3.3.2", "Lower common tangent, given an initial guess", tangent},
          {"3.3.3", "Circle of increasing radius in the rising bubble algorithm", rising_bubble},
          {"3.3.4", "Voronoi diagram modified by Bowyer's algorithm", territory},
          {"3.3.5", "Watson's algorithm", watson, 2},
          {"3.3.6", "Green and Sibson's algorithm", green_sibson, 2},
          {"3.3.7", "Edge swapping with forward propagation", forward_propagation},
          {"3.3.8", "A difficult order of sites", quadratic_case, 1}};
}

}  // namespace leonhard::notes
