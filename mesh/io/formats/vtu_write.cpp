// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/facet_cells.hpp"
#include "leonhard/mesh/io/formats/field_checks.hpp"
#include "leonhard/mesh/io/formats/vtk_array.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/formats/xml.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

namespace {

template <class T>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

/// The XML of a file and the appended data that it points into, growing together.
class VtuText {
 public:
  void line(const std::string& text) { xml_ += text + "\n"; }

  /// rows of `components` numbers; tuples = true adds their number, which field data needs.
  template <class T>
  void array(const std::string& name, std::size_t components, const std::vector<T>& values,
             bool tuples = false, const std::string& more_attributes = "") {
    xml_ += "<DataArray type=\"" + std::string(vtk_type<T>()) + "\" Name=\"" + xml_escaped(name) +
            "\" NumberOfComponents=\"" + std::to_string(components) + "\"";
    xml_ += more_attributes;
    if (tuples) xml_ += " NumberOfTuples=\"" + std::to_string(values.size() / components) + "\"";
    xml_ += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
    append_vtk_bytes(appended_, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }

  [[nodiscard]] std::string finish() && {
    xml_ += "<AppendedData encoding=\"raw\">\n_";
    return std::move(xml_) + appended_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  std::string xml_, appended_;
};

/// Two-component rows as three-component ones.
std::vector<double> with_third_component(const std::vector<double>& pairs) {
  std::vector<double> triples;
  triples.reserve(pairs.size() / 2 * 3);
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
    triples.insert(triples.end(), {pairs[i], pairs[i + 1], 0.0});
  return triples;
}

MixedFacet<2> vertices_of(const MarkedEdge& edge) { return {edge.from, edge.to}; }
MixedFacet<3> vertices_of(const MarkedFace& face) { return MixedFacet<3>(face.corners); }
template <int Dim>
const MixedFacet<Dim>& vertices_of(const MarkedMixedFacet<Dim>& facet) {
  return facet.corners;
}

template <int Dim>
const auto& inner_facets_of(const SimplexMesh<Dim>& mesh) {
  return mesh.inner_facets();
}
template <int Dim>
const auto& inner_facets_of(const MixedMesh<Dim>& mesh) {
  return mesh.inner_facets;
}

/// Numbers, and names of UTF-8, each ended by a zero byte.
void write_names(VtuText& text, const std::map<Marker, std::string>& names, const std::string& word,
                 const char* numbers_array, const char* names_array) {
  if (names.empty()) return;
  std::vector<std::int64_t> numbers;
  std::vector<std::uint8_t> bytes;
  for (const auto& [number, name] : names) {
    if (name.find('\0') != std::string::npos)
      throw InputError(word + " " + std::to_string(number), "its name holds a zero byte",
                       "choose another name");
    numbers.push_back(number);
    bytes.insert(bytes.end(), name.begin(), name.end());
    bytes.push_back(0);
  }
  text.array(numbers_array, 1, numbers, true);
  text.array(names_array, 1, bytes, true);
}

/// The facets of a mesh that are written as cells: its boundary, then those within.
template <int Dim>
struct WrittenFacets {
  std::vector<MixedFacet<Dim>> facets;
  std::vector<Marker> markers;

  template <class Mesh>
  explicit WrittenFacets(const Mesh& mesh) {
    for (const auto* list : {&mesh.boundary, &inner_facets_of(mesh)})
      for (const auto& facet : *list) {
        facets.push_back(vertices_of(facet));
        markers.push_back(facet.marker);
      }
  }
};

template <class Mesh>
void write_field_data(VtuText& text, const Mesh& mesh) {
  text.line("<FieldData>");
  text.array<std::int64_t>(vtu_names::facets, 1,
                           {std::ssize(mesh.boundary), std::ssize(inner_facets_of(mesh))}, true);
  write_names(text, mesh.marker_names, "marker", vtu_names::marker_numbers, vtu_names::marker_names);
  write_names(text, mesh.region_names, "region", vtu_names::region_numbers, vtu_names::region_names);
  text.line("</FieldData>");
}

/// The fields of vertices or of cells.
template <class Field>
void write_fields(VtuText& text, const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    if (field.components == 2) {
      text.array(field.name, 3, with_third_component(field.values), false,
                 " " + std::string(vtu_names::components) + "=\"2\"");
    } else {
      text.array(field.name, field.components, field.values);
    }
  }
}

/// The fields of cells with a row more for each facet: that of the cell at it, so that a picture shows no seam.
std::vector<CellField> with_rows_of(const std::vector<CellField>& fields,
                                    const std::vector<std::size_t>& cells) {
  std::vector<CellField> longer = fields;
  for (CellField& field : longer) {
    field.values.reserve(field.values.size() + cells.size() * field.components);
    for (const std::size_t cell : cells)
      for (std::size_t k = 0; k < field.components; ++k)
        field.values.push_back(field.values[cell * field.components + k]);
  }
  return longer;
}

Point3 in_space(Point2 p) { return {p.x, p.y, 0}; }
const Point3& in_space(const Point3& p) { return p; }

/// Cells as VTK has them.
class VtuCellArrays {
 public:
  template <class Corners>
  void add(CellKind kind, const Corners& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      connectivity_.push_back(
          static_cast<std::int64_t>(corners[kind == CellKind::prism ? vtk_prism_order[i] : i].index()));
    offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
    types_.push_back(static_cast<std::uint8_t>(vtk_type_of(kind)));
  }
  template <int Dim>
  void add_facet(const MixedFacet<Dim>& facet) {
    for (const VertexId v : facet) connectivity_.push_back(static_cast<std::int64_t>(v.index()));
    offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
    types_.push_back(static_cast<std::uint8_t>(facet.size() == 2   ? vtk_line
                                               : facet.size() == 3 ? vtk_triangle
                                                                   : vtk_quadrilateral));
  }
  void write(VtuText& text) const {
    text.array("connectivity", 1, connectivity_);
    text.array("offsets", 1, offsets_);
    text.array("types", 1, types_);
  }

 private:
  std::vector<std::int64_t> connectivity_, offsets_;
  std::vector<std::uint8_t> types_;
};

template <int Dim>
void add_cells(VtuCellArrays& cells, const SimplexMesh<Dim>& mesh) {
  for (const auto& corners : mesh.corners) cells.add(simplex_kind<Dim>, corners);
}
template <int Dim>
void add_cells(VtuCellArrays& cells, const MixedMesh<Dim>& mesh) {
  for (const CellId cell : mesh.kinds.ids()) cells.add(mesh.kinds[cell], mesh.corners_of(cell));
}

/// What goes into the piece of a file beside its cells.
struct WrittenPiece {
  std::size_t points{}, cells{};
  std::vector<double> coordinates;  ///< three a point
  VtuCellArrays cell_arrays;
};

template <class Points>
std::vector<double> coordinates_of(const Points& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const auto& point : points) {
    const Point3 p = in_space(point);
    coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  }
  return coordinates;
}

/// The file about its parts: each of the three writes its lines, or none.
template <class FieldData, class PointData, class CellData>
std::string format_piece(const WrittenPiece& piece, FieldData field_data, PointData point_data,
                         CellData cell_data) {
  VtuText text;
  const std::string compressor(vtk_compressor());
  text.line("<?xml version=\"1.0\"?>");
  text.line(std::string("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"") +
            (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian") +
            "\" header_type=\"UInt64\"" + (compressor.empty() ? "" : " compressor=\"" + compressor + "\"") +
            ">");
  text.line("<UnstructuredGrid>");
  field_data(text);
  text.line("<Piece NumberOfPoints=\"" + std::to_string(piece.points) + "\" NumberOfCells=\"" +
            std::to_string(piece.cells) + "\">");
  text.line("<PointData>");
  point_data(text);
  text.line("</PointData>");
  text.line("<CellData>");
  cell_data(text);
  text.line("</CellData>");
  text.line("<Points>");
  text.array("Points", 3, piece.coordinates);
  text.line("</Points>");
  text.line("<Cells>");
  piece.cell_arrays.write(text);
  text.line("</Cells>");
  text.line("</Piece>");
  text.line("</UnstructuredGrid>");
  return std::move(text).finish();
}

template <int Dim, class Mesh>
std::string format(const Mesh& mesh, const std::vector<PointField>& point_fields,
                   const std::vector<CellField>& cell_fields) {
  mesh::require_ids_in_range(mesh);
  check_fields(point_fields, mesh.vertex_count(), {vtu_names::vertex_marker});
  check_fields(cell_fields, mesh.cell_count(), {vtu_names::region, vtu_names::other_cell_marker});
  const WrittenFacets<Dim> facets(mesh);
  std::vector<std::size_t> cells_at_facets;
  if (!cell_fields.empty() || !mesh.regions.empty()) cells_at_facets = cells_at<Dim>(mesh, facets.facets);
  WrittenPiece piece{
      mesh.vertex_count(), mesh.cell_count() + facets.facets.size(), coordinates_of(mesh.points), {}};
  add_cells(piece.cell_arrays, mesh);
  for (const MixedFacet<Dim>& facet : facets.facets) piece.cell_arrays.add_facet(facet);
  return format_piece(
      piece, [&](VtuText& text) { write_field_data(text, mesh); },
      [&](VtuText& text) {
        write_fields(text, point_fields);
        if (!mesh.vertex_markers.empty()) text.array(vtu_names::vertex_marker, 1, mesh.vertex_markers.flat());
      },
      [&](VtuText& text) {
        write_fields(text, with_rows_of(cell_fields, cells_at_facets));
        if (!mesh.regions.empty()) {
          const std::vector<CellField> regions{{vtu_names::region, 1, mesh.regions.flat()}};
          write_fields(text, with_rows_of(regions, cells_at_facets));
        }
        std::vector<Marker> markers(mesh.cell_count(), 0);
        markers.insert(markers.end(), facets.markers.begin(), facets.markers.end());
        const bool is_taken = std::any_of(cell_fields.begin(), cell_fields.end(), [](const CellField& field) {
          return field.name == vtu_names::cell_marker;
        });
        text.array(is_taken ? vtu_names::other_cell_marker : vtu_names::cell_marker, 1, markers);
      });
}

/// The points that facets use, numbered in rising order.
class UsedPoints {
 public:
  UsedPoints(std::size_t points, const std::vector<MixedFacet<3>>& facets) : number_(points) {
    for (const MixedFacet<3>& facet : facets)
      for (const VertexId v : facet) {
        if (!number_.contains(v))
          throw InputError("surface",
                           "a facet names vertex " + std::to_string(v.raw) + ", which is not there",
                           "give facets of the mesh");
        number_[v] = v;  // is used
      }
    for (const VertexId v : number_.ids()) {
      if (!number_[v]) continue;
      number_[v] = VertexId::from(used_.size());
      used_.push_back(v);
    }
  }
  [[nodiscard]] const std::vector<VertexId>& all() const { return used_; }
  [[nodiscard]] MixedFacet<3> renumbered(MixedFacet<3> facet) const {
    for (std::size_t i = 0; i < facet.size(); ++i) facet[i] = *number_[facet[i]];
    return facet;
  }
  [[nodiscard]] PointField of(const PointField& field) const {
    PointField part{field.name, field.components, {}};
    for (const VertexId v : used_)
      for (std::size_t i = 0; i < field.components; ++i)
        part.values.push_back(field.values[v.index() * field.components + i]);
    return part;
  }

 private:
  PerId<VertexId, MaybeId<VertexId>> number_;
  std::vector<VertexId> used_;
};

}  // namespace

std::string format_vtu(const TriangleMesh& mesh, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields) {
  return format<2>(mesh, point_fields, cell_fields);
}
std::string format_vtu(const TetMesh& mesh, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields) {
  return format<3>(mesh, point_fields, cell_fields);
}
std::string format_vtu(const MixedMesh<2>& mesh, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields) {
  return format<2>(mesh, point_fields, cell_fields);
}
std::string format_vtu(const MixedMesh<3>& mesh, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields) {
  return format<3>(mesh, point_fields, cell_fields);
}

void write_vtu(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format_vtu(mesh, point_fields, cell_fields));
}
void write_vtu(const std::filesystem::path& path, const TetMesh& mesh,
               const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format_vtu(mesh, point_fields, cell_fields));
}
void write_vtu(const std::filesystem::path& path, const MixedMesh<2>& mesh,
               const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format_vtu(mesh, point_fields, cell_fields));
}
void write_vtu(const std::filesystem::path& path, const MixedMesh<3>& mesh,
               const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format_vtu(mesh, point_fields, cell_fields));
}

void write_surface_vtu(const std::filesystem::path& path, const PerId<VertexId, Point3>& points,
                       const std::vector<MixedFacet<3>>& facets, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields, const std::vector<Marker>& markers) {
  check_fields(point_fields, points.size(), {vtu_names::vertex_marker});
  if (markers.empty())
    check_fields(cell_fields, facets.size(), {vtu_names::region});
  else
    check_fields(cell_fields, facets.size(), {vtu_names::region, vtu_names::cell_marker});
  const UsedPoints used(points.size(), facets);
  std::vector<Point3> places;
  for (const VertexId v : used.all()) places.push_back(points[v]);
  WrittenPiece piece{places.size(), facets.size(), coordinates_of(places), {}};
  for (const MixedFacet<3>& facet : facets) piece.cell_arrays.add_facet(used.renumbered(facet));
  std::vector<PointField> parts;
  for (const PointField& field : point_fields) parts.push_back(used.of(field));
  write_file_atomically(path, format_piece(
                                  piece, [](VtuText&) {}, [&](VtuText& text) { write_fields(text, parts); },
                                  [&](VtuText& text) {
                                    write_fields(text, cell_fields);
                                    if (!markers.empty()) text.array(vtu_names::cell_marker, 1, markers);
                                  }));
}

}  // namespace leonhard::io
