// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "leonhard/delaunay/voronoi_pieces.hpp"

namespace leonhard::app {

/// Write the clipped cells of a Voronoi diagram, or the pieces that a window leaves of them, as an unstructured grid of polygons
/// (.vtu, text), which ParaView opens: cell data `site` (number), `area` and `unbounded`. Each has corners of its own.
/// throws OutputError
void write_cells_vtu(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                     const delaunay::VoronoiPieces& pieces);

/// The same as JSON: {"cells": [{"site": 0, "at": [x, y], "area": a, "unbounded": false, "corners": [[x, y], ...]}],
/// "site_of_input": [0, ...]}, the last one a site for each input point.
/// throws OutputError
void write_cells_json(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                      const delaunay::VoronoiPieces& pieces);

/// The same as GeoJSON (RFC 7946): a feature a piece, a polygon whose neighbours have the same corners to the last bit.
/// throws OutputError
void write_cells_geojson(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                         const delaunay::VoronoiPieces& pieces);

}  // namespace leonhard::app
