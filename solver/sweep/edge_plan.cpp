// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/edge_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "leonhard/graph/partition.hpp"

namespace leonhard::solver {
namespace {

constexpr std::size_t lanes = 4;

void list_neighbours(const EdgeList& edges, EdgePlan& plan) {
  plan.neighbours = collect_rows<std::uint32_t>(plan.vertex_count, [&](const auto& add) {
    for (const auto& [a, b] : edges.ends) {
      add(a.index(), static_cast<std::uint32_t>(b.index()));
      add(b.index(), static_cast<std::uint32_t>(a.index()));
    }
  });
  plan.diagonal.resize(plan.vertex_count);
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
    const auto row = plan.neighbours[v];
    std::ranges::sort(row);
    plan.diagonal[v] = plan.neighbours.offsets()[v] + v +
                       static_cast<std::uint32_t>(std::ranges::lower_bound(row, v) - row.begin());
  }
}

/// Least-squares weights of one vertex: rows of the pseudo-inverse of the matrix of weighted edge vectors.
void fit_gradient(const MeshDual<2>& dual, EdgePlan& plan, std::uint32_t v) {
  const Point2 here = dual.points[VertexId::from(v)];
  double xx = 0, xy = 0, yy = 0;
  const std::uint32_t first = plan.neighbours.offsets()[v], last = plan.neighbours.offsets()[v + 1];
  const auto edge_vector = [&](std::uint32_t i) {
    return dual.points[VertexId::from(plan.neighbours.links()[i])] - here;
  };
  for (std::uint32_t i = first; i < last; ++i) {
    const Vec2 d = edge_vector(i);
    const double w2 = 1 / dot(d, d);
    xx += w2 * d.x * d.x, xy += w2 * d.x * d.y, yy += w2 * d.y * d.y;
  }
  const double determinant = xx * yy - xy * xy, trace = xx + yy;
  const bool on_a_line = determinant <= 1e-24 * trace * trace;
  for (std::uint32_t i = first; i < last; ++i) {
    const Vec2 d = edge_vector(i);
    const double w2 = 1 / dot(d, d);
    StencilSlot& slot = plan.slot[i];
    slot.half_x = 0.5 * d.x, slot.half_y = 0.5 * d.y;
    slot.weight_x = w2 * (on_a_line ? d.x / trace : (yy * d.x - xy * d.y) / determinant);
    slot.weight_y = w2 * (on_a_line ? d.y / trace : (xx * d.y - xy * d.x) / determinant);
  }
}

void choose_parts(const MeshDual<2>& dual, EdgePlan& plan) {
  const auto count =
      static_cast<std::uint32_t>(std::max<std::size_t>(1, plan.vertex_count / EdgePlan::vertices_per_part));
  plan.part_of = graph::recursive_coordinate_bisection(dual.points.flat(), count).part_of;
  plan.parts.assign(count, PartRange{});
}

void deal_out_vertices(EdgePlan& plan) {
  for (const std::uint32_t part : plan.part_of) ++plan.parts[part].vertex_end;
  std::uint32_t sum = 0;
  for (PartRange& part : plan.parts) {
    part.vertex_begin = sum;
    sum += part.vertex_end;
    part.vertex_end = part.vertex_begin;
  }
  plan.part_vertices.resize(plan.vertex_count);
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v)
    plan.part_vertices[plan.parts[plan.part_of[v]].vertex_end++] = v;
}

/// One part's list of edges, filled up to whole batches.
class PartEdges {
 public:
  PartEdges(const MeshDual<2>& dual, EdgePlan& plan) : dual_(dual), plan_(plan) {}

  void add(std::uint32_t part, EdgeId edge, VertexId from, VertexId to) {
    const auto a = static_cast<std::uint32_t>(from.index()), b = static_cast<std::uint32_t>(to.index());
    EdgeEnds ends = rubbish(part);
    ends.a = a, ends.b = b;
    if (plan_.part_of[a] == part) {
      ends.into_a = a;
      ends.block_aa = plan_.diagonal_block(a);
      ends.block_ab = plan_.neighbour_block(a, plan_.slot_to(a, b));
    }
    if (plan_.part_of[b] == part) {
      ends.into_b = b;
      ends.block_bb = plan_.diagonal_block(b);
      ends.block_ba = plan_.neighbour_block(b, plan_.slot_to(b, a));
    }
    const Vec2 normal = dual_.face[edge], half = 0.5 * (dual_.points[to] - dual_.points[from]);
    const double length = norm(normal);
    push(ends, length > 0 ? (1 / length) * normal : Vec2{1, 0}, length, half);
  }

  void pad(std::uint32_t part) {
    while (plan_.ends.size() % lanes != 0) {
      EdgeEnds ends = rubbish(part);
      ends.a = ends.b = plan_.part_vertices[plan_.parts[part].vertex_begin];
      push(ends, {1, 0}, 0, {0, 0});
    }
  }

 private:
  [[nodiscard]] EdgeEnds rubbish(std::uint32_t part) const {
    const auto line = static_cast<std::uint32_t>(plan_.vertex_count + rubbish_stride * part);
    const auto block = static_cast<std::uint32_t>(plan_.block_count() + part);
    return {0, 0, line, line, block, block, block, block};
  }
  void push(const EdgeEnds& ends, Vec2 unit, double length, Vec2 half) {
    const std::size_t lane = plan_.ends.size() % lanes;
    plan_.ends.push_back(ends);
    if (lane == 0) plan_.metric.emplace_back();
    EdgeMetric& m = plan_.metric.back();
    m.nx[lane] = unit.x, m.ny[lane] = unit.y, m.length[lane] = length, m.half_x[lane] = half.x,
    m.half_y[lane] = half.y;
  }

  const MeshDual<2>& dual_;
  EdgePlan& plan_;
};

void list_edges(const MeshDual<2>& dual, EdgePlan& plan) {
  const std::vector<std::uint32_t>& part_of = plan.part_of;
  const PerId<EdgeId, std::array<VertexId, 2>>& edge_ends = dual.edges.ends;
  PartEdges list(dual, plan);
  std::vector<std::vector<EdgeId>> of_part(plan.parts.size());
  for (const EdgeId edge : edge_ends.ids()) {
    const auto [a, b] = edge_ends[edge];
    of_part[part_of[a.index()]].push_back(edge);
    if (part_of[a.index()] != part_of[b.index()]) of_part[part_of[b.index()]].push_back(edge);
  }
  for (std::uint32_t part = 0; part < plan.parts.size(); ++part) {
    plan.parts[part].edge_begin = static_cast<std::uint32_t>(plan.ends.size());
    for (const EdgeId edge : of_part[part]) list.add(part, edge, edge_ends[edge][0], edge_ends[edge][1]);
    list.pad(part);
    plan.parts[part].edge_end = static_cast<std::uint32_t>(plan.ends.size());
  }
}

void list_boundary(const MeshDual<2>& dual, EdgePlan& plan) {
  const std::vector<std::uint32_t>& part_of = plan.part_of;
  for (std::uint32_t part = 0; part < plan.parts.size(); ++part) {
    plan.parts[part].boundary_begin = static_cast<std::uint32_t>(plan.part_boundary.size());
    for (std::uint32_t k = 0; k < dual.boundary.size(); ++k) {
      const MixedFacet<2>& edge = dual.boundary[k].corners;
      if (part_of[edge[0].index()] == part || part_of[edge[1].index()] == part)
        plan.part_boundary.push_back(k);
    }
    plan.parts[part].boundary_end = static_cast<std::uint32_t>(plan.part_boundary.size());
  }
}

}  // namespace

std::uint32_t EdgePlan::slot_to(std::uint32_t v, std::uint32_t other) const {
  const auto row = neighbours[v];
  return neighbours.offsets()[v] +
         static_cast<std::uint32_t>(std::ranges::lower_bound(row, other) - row.begin());
}

SweepMesh EdgePlan::view() const {
  return {neighbours.offsets().data(),
          neighbours.links().data(),
          slot.data(),
          part_vertices.data(),
          ends.data(),
          metric.data()};
}

EdgePlan make_edge_plan(const MeshDual<2>& dual, std::span<const std::uint32_t> part_of, std::uint32_t parts) {
  EdgePlan plan;
  plan.vertex_count = dual.vertex_count();
  plan.area = dual.volume.flat();
  list_neighbours(dual.edges, plan);
  plan.slot.resize(plan.neighbours.link_count());
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) fit_gradient(dual, plan, v);
  if (part_of.empty()) {
    choose_parts(dual, plan);
  } else {
    plan.part_of.assign(part_of.begin(), part_of.end());
    plan.parts.assign(parts, PartRange{});
  }
  deal_out_vertices(plan);
  list_edges(dual, plan);
  list_boundary(dual, plan);
  return plan;
}

}  // namespace leonhard::solver
