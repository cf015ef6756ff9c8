// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/app/case/case.hpp"
#include "leonhard/app/case/conditions.hpp"
#include "leonhard/app/geometry/assemble.hpp"
#include "leonhard/delaunay/refine.hpp"
#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/euler.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/quality.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"
#include "leonhard/solver/steady.hpp"

namespace leonhard::app {

struct StageTime {
  std::string name;
  double seconds{};
};

/// The mesh's area against the polygon's, both exact: decimal for the reader, equality decided in rationals.
struct AreaAccount {
  double mesh{};
  double polygon{};
  bool equal{};
  double difference{};  ///< mesh less polygon, rounded from the exact difference
};

/// What a numbering costs, and the pattern of the matrix that it gives.
struct Numbering {
  std::string name;
  graph::OrderingCost cost;
  std::uint64_t fill{};
  std::vector<std::uint32_t> order;  ///< order[new] = vertex of the graph
};

/// What a run of `leonhard solve` knows whatever its dimension.
struct RunCommon {
  Case the_case;
  std::map<Marker, BoundaryCase> conditions;

  std::optional<graph::CsrGraph> vertex_graph;  ///< of the mesh as it came, before ordering
  std::vector<Numbering> numberings;            ///< as it came, then as ordered

  std::vector<StageTime> stages;
  std::vector<std::string> warnings;
  double total_seconds{};
  int threads{};
};

/// And its flow.
template <int dim>
struct FlowRun : RunCommon {
  SteadyResult<dim> flow;

  /// Verdicts that count as "done": the rest is a goal not met, or a stop.
  [[nodiscard]] bool goal_met() const {
    return flow.verdict == Verdict::converged || flow.verdict == Verdict::settled;
  }
};

/// Everything that one run about the plane knows, filled step by step (solve/steps.hpp) and read by the report.
struct SolveRun : FlowRun<2> {
  std::optional<DomainGeometry> geometry;            ///< none where the case names a mesh
  std::optional<delaunay::RefineReport> refinement;  ///< likewise

  TriangleMesh mesh;  ///< in the numbering of the solver; quadrilaterals of a file cut in two
  std::optional<MeshDual<2>> dual;  ///< where the file has quadrilaterals, which the solver takes whole, or sides are periodic: likewise
  EdgeStructure edges;

  EulerAccount euler;
  MeshQuality quality;
  Fingerprint fingerprint;
  std::optional<AreaAccount> area;  ///< none where there is no polygon to compare with

  graph::TrianglePartition triangle_parts;
  graph::PartitionCost partition_cost;
};

}  // namespace leonhard::app
