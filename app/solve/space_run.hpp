// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "leonhard/app/solve/run.hpp"
#include "leonhard/mesh/mixed_euler.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/split_cells.hpp"
#include "leonhard/mesh/tet_quality.hpp"

namespace leonhard::app {

/// In the order in which they are told.
inline constexpr std::array kinds_of_space{CellKind::tetrahedron, CellKind::pyramid, CellKind::prism, CellKind::hexahedron};

/// The volume of the mesh's cells, cut into tetrahedra, against that which its boundary encloses; and its control volumes.
struct VolumeAccount {
  double cells{}, enclosed{};
  bool equal{};  ///< in rational arithmetic
  double smallest_control{}, largest_control{};
};

/// Everything that one run in space knows, filled step by step (solve/space_steps.hpp) and read by the report.
struct SpaceRun : FlowRun<3> {
  MixedMesh<3> mesh;           ///< in the file's numbering, as all that is written
  std::optional<TetMesh> tets;  ///< the same, cells cut; none where faces that bend do not allow it
  std::optional<MeshDual<3>> dual;               ///< in the numbering of the solver; until the march
  PerId<VertexId, VertexId> solver_vertex;       ///< of each vertex of the mesh
  std::size_t edges{};

  MixedEulerAccount euler;
  std::optional<VolumeAccount> volume;      ///< none where there are no tets
  std::optional<TetMeshQuality> quality;    ///< of meshes of tetrahedra alone

  /// The flow at each vertex of the mesh.
  [[nodiscard]] PerId<VertexId, State<3>> states() const {
    PerId<VertexId, State<3>> states(mesh.vertex_count());
    for (const VertexId v : mesh.points.ids()) states[v] = flow.state[solver_vertex[v]];
    return states;
  }
};

}  // namespace leonhard::app
