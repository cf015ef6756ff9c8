// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_euler.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>

#include "leonhard/mesh/check/same_mesh.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/exact_sum.hpp"
#include "leonhard/mesh/structures/sorted_facet.hpp"

namespace leonhard {

std::int64_t TetEulerAccount::characteristic() const {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  return n(stars) - n(fans) + n(faces) - n(tetrahedra);
}

bool TetEulerAccount::balances() const {
  return std::all_of(formulas.begin(), formulas.end(), [](const Formula& f) { return f.holds(); });
}

namespace mesh {
namespace {

/// Where v stands among the corners of t, which has it.
std::size_t corner_of(const TetMesh& mesh, TetId t, VertexId v) {
  const auto& corners = mesh.corners[t];
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
}

/// The classes of corners that meet at a vertex and are joined across faces.
class Stars {
 public:
  explicit Stars(const TetMesh& mesh) : star_(4 * mesh.tet_count(), none) {
    for (const TetId t : mesh.corners.ids()) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (star_[4 * t.index() + i] == none) flood(mesh, t, i);
      }
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t at(TetId t, std::size_t corner) const { return star_[4 * t.index() + corner]; }
  [[nodiscard]] std::size_t at(const TetMesh& mesh, TetId t, VertexId v) const {
    return at(t, corner_of(mesh, t, v));
  }

 private:
  static constexpr IdRaw none = static_cast<IdRaw>(-1);

  void flood(const TetMesh& mesh, TetId t, std::size_t corner) {
    const VertexId v = mesh.corners[t][corner];
    const auto star = static_cast<IdRaw>(count_++);
    star_[4 * t.index() + corner] = star;
    stack_.assign(1, t);
    while (!stack_.empty()) {
      const TetId from = stack_.back();
      stack_.pop_back();
      for (std::size_t side = 0; side < 4; ++side) {
        const MaybeId<TetId> to = mesh.neighbours[from][side];
        if (!to || mesh.corners[from][side] == v) continue;
        IdRaw& entry = star_[4 * (*to).index() + corner_of(mesh, *to, v)];
        if (entry != none) continue;
        entry = star;
        stack_.push_back(*to);
      }
    }
  }

  std::vector<IdRaw> star_;  ///< of corner i of tetrahedron t at 4 t + i
  std::vector<TetId> stack_;
  std::size_t count_ = 0;
};

std::size_t component_count(const TetMesh& mesh) {
  std::size_t count = 0;
  std::vector<TetId> stack;
  PerId<TetId, char> seen(mesh.tet_count(), 0);
  for (const TetId start : mesh.corners.ids()) {
    if (seen[start]) continue;
    ++count;
    seen[start] = 1;
    stack.assign(1, start);
    while (!stack.empty()) {
      const TetId from = stack.back();
      stack.pop_back();
      for (const MaybeId<TetId> to : mesh.neighbours[from]) {
        if (to && !seen[*to]) seen[*to] = 1, stack.push_back(*to);
      }
    }
  }
  return count;
}

/// A side of a tetrahedron, or one of its four corners.
struct Side {
  TetId tet;
  std::size_t side;
};

/// The tetrahedra about an edge that are joined across faces at it: all round it, or from one boundary face to another.
struct Fan {
  VertexId from, to;
  TetId tet;                                ///< one of them
  std::optional<std::array<Side, 2>> ends;  ///< the boundary faces, if it is open
};

/// Goes round edges from tetrahedron to tetrahedron.
class FanWalk {
 public:
  explicit FanWalk(const TetMesh& mesh) : mesh_(mesh), walked_(mesh.tet_count(), 0) {}

  /// Calls visit(fan) for each fan of the mesh.
  template <class Visit>
  void for_each(Visit visit) {
    for (const TetId t : mesh_.corners.ids()) {
      for (std::size_t e = 0; e < 6; ++e) {
        if ((walked_[t] >> e & 1) == 0) visit(fan_from(t, e));
      }
    }
  }

 private:
  Fan fan_from(TetId t, std::size_t e) {
    const auto& corners = mesh_.corners[t];
    Fan fan{corners[tet_edge_corners[e][0]], corners[tet_edge_corners[e][1]], t, std::nullopt};
    const VertexId p = corners[tet_edge_corners[5 - e][0]], q = corners[tet_edge_corners[5 - e][1]];
    walked_[t] = static_cast<std::uint8_t>(walked_[t] | 1U << e);
    const auto one_end = end_beyond(fan, p, q);
    if (one_end) fan.ends = {*one_end, *end_beyond(fan, q, p)};
    return fan;
  }

  /// From fan.tet across the face opposite p, and on. q is the fourth corner, besides p and the edge's ends.
  /// returns  the boundary face where the walk ends; none if it comes round
  std::optional<Side> end_beyond(const Fan& fan, VertexId p, VertexId q) {
    for (TetId t = fan.tet;;) {
      const std::size_t side = corner_of(mesh_, t, p);
      const MaybeId<TetId> next = mesh_.neighbours[t][side];
      if (!next) return Side{t, side};
      if (*next == fan.tet) return std::nullopt;
      t = *next;
      const auto& corners = mesh_.corners[t];
      const std::size_t i = corner_of(mesh_, t, fan.from), j = corner_of(mesh_, t, fan.to);
      walked_[t] = static_cast<std::uint8_t>(walked_[t] | 1U << edge_at[i][j]);
      p = q;
      q = corners[6 - i - j - corner_of(mesh_, t, p)];
    }
  }

  /// The edge between two corners, as a number in tet_edge_corners.
  static constexpr std::array<std::array<std::uint8_t, 4>, 4> edge_at{
      {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}}};

  const TetMesh& mesh_;
  PerId<TetId, std::uint8_t> walked_;  ///< a bit an edge
};

/// Boundary faces, numbered in the order of tetrahedra and sides, and how they hang together.
class Boundary {
 public:
  explicit Boundary(const TetMesh& mesh)
      : mesh_(mesh), sides_(sides_of(mesh)), shells_(sides_.size()), sheets_(3 * sides_.size()) {}

  void join(const Fan& fan) {
    const std::size_t f = number((*fan.ends)[0]), g = number((*fan.ends)[1]);
    shells_.join(f, g);
    for (const VertexId v : {fan.from, fan.to}) sheets_.join(corner(f, v), corner(g, v));
  }

  [[nodiscard]] std::size_t face_count() const { return sides_.size(); }
  [[nodiscard]] std::size_t shell_count() const { return shells_.class_count(); }
  [[nodiscard]] std::size_t sheet_count() const { return sheets_.class_count(); }

  /// Calls visit(side, its corner's number in the tetrahedron, whether it is the first of its sheet).
  template <class Visit>
  void for_each_corner(Visit visit) {
    for (std::size_t c = 0; c < 3 * sides_.size(); ++c) {
      const Side& side = sides_[c / 3];
      visit(side, tet_face_corners[side.side][c % 3], sheets_.find(c) == c);
    }
  }

  /// The sign of the volume that each shell encloses, normals pointing outwards.
  [[nodiscard]] std::vector<Sign> shell_signs() {
    std::map<std::size_t, ExactSum> volume6;
    for (std::size_t f = 0; f < sides_.size(); ++f) {
      const auto [a, b, c] = face(f);
      volume6[shells_.find(f)].add_determinant(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
    }
    std::vector<Sign> signs;
    for (const auto& [shell, sum] : volume6) signs.push_back(sum.sign());
    return signs;
  }

 private:
  static std::vector<Side> sides_of(const TetMesh& mesh) {
    std::vector<Side> sides;
    for (const TetId t : mesh.neighbours.ids()) {
      for (std::size_t side = 0; side < 4; ++side) {
        if (!mesh.neighbours[t][side]) sides.push_back({t, side});
      }
    }
    return sides;
  }
  [[nodiscard]] std::array<VertexId, 3> face(std::size_t f) const {
    return outward_facet(mesh_.corners[sides_[f].tet], sides_[f].side);
  }
  [[nodiscard]] std::size_t number(const Side& side) const {
    const auto place = [](const Side& s) { return 4 * s.tet.index() + s.side; };
    const auto at = std::partition_point(sides_.begin(), sides_.end(),
                                         [&](const Side& s) { return place(s) < place(side); });
    return static_cast<std::size_t>(at - sides_.begin());
  }
  [[nodiscard]] std::size_t corner(std::size_t f, VertexId v) const {
    const auto corners = face(f);
    return 3 * f + static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
  }

  const TetMesh& mesh_;
  std::vector<Side> sides_;
  DisjointSets shells_, sheets_;
};

/// What lies about one star, in the notes' letters: d_phi, d_e, F_b, N_b, and the parts of E: faces within the mesh that
/// meet the star and edges on the boundary.
struct StarCounts {
  std::int64_t tets{}, edges{}, faces{}, boundary_faces{}, boundary_edges{}, sheets{};

  [[nodiscard]] std::int64_t polyhedron_faces() const { return tets + boundary_faces; }
  [[nodiscard]] std::int64_t polyhedron_vertices() const { return edges + sheets; }
  [[nodiscard]] std::int64_t polyhedron_edges() const { return faces + boundary_edges; }
};

void count_tets_and_faces(const TetMesh& mesh, const FaceStructure& faces, const Stars& stars,
                          std::vector<StarCounts>& counts) {
  for (const TetId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 4; ++i) ++counts[stars.at(t, i)].tets;
  }
  for (const FaceId f : faces.corners.ids()) {
    const TetId t = faces.sides[f][0] ? *faces.sides[f][0] : *faces.sides[f][1];
    for (const VertexId v : faces.corners[f]) ++counts[stars.at(mesh, t, v)].faces;
  }
}

std::size_t vertices_in_use(const TetMesh& mesh) {
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) used[v] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

/// Pairs of boundary faces beyond the first, over all edges: counted at the edges, not by going round them.
std::size_t edge_pinches(const FaceStructure& faces, const TetEdges& edges) {
  PerId<EdgeId, IdRaw> boundary_faces(edges.edge_count(), 0);
  for (const FaceId f : faces.corners.ids()) {
    if (!faces.is_boundary(f)) continue;
    const auto& [a, b, c] = faces.corners[f];
    for (const auto& edge : {edges.find(a, b), edges.find(b, c), edges.find(a, c)}) {
      if (edge) ++boundary_faces[*edge];
    }
  }
  return std::accumulate(boundary_faces.begin(), boundary_faces.end(), std::size_t{0},
                         [](std::size_t sum, IdRaw n) { return sum + (n > 2 ? n / 2 - 1 : 0); });
}

/// Sums over all stars, and how many stars satisfy the formulas.
struct StarSums {
  std::int64_t stars{}, tets{}, edges{}, boundary_faces{}, sheets{};
  std::int64_t with_117{}, with_118{}, with_119{};

  explicit StarSums(const std::vector<StarCounts>& counts) : stars(static_cast<std::int64_t>(counts.size())) {
    for (const StarCounts& s : counts) {
      tets += s.tets;
      edges += s.edges;
      boundary_faces += s.boundary_faces;
      sheets += s.sheets;
      with_117 += s.polyhedron_faces() + s.polyhedron_vertices() == s.polyhedron_edges() + 2;
      with_118 += 2 * s.polyhedron_edges() == 3 * s.polyhedron_faces();
      with_119 += 2 * s.edges == s.tets + s.boundary_faces - 2 * s.sheets + 4;
    }
  }
};

void write_formulas(TetEulerAccount& account, const StarSums& sums) {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const std::int64_t v = n(account.stars), e = n(account.fans), f = n(account.faces),
                     phi = n(account.tetrahedra);
  const std::int64_t v_bound = n(account.sheets), e_bound = n(account.boundary_edges),
                     f_bound = n(account.boundary_faces);
  const std::int64_t c = n(account.components), h = n(account.handles), k = n(account.cavities),
                     s = n(account.shells);
  account.formulas = {
      {"(1.1.5)", "closed by a cone over each shell, vertices + faces are edges + volumes + handles",
       (v + s) + (f + e_bound), (e + v_bound) + (phi + f_bound) + h},
      {"(1.1.6)", "faces + vertices are edges + tetrahedra + components - handles + cavities", f + v,
       e + phi + c - h + k},
      {"(1.1.7)", "about every star, faces + vertices of the polyhedron are its edges + 2", sums.with_117,
       sums.stars},
      {"(1.1.8)", "about every star, the polyhedron's faces are triangles: 2 edges for 3 faces",
       sums.with_118, sums.stars},
      {"(1.1.9)", "about every star, 2 edges are tetrahedra + boundary faces - 2 sheets + 4", sums.with_119,
       sums.stars},
      {"(1.1.10)", "summed over stars, 2 edges are tetrahedra + boundary faces - 2 sheets + 4",
       2 * sums.edges, sums.tets + sums.boundary_faces - 2 * sums.sheets + 4 * v},
      {"(1.1.11)", "edges summed over stars are twice the edges", sums.edges, 2 * e},
      {"(1.1.11)", "tetrahedra summed over stars are four times the tetrahedra", sums.tets, 4 * phi},
      {"(1.1.12)", "4 edges are 4 tetrahedra + 4 vertices + sum of boundary faces - 2 sum of sheets", 4 * e,
       4 * phi + 4 * v + sums.boundary_faces - 2 * sums.sheets},
      {"(1.1.13)", "4 edges are 4 tetrahedra + 4 vertices + 3 boundary faces - 2 boundary vertices", 4 * e,
       4 * phi + 4 * v + 3 * f_bound - 2 * v_bound},
      {"(1.1.14)", "2 faces are 4 tetrahedra + boundary faces", 2 * f, 4 * phi + f_bound},
      {"(1.1.15)", "4 edges + 4 tetrahedra are 4 faces + 4 vertices + boundary faces - 2 boundary vertices",
       4 * e + 4 * phi, 4 * f + 4 * v + f_bound - 2 * v_bound},
      {"half the boundary's", "twice the characteristic is the boundary's: vertices - edges + faces",
       2 * account.characteristic(), v_bound - e_bound + f_bound},
      {"boundary edges", "each boundary face has three edges, each boundary edge two faces", 2 * e_bound,
       3 * f_bound},
      {"boundary corners", "boundary faces summed over stars are three times the boundary faces",
       sums.boundary_faces, 3 * f_bound},
      {"outer shells", "each component has one shell that encloses a positive volume",
       n(account.outer_shells), c},
      {"shells", "shells are outer shells, one a component, and cavities", s, c + k},
      {"boundary", "the boundary faces that the mesh lists are those with one tetrahedron",
       n(account.listed_boundary_faces), f_bound},
      {"vertices", "every vertex has a tetrahedron, and pinched ones one star more for each pinch", v,
       n(account.vertices) + n(account.vertex_pinches)},
      {"edges", "every edge has a fan, and pinched ones one more for each pinch", e,
       n(account.edges) + n(account.edge_pinches)},
  };
}

}  // namespace

TetEulerAccount euler_account(const TetMesh& mesh, const FaceStructure& faces, const TetEdges& edges) {
  require_faces_within(mesh, faces);
  require_edge_list_of(mesh, edges);
  TetEulerAccount account;
  account.vertices = mesh.vertex_count();
  account.edges = edges.edge_count();
  account.faces = faces.face_count();
  account.tetrahedra = mesh.tet_count();
  account.listed_boundary_faces = mesh.boundary.size();
  account.components = component_count(mesh);

  const Stars stars(mesh);
  account.stars = stars.count();
  account.vertex_pinches = account.stars - vertices_in_use(mesh);
  std::vector<StarCounts> counts(stars.count());
  count_tets_and_faces(mesh, faces, stars, counts);

  Boundary boundary(mesh);
  PerId<EdgeId, char> has_fan(edges.edge_count(), 0);
  FanWalk(mesh).for_each([&](const Fan& fan) {
    ++account.fans;
    if (const auto e = edges.find(fan.from, fan.to)) has_fan[*e] = 1;
    if (fan.ends) ++account.boundary_edges, boundary.join(fan);
    for (const VertexId v : {fan.from, fan.to}) {
      StarCounts& star = counts[stars.at(mesh, fan.tet, v)];
      ++star.edges;
      if (fan.ends) ++star.boundary_edges;
    }
  });
  for (const EdgeId e : edges.ends.ids())
    if (!has_fan[e]) throw_foreign_edge(e, edges.ends[e]);
  account.edge_pinches = edge_pinches(faces, edges);

  boundary.for_each_corner([&](const Side& side, std::size_t corner, bool first_of_sheet) {
    StarCounts& star = counts[stars.at(side.tet, corner)];
    ++star.boundary_faces;
    if (first_of_sheet) ++star.sheets;
  });
  account.boundary_faces = static_cast<std::size_t>(
      std::count_if(faces.sides.begin(), faces.sides.end(), [](const auto& s) { return !s[0] || !s[1]; }));
  account.sheets = boundary.sheet_count();
  for (const StarCounts& star : counts) {
    if (star.sheets > 1) account.sheet_pinches += static_cast<std::size_t>(star.sheets - 1);
  }

  const std::vector<Sign> signs = boundary.shell_signs();
  account.shells = boundary.shell_count();
  account.outer_shells = static_cast<std::size_t>(std::count(signs.begin(), signs.end(), Sign::positive));
  account.cavities = static_cast<std::size_t>(std::count(signs.begin(), signs.end(), Sign::negative));
  // Each shell is a closed, oriented surface: its vertices - edges + faces are 2 - 2 handles.
  account.handles =
      (2 * account.shells + account.boundary_edges - account.sheets - account.boundary_faces) / 2;
  write_formulas(account, StarSums(counts));
  return account;
}

}  // namespace mesh
}  // namespace leonhard
