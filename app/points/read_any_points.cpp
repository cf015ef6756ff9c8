// SPDX-License-Identifier: MIT
#include "leonhard/app/points/read_any_points.hpp"

#include <algorithm>
#include <cctype>

#include "leonhard/app/points/points_json.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::app {

const std::vector<std::string>& any_point_extensions() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> all = io::point_extensions();
    all.insert(all.end(), {".json", ".geojson"});
    return all;
  }();
  return known;
}

PointsFile read_any_points(const std::filesystem::path& path) {
  const std::string extension = io::known_extension(path, any_point_extensions(), "points");
  if (extension != ".json" && extension != ".geojson") return io::read_points(path);
  return parse_points_json(io::read_whole_file(path), path.string());
}

bool is_points_file(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto& known = any_point_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) return false;
  return extension != ".node" ||
         !std::filesystem::exists(std::filesystem::path(path).replace_extension(".ele"));
}

}  // namespace leonhard::app
