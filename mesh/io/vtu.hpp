// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"

namespace leonhard::io {

/// Write a VTK XML unstructured grid (.vtu): binary, appended raw, zlib-compressed where Leonhard was built
/// with zlib, 64-bit headers. ParaView opens it; read_vtu gives the same mesh back: points to the last bit,
/// triangles, regions, markers, names of both, boundary, constraints, and fields.
///
/// Point data: one array a field (two components are written as three with a zero, since VTK knows only
/// three-component vectors, and with the attribute leonhard_components="2", which other programs pass over) and
/// `marker`. The edges of the boundary, then the marked ones within, are cells behind the triangles. Cell data: `marker`, 0 of
/// triangles (`leonhard_marker` where a field is called so), one array a field and `region`, in which edges have the value of a
/// triangle beside them. Field data:
/// `leonhard_facets` (how many edges of both sorts), `leonhard_marker_numbers`, and `leonhard_marker_names` (UTF-8, each name
/// ended by a zero byte), and the like of regions.
///
/// fields  one value each a vertex or cell and component; any doubles, NaN too
/// throws InputError if a field's size does not fit the mesh or its name is empty, repeated among those of its kind, or
/// `marker` (of vertices), `region` or `leonhard_marker` (of cells); OutputError if the file cannot be written
void write_vtu(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::vector<PointField>& point_fields = {},
               const std::vector<CellField>& cell_fields = {});

/// The bytes that write_vtu writes.
[[nodiscard]] std::string format_vtu(const TriangleMesh& mesh,
                                     const std::vector<PointField>& point_fields = {},
                                     const std::vector<CellField>& cell_fields = {});

/// Read a .vtu whose cells are triangles (quadrilaterals are split, lines are taken as marked edges): what write_vtu writes, and
/// the ascii, base64 and raw appended variants that ParaView and meshio write, compressed with zlib or not. Cells of higher order
/// are taken by their corners, strips as triangles, pixels as quadrilaterals. Points of equal coordinates in different pieces
/// are joined where no piece has two of them, and cells that are copies of another piece's (vtkGhostType) dropped.
///
/// Regions are the cell array `region`, else the first of gmsh:physical, medit:ref, CellEntityIds that there is, markers of
/// lines `marker`, else that one, else 1. All other arrays of point and cell data come as fields, integers as doubles; those of
/// texts, without a name, or with a name that came before are left out, which a warning tells.
///
/// Files by other programs: edges without a marker, unused vertices, cells that are turned over as mesh_soup.hpp says.
///
/// throws InputError: not a .vtu, parts missing or cut short, unknown compressor or cell type, points off the
/// plane z = const, ids out of range, bad cells as in read_su2
[[nodiscard]] MeshFile read_vtu(const std::filesystem::path& path);

/// One point field of a mesh file of any format that has fields, in the order of the vertices that read_any_mesh gives.
///
/// throws InputError: as read_vtu; no field of that name (the message lists those there are), more than three
/// components, values that are not finite
[[nodiscard]] PointField read_vtu_field(const std::filesystem::path& path, const std::string& name);

/// The same as read_vtu from bytes in memory; source names them in errors.
[[nodiscard]] MeshFile parse_vtu(std::string_view bytes, const std::string& source);

/// The same for tetrahedral meshes: cells of type 10, behind them the marked faces as triangles. throws as write_vtu of
/// triangles
void write_vtu(const std::filesystem::path& path, const TetMesh& mesh,
               const std::vector<PointField>& point_fields = {},
               const std::vector<CellField>& cell_fields = {});
[[nodiscard]] std::string format_vtu(const TetMesh& mesh, const std::vector<PointField>& point_fields = {},
                                     const std::vector<CellField>& cell_fields = {});

/// Read a .vtu whose cells are tetrahedra; triangles are marked faces, lines and points are left out.
///
/// throws InputError: as read_vtu; other cells, and as read_tet_mesh
[[nodiscard]] TetMeshFile read_tet_vtu(const std::filesystem::path& path);
[[nodiscard]] TetMeshFile parse_tet_vtu(std::string_view bytes, const std::string& source);

/// The same for meshes of mixed cells: types 5 (triangle) and 9 (quadrilateral) in the plane, 10 (tetrahedron), 12
/// (hexahedron), 13 (wedge, a prism) and 14 (pyramid) in space, behind them the marked edges, or faces as triangles and
/// quadrilaterals. A prism's base is directed outwards, as VTK's text has it. throws as write_vtu of triangles
void write_vtu(const std::filesystem::path& path, const MixedMesh<2>& mesh,
               const std::vector<PointField>& point_fields = {},
               const std::vector<CellField>& cell_fields = {});
void write_vtu(const std::filesystem::path& path, const MixedMesh<3>& mesh,
               const std::vector<PointField>& point_fields = {},
               const std::vector<CellField>& cell_fields = {});
[[nodiscard]] std::string format_vtu(const MixedMesh<2>& mesh,
                                     const std::vector<PointField>& point_fields = {},
                                     const std::vector<CellField>& cell_fields = {});
[[nodiscard]] std::string format_vtu(const MixedMesh<3>& mesh,
                                     const std::vector<PointField>& point_fields = {},
                                     const std::vector<CellField>& cell_fields = {});

/// Write facets of a mesh of space as a surface for ParaView: types 5 (triangle) and 9 (quadrilateral), with the points that they
/// use alone, in rising order.
///
/// points        of the mesh
/// point_fields  one value a point of the mesh
/// cell_fields   one value a facet
/// markers       of the facets, or empty
/// throws        InputError for a facet of a vertex that is not there, and as write_vtu; OutputError
void write_surface_vtu(const std::filesystem::path& path, const PerId<VertexId, Point3>& points,
                       const std::vector<MixedFacet<3>>& facets,
                       const std::vector<PointField>& point_fields = {},
                       const std::vector<CellField>& cell_fields = {},
                       const std::vector<Marker>& markers = {});

/// Read a .vtu of mixed cells, quadrilaterals left whole; in space triangles and quadrilaterals are marked faces. Prisms are
/// taken with the base either way.
///
/// throws InputError: as read_vtu; other cells, and as read_mixed_mesh
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> read_mixed_vtu(const std::filesystem::path& path);
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> parse_mixed_vtu(std::string_view bytes, const std::string& source);

}  // namespace leonhard::io
