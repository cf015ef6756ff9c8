// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/nested_dissection.hpp"

#include <span>
#include <utility>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/ordering/minimum_degree.hpp"
#include "leonhard/graph/separator/multilevel_separator.hpp"
#include "leonhard/graph/support/step_counter.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using detail::KwayGraph;
using Vertices = std::vector<std::uint32_t>;

struct Piece {
  KwayGraph graph;
  Vertices vertices;  ///< of the whole graph, one a vertex of the piece
};

/// The vertices with each label, in their sequence.
std::vector<Vertices> by_label(std::span<const std::uint32_t> label, std::uint32_t labels) {
  std::vector<Vertices> members(labels);
  for (std::uint32_t v = 0; v < label.size(); ++v) members[label[v]].push_back(v);
  return members;
}

Vertices chosen(const Vertices& from, const Vertices& places) {
  Vertices result;
  result.reserve(places.size());
  for (const std::uint32_t i : places) result.push_back(from[i]);
  return result;
}

/// Divides again and again, numbering the sets in the sequence of their elimination.
class Dissection {
 public:
  Dissection(std::uint32_t vertices, const NestedDissectionOptions& options)
      : options_(options), random_(options.seed), set_of_(vertices, 0) {}

  void divide(Piece piece) {
    if (piece.vertices.size() <= options_.leaf || stop()) return close_set(piece.vertices);
    const detail::KwayComponents parts = detail::components(piece.graph);
    if (parts.count > 1) return divide_components(piece, parts);
    const Sides side = detail::multilevel_separator(piece.graph, options_.largest_side, options_.tries,
                                                    random_, options_.progress.stop)
                           .side;
    std::vector<Vertices> sets = by_label(side, 3);
    if (sets[0].empty() || sets[1].empty()) return close_set(piece.vertices);
    const Vertices separator = chosen(piece.vertices, sets[detail::middle]);
    detail::KwaySubgraph subgraph(piece.graph);
    Piece first{subgraph(sets[0], side), chosen(piece.vertices, sets[0])};
    Piece second{subgraph(sets[1], side), chosen(piece.vertices, sets[1])};
    piece = {};
    divide(std::move(first));
    divide(std::move(second));
    close_set(separator);
  }

  [[nodiscard]] const Vertices& set_of() const { return set_of_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  using Sides = detail::Sides;

  [[nodiscard]] bool stop() {
    stopped_ = stopped_ || options_.progress.stop_requested();
    return stopped_;
  }

  /// Components that are leaves need no set of their own.
  void divide_components(const Piece& piece, const detail::KwayComponents& parts) {
    Vertices small;
    detail::KwaySubgraph subgraph(piece.graph);
    for (const Vertices& part : by_label(parts.component_of, parts.count)) {
      Vertices vertices = chosen(piece.vertices, part);
      if (part.size() > options_.leaf)
        divide({subgraph(part, parts.component_of), std::move(vertices)});
      else
        small.insert(small.end(), vertices.begin(), vertices.end());
    }
    close_set(small);
  }

  void close_set(const Vertices& vertices) {
    if (vertices.empty()) return;
    for (const std::uint32_t v : vertices) set_of_[v] = set_count_;
    ++set_count_;
    closed_ += vertices.size();
    options_.progress("nested dissection",
                      static_cast<double>(closed_) / static_cast<double>(set_of_.size()));
  }

  const NestedDissectionOptions& options_;
  detail::Random random_;
  Vertices set_of_;
  std::uint32_t set_count_ = 0;
  std::size_t closed_ = 0;  ///< vertices that have their set
  bool stopped_ = false;
};

}  // namespace

OrderResult nested_dissection(const CsrGraph& graph, const NestedDissectionOptions& options) {
  if (options.leaf == 0) throw InputError("options", "leaves of 0 vertices", "give at least 1");
  detail::check_separator_options(options.largest_side, options.tries);
  Dissection dissection(vertex_count(graph), options);
  dissection.divide({detail::weighted_graph(graph, {}, {}), natural_order(graph)});
  detail::StepCounter steps(options.progress, "minimum degree", vertex_count(graph));
  std::vector<std::uint32_t> order = detail::constrained_minimum_degree(graph, dissection.set_of(), steps);
  const bool stopped = dissection.stopped() || steps.stopped();
  return {std::move(order), stopped ? OrderOutcome::stopped : OrderOutcome::done};
}

}  // namespace leonhard::graph
