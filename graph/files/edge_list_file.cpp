// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <limits>

#include "leonhard/graph/files/listed_graph.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::graph {
namespace {

std::uint32_t read_vertex(io::TextScanner& scan) {
  const std::int64_t number = scan.integer("a vertex");
  if (number < 0 || number >= std::numeric_limits<std::uint32_t>::max())
    scan.fail("vertex " + std::to_string(number) + " is out of range",
              "number vertices from 0, below 2^32 - 1");
  return static_cast<std::uint32_t>(number);
}

bool is_header(const io::TextScanner& scan) {
  const char first = scan.rest().front();
  return std::isalpha(static_cast<unsigned char>(first)) != 0 || first == '"';
}

/// A stray large number would ask for memory beyond all measure.
void check_density(const io::TextScanner& scan, const detail::ListedGraph& listed) {
  if (listed.vertices <= 1024 + 64 * listed.entries.size()) return;
  const auto largest = std::ranges::max_element(
      listed.entries, {}, [](const detail::ListedEdge& e) { return std::max(e.from, e.to); });
  throw InputError(at_line(scan.source(), largest->line),
                   "vertex " + std::to_string(listed.vertices - 1) + " in a list of " +
                       std::to_string(listed.entries.size()) + " edges",
                   "number the vertices one after another");
}

}  // namespace

GraphFile parse_edge_list(std::string_view text, const std::string& source) {
  std::string without_percent(text);  // two comment signs, the scanner knows one
  std::ranges::replace(without_percent, '%', '#');
  io::TextScanner scan(without_percent, source, {.comment = '#', .extra_blank = ','});
  GraphFile file;
  file.first_number = 0;
  detail::ListedGraph listed;
  listed.source = source;
  bool first = true, weighted = false;
  while (scan.next_line()) {
    if (first && is_header(scan)) continue;
    const std::uint32_t a = read_vertex(scan), b = read_vertex(scan);
    if (first) weighted = !scan.line_done();
    if (weighted) listed.weights.push_back(scan.integer("an edge's weight, as on the first line"));
    scan.expect_line_end(weighted ? "an edge's weight" : "an edge's two vertices");
    listed.entries.push_back({a, b, static_cast<std::uint32_t>(scan.line())});
    listed.vertices = std::max({listed.vertices, a + 1, b + 1});
    first = false;
  }
  if (listed.entries.empty()) scan.fail("no edge was found", "give one edge a line, its two vertices");
  check_density(scan, listed);
  detail::assemble(std::move(listed), file);
  if (degree(file.graph, 0) == 0)
    file.warnings.push_back(source + ": vertex 0 has no edge; numbers count from 0");
  return file;
}

}  // namespace leonhard::graph
