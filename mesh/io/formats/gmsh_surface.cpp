// SPDX-License-Identifier: MIT
#include <utility>

#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"

namespace leonhard::io {

SurfaceFile parse_gmsh_surface(std::string_view bytes, const std::string& source) {
  GmshData data = parse_gmsh_data(bytes, source);
  SurfaceBuilder surface(source, 0);
  surface.set_points({std::move(data.points), {}, 0, {}}, 0);
  const auto add = [&](const std::vector<GmshCell>& cells, std::size_t corners) {
    for (const GmshCell& cell : cells) {
      for (std::size_t k = 0; k < corners; ++k)
        surface.add_corner(static_cast<std::int64_t>(cell.corners[k].index()));
      surface.end_polygon(cell.line, cell.group);
    }
  };
  add(data.triangles, 3);
  add(data.quadrilaterals, 4);
  for (std::string& warning : data.warnings) surface.warn(std::move(warning));
  return std::move(surface).finish();
}

}  // namespace leonhard::io
