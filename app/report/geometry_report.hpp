// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/app/report/points_report.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::app {

/// What `leonhard check` says of a geometry of the plane, points and segments between them.
struct GeometryReport {
  /// The segments of one marker.
  struct Part {
    Marker marker{};
    std::string name;
    std::size_t segments{};
    double length{};
  };

  PointsAccount account;
  std::size_t segments{}, holes{};
  std::size_t open_ends{};  ///< points at which one segment alone ends
  std::vector<Part> parts;  ///< by marker
  delaunay::TriangulateOutcome outcome{};
  std::size_t triangles{};  ///< of the constrained Delaunay triangulation: within the outlines if is_closed()
  double area{};            ///< of these
  std::size_t crossings{};  ///< of segments where neither ends; the triangulation has vertices there
  std::vector<std::string> repairs;  ///< what the triangulation mended, in words

  [[nodiscard]] bool is_closed() const { return open_ends == 0; }
  /// There is something to mesh.
  [[nodiscard]] bool is_sound() const { return is_closed() && outcome == delaunay::TriangulateOutcome::done; }
};

/// throws  InputError as delaunay::triangulate does, of a seed on a segment
[[nodiscard]] GeometryReport geometry_report(const Pslg& pslg, const delaunay::TriangulateOptions& options);

/// For people, and for programs.
[[nodiscard]] std::string text_of(const GeometryReport& report);
[[nodiscard]] Json to_json(const GeometryReport& report);

}  // namespace leonhard::app
