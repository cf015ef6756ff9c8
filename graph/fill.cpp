// SPDX-License-Identifier: MIT
#include "leonhard/graph/fill.hpp"

#include <string>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

std::vector<std::uint32_t> checked_inverse(const CsrGraph& graph, std::span<const std::uint32_t> order) {
  if (order.size() != vertex_count(graph))
    throw InputError(
        "order",
        std::to_string(order.size()) + " numbers for " + std::to_string(vertex_count(graph)) + " vertices",
        "give one a vertex");
  return invert(order);
}

std::vector<std::uint32_t> tree_of(const CsrGraph& graph, std::span<const std::uint32_t> order,
                                   std::span<const std::uint32_t> new_of_old) {
  std::vector<std::uint32_t> parent(order.size(), no_parent);
  std::vector<std::uint32_t> ancestor(order.size(),
                                      no_parent);  // a shortcut towards the root of the tree so far
  for (std::uint32_t row = 0; row < order.size(); ++row)
    for (const std::uint32_t w : neighbours(graph, order[row])) {
      std::uint32_t j = new_of_old[w];
      while (j < row) {  // climb from column j; every root met becomes a child of this row
        const std::uint32_t up = ancestor[j];
        ancestor[j] = row;
        if (up == no_parent) parent[j] = row;
        j = up;
      }
    }
  return parent;
}

/// The tree's vertices, children before parents, each subtree contiguous.
std::vector<std::uint32_t> postorder(std::span<const std::uint32_t> parent) {
  const auto n = static_cast<std::uint32_t>(parent.size());
  std::vector<std::uint32_t> first_child(n, no_parent), next_sibling(n, no_parent);
  for (std::uint32_t v = n; v-- > 0;)
    if (parent[v] != no_parent) {
      next_sibling[v] = first_child[parent[v]];
      first_child[parent[v]] = v;
    }
  std::vector<std::uint32_t> sequence, stack;
  sequence.reserve(n);
  for (std::uint32_t root = 0; root < n; ++root) {
    if (parent[root] != no_parent) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      if (first_child[v] == no_parent) {
        sequence.push_back(v);
        stack.pop_back();
      } else {
        stack.push_back(first_child[v]);
        first_child[v] = next_sibling[first_child[v]];
      }
    }
  }
  return sequence;
}

/// Least common ancestors in the tree as it is visited in postorder: each finished vertex joins its parent's
/// set.
class AncestorSets {
 public:
  explicit AncestorSets(std::uint32_t n) : up_(n) {
    for (std::uint32_t v = 0; v < n; ++v) up_[v] = v;
  }
  void join(std::uint32_t vertex, std::uint32_t parent) { up_[vertex] = parent; }
  std::uint32_t find(std::uint32_t v) {
    std::uint32_t root = v;
    while (up_[root] != root) root = up_[root];
    while (up_[v] != root) {
      const std::uint32_t next = up_[v];
      up_[v] = root;
      v = next;
    }
    return root;
  }

 private:
  std::vector<std::uint32_t> up_;
};

/// Column counts: row i of L has the pattern of a subtree of the elimination tree with root i. Each subtree
/// adds 1 at its leaves, takes 1 off where two leaves' paths meet and at the parent of its root; summed up
/// the tree that makes 1 at each of its vertices, so the sums over all rows are the column counts.
std::vector<std::uint32_t> column_counts(const CsrGraph& graph, std::span<const std::uint32_t> order,
                                         std::span<const std::uint32_t> new_of_old,
                                         std::span<const std::uint32_t> parent) {
  const auto n = static_cast<std::uint32_t>(order.size());
  const std::vector<std::uint32_t> sequence = postorder(parent);
  std::vector<std::uint32_t> first_descendant(n, no_parent);  // as position in the postorder
  std::vector<std::int64_t> weight(n, 0);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t leaf = sequence[k];
    if (first_descendant[leaf] != no_parent) continue;
    weight[leaf] = 1;
    for (std::uint32_t v = leaf; v != no_parent && first_descendant[v] == no_parent; v = parent[v])
      first_descendant[v] = k;
  }

  AncestorSets sets(n);
  std::vector<std::uint32_t> last_leaf(n, no_parent);  // per row: the latest leaf of its subtree, as column
  std::vector<std::uint32_t> last_seen(n, 0);  // per row: 1 + postorder position of its latest neighbour
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t j = sequence[k];
    if (parent[j] != no_parent) --weight[parent[j]];
    for (const std::uint32_t w : neighbours(graph, order[j])) {
      const std::uint32_t row = new_of_old[w];
      if (row <= j) continue;
      if (first_descendant[j] >= last_seen[row]) {  // no earlier neighbour of row below j: j is a leaf
        ++weight[j];
        if (last_leaf[row] != no_parent) --weight[sets.find(last_leaf[row])];
        last_leaf[row] = j;
      }
      last_seen[row] = k + 1;
    }
    if (parent[j] != no_parent) sets.join(j, parent[j]);
  }
  for (const std::uint32_t v : sequence)
    if (parent[v] != no_parent) weight[parent[v]] += weight[v];
  return {weight.begin(), weight.end()};
}

}  // namespace

std::vector<std::uint32_t> elimination_tree(const CsrGraph& graph, std::span<const std::uint32_t> order) {
  return tree_of(graph, order, checked_inverse(graph, order));
}

CholeskyFill cholesky_fill(const CsrGraph& graph, std::span<const std::uint32_t> order) {
  const std::vector<std::uint32_t> new_of_old = checked_inverse(graph, order);
  const std::vector<std::uint32_t> parent = tree_of(graph, order, new_of_old);
  CholeskyFill result;
  result.column_count = column_counts(graph, order, new_of_old, parent);
  for (const std::uint32_t count : result.column_count) {
    result.nonzeros += count;
    result.flops += static_cast<double>(count) * count;
  }
  result.fill = result.nonzeros - vertex_count(graph) - edge_count(graph);
  return result;
}

}  // namespace leonhard::graph
