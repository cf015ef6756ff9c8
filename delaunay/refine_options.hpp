// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/delaunay/crossings.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

/// What mesh_pslg takes besides the graph, and what it reports.
namespace leonhard::delaunay {

struct RefineOptions {
  /// No triangle angle below this, input angles aside. Up to 20.7 provably reached, up to about 33 in
  /// practice; above, the vertex budget may be what ends the work. 0: no bound.
  double min_angle_deg = 25;
  /// Target edge length at a point, positive and finite; may be empty. The mean edge length comes out close
  /// to it.
  std::function<double(Point2)> size{};
  double max_area = -1;                   ///< no triangle larger than this; not positive: no bound
  std::size_t max_vertices = 10'000'000;  ///< stop adding vertices here
  double min_edge = 0;                    ///< add no vertex closer than this to another one
  /// Keep the convex hull although no segment bounds it (its edges then act as segments).
  bool keep_convex_hull = false;
  Progress progress{};
  Crossings crossings = Crossings::reject;
};

enum class RefineOutcome {
  achieved,             ///< every triangle meets every bound
  small_angles_left,    ///< all others meet theirs; those left owe it to small input angles, min_edge or
                        ///< rounding
  vertex_budget_spent,  ///< max_vertices reached; the mesh is valid, some bounds unmet
  stopped,  ///< a stop was requested; the mesh is valid, some bounds unmet (empty if it came too early)
};

/// The word for it, e.g. "achieved".
[[nodiscard]] constexpr std::string_view to_string(RefineOutcome outcome) {
  switch (outcome) {
    case RefineOutcome::achieved:
      return "achieved";
    case RefineOutcome::small_angles_left:
      return "small_angles_left";
    case RefineOutcome::vertex_budget_spent:
      return "vertex_budget_spent";
    case RefineOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct [[nodiscard]] RefineReport {
  RefineOutcome outcome = RefineOutcome::achieved;
  std::size_t inserted = 0;        ///< vertices added in all
  std::size_t segment_splits = 0;  ///< of these, on segments
  std::size_t rounded_splits =
      0;  ///< of these, not exactly on their segment (0: the domain is unchanged to the bit)
  double min_angle_deg = 0;     ///< smallest angle of the mesh
  double max_angle_deg = 0;     ///< largest angle of the mesh
  std::size_t below_angle = 0;  ///< triangles with an angle below the bound, in all
  std::size_t above_size = 0;   ///< triangles above the size or area bound, in all
  /// Triangles with an unmet bound by reason; they add up to those that miss a bound when the outcome is
  /// achieved or small_angles_left.
  std::size_t excused_small_input_angle =
      0;                             ///< the shortest edge spans two segments that meet at a small angle
  std::size_t excused_min_edge = 0;  ///< the cure would make an edge shorter than min_edge
  std::size_t excused_rounding = 0;  ///< no floating-point point is a cure
  std::vector<std::string> repairs;  ///< as in Triangulation
};

}  // namespace leonhard::delaunay
