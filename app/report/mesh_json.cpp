// SPDX-License-Identifier: MIT
#include "leonhard/app/report/mesh_json.hpp"

#include <unordered_map>

namespace leonhard::app {

Json to_json(const EulerAccount::Formula& formula) {
  return {{"name", formula.name}, {"words", formula.words}, {"left", formula.lhs}, {"right", formula.rhs}};
}

Json to_json(const EulerAccount& account) {
  Json formulas = Json::array();
  for (const auto& formula : account.formulas) formulas.push_back(to_json(formula));
  return {{"balances", account.balances()},
          {"components", account.components},
          {"holes", account.holes},
          {"boundary_loops", account.boundary_loops},
          {"boundary_edges", account.boundary_edges},
          {"pinches", account.pinches},
          {"formulas", formulas}};
}

Json to_json(const MeshQuality& quality) {
  Json worst = Json::array();
  for (const auto& named : quality.worst) {
    worst.push_back({{"triangle", named.triangle.index()},
                     {"centroid", Json::array({named.centroid.x, named.centroid.y})},
                     {"min_angle_deg", named.figures.min_angle_deg}});
  }
  return {{"min_angle_deg", quality.min_angle_deg},
          {"max_angle_deg", quality.max_angle_deg},
          {"mean_min_angle_deg", quality.mean_min_angle_deg},
          {"max_aspect_ratio", quality.max_aspect_ratio},
          {"max_size_growth", quality.max_size_growth},
          {"min_area", quality.min_area},
          {"max_area", quality.max_area},
          {"angle_histogram", quality.angle_histogram},
          {"worst", worst}};
}

Json to_json(const delaunay::RefineReport& report) {
  return {{"outcome", to_string(report.outcome)},
          {"inserted", report.inserted},
          {"segment_splits", report.segment_splits},
          {"rounded_splits", report.rounded_splits},
          {"below_angle", report.below_angle},
          {"above_size", report.above_size},
          {"excused_small_input_angle", report.excused_small_input_angle},
          {"excused_min_edge", report.excused_min_edge},
          {"excused_rounding", report.excused_rounding}};
}

Json merged_points_json(const std::vector<MaybeId<VertexId>>& vertex_of_input) {
  std::unordered_map<IdRaw, std::size_t> first_of;
  Json pairs = Json::array();
  for (std::size_t i = 0; i < vertex_of_input.size(); ++i) {
    if (!vertex_of_input[i]) continue;
    const auto [first, is_new] = first_of.emplace((*vertex_of_input[i]).raw, i);
    if (!is_new) pairs.push_back(Json::array({i, first->second}));
  }
  return pairs;
}

}  // namespace leonhard::app
