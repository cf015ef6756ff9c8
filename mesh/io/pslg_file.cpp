// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/pslg_file.hpp"

#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/triangle_files.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

const std::vector<std::string> pslg_extensions{".poly"};

/// Whether a .poly file leaves its vertices to a .node file.
bool declares_no_vertices(const std::string& poly, const std::string& source) {
  TextScanner scan(poly, source, {.comment = '#'});
  scan.need_line("the number of vertices");
  return scan.integer("the number of vertices") == 0;
}

}  // namespace

Pslg read_pslg(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  return read_pslg(path, warnings);
}

Pslg read_pslg(const std::filesystem::path& path, std::vector<std::string>& warnings) {
  known_extension(path, pslg_extensions, "geometry");
  const std::string poly = read_whole_file(path);
  std::filesystem::path node_path = path;
  node_path.replace_extension(".node");
  std::optional<std::string> node;
  if (declares_no_vertices(poly, path.string()) && std::filesystem::exists(node_path))
    node = read_whole_file(node_path);
  return parse_poly(poly, node, path.string(), &warnings);
}

void write_pslg(const std::filesystem::path& path, const Pslg& pslg) {
  known_extension(path, pslg_extensions, "geometry");
  write_file_atomically(path, format_poly(pslg));
}

}  // namespace leonhard::io
