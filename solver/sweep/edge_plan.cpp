// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/edge_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "leonhard/graph/partition.hpp"
#include "leonhard/solver/axes.hpp"
#include "leonhard/solver/sweep/pseudo_inverse.hpp"

namespace leonhard::solver {
namespace {

constexpr std::size_t lanes = 4;

/// The way to the other end of an edge.
template <int dim>
struct Link {
  std::uint32_t to;
  Axes<dim> way, face;
};

/// The ends of all edges about each vertex, ascending; an edge from a vertex to itself counts twice, once each way.
template <int dim>
CompressedRows<Link<dim>> links_of(const MeshDual<dim>& dual) {
  auto links = collect_rows<Link<dim>>(dual.vertex_count(), [&](const auto& add) {
    for (const EdgeId e : dual.edges.ends.ids()) {
      const auto [a, b] = dual.edges.ends[e];
      add(a.index(), Link<dim>{static_cast<std::uint32_t>(b.index()), axes(dual.edge_vector(e)), axes(dual.face[e])});
      add(b.index(), Link<dim>{static_cast<std::uint32_t>(a.index()), axes(-dual.edge_vector(e)), axes(-dual.face[e])});
    }
  });
  for (std::size_t v = 0; v < links.size(); ++v) std::ranges::stable_sort(links[v], {}, &Link<dim>::to);
  return links;
}

/// Rows of a joined dual: neighbours once each, and the stencil with every link.
template <int dim>
void list_joined(const CompressedRows<Link<dim>>& links, EdgePlan<dim>& plan) {
  plan.repeats_edges = true;
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
    const auto row = links[v];
    for (std::size_t i = 0; i < row.size(); ++i) {
      plan.stencil.add_link(row[i].to);
      if (row[i].to != v && (i == 0 || row[i].to != row[i - 1].to)) plan.neighbours.add_link(row[i].to);
    }
    plan.stencil.end_row(), plan.neighbours.end_row();
  }
}

template <int dim>
void list_neighbours(const EdgeList& edges, EdgePlan<dim>& plan) {
  plan.neighbours = collect_rows<std::uint32_t>(plan.vertex_count, [&](const auto& add) {
    for (const auto& [a, b] : edges.ends) {
      add(a.index(), static_cast<std::uint32_t>(b.index()));
      add(b.index(), static_cast<std::uint32_t>(a.index()));
    }
  });
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) std::ranges::sort(plan.neighbours[v]);
}

template <int dim>
void find_diagonals(EdgePlan<dim>& plan) {
  plan.diagonal.resize(plan.vertex_count);
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
    const auto row = plan.neighbours[v];
    plan.diagonal[v] = plan.neighbours.offsets()[v] + v +
                       static_cast<std::uint32_t>(std::ranges::lower_bound(row, v) - row.begin());
  }
}

/// Least-squares weights of one vertex: rows of the pseudo-inverse of the matrix of weighted edge vectors.
/// slots   of the vertex, one an edge
/// way     way(i): from the vertex along edge i
template <int dim>
void fit_gradient(std::span<StencilSlot<dim>> slots, const auto& way) {
  SymmetricMatrix<dim> sum{};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Axes<dim> d = way(i);
    const double square = dot<dim>(d, d);
    for (std::size_t j = 0; j < dim; ++j)
      for (std::size_t k = 0; k < dim; ++k) sum[j][k] += d[j] * d[k] / square;
  }
  const SymmetricMatrix<dim> inverse = pseudo_inverse<dim>(sum);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Axes<dim> d = way(i);
    const double square = dot<dim>(d, d);
    for (std::size_t j = 0; j < dim; ++j) slots[i].half[j] = 0.5 * d[j], slots[i].weight[j] = dot<dim>(inverse[j], d) / square;
  }
}

/// Rows and gradients of a dual as it comes from a mesh.
template <int dim>
void list_stencils(const MeshDual<dim>& dual, EdgePlan<dim>& plan) {
  list_neighbours(dual.edges, plan);
  plan.slot.resize(plan.neighbours.link_count());
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
    const auto here = dual.points[VertexId::from(v)];
    const auto row = plan.neighbours[v];
    fit_gradient<dim>({plan.slot.data() + plan.neighbours.offsets()[v], row.size()},
                      [&](std::size_t i) { return axes(dual.points[VertexId::from(row[i])] - here); });
  }
}

/// And of a joined one.
template <int dim>
void list_joined_stencils(const MeshDual<dim>& dual, EdgePlan<dim>& plan) {
  const CompressedRows<Link<dim>> links = links_of(dual);
  list_joined(links, plan);
  plan.slot.resize(links.link_count());
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v)
    fit_gradient<dim>({plan.slot.data() + links.offsets()[v], links[v].size()}, [&](std::size_t i) { return links[v][i].way; });
}

/// Weights of Green and Gauss away from the boundary. Over a closed surface a constant adds up to nothing, so that the mean on each
/// face leaves half of the difference.
template <int dim>
void use_green_gauss(const MeshDual<dim>& dual, EdgePlan<dim>& plan) {
  const CompressedRows<Link<dim>> links = links_of(dual);
  std::vector<bool> on_boundary(plan.vertex_count, false);
  for (const DualFacet<dim>& facet : dual.boundary)
    for (const VertexId v : facet.corners) on_boundary[v.index()] = true;
  for (std::uint32_t v = 0; v < plan.vertex_count; ++v) {
    if (on_boundary[v]) continue;
    const auto row = links[v];
    for (std::size_t i = 0; i < row.size(); ++i)
      for (std::size_t j = 0; j < dim; ++j)
        plan.slot[links.offsets()[v] + i].weight[j] = 0.5 * row[i].face[j] / plan.volume[v];
  }
}

template <int dim>
void choose_parts(const MeshDual<dim>& dual, EdgePlan<dim>& plan) {
  const auto count =
      static_cast<std::uint32_t>(std::max<std::size_t>(1, plan.vertex_count / EdgePlan<dim>::vertices_per_part));
  plan.part_of = graph::recursive_coordinate_bisection(dual.points.flat(), count).part_of;
  plan.parts.assign(count, PartRange{});
}

template <int dim>
void deal_out_vertices(EdgePlan<dim>& plan) {
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
template <int dim>
class PartEdges {
 public:
  PartEdges(const MeshDual<dim>& dual, EdgePlan<dim>& plan) : dual_(dual), plan_(plan) {}

  void add(std::uint32_t part, EdgeId edge, VertexId from, VertexId to) {
    const auto a = static_cast<std::uint32_t>(from.index()), b = static_cast<std::uint32_t>(to.index());
    EdgeEnds ends = rubbish(part);
    ends.a = a, ends.b = b;
    if (plan_.part_of[a] == part) {
      ends.into_a = a;
      ends.block_aa = plan_.diagonal_block(a);
      ends.block_ab = static_cast<std::uint32_t>(plan_.block_of(a, b));
    }
    if (plan_.part_of[b] == part) {
      ends.into_b = b;
      ends.block_bb = plan_.diagonal_block(b);
      ends.block_ba = static_cast<std::uint32_t>(plan_.block_of(b, a));
    }
    const Axes<dim> normal = axes(dual_.face[edge]), d = axes(dual_.edge_vector(edge));
    push(ends, normal, d);
  }

  void pad(std::uint32_t part) {
    while (plan_.ends.size() % lanes != 0) {
      EdgeEnds ends = rubbish(part);
      ends.a = ends.b = plan_.part_vertices[plan_.parts[part].vertex_begin];
      push(ends, {}, {});
    }
  }

 private:
  [[nodiscard]] EdgeEnds rubbish(std::uint32_t part) const {
    const auto line = static_cast<std::uint32_t>(plan_.vertex_count + rubbish_stride * part);
    return {0, 0, line, line, no_block, no_block, no_block, no_block};
  }
  /// A face of size 0 has the unit normal along the edge, and an edge of no length (of the padding) one axis, so that nothing
  /// divides by zero.
  void push(const EdgeEnds& ends, const Axes<dim>& normal, const Axes<dim>& d) {
    const std::size_t lane = plan_.ends.size() % lanes;
    plan_.ends.push_back(ends);
    if (lane == 0) plan_.metric.emplace_back();
    EdgeMetric<dim>& m = plan_.metric.back();
    const double size = norm(vector_of(normal)), length = norm(vector_of(d));
    m.size[lane] = size;
    for (std::size_t j = 0; j < dim; ++j) {
      const double axis = j == 0 ? 1 : 0;
      m.n[j][lane] = size > 0 ? normal[j] / size : length > 0 ? d[j] / length : axis;
      m.half[j][lane] = 0.5 * (length > 0 ? d[j] : axis);
    }
  }

  const MeshDual<dim>& dual_;
  EdgePlan<dim>& plan_;
};

template <int dim>
void list_edges(const MeshDual<dim>& dual, EdgePlan<dim>& plan) {
  const std::vector<std::uint32_t>& part_of = plan.part_of;
  const PerId<EdgeId, std::array<VertexId, 2>>& edge_ends = dual.edges.ends;
  PartEdges<dim> list(dual, plan);
  std::vector<std::vector<EdgeId>> of_part(plan.parts.size());
  for (const EdgeId edge : edge_ends.ids()) {
    const auto [a, b] = edge_ends[edge];
    if (a == b) continue;  // what leaves a vertex through such a face comes in through it
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

template <int dim>
void list_boundary(const MeshDual<dim>& dual, EdgePlan<dim>& plan) {
  const std::vector<std::uint32_t>& part_of = plan.part_of;
  for (std::uint32_t part = 0; part < plan.parts.size(); ++part) {
    plan.parts[part].boundary_begin = static_cast<std::uint32_t>(plan.part_boundary.size());
    for (std::uint32_t k = 0; k < dual.boundary.size(); ++k) {
      const MixedFacet<dim>& corners = dual.boundary[k].corners;
      if (std::ranges::any_of(corners, [&](VertexId v) { return part_of[v.index()] == part; }))
        plan.part_boundary.push_back(k);
    }
    plan.parts[part].boundary_end = static_cast<std::uint32_t>(plan.part_boundary.size());
  }
}

}  // namespace

template <int dim>
std::uint32_t EdgePlan<dim>::slot_to(std::uint32_t v, std::uint32_t other) const {
  const auto row = neighbours[v];
  return neighbours.offsets()[v] +
         static_cast<std::uint32_t>(std::ranges::lower_bound(row, other) - row.begin());
}

template <int dim>
SweepMesh<dim> EdgePlan<dim>::view() const {
  const CompressedRows<std::uint32_t>& rows = stencil.empty() ? neighbours : stencil;
  return {rows.offsets().data(),
          rows.links().data(),
          slot.data(),
          part_vertices.data(),
          ends.data(),
          metric.data()};
}

template <int dim>
EdgePlan<dim> make_edge_plan(const MeshDual<dim>& dual, std::span<const std::uint32_t> part_of, std::uint32_t parts,
                             GradientKind gradient) {
  EdgePlan<dim> plan;
  plan.vertex_count = dual.vertex_count();
  plan.volume = dual.volume.flat();
  if (dual.span.empty())
    list_stencils(dual, plan);
  else
    list_joined_stencils(dual, plan);
  if (gradient == GradientKind::green_gauss) use_green_gauss(dual, plan);
  find_diagonals(plan);
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

template struct EdgePlan<2>;
template struct EdgePlan<3>;
template EdgePlan<2> make_edge_plan(const MeshDual<2>&, std::span<const std::uint32_t>, std::uint32_t, GradientKind);
template EdgePlan<3> make_edge_plan(const MeshDual<3>&, std::span<const std::uint32_t>, std::uint32_t, GradientKind);

}  // namespace leonhard::solver
