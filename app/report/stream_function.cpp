// SPDX-License-Identifier: MIT
#include "leonhard/app/report/stream_function.hpp"

#include <cmath>
#include <numeric>

namespace leonhard::app {
namespace {

/// The equations: psi at one end less psi at the other, and their weights.
struct Difference {
  std::size_t from, to;
  double flow, weight;
};

std::vector<Difference> differences(const TriangleMesh& mesh, const EdgeStructure& edges, const PerId<VertexId, State<2>>& states) {
  std::vector<Difference> all;
  all.reserve(edges.ends.size());
  for (const auto& [a, b] : edges.ends) {
    const Vec2 way = mesh.points[b] - mesh.points[a];
    const State<2>&p = states[a], &q = states[b];
    const double flow = 0.5 * ((p.rho * p.u + q.rho * q.u) * way.y - (p.rho * p.v + q.rho * q.v) * way.x);
    all.push_back({a.index(), b.index(), flow, 1 / dot(way, way)});
  }
  return all;
}

/// Sums along a tree of the edges from a vertex; vertices that no edge leads to keep 0.
std::vector<double> tree_sums(const std::vector<Difference>& all, std::size_t vertices, std::size_t root) {
  std::vector<std::vector<std::size_t>> at(vertices);
  for (std::size_t k = 0; k < all.size(); ++k) at[all[k].from].push_back(k), at[all[k].to].push_back(k);
  std::vector<double> psi(vertices, 0);
  std::vector<bool> reached(vertices, false);
  std::vector<std::size_t> front{root};
  reached[root] = true;
  for (std::size_t i = 0; i < front.size(); ++i)
    for (const std::size_t k : at[front[i]]) {
      const Difference& d = all[k];
      const bool forward = d.from == front[i];
      const std::size_t other = forward ? d.to : d.from;
      if (reached[other]) continue;
      reached[other] = true;
      psi[other] = psi[front[i]] + (forward ? d.flow : -d.flow);
      front.push_back(other);
    }
  return psi;
}

}  // namespace

std::vector<double> stream_function(const TriangleMesh& mesh, const EdgeStructure& edges, const PerId<VertexId, State<2>>& states,
                                    VertexId zero) {
  const std::vector<Difference> all = differences(mesh, edges, states);
  const std::size_t n = mesh.vertex_count(), root = zero.index();
  std::vector<double> psi = tree_sums(all, n, root), residual(n, 0.0), diagonal(n, 0.0), direction, product(n), scaled(n);
  for (const Difference& d : all) {
    const double off = d.weight * (d.flow - (psi[d.to] - psi[d.from]));
    residual[d.to] += off, residual[d.from] -= off;
    diagonal[d.to] += d.weight, diagonal[d.from] += d.weight;
  }
  const auto precondition = [&] {
    for (std::size_t v = 0; v < n; ++v) scaled[v] = v == root || diagonal[v] == 0 ? 0 : residual[v] / diagonal[v];
    return std::inner_product(residual.begin(), residual.end(), scaled.begin(), 0.0);
  };
  double size = precondition();
  const double goal = 1e-12 * size;
  direction = scaled;
  for (int step = 0; step < 3000 && size > goal; ++step) {
    std::fill(product.begin(), product.end(), 0.0);
    for (const Difference& d : all) {
      const double slope = d.weight * (direction[d.to] - direction[d.from]);
      product[d.to] += slope, product[d.from] -= slope;
    }
    const double length = size / std::inner_product(direction.begin(), direction.end(), product.begin(), 0.0);
    for (std::size_t v = 0; v < n; ++v) psi[v] += length * direction[v], residual[v] -= length * product[v];
    const double before = size;
    size = precondition();
    for (std::size_t v = 0; v < n; ++v) direction[v] = scaled[v] + size / before * direction[v];
  }
  return psi;
}

std::vector<double> density_slopes(const TriangleMesh& mesh, const PerId<VertexId, State<2>>& states) {
  std::vector<Vec2> sum(mesh.vertex_count());
  std::vector<double> area(mesh.vertex_count()), slopes;
  for (const auto& [a, b, c] : mesh.corners) {
    const Vec2 to_b = mesh.points[b] - mesh.points[a], to_c = mesh.points[c] - mesh.points[a];
    const double by_b = states[b].rho - states[a].rho, by_c = states[c].rho - states[a].rho;
    const Vec2 doubled{by_b * to_c.y - by_c * to_b.y, by_c * to_b.x - by_b * to_c.x};  // gradient times twice the area
    for (const VertexId v : {a, b, c}) sum[v.index()] += doubled, area[v.index()] += cross(to_b, to_c);
  }
  for (std::size_t v = 0; v < sum.size(); ++v) slopes.push_back(area[v] > 0 ? norm(sum[v]) / area[v] : 0);
  return slopes;
}

}  // namespace leonhard::app
