// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/partition_output.hpp"

#include "leonhard/app/graphs/graph_picture.hpp"
#include "leonhard/app/graphs/parts_file.hpp"
#include "leonhard/app/report/picture_view.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/draw.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

using graph::Partition;

std::string extension_of(const std::filesystem::path& output) {
  return io::known_extension(output, {".txt", ".vtu", ".png", ".svg", ".pdf"}, "partition");
}

template <class Mesh>
void write_grid(const std::filesystem::path& path, Mesh& mesh, GraphOf which, const Partition& partition) {
  if (which == GraphOf::vertices)
    return io::write_vtu(path, mesh, {{"part", 1, {partition.part_of.begin(), partition.part_of.end()}}});
  mesh.regions.flat().assign(partition.part_of.begin(), partition.part_of.end());
  io::write_vtu(path, mesh);
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
  auto* triangles = std::get_if<TriangleMesh>(&input.mesh);
  auto* tets = std::get_if<TetMesh>(&input.mesh);
  const std::string extension = extension_of(path);
  if (extension == ".txt") return write_parts(path, partition);
  if (extension == ".vtu")
    return tets ? write_grid(path, *tets, which, partition) : write_grid(path, *triangles, which, partition);
  if (triangles)
    return draw::draw_partition(path, *triangles, partition.part_of, partition.parts,
                                {.view = plane_view(output.view), .title = title});
  if (tets && which == GraphOf::cells)
    return draw::draw_tet_partition(path, *tets, partition.part_of, partition.parts,
                                    tet_options(output, *tets, title));
  draw_graph(output, input, partition, title);
}

}  // namespace leonhard::app
