// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/space/tet_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError("mesh", problem, "run mesh::validate on it");
}

// The markers of boundary faces and interfaces, to be found by corners in any order.
class FaceMarkers {
 public:
  explicit FaceMarkers(const TetMesh& mesh) {
    for (const auto* list : {&mesh.boundary, &mesh.interfaces}) {
      for (const MarkedFace& face : *list) faces_.push_back({sorted(face.corners), face.marker});
    }
    std::ranges::sort(faces_, {}, &MarkedFace::corners);
  }
  [[nodiscard]] std::optional<Marker> find(const std::array<VertexId, 3>& corners) const {
    const auto key = sorted(corners);
    const auto at = std::ranges::lower_bound(faces_, key, {}, &MarkedFace::corners);
    if (at == faces_.end() || at->corners != key) return std::nullopt;
    return at->marker;
  }

 private:
  static std::array<VertexId, 3> sorted(std::array<VertexId, 3> corners) {
    std::ranges::sort(corners);
    return corners;
  }
  std::vector<MarkedFace> faces_;
};

// A corner before it is seen.
struct Corner3 {
  Vec3 at;  // turned
  double value{};
  CornerPlace place;
};

struct Polygon {
  std::array<Corner3, 4> corners;
  std::uint8_t count = 0;
  void add(const Corner3& corner) { corners[count++] = corner; }
};

Vec3 area_vector(const Polygon& p) {
  Vec3 sum;
  for (std::size_t i = 2; i < p.count; ++i) {
    sum = sum + cross(p.corners[i - 1].at - p.corners[0].at, p.corners[i].at - p.corners[0].at);
  }
  return sum;
}

bool faces_viewer(const Facet& facet) {
  double area = 0;
  const FacetCorner& o = facet.corners[0];
  for (std::size_t i = 2; i < facet.count; ++i) {
    const FacetCorner &a = facet.corners[i - 1], &b = facet.corners[i];
    area += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return area > 0;
}

// None where it turns its back to the viewer.
std::optional<Facet> visible_facet(const Polygon& p, const Camera& camera) {
  if (p.count < 3) return std::nullopt;
  Facet facet;
  facet.count = p.count;
  for (std::size_t i = 0; i < p.count; ++i) {
    const Camera::Seen seen = camera.see(p.corners[i].at);
    facet.corners[i] = {seen.x, seen.y, seen.nearness, p.corners[i].value};
    facet.places[i] = p.corners[i].place;
  }
  if (!faces_viewer(facet)) return std::nullopt;
  const Vec3 normal = area_vector(p);
  const double length = norm(normal);
  facet.normal = length > 0 ? (1 / length) * normal : Vec3{0, 0, 1};
  return facet;
}

class Builder {
 public:
  Builder(const TetMesh& mesh, const Camera& camera, CutStyle style, const CutPlane& plane,
          std::span<const double> values)
      : mesh_(mesh), camera_(camera), values_(values), markers_(mesh), at_(mesh.vertex_count()) {
    for (const VertexId v : mesh.points.ids()) at_[v] = camera.turn(mesh.points[v]);
    if (style == CutStyle::none) return;
    const double longest =
        std::max({std::abs(plane.normal.x), std::abs(plane.normal.y), std::abs(plane.normal.z)});
    const Vec3 direction =
        camera.turn(Vec3{plane.normal.x / longest, plane.normal.y / longest, plane.normal.z / longest});
    normal_ = (1 / norm(direction)) * direction;
    const Vec3 through = camera.turn(plane.point);
    beyond_ = PerId<VertexId, double>(mesh.vertex_count());
    for (const VertexId v : mesh.points.ids()) {
      // Vertices meant to lie in the plane, but for rounding, shall not leave slivers.
      const double distance = dot(normal_, at_[v] - through);
      beyond_[v] = std::abs(distance) < 1e-12 ? 0 : distance;
    }
  }

  // Whole tetrahedra are removed where `style` is crinkled, none otherwise.
  std::vector<Facet> faces(CutStyle style) {
    PerId<TetId, char> is_kept(mesh_.tet_count(), 1);
    if (style == CutStyle::crinkled) {
      for (const TetId t : mesh_.corners.ids()) {
        double sum = 0;
        for (const VertexId v : mesh_.corners[t]) sum += beyond_[v];
        is_kept[t] = sum > 0 ? 0 : 1;
      }
    }
    for (const TetId t : mesh_.corners.ids()) {
      if (is_kept[t] == 0) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const MaybeId<TetId> across = mesh_.neighbours[t][i];
        if (across && is_kept[*across] != 0) continue;
        add(whole_face(t, i), across ? FacetKind::inside : FacetKind::boundary, t, face_corners(t, i));
      }
    }
    return std::move(facets_);
  }

  std::vector<Facet> planar() {
    for (const TetId t : mesh_.corners.ids()) {
      std::size_t removed = 0;
      for (const VertexId v : mesh_.corners[t]) removed += beyond_[v] > 0 ? 1 : 0;
      if (removed > 0 && removed < 4) add(section(t), FacetKind::section, t, {});
      if (removed == 4) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        if (mesh_.neighbours[t][i]) continue;
        add(trimmed(whole_face(t, i)), FacetKind::boundary, t, face_corners(t, i));
      }
    }
    return std::move(facets_);
  }

 private:
  [[nodiscard]] std::array<VertexId, 3> face_corners(TetId t, std::size_t i) const {
    const auto& [a, b, c] = tet_face_corners[i];
    return {mesh_.corners[t][a], mesh_.corners[t][b], mesh_.corners[t][c]};
  }
  [[nodiscard]] Corner3 corner(VertexId v) const {
    return {at_[v], values_.empty() ? 0 : values_[v.index()], {v, v}};
  }
  // Ends ordered by number: all who meet here get the same bits.
  [[nodiscard]] Corner3 crossing(VertexId a, VertexId b) const {
    if (beyond_[a] == 0) return corner(a);
    if (beyond_[b] == 0) return corner(b);
    if (b < a) std::swap(a, b);
    const double s = beyond_[a] / (beyond_[a] - beyond_[b]);
    const Corner3 from = corner(a), to = corner(b);
    return {from.at + s * (to.at - from.at), from.value + s * (to.value - from.value), {a, b}};
  }
  [[nodiscard]] Polygon whole_face(TetId t, std::size_t i) const {
    Polygon p;
    for (const VertexId v : face_corners(t, i)) p.add(corner(v));
    return p;
  }
  // What of a triangle is not beyond the plane.
  [[nodiscard]] Polygon trimmed(const Polygon& whole) const {
    Polygon p;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = whole.corners[i].place.low, b = whole.corners[(i + 1) % 3].place.low;
      if (beyond_[a] <= 0) p.add(whole.corners[i]);
      // A corner in the plane itself is there already.
      if ((beyond_[a] > 0) != (beyond_[b] > 0) && beyond_[a] != 0 && beyond_[b] != 0) p.add(crossing(a, b));
    }
    return p;
  }
  // Seen from the removed side.
  [[nodiscard]] Polygon section(TetId t) const {
    std::array<VertexId, 4> removed{}, kept{};
    std::size_t r = 0, k = 0;
    for (const VertexId v : mesh_.corners[t]) (beyond_[v] > 0 ? removed[r++] : kept[k++]) = v;
    Polygon p;
    if (r == 2) {
      p.add(crossing(removed[0], kept[0]));
      p.add(crossing(removed[0], kept[1]));
      p.add(crossing(removed[1], kept[1]));
      p.add(crossing(removed[1], kept[0]));
    } else {
      for (std::size_t i = 0; i < 3; ++i)
        p.add(r == 1 ? crossing(removed[0], kept[i]) : crossing(removed[i], kept[0]));
    }
    if (dot(area_vector(p), normal_) < 0) std::reverse(p.corners.begin(), p.corners.begin() + p.count);
    return p;
  }

  void add(const Polygon& p, FacetKind kind, TetId t, const std::array<VertexId, 3>& face) {
    auto facet = visible_facet(p, camera_);
    if (!facet) return;
    facet->kind = kind;
    facet->tet = t;
    if (kind != FacetKind::section) facet->marker = markers_.find(face);
    facets_.push_back(*facet);
  }

  const TetMesh& mesh_;
  const Camera& camera_;
  std::span<const double> values_;
  FaceMarkers markers_;
  PerId<VertexId, Vec3> at_;        // turned
  PerId<VertexId, double> beyond_;  // signed distance from the plane, positive where all is removed
  Vec3 normal_;                     // of the plane, turned
  std::vector<Facet> facets_;
};

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of SplitMix64 (Steele, Lea and Flood 2014)
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ x >> 27) * 0x94D049BB133111EBULL;
  return x ^ x >> 31;
}

// A number of the edge between two corners, alike in either direction. Two edges that share it by accident would have
// a line too strong or too thin, no more.
std::uint64_t edge_key(const CornerPlace& a, const CornerPlace& b) {
  const auto number = [](const CornerPlace& p) { return mixed(mixed(p.low.raw + 1) ^ p.high.raw); };
  return number(a) + number(b);
}

bool is_crease(const Facet& a, const Facet& b) {
  constexpr double cosine_of_40_degrees = 0.766;
  return a.kind == FacetKind::boundary && dot(a.normal, b.normal) < cosine_of_40_degrees;
}

}  // namespace

void check_mesh(const TetMesh& mesh) {
  if (mesh.corners.empty()) throw InputError("mesh", "it has no tetrahedron", "there is nothing to draw");
  if (mesh.neighbours.size() != mesh.corners.size()) {
    throw InputError("mesh",
                     std::to_string(mesh.neighbours.size()) + " quadruples of neighbours do not fit " +
                         std::to_string(mesh.corners.size()) + " tetrahedra",
                     "call mesh::build_neighbours first");
  }
  const auto check_vertex = [&](VertexId v, const std::string& owner) {
    if (!mesh.points.contains(v)) {
      refuse(owner + " names vertex " + std::to_string(v.raw) + ", which is not there");
    }
    const Point3& p = mesh.points[v];
    if (!is_finite(p)) {
      refuse("vertex " + std::to_string(v.raw) + " at (" + mesh::words(p.x) + ", " + mesh::words(p.y) + ", " +
             mesh::words(p.z) + ") is not finite");
    }
  };
  for (const TetId t : mesh.corners.ids()) {
    for (const VertexId v : mesh.corners[t]) {
      if (!mesh.points.contains(v) || !is_finite(mesh.points[v]))
        check_vertex(v, "tetrahedron " + std::to_string(t.raw));
    }
    for (const MaybeId<TetId> n : mesh.neighbours[t]) {
      if (n && !mesh.neighbours.contains(*n)) {
        refuse("tetrahedron " + std::to_string(t.raw) + " has neighbour " + std::to_string((*n).raw) +
               ", which is not there");
      }
    }
  }
  for (const MarkedFace& face : mesh.boundary) {
    for (const VertexId v : face.corners) check_vertex(v, "a boundary face");
  }
}

std::vector<Facet> visible_facets(const TetMesh& mesh, const Camera& camera, CutStyle style,
                                  const CutPlane& plane, std::span<const double> values) {
  Builder builder(mesh, camera, style, plane, values);
  return style == CutStyle::planar ? builder.planar() : builder.faces(style);
}

std::vector<Facet> visible_facets(const PerId<VertexId, Point3>& points,
                                  std::span<const std::array<VertexId, 3>> triangles, const Camera& camera,
                                  std::span<const double> values) {
  std::vector<Facet> facets;
  for (const auto& triangle : triangles) {
    Polygon p;
    for (const VertexId v : triangle)
      p.add({camera.turn(points[v]), values.empty() ? 0 : values[v.index()], {v, v}});
    if (const auto facet = visible_facet(p, camera)) facets.push_back(*facet);
  }
  return facets;
}

void mark_lines(std::span<Facet> facets, bool between_colours) {
  struct Side {
    std::uint64_t key;
    std::uint32_t facet, edge;
  };
  std::vector<Side> sides;
  sides.reserve(3 * facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Facet& facet = facets[f];
    for (std::size_t i = 0; i < facet.count; ++i) {
      const CornerPlace &from = facet.places[i], &to = facet.places[(i + 1) % facet.count];
      if (from == to) continue;  // a section through a vertex
      sides.push_back({edge_key(from, to), static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(i)});
    }
  }
  std::ranges::sort(sides, {}, &Side::key);
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t end = first + 1;
    while (end < sides.size() && sides[end].key == sides[first].key) ++end;
    bool strong = false;
    const Facet& one = facets[sides[first].facet];
    for (std::size_t s = first + 1; s < end; ++s) {
      const Facet& other = facets[sides[s].facet];
      strong = strong || one.kind != other.kind || is_crease(one, other) ||
               (between_colours && one.colour != other.colour);
    }
    const FacetLine line = end - first == 1 ? FacetLine::outline
                           : strong         ? FacetLine::strong
                                            : FacetLine::thin;
    for (std::size_t s = first; s < end; ++s) facets[sides[s].facet].lines[sides[s].edge] = line;
    first = end;
  }
}

void place(std::span<Facet> facets, const Rect& area) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 low{infinity, infinity}, high{-infinity, -infinity};
  for (const Facet& facet : facets) {
    for (std::size_t i = 0; i < facet.count; ++i) {
      low = {std::min(low.x, facet.corners[i].x), std::min(low.y, facet.corners[i].y)};
      high = {std::max(high.x, facet.corners[i].x), std::max(high.y, facet.corners[i].y)};
    }
  }
  const double scale = std::min(area.width / (high.x - low.x), area.height / (high.y - low.y));
  const Point2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  for (Facet& facet : facets) {
    for (std::size_t i = 0; i < facet.count; ++i) {
      FacetCorner& corner = facet.corners[i];
      corner.x = area.left + area.width / 2 + scale * (corner.x - middle.x);
      corner.y = area.top + area.height / 2 - scale * (corner.y - middle.y);
    }
  }
}

double brightness(const Facet& facet) {
  if (facet.kind == FacetKind::section) return 1;  // flat: its colours are those of the legend
  // In the camera's axes, of length 1: the light itself, and what the room gives back from the other side.
  constexpr Vec3 light{-0.36, 0.48, 0.8}, room{0.8, 0, 0.6};
  const double ambient = facet.kind == FacetKind::boundary ? 0.5 : 0.7;
  const double given =
      0.82 * std::max(0.0, dot(facet.normal, light)) + 0.36 * std::max(0.0, dot(facet.normal, room));
  return ambient + (1 - ambient) * std::min(given, 1.0);
}

Colour lit(Colour colour, double brightness) {
  return {colour.red * brightness, colour.green * brightness, colour.blue * brightness};
}

double line_width(const Facet& facet, std::size_t edge, double thin) {
  const FacetCorner &a = facet.corners[edge], &b = facet.corners[(edge + 1) % facet.count];
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length == 0) return 0;
  double height = 0;  // of the facet over the edge
  for (std::size_t i = 2; i < facet.count; ++i) {
    const FacetCorner& c = facet.corners[(edge + i) % facet.count];
    height = std::max(height, std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / length);
  }
  const double size = std::min(length, 2.5 * height) / thin;
  const double fade = std::min(1.0, std::pow(size / 26, 0.75));
  return facet.lines[edge] == FacetLine::thin ? 0.85 * fade : 0.8 + 1.1 * fade;
}

}  // namespace leonhard::draw
