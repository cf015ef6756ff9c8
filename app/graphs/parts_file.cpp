// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/parts_file.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::app {

graph::Partition parse_parts(std::string_view text, const std::string& source, std::size_t vertices) {
  io::TextScanner scan(text, source, {.comment = '#'});
  graph::Partition partition;
  while (scan.next_line()) {
    if (partition.part_of.size() == vertices)
      scan.fail(fmt::format("more than {} parts, the number of vertices", vertices),
                "is it the file of another graph, or of another --of?");
    const std::int64_t part = scan.integer("a vertex's part");
    scan.expect_line_end("the part");
    if (part < 0 || static_cast<std::uint64_t>(part) >= vertices)
      scan.fail(fmt::format("part {} of {} vertices", part, vertices), "number the parts from 0");
    partition.part_of.push_back(static_cast<std::uint32_t>(part));
    partition.parts = std::max(partition.parts, partition.part_of.back() + 1);
  }
  if (partition.part_of.size() < vertices)
    scan.fail(fmt::format("{} parts for {} vertices", partition.part_of.size(), vertices),
              "is it the file of another graph, or of another --of?");
  return partition;
}

graph::Partition read_parts(const std::filesystem::path& path, std::size_t vertices) {
  return parse_parts(io::read_whole_file(path), path.string(), vertices);
}

void write_parts(const std::filesystem::path& path, const graph::Partition& partition) {
  std::string text;
  for (const std::uint32_t part : partition.part_of) {
    io::append_number(text, part);
    text += '\n';
  }
  io::write_file_atomically(path, text);
}

}  // namespace leonhard::app
