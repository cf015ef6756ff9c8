// SPDX-License-Identifier: MIT
#include <utility>

#include "leonhard/mesh/io/formats/medit_data.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"

namespace leonhard::io {

SurfaceFile parse_medit_surface(std::string_view text, const std::string& source) {
  MeditData data = parse_medit_data(text, source);
  SurfaceBuilder surface(source, 1);
  surface.set_points({std::move(data.points), std::move(data.references), 0, {}}, 1);
  const auto add = [&](const std::vector<MeditCell>& cells, std::size_t corners) {
    for (const MeditCell& cell : cells) {
      for (std::size_t k = 0; k < corners; ++k)
        surface.add_corner(static_cast<std::int64_t>(cell.corners[k].index()) + 1);
      surface.end_polygon(cell.line, cell.reference);
    }
  };
  add(data.triangles, 3);
  add(data.quadrilaterals, 4);
  for (std::string& warning : data.warnings) surface.warn(std::move(warning));
  return std::move(surface).finish();
}

}  // namespace leonhard::io
