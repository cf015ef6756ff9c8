// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/partition_output.hpp"

#include "leonhard/app/graphs/graph_picture.hpp"
#include "leonhard/app/graphs/parts_file.hpp"
#include "leonhard/app/meshes/cut_cells.hpp"
#include "leonhard/app/report/picture_view.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/draw.hpp"
#include "leonhard/mesh/io/extension.hpp"

namespace leonhard::app {
namespace {

using graph::Partition;

/// Also "graph.part.8", as METIS calls it.
std::string extension_of(const std::filesystem::path& output) {
  const std::string last = output.extension().string(), stem = output.stem().extension().string();
  const bool is_count = last.size() > 1 && last.find_first_not_of("0123456789", 1) == std::string::npos;
  if (is_count && stem == ".part") return ".txt";
  return io::known_extension(output, {".txt", ".vtu", ".png", ".svg", ".pdf"}, "partition");
}

/// The file's mesh and fields, and the parts as the field `part` of vertices or of cells.
void write_grid(const std::filesystem::path& path, AnyMeshFile& file, GraphOf which,
                const Partition& partition) {
  const auto add = [&](auto& fields) {
    std::erase_if(fields, [](const auto& field) { return field.name == "part"; });
    fields.push_back({"part", 1, {partition.part_of.begin(), partition.part_of.end()}});
  };
  if (which == GraphOf::vertices) {
    add(file.point_fields);
  } else {
    add(file.cell_fields);
  }
  io::write_any_mesh(path, file);
}

/// The parts of a mesh's cells as those of the simplices that they were cut into.
Partition with_parts_of(const CutCells& cut, const Partition& partition) {
  if (cut.cell_of.empty()) return partition;
  Partition parts = partition;
  parts.part_of.clear();
  for (const std::size_t cell : cut.cell_of) parts.part_of.push_back(partition.part_of[cell]);
  return parts;
}

bool is_picture(const std::filesystem::path& output) {
  const std::string extension = extension_of(output);
  return extension != ".txt" && extension != ".vtu";
}

draw::TetPictureOptions tet_options(const PartitionOutput& output, const TetMesh& mesh,
                                    const std::string& title) {
  draw::TetPictureOptions options;
  options.title = title;
  options.view = space_view(output.view);
  parse_cut(output.cut, draw::box_of(mesh), options);
  return options;
}

void draw_graph(const PartitionOutput& output, const AnyGraph& input, const Partition& partition,
                const std::string& title) {
  const bool is_of_space = input.dimension == 3;
  const draw::View3 view = is_of_space ? space_view(output.view) : draw::View3{};
  draw::Diagram diagram = graph_diagram(input, places_on_page(input, view), partition, title);
  if (!is_of_space) diagram.region = plane_view(output.view).region;
  draw::draw_diagram(output.path, diagram);
}

}  // namespace

void check_partition_output(const PartitionOutput& output, const std::filesystem::path& input) {
  if (extension_of(output.path) == ".vtu" && is_graph_file(input))
    throw InputError(output.path.string(), input.string() + " is a graph: it has no cells for a .vtu",
                     "write .txt, or partition a mesh");
  if (!is_picture(output.path) && (!output.view.empty() || !output.cut.empty()))
    throw InputError(output.view.empty() ? "--cut" : "--view", output.path.string() + " is no picture",
                     "leave the option out, or write .png, .svg or .pdf");
}

void check_partition_output(const PartitionOutput& output, const AnyGraph& input, GraphOf which,
                            const std::string& source) {
  if (!is_picture(output.path)) return;
  if (!input.has_mesh()) check_drawable(input, source);
  const bool is_cut_open = input.tets() && which == GraphOf::cells;
  if (is_cut_open) {
    (void)tet_options(output, *input.tets(), {});
  } else if (!output.cut.empty()) {
    throw InputError("--cut", "what is drawn of " + source + " are no tetrahedra", "leave the option out");
  } else if (input.dimension == 3) {
    (void)space_view(output.view);
  } else {
    (void)plane_view(output.view);
  }
}

void write_partition(const PartitionOutput& output, AnyGraph& input, GraphOf which,
                     const Partition& partition, const std::string& title) {
  const std::filesystem::path& path = output.path;
  const std::string extension = extension_of(path);
  if (extension == ".txt") return write_parts(path, partition);
  if (extension == ".vtu") return write_grid(path, *input.file, which, partition);
  if (!input.has_mesh() || (which == GraphOf::vertices && !input.triangles()))
    return draw_graph(output, input, partition, title);
  const CutCells cut = which == GraphOf::cells ? cut_cells(*input.file) : CutCells{};
  const Partition parts = with_parts_of(cut, partition);
  if (const TriangleMesh* triangles = input.triangles())
    return draw::draw_partition(path, *triangles, parts.part_of, parts.parts,
                                {.view = plane_view(output.view), .title = title, .cell_of = cut.cell_of});
  draw::draw_tet_partition(path, *input.tets(), parts.part_of, parts.parts,
                           tet_options(output, *input.tets(), title));
}

}  // namespace leonhard::app
