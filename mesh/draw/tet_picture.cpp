// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/tet_picture.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "leonhard/mesh/draw/canvas/part_colours.hpp"
#include "leonhard/mesh/draw/plane/contours.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"
#include "leonhard/mesh/draw/space/depth_raster.hpp"
#include "leonhard/mesh/draw/space/painters_order.hpp"
#include "leonhard/mesh/draw/space/tet_scene.hpp"
#include "leonhard/mesh/tet_quality.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

constexpr const char* quality_label = "smallest angle between faces of the tetrahedron (degrees)";
constexpr std::size_t most_vector_facets = 20'000;
constexpr Colour line_ink{0.13, 0.15, 0.2}, quiet_ink{0.42, 0.42, 0.42};

Colour boundary_colour() { return to_srgb({.lightness = 84, .a = -5, .b = -17}); }
Colour inside_colour() { return to_srgb({.lightness = 88, .a = 6, .b = 46}); }
Colour neutral_inside_colour() { return to_srgb({.lightness = 93, .a = 0, .b = 4}); }

/// What a picture is made of: the facets and how they are coloured.
struct TetScene {
  const TetMesh& mesh;
  TetPictureOptions options;
  Camera camera;
  std::string caption;
  std::vector<Facet> facets;

  std::vector<Colour> palette;
  std::optional<Bands> bands;   ///< with a colour bar
  bool bands_by_value = false;  ///< the bands are of the field, not one a facet
  std::string bar_label;
  std::vector<LegendEntry> legend;
};

void check_cut(const TetPictureOptions& options) {
  if (!options.cut_plane) return;
  const auto& [point, normal] = *options.cut_plane;
  const bool has_direction = normal.x != 0 || normal.y != 0 || normal.z != 0;
  if (is_finite(point) && is_finite(Point3{normal.x, normal.y, normal.z}) && has_direction) return;
  const auto triple = [](double x, double y, double z) {
    return "(" + mesh::words(x) + ", " + mesh::words(y) + ", " + mesh::words(z) + ")";
  };
  throw InputError("cut",
                   "a plane through " + triple(point.x, point.y, point.z) + " with normal " +
                       triple(normal.x, normal.y, normal.z) + " is no plane",
                   "give a finite point and a finite normal that is not zero");
}

std::string grouped(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

// Four digits; 0 for what is rounding noise in a mesh of this size.
std::string short_words(double value, double size) {
  if (std::abs(value) < 1e-12 * size) value = 0;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(value), std::chars_format::general, 4);
  return (value < 0 ? "−" : "") + std::string(text.data(), end.ptr);
}

// "y < 0.5", or "x − 0.5 z > 1": the side that is removed.
std::string removed_side(const CutPlane& plane, const Box3& box) {
  const std::array<double, 3> normal{plane.normal.x, plane.normal.y, plane.normal.z};
  const std::array<double, 3> point{plane.point.x, plane.point.y, plane.point.z};
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  const double size = std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
  const double largest = std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
  std::string sum;
  double offset = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (normal[i] == 0) continue;
    if (std::abs(normal[i]) == norm(plane.normal)) {
      return names[i] + std::string(normal[i] > 0 ? " > " : " < ") + short_words(point[i], size);
    }
    const double share = normal[i] / largest;
    sum += sum.empty() ? (share < 0 ? "−" : "") : (share < 0 ? " − " : " + ");
    if (std::abs(share) != 1) sum += short_words(std::abs(share), 1) + " ";
    sum += names[i];
    offset += share * point[i];
  }
  return sum + " > " + short_words(offset, size);
}

std::string caption_of(const TetMesh& mesh, CutStyle cut, const CutPlane& plane, const Box3& box) {
  const std::size_t count = mesh.tet_count();
  std::string words = grouped(count) + (count == 1 ? " tetrahedron" : " tetrahedra");
  if (cut == CutStyle::none) return words;
  const std::string side = removed_side(plane, box);
  return words + (cut == CutStyle::crinkled ? "; those with centre at " + side + " are removed"
                                            : "; what lies at " + side + " is removed");
}

TetScene make_scene(const TetMesh& mesh, const TetPictureOptions& options, std::span<const double> values) {
  check_mesh(mesh);
  check_view(options.view);
  check_cut(options);
  const Box3 box = box_of(mesh);
  const CutPlane plane = options.cut_plane.value_or(cut_through_middle(box, options.view));
  TetScene scene{.mesh = mesh,
                 .options = options,
                 .camera = Camera(box, options.view),
                 .caption = caption_of(mesh, options.cut, plane, box),
                 .facets = {},
                 .palette = {},
                 .bands = {},
                 .bar_label = {},
                 .legend = {}};
  scene.facets = visible_facets(mesh, scene.camera, options.cut, plane, values);
  if (scene.facets.empty()) {
    if (options.cut == CutStyle::none) {
      throw InputError("mesh", "no face of it is turned to the viewer", "run mesh::validate on it");
    }
    throw InputError("cut", "it leaves nothing that faces the viewer",
                     "move the plane, turn its normal or leave it out");
  }
  return scene;
}

// ---- colours

void colour_plainly(TetScene& scene) {
  scene.palette = {boundary_colour(), inside_colour()};
  bool any_inside = false;
  for (Facet& facet : scene.facets) {
    facet.colour = facet.kind == FacetKind::boundary ? 0 : 1;
    any_inside = any_inside || facet.colour == 1;
  }
  if (!any_inside) return;
  scene.legend = {{.words = "boundary", .colour = scene.palette[0], .area = true},
                  {.words = "inside", .colour = scene.palette[1], .area = true}};
}

std::string boundary_name(const TetMesh& mesh, Marker marker) {
  const auto name = mesh.marker_names.find(marker);
  return name != mesh.marker_names.end() && !name->second.empty() ? name->second
                                                                  : "marker " + std::to_string(marker);
}

void colour_by_marker(TetScene& scene) {
  // Numbered over the whole mesh, so that a marker keeps its colour whatever is cut away.
  std::map<Marker, std::uint32_t> number;
  for (const auto* list : {&scene.mesh.boundary, &scene.mesh.interfaces}) {
    for (const MarkedFace& face : *list) number.emplace(face.marker, 0);
  }
  scene.palette = {neutral_inside_colour()};
  for (auto& [marker, index] : number) {
    index = static_cast<std::uint32_t>(scene.palette.size());
    scene.palette.push_back(area_colour(index - 1));
  }
  std::set<std::uint32_t> shown;
  for (Facet& facet : scene.facets) {
    const auto at = facet.marker ? number.find(*facet.marker) : number.end();
    facet.colour = at == number.end() ? 0 : at->second;
    shown.insert(facet.colour);
  }
  for (const auto& [marker, index] : number) {
    if (!shown.contains(index)) continue;
    scene.legend.push_back(
        {.words = boundary_name(scene.mesh, marker), .colour = scene.palette[index], .area = true});
  }
  if (shown.contains(0)) {
    scene.legend.push_back({.words = "inside", .colour = scene.palette[0], .area = true});
  }
}

void colour_by_region(TetScene& scene) {
  const TetMesh& mesh = scene.mesh;
  std::map<double, std::uint32_t> number;
  const auto region = [&](TetId t) { return mesh.regions.contains(t) ? mesh.regions[t] : 0.0; };
  for (const TetId t : mesh.corners.ids()) number.emplace(region(t), 0);
  for (auto& [attribute, index] : number) {
    index = static_cast<std::uint32_t>(scene.palette.size());
    scene.palette.push_back(area_colour(index));
  }
  std::set<std::uint32_t> shown;
  for (Facet& facet : scene.facets) shown.insert(facet.colour = number.at(region(facet.tet)));
  for (const auto& [attribute, index] : number) {
    if (!shown.contains(index)) continue;
    scene.legend.push_back(
        {.words = "region " + mesh::words(attribute), .colour = scene.palette[index], .area = true});
  }
}

double smallest_dihedral_deg(const TetMesh& mesh, TetId t) {
  const auto& [a, b, c, d] = mesh.corners[t];
  return mesh::tet_quality(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]).min_dihedral_deg;
}

void colour_by_quality(TetScene& scene) {
  // Fifteen bands of 5 degrees; the regular tetrahedron has 70.5.
  FieldOptions options;
  options.value_range = Range{0, 75};
  options.bands = 15;
  scene.bands = make_bands({0, 75}, options);
  scene.bar_label = quality_label;
  scene.palette = scene.bands->colours;
  for (Facet& facet : scene.facets) {
    facet.colour =
        static_cast<std::uint32_t>(scene.bands->index_of(smallest_dihedral_deg(scene.mesh, facet.tet)));
  }
}

void colour_by_value(TetScene& scene, const TetFieldScale& scale) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range seen{infinity, -infinity};
  for (const Facet& facet : scene.facets) {
    for (std::size_t i = 0; i < facet.count; ++i) {
      seen = {std::min(seen.low, facet.corners[i].value), std::max(seen.high, facet.corners[i].value)};
    }
  }
  FieldOptions options;
  options.colour_map = scale.colour_map;
  options.value_range = scale.range;
  options.bands = scale.bands;
  scene.bands = make_bands(seen, options);
  scene.bands_by_value = true;
  scene.bar_label = scale.label;
  scene.palette = scene.bands->colours;
}

void colour_by_part(TetScene& scene, std::span<const std::uint32_t> part_of, std::uint32_t parts) {
  const TetMesh& mesh = scene.mesh;
  std::vector<std::set<std::uint32_t>> touching(parts);
  for (const TetId t : mesh.corners.ids()) {
    for (const MaybeId<TetId> across : mesh.neighbours[t]) {
      if (!across) continue;
      const std::uint32_t a = part_of[t.index()], b = part_of[(*across).index()];
      if (a != b) touching[a].insert(b);
    }
  }
  const auto colour_of = colour_parts(touching);
  for (std::size_t c = 0; c <= std::ranges::max(colour_of); ++c) scene.palette.push_back(area_colour(c));
  for (Facet& facet : scene.facets) {
    facet.colour = static_cast<std::uint32_t>(colour_of[part_of[facet.tet.index()]]);
  }
}

// ---- painting

void paint_as_image(Canvas& canvas, const TetScene& scene, const Rect& area) {
  DepthRaster raster(area, canvas.dots_per_pixel());
  FacetPaint paint{.colours = scene.palette,
                   .levels = {},
                   .line = line_ink,
                   .thin = canvas.thin(),
                   .show_lines = scene.options.show_edges,
                   .is_perspective = scene.camera.is_perspective()};
  if (scene.bands_by_value) paint.levels = scene.bands->levels;
  for (const Facet& facet : scene.facets) raster.fill(facet, paint);
  canvas.image(area, raster.resolve());
}

std::vector<Point2> outline(const Facet& facet) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < facet.count; ++i) points.push_back({facet.corners[i].x, facet.corners[i].y});
  return points;
}

// The bands of a field on a facet, fan by fan; in perspective linear on the page, which small facets do not show.
void paint_bands(Canvas& canvas, const TetScene& scene, const Facet& facet) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Bands& bands = *scene.bands;
  const double light = brightness(facet);
  for (std::size_t k = 2; k < facet.count; ++k) {
    const std::array<const FacetCorner*, 3> fan{&facet.corners[0], &facet.corners[k - 1], &facet.corners[k]};
    std::array<Point2, 3> p;
    std::array<double, 3> u{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = {fan[i]->x, fan[i]->y}, u[i] = fan[i]->value;
    const auto [least, most] = std::ranges::minmax(u);
    for (std::size_t i = bands.index_of(least); i <= bands.index_of(most); ++i) {
      const double low = i == 0 ? -infinity : bands.levels[i - 1];
      const double high = i == bands.levels.size() ? infinity : bands.levels[i];
      add_polygon(canvas, band_of(p, u, low, high));
      const Colour colour = lit(bands.colours[i], light);
      canvas.fill_and_keep(colour);
      canvas.stroke({colour, 0.3});
    }
  }
}

void paint_facet(Canvas& canvas, const TetScene& scene, const Facet& facet) {
  if (scene.bands_by_value) {
    paint_bands(canvas, scene, facet);
  } else {
    const Colour colour = lit(scene.palette[facet.colour], brightness(facet));
    add_polygon(canvas, outline(facet));
    canvas.fill_and_keep(colour);
    canvas.stroke({colour, 0.3});  // closes the hair's breadth that viewers leave between areas
  }
  if (!scene.options.show_edges) return;
  for (std::size_t i = 0; i < facet.count; ++i) {
    const FacetCorner &a = facet.corners[i], &b = facet.corners[(i + 1) % facet.count];
    const double width = line_width(facet, i, canvas.thin());
    if (width > 0.02) canvas.line({a.x, a.y}, {b.x, b.y}, {line_ink, width});
  }
}

void paint_facets(Canvas& canvas, const TetScene& scene, const Rect& area) {
  if (!canvas.is_vector()) return paint_as_image(canvas, scene, area);
  const auto order = painters_order(scene.facets, area);
  if (order.size() > most_vector_facets) return paint_as_image(canvas, scene, area);
  for (const std::uint32_t f : order) paint_facet(canvas, scene, scene.facets[f]);
}

// ---- around the mesh

void draw_triad(Canvas& canvas, const Camera& camera, Point2 origin) {
  struct Arrow {
    Vec3 direction;
    const char* name;
    Colour colour;
  };
  std::array<Arrow, 3> arrows{{{camera.turn(Vec3{1, 0, 0}), "x", {0.75, 0.2, 0.15}},
                               {camera.turn(Vec3{0, 1, 0}), "y", {0.15, 0.5, 0.2}},
                               {camera.turn(Vec3{0, 0, 1}), "z", {0.15, 0.3, 0.7}}}};
  std::ranges::sort(arrows, {}, [](const Arrow& arrow) { return arrow.direction.z; });
  const double em = canvas.text_size(), reach = 1.9 * em;
  for (const Arrow& arrow : arrows) {
    const Vec2 along{arrow.direction.x, -arrow.direction.y};
    const double seen = norm(along);
    const Point2 tip = origin + reach * along;
    canvas.line(origin, tip, {arrow.colour, 2});
    const Vec2 unit = seen > 1e-9 ? (1 / seen) * along : Vec2{0.7, -0.7}, across{-unit.y, unit.x};
    if (seen > 0.25) {
      canvas.move_to(tip + 0.3 * em * unit);
      canvas.line_to(tip + 0.17 * em * across);
      canvas.line_to(tip + (-0.17 * em) * across);
      canvas.close_path();
      canvas.fill(arrow.colour);
    }
    canvas.text(tip + 0.75 * em * unit, arrow.name,
                {.size = 0.9, .bold = true, .across = 0.5, .colour = arrow.colour});
  }
}

std::vector<Point2> some_corners(const std::vector<Facet>& facets) {
  std::vector<Point2> points;
  const std::size_t step = 1 + facets.size() / 20'000;
  for (std::size_t f = 0; f < facets.size(); f += step)
    points.push_back({facets[f].corners[0].x, facets[f].corners[0].y});
  return points;
}

void paint(const std::filesystem::path& path, TetScene& scene) {
  const TetPictureOptions& options = scene.options;
  Canvas canvas(path, options.size);
  const double em = canvas.text_size();
  const double top = (options.title.empty() ? 1.0 : 3.0) * em,
               bottom = (options.show_caption ? 2.4 : 1.0) * em;
  const double left = (options.show_axes ? 4.6 : 1.0) * em;
  const double right = scene.bands ? colour_bar_room(canvas, *scene.bands, scene.bar_label) + em : em;
  const Rect area{left, top, std::max(canvas.width() - left - right, em),
                  std::max(canvas.height() - top - bottom, em)};
  mark_lines(scene.facets, !scene.bands);
  place(scene.facets, area);
  paint_facets(canvas, scene, area);

  canvas.text({em, 0.9 * em}, options.title, {.size = 1.15, .bold = true, .down = 0});
  if (options.show_caption) {
    canvas.text({canvas.width() - em, canvas.height() - em}, scene.caption,
                {.size = 0.8, .across = 1, .colour = quiet_ink});
  }
  if (options.show_axes) draw_triad(canvas, scene.camera, {3.1 * em, canvas.height() - 2.9 * em});
  draw_legend(canvas, {em, top, canvas.width() - 2 * em, area.height}, scene.legend, options.legend,
              some_corners(scene.facets));
  if (scene.bands) {
    draw_colour_bar(canvas, {area.right() + 0.5 * em, area.top + 0.5 * em, right, area.height - em},
                    *scene.bands, scene.bar_label);
  }
  canvas.save();
}

void check_values(std::size_t vertices, std::span<const double> values, const TetFieldScale& scale) {
  if (values.size() != vertices) {
    throw InputError(
        "field",
        std::to_string(values.size()) + " values for " + std::to_string(vertices) + " vertices",
        "give one value a vertex");
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!std::isfinite(values[v])) {
      throw InputError("field", "the value of vertex " + std::to_string(v) + " is " + mesh::words(values[v]),
                       "give finite values");
    }
  }
  if (scale.range && !(std::isfinite(scale.range->low) && std::isfinite(scale.range->high) &&
                       scale.range->low < scale.range->high)) {
    throw InputError(
        "value range",
        "from " + mesh::words(scale.range->low) + " to " + mesh::words(scale.range->high) + " is no range",
        "give finite bounds, the lower one first");
  }
  if (scale.bands < 1 || scale.bands > 200) {
    throw InputError("bands", std::to_string(scale.bands) + " is out of range", "give 1 to 200");
  }
}

/// The box of a surface's corners. throws InputError for an id out of range, a point that is not finite, no triangle
Box3 box_of(const PerId<VertexId, Point3>& points, std::span<const std::array<VertexId, 3>> triangles) {
  if (triangles.empty()) throw InputError("surface", "it has no triangle", "there is nothing to draw");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box3 box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const auto& triangle : triangles) {
    for (const VertexId v : triangle) {
      if (!points.contains(v) || !is_finite(points[v]))
        throw InputError("surface", "vertex " + std::to_string(v.raw) + " is not there or not finite",
                         "run mesh::validate on the mesh");
      const Point3& p = points[v];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
  }
  return box;
}

void check_parts(const TetMesh& mesh, std::span<const std::uint32_t> part_of, std::uint32_t parts) {
  if (part_of.size() != mesh.tet_count()) {
    throw InputError(
        "partition",
        std::to_string(part_of.size()) + " entries for " + std::to_string(mesh.tet_count()) + " tetrahedra",
        "give one part a tetrahedron");
  }
  if (parts < 1 || parts > 65000) {
    throw InputError("partition", std::to_string(parts) + " parts are out of range", "give 1 to 65000");
  }
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    if (part_of[i] >= parts) {
      throw InputError("partition",
                       "entry " + std::to_string(i) + " is part " + std::to_string(part_of[i]) + " of " +
                           std::to_string(parts),
                       "number the parts from 0");
    }
  }
}

}  // namespace

void draw_tet_mesh(const std::filesystem::path& path, const TetMesh& mesh, TetFill fill,
                   const TetPictureOptions& options) {
  TetScene scene = make_scene(mesh, options, {});
  switch (fill) {
    case TetFill::plain:
      colour_plainly(scene);
      break;
    case TetFill::marker:
      colour_by_marker(scene);
      break;
    case TetFill::region:
      colour_by_region(scene);
      break;
    case TetFill::quality:
      colour_by_quality(scene);
      break;
  }
  paint(path, scene);
}

void draw_tet_field(const std::filesystem::path& path, const TetMesh& mesh,
                    std::span<const double> vertex_values, const TetFieldScale& scale,
                    const TetPictureOptions& options) {
  check_values(mesh.vertex_count(), vertex_values, scale);
  TetScene scene = make_scene(mesh, options, vertex_values);
  colour_by_value(scene, scale);
  paint(path, scene);
}

void draw_surface_field(const std::filesystem::path& path, const PerId<VertexId, Point3>& points,
                        std::span<const std::array<VertexId, 3>> triangles, std::span<const double> vertex_values,
                        const TetFieldScale& scale, const TetPictureOptions& options) {
  check_values(points.size(), vertex_values, scale);
  check_view(options.view);
  const Box3 box = box_of(points, triangles);
  const TetMesh no_tetrahedra;
  TetScene scene{.mesh = no_tetrahedra,
                 .options = options,
                 .camera = Camera(box, options.view),
                 .caption = grouped(triangles.size()) + " facets",
                 .facets = {},
                 .palette = {},
                 .bands = {},
                 .bar_label = {},
                 .legend = {}};
  scene.facets = visible_facets(points, triangles, scene.camera, vertex_values);
  if (scene.facets.empty())
    throw InputError("surface", "no triangle of it is turned to the viewer", "look from another side");
  colour_by_value(scene, scale);
  paint(path, scene);
}

void draw_tet_partition(const std::filesystem::path& path, const TetMesh& mesh,
                        std::span<const std::uint32_t> part_of, std::uint32_t parts,
                        const TetPictureOptions& options) {
  check_parts(mesh, part_of, parts);
  TetScene scene = make_scene(mesh, options, {});
  colour_by_part(scene, part_of, parts);
  paint(path, scene);
}

}  // namespace leonhard::draw
