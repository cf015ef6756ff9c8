// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "leonhard/graph/files/listed_graph.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::graph {
namespace {

struct Header {
  std::uint32_t vertices{};
  std::size_t edges{};
  bool vertex_sizes = false, edge_weights = false;
  std::uint32_t weights_each = 0;
};

/// Up to three digits 0 or 1: vertex sizes, vertex weights, edge weights.
void read_flags(io::TextScanner& scan, Header& header) {
  const std::string_view flags = scan.word("the flags of weights");
  if (flags.size() > 3 || flags.find_first_not_of("01") != std::string_view::npos)
    scan.fail_found(flags, "flags of weights (three digits 0 or 1)");
  const auto flag = [&](std::size_t from_end) {
    return flags.size() > from_end && flags[flags.size() - 1 - from_end] == '1';
  };
  header.edge_weights = flag(0);
  header.weights_each = flag(1) ? 1 : 0;
  header.vertex_sizes = flag(2);
  if (scan.line_done()) return;
  const std::int64_t each = scan.integer("the number of weights of a vertex");
  if (each < 0 || each > 1000 || (each == 0 && header.weights_each > 0))
    scan.fail(std::to_string(each) + " weights a vertex are out of range", "give 1 to 1000");
  if (header.weights_each > 0) header.weights_each = static_cast<std::uint32_t>(each);
}

Header read_header(io::TextScanner& scan) {
  scan.need_line("the number of vertices");
  Header header;
  const std::size_t vertices = scan.count("the number of vertices", 1);
  if (vertices >= std::numeric_limits<std::uint32_t>::max())
    scan.fail(std::to_string(vertices) + " vertices", "graphs hold fewer than 2^32 - 1");
  header.vertices = static_cast<std::uint32_t>(vertices);
  header.edges = scan.count("the number of edges", 3);
  if (!scan.line_done()) read_flags(scan, header);
  scan.expect_line_end("the header");
  return header;
}

std::int64_t read_weight(io::TextScanner& scan, const char* what, std::int64_t least) {
  const std::int64_t weight = scan.integer(what);
  if (weight < least)
    scan.fail(std::string(what) + " is " + std::to_string(weight),
              least == 0 ? "give 0 or more" : "give 1 or more");
  return weight;
}

void read_vertex(io::TextScanner& scan, std::uint32_t v, const Header& header, GraphFile& file,
                 detail::ListedGraph& listed) {
  if (header.vertex_sizes) read_weight(scan, "a vertex's size", 0);
  for (std::uint32_t i = 0; i < header.weights_each; ++i)
    file.vertex_weights.push_back(read_weight(scan, "a vertex's weight", 0));
  while (!scan.line_done()) {
    const std::int64_t neighbour = scan.integer("a neighbour");
    if (neighbour < 1 || neighbour > header.vertices)
      scan.fail("vertex " + std::to_string(v + std::uint64_t{1}) + " has neighbour " +
                    std::to_string(neighbour) + ", the file declares " + std::to_string(header.vertices) +
                    " vertices",
                "number vertices from 1");
    listed.entries.push_back(
        {v, static_cast<std::uint32_t>(neighbour - 1), static_cast<std::uint32_t>(scan.line())});
    if (header.edge_weights) listed.weights.push_back(read_weight(scan, "an edge's weight", 1));
  }
}

std::size_t count_self_loops(const detail::ListedGraph& listed) {
  return static_cast<std::size_t>(
      std::ranges::count_if(listed.entries, [](const detail::ListedEdge& e) { return e.from == e.to; }));
}

/// Self-loops stand in one list; writers count them as edges or not.
void check_edge_count(const std::string& source, const Header& header, std::size_t entries,
                      std::size_t loops) {
  const std::size_t proper = entries - loops;
  if (2 * header.edges >= proper && 2 * header.edges <= proper + 2 * loops) return;
  throw InputError(source,
                   "the header declares " + std::to_string(header.edges) + " edges, the lists hold " +
                       std::to_string(entries) + " neighbours",
                   "each edge stands in two lists: correct the header, or the file is damaged");
}

void append_weights(std::string& text, std::span<const std::int64_t> weights) {
  for (const std::int64_t weight : weights) {
    io::append_number(text, weight);
    text += ' ';
  }
}

void check_weights(const CsrGraph& graph, std::span<const std::int64_t> vertex_weights,
                   std::span<const std::int64_t> edge_weights) {
  const std::size_t n = vertex_count(graph), m = 2 * edge_count(graph);
  if (n == 0 ? !vertex_weights.empty() : vertex_weights.size() % n != 0)
    throw InputError(
        "vertex_weights",
        std::to_string(vertex_weights.size()) + " weights for " + std::to_string(n) + " vertices",
        "give each the same number");
  if (!edge_weights.empty() && edge_weights.size() != m)
    throw InputError(
        "edge_weights",
        std::to_string(edge_weights.size()) + " weights for " + std::to_string(m) + " directed edges",
        "give one each");
  if (std::ranges::any_of(vertex_weights, [](std::int64_t w) { return w < 0; }) ||
      std::ranges::any_of(edge_weights, [](std::int64_t w) { return w < 1; }))
    throw InputError("weights", "a vertex's weight is negative or an edge's is not positive",
                     "METIS's format carries no such weights");
}

}  // namespace

GraphFile parse_metis_graph(std::string_view text, const std::string& source) {
  io::TextScanner scan(text, source, {.comment = '%'});
  const Header header = read_header(scan);
  GraphFile file;
  file.weights_each = header.weights_each;
  detail::ListedGraph listed{
      source, header.vertices, {}, {}, true, "an edge stands in the lists of both its ends"};
  listed.entries.reserve(2 * header.edges);
  for (std::uint32_t v = 0; v < header.vertices; ++v) {
    if (!scan.next_line_even_if_empty())
      scan.fail("file ends where the neighbours of vertex " + std::to_string(v + std::uint64_t{1}) +
                    " were expected",
                "a vertex without neighbours has an empty line; or the file was cut short");
    read_vertex(scan, v, header, file, listed);
  }
  if (scan.next_line()) scan.fail("found a line after the last vertex's", "correct the number of vertices");
  const std::size_t entries = listed.entries.size(), loops = count_self_loops(listed);
  detail::assemble(std::move(listed), file);
  check_edge_count(source, header, entries, loops);
  if (header.vertex_sizes) file.warnings.push_back(source + ": the sizes of its vertices were left out");
  return file;
}

std::string format_metis_graph(const CsrGraph& graph, std::span<const std::int64_t> vertex_weights,
                               std::span<const std::int64_t> edge_weights) {
  check_weights(graph, vertex_weights, edge_weights);
  const std::uint32_t n = vertex_count(graph);
  const std::size_t each = n == 0 ? 0 : vertex_weights.size() / n;
  std::string text;
  io::append_number(text, n);
  text += ' ';
  io::append_number(text, edge_count(graph));
  if (each > 0 || !edge_weights.empty())
    text += std::string(" 0") + (each > 0 ? '1' : '0') + (edge_weights.empty() ? '0' : '1');
  if (each > 1) text += " " + std::to_string(each);
  text += '\n';
  std::size_t next_edge = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    append_weights(text, vertex_weights.subspan(v * each, each));
    for (const std::uint32_t w : neighbours(graph, v)) {
      io::append_number(text, w + std::uint64_t{1});
      text += ' ';
      if (!edge_weights.empty()) append_weights(text, edge_weights.subspan(next_edge, 1));
      ++next_edge;
    }
    if (text.back() == ' ') text.pop_back();
    text += '\n';
  }
  return text;
}

}  // namespace leonhard::graph
