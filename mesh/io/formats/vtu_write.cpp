// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <type_traits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/field_checks.hpp"
#include "leonhard/mesh/io/formats/vtk_array.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/formats/xml.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

namespace {

constexpr std::uint8_t triangle_type = 5, tetrahedron_type = 10;

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

/// Rows of the vertices and the marker of each.
template <int Dim>
std::vector<std::int64_t> rows_of(const std::vector<typename Simplex<Dim>::MarkedFacet>& facets) {
  std::vector<std::int64_t> rows;
  for (const auto& facet : facets) {
    for (const VertexId v : Simplex<Dim>::corners_of(facet))
      rows.push_back(static_cast<std::int64_t>(v.index()));
    rows.push_back(facet.marker);
  }
  return rows;
}

template <int Dim>
void write_field_data(VtuText& text, const SimplexMesh<Dim>& mesh) {
  text.line("<FieldData>");
  text.array(vtu_names::boundary, Dim + 1, rows_of<Dim>(mesh.boundary), true);
  if (!mesh.inner_facets().empty())
    text.array(Dim == 2 ? vtu_names::constraints : vtu_names::interfaces, Dim + 1,
               rows_of<Dim>(mesh.inner_facets()), true);
  if (!mesh.marker_names.empty()) {
    std::vector<std::int64_t> numbers;
    std::vector<std::uint8_t> names;
    for (const auto& [marker, name] : mesh.marker_names) {
      if (name.find('\0') != std::string::npos)
        throw InputError("marker " + std::to_string(marker), "its name holds a zero byte",
                         "choose another name");
      numbers.push_back(marker);
      names.insert(names.end(), name.begin(), name.end());
      names.push_back(0);
    }
    text.array(vtu_names::marker_numbers, 1, numbers, true);
    text.array(vtu_names::marker_names, 1, names, true);
  }
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

Point3 in_space(Point2 p) { return {p.x, p.y, 0}; }
const Point3& in_space(const Point3& p) { return p; }

template <int Dim>
void write_grid(VtuText& text, const SimplexMesh<Dim>& mesh) {
  text.line("<Points>");
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.vertex_count());
  for (const auto& point : mesh.points) {
    const Point3 p = in_space(point);
    coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  }
  text.array("Points", 3, coordinates);
  text.line("</Points>");

  text.line("<Cells>");
  std::vector<std::int64_t> connectivity, offsets;
  connectivity.reserve(4 * mesh.corners.size());
  offsets.reserve(mesh.corners.size());
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) connectivity.push_back(static_cast<std::int64_t>(v.index()));
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  text.array("connectivity", 1, connectivity);
  text.array("offsets", 1, offsets);
  text.array("types", 1,
             std::vector<std::uint8_t>(mesh.corners.size(), Dim == 2 ? triangle_type : tetrahedron_type));
  text.line("</Cells>");
}

template <int Dim>
std::string format(const SimplexMesh<Dim>& mesh, const std::vector<PointField>& point_fields,
                   const std::vector<CellField>& cell_fields) {
  check_fields(point_fields, mesh.vertex_count(), {vtu_names::vertex_marker});
  check_fields(cell_fields, mesh.corners.size(), {vtu_names::region});
  VtuText text;
  const std::string compressor(vtk_compressor());
  text.line("<?xml version=\"1.0\"?>");
  text.line(std::string("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"") +
            (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian") +
            "\" header_type=\"UInt64\"" + (compressor.empty() ? "" : " compressor=\"" + compressor + "\"") +
            ">");
  text.line("<UnstructuredGrid>");
  write_field_data(text, mesh);
  text.line("<Piece NumberOfPoints=\"" + std::to_string(mesh.vertex_count()) + "\" NumberOfCells=\"" +
            std::to_string(mesh.corners.size()) + "\">");
  text.line("<PointData>");
  write_fields(text, point_fields);
  if (!mesh.vertex_markers.empty()) text.array(vtu_names::vertex_marker, 1, mesh.vertex_markers.flat());
  text.line("</PointData>");
  text.line("<CellData>");
  write_fields(text, cell_fields);
  if (!mesh.regions.empty()) text.array(vtu_names::region, 1, mesh.regions.flat());
  text.line("</CellData>");
  write_grid(text, mesh);
  text.line("</Piece>");
  text.line("</UnstructuredGrid>");
  return std::move(text).finish();
}

}  // namespace

std::string format_vtu(const TriangleMesh& mesh, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields) {
  mesh::require_ids_in_range(mesh);
  return format(mesh, point_fields, cell_fields);
}
std::string format_vtu(const TetMesh& mesh, const std::vector<PointField>& point_fields,
                       const std::vector<CellField>& cell_fields) {
  mesh::require_ids_in_range(mesh);
  return format(mesh, point_fields, cell_fields);
}

void write_vtu(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format_vtu(mesh, point_fields, cell_fields));
}
void write_vtu(const std::filesystem::path& path, const TetMesh& mesh,
               const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format_vtu(mesh, point_fields, cell_fields));
}

}  // namespace leonhard::io
