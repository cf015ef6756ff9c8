// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/any_mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/any_contents.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/pslg_file.hpp"
#include "leonhard/mesh/io/soup/read_soup.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/tet_mesh_file.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

constexpr const char* marker_field = "marker";

template <class File>
AnyMeshFile any_of(File&& file) {
  return {std::move(file.mesh), std::move(file.warnings), std::move(file.point_fields),
          std::move(file.cell_fields)};
}

template <int Dim>
const char* facet_in_words(const SimplexMesh<Dim>&) {
  return Simplex<Dim>::facet;
}
template <int Dim>
const char* facet_in_words(const MixedMesh<Dim>&) {
  return Simplex<Dim>::facet;
}

template <int Dim>
const auto& inner_facets_in(const SimplexMesh<Dim>& mesh) {
  return mesh.inner_facets();
}
template <int Dim>
const auto& inner_facets_in(const MixedMesh<Dim>& mesh) {
  return mesh.inner_facets;
}

template <int Dim>
auto& inner_facets_in(SimplexMesh<Dim>& mesh) {
  return mesh.inner_facets();
}
template <int Dim>
auto& inner_facets_in(MixedMesh<Dim>& mesh) {
  return mesh.inner_facets;
}

/// Which of the things that a mesh may carry a format has a place for.
struct FormatPlaces {
  bool regions = true, inner_facets = true, vertex_markers = true, fields = false;
};

FormatPlaces places_of(const std::string& extension) {
  if (extension == ".su2") return {false, false, false, false};
  if (extension == ".msh") return {true, true, false, true};
  if (extension == ".vtu") return {true, true, true, true};
  return {};
}

class LossList {
 public:
  void add(const std::string& what) { words_ += (words_.empty() ? "" : ", ") + what; }
  [[nodiscard]] const std::string& words() const { return words_; }

 private:
  std::string words_;
};

template <class Field>
void add_lost_fields(LossList& list, const std::vector<Field>& fields) {
  for (const Field& field : fields) list.add("the field " + in_quotes(field.name));
}

template <class Mesh>
void add_lost_parts(LossList& list, const Mesh& mesh, const FormatPlaces& places) {
  const std::set<double> regions(mesh.regions.begin(), mesh.regions.end());
  const bool has_regions = regions.size() > 1 || (regions.size() == 1 && *regions.begin() != 0);
  if (!places.regions && has_regions)
    list.add(regions.size() == 1 ? "the region of the cells"
                                 : "regions (" + std::to_string(regions.size()) + " different ones)");
  const std::size_t inner = inner_facets_in(mesh).size();
  if (!places.inner_facets && inner > 0)
    list.add(std::to_string(inner) + " inner " + facet_in_words(mesh) + (inner == 1 ? "" : "s"));
  const bool has_vertex_markers = std::any_of(mesh.vertex_markers.begin(), mesh.vertex_markers.end(),
                                              [](Marker marker) { return marker != 0; });
  if (!places.vertex_markers && has_vertex_markers) list.add("markers of vertices");
}

/// Numbers that a format without signs can hold, for those that are not.
class Renumbering {
 public:
  Renumbering(std::set<Marker> used, std::map<Marker, std::string>& names, const char* word)
      : used_(std::move(used)), names_(names), word_(word) {}

  /// A number in place of one that is negative or no whole number of 32 bits.
  Marker operator()(double old) {
    if (old >= 0 && old <= std::numeric_limits<Marker>::max() && old == std::floor(old))
      return static_cast<Marker>(old);
    const auto [at, is_new] = new_numbers_.emplace(old, 0);
    if (!is_new) return at->second;
    while (used_.contains(next_)) ++next_;
    used_.insert(next_);
    at->second = next_;
    std::string name = std::string(word_) + "_" + mesh::words(old);
    if (old == std::floor(old) && std::abs(old) <= std::numeric_limits<Marker>::max())
      if (const auto named = names_.find(static_cast<Marker>(old)); named != names_.end()) {
        name = named->second;
        names_.erase(named);
      }
    names_.insert_or_assign(next_, name);
    return next_;
  }

  [[nodiscard]] std::string words() const {
    std::string list;
    for (const auto& [old, number] : new_numbers_)
      list += (list.empty() ? std::string(word_) + " " : ", ") + mesh::words(old) + " is now " +
              std::to_string(number);
    return list;
  }

 private:
  std::set<Marker> used_;
  std::map<Marker, std::string>& names_;
  const char* word_;
  std::map<double, Marker> new_numbers_;
  Marker next_ = 1;
};

template <class Mesh>
std::string renumber(Mesh& mesh) {
  std::set<Marker> used{0}, used_regions{0};
  for (const auto& facet : mesh.boundary) used.insert(facet.marker);
  for (const auto& facet : inner_facets_in(mesh)) used.insert(facet.marker);
  for (const auto& name : mesh.marker_names) used.insert(name.first);
  for (const double region : mesh.regions)
    if (std::abs(region) <= std::numeric_limits<Marker>::max())
      used_regions.insert(static_cast<Marker>(region));
  for (const auto& name : mesh.region_names) used_regions.insert(name.first);
  Renumbering of_markers(std::move(used), mesh.marker_names, "marker"),
      of_regions(std::move(used_regions), mesh.region_names, "region");
  for (auto& facet : mesh.boundary) facet.marker = of_markers(facet.marker);
  for (auto& facet : inner_facets_in(mesh)) facet.marker = of_markers(facet.marker);
  for (Marker& marker : mesh.vertex_markers)
    if (marker < 0) marker = of_markers(marker);
  for (double& region : mesh.regions) region = of_regions(region);
  const std::string markers = of_markers.words(), regions = of_regions.words();
  return markers + (markers.empty() || regions.empty() ? "" : "; ") + regions;
}

AnyMeshFile mesh_of(AnySoup&& any, const ReadOptions& options) {
  return std::visit(
      [&](auto&& soup) {
        constexpr int dimension = std::is_same_v<std::decay_t<decltype(soup)>, MeshSoup<2>> ? 2 : 3;
        const bool simplices_alone =
            soup.mesh.count_of(simplex_kind<dimension>) == soup.mesh.cell_count() || options.split;
        if (simplices_alone) return any_of(assemble_simplices(std::move(soup), options));
        return any_of(assemble_mixed(std::move(soup), options));
      },
      std::move(any));
}

template <int Dim>
bool has_facets_alone(const MeshSoup<Dim>& soup) {
  return soup.mesh.kinds.empty() && !soup.mesh.boundary.empty();
}

/// The faces of a file without cells.
SurfaceFile surface_of(MeshSoup<3>&& soup) {
  SurfaceBuilder surface(soup.source, 0);
  surface.set_points({std::move(soup.mesh.points.flat()), {}, 0, {}}, 0);
  for (std::size_t i = 0; i < soup.mesh.boundary.size(); ++i) {
    const auto& face = soup.mesh.boundary[i];
    for (const VertexId v : face.corners) surface.add_corner(static_cast<std::int64_t>(v.index()));
    surface.end_polygon(soup.facet_lines.empty() ? 0 : soup.facet_lines[i], face.marker);
  }
  for (std::string& warning : soup.warnings) surface.warn(std::move(warning));
  return std::move(surface).finish();
}

}  // namespace

const std::vector<std::string>& any_mesh_extensions() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> all = soup_extensions(2);
    for (const std::string& extension : soup_extensions(3))
      if (std::find(all.begin(), all.end(), extension) == all.end()) all.push_back(extension);
    return all;
  }();
  return known;
}

std::vector<std::string> any_mesh_output_extensions(const AnyMeshFile& file) {
  if (std::holds_alternative<TriangleMesh>(file.mesh)) return mesh_extensions();
  if (std::holds_alternative<TetMesh>(file.mesh)) return tet_mesh_extensions();
  return mixed_mesh_extensions();
}

AnyMeshFile read_any_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  return mesh_of(read_any_soup(path, options), options);
}

AnyContents read_any_contents(const std::filesystem::path& path, const ReadOptions& options) {
  AnySoup soup = read_any_soup(path, options);
  if (auto* space = std::get_if<MeshSoup<3>>(&soup); space != nullptr && has_facets_alone(*space))
    return surface_of(std::move(*space));
  const bool can_be_graph = std::ranges::count(pslg_extensions(), small_extension(path)) > 0;
  if (auto* plane = std::get_if<MeshSoup<2>>(&soup);
      plane != nullptr && can_be_graph && has_facets_alone(*plane))
    return EdgesAlone{};
  return mesh_of(std::move(soup), options);
}

void write_any_mesh(const std::filesystem::path& path, const AnyMeshFile& file, const WriteOptions& options) {
  const std::string extension = known_extension(path, any_mesh_output_extensions(file), "mesh");
  if (extension == ".msh") {
    const GmshForm form{options.msh_2_2 ? GmshVersion::v2_2 : GmshVersion::v4_1, options.msh_binary};
    return std::visit(
        [&](const auto& mesh) { write_gmsh(path, mesh, form, file.point_fields, file.cell_fields); },
        file.mesh);
  }
  const bool with_fields = carries_fields(path);
  static const std::vector<PointField> no_point_fields;
  static const std::vector<CellField> no_cell_fields;
  const auto& point_fields = with_fields ? file.point_fields : no_point_fields;
  const auto& cell_fields = with_fields ? file.cell_fields : no_cell_fields;
  if (const auto* triangles = std::get_if<TriangleMesh>(&file.mesh))
    return write_mesh(path, *triangles, point_fields, cell_fields);
  if (const auto* tets = std::get_if<TetMesh>(&file.mesh))
    return write_tet_mesh(path, *tets, point_fields, cell_fields);
  if (const auto* plane = std::get_if<MixedMesh<2>>(&file.mesh))
    return write_mixed_mesh(path, *plane, point_fields, cell_fields);
  write_mixed_mesh(path, std::get<MixedMesh<3>>(file.mesh), point_fields, cell_fields);
}

std::string left_behind(const std::filesystem::path& path, const AnyMeshFile& file) {
  const FormatPlaces places = places_of(small_extension(path));
  LossList list;
  std::visit([&](const auto& mesh) { add_lost_parts(list, mesh, places); }, file.mesh);
  if (!places.fields) {
    add_lost_fields(list, file.point_fields);
    add_lost_fields(list, file.cell_fields);
  }
  return list.words();
}

std::string renumber_markers(AnyMeshFile& file) {
  return std::visit([](auto& mesh) { return renumber(mesh); }, file.mesh);
}

PointField finite_field(const AnyMeshFile& file, const std::string& name, const std::string& source) {
  const auto found = std::find_if(file.point_fields.begin(), file.point_fields.end(),
                                  [&](const PointField& field) { return field.name == name; });
  if (found == file.point_fields.end()) {
    const std::vector<double> markers = std::visit(
        [](const auto& mesh) {
          return std::vector<double>(mesh.vertex_markers.begin(), mesh.vertex_markers.end());
        },
        file.mesh);
    if (name == marker_field && !markers.empty()) return {marker_field, 1, markers};
    std::string names = markers.empty() ? "" : std::string("it has ") + marker_field;
    for (const PointField& field : file.point_fields)
      names += (names.empty() ? "it has " : ", ") + field.name;
    throw InputError(source, "there is no point field " + in_quotes(name), names);
  }
  if (found->components > 3)
    throw InputError(
        source, "the field " + in_quotes(name) + " has " + std::to_string(found->components) + " components",
        "1 to 3 can be read");
  for (std::size_t i = 0; i < found->values.size(); ++i)
    if (!std::isfinite(found->values[i]))
      throw InputError(source, "the field " + in_quotes(name) + " is not finite at vertex " +
                                   std::to_string(i / found->components));
  return *found;
}

}  // namespace leonhard::io
