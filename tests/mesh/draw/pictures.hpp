// SPDX-License-Identifier: MIT
#pragma once

#include <cairo.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/canvas/canvas.hpp"
#include "leonhard/mesh/draw/draw.hpp"
#include "tests/mesh/shelf.hpp"

/// What the tests of pictures share: a folder to write to, PNG files read back, meshes.
namespace leonhard::draw::test {

/// A folder that goes when the test ends.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "leonhard-draw-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A PNG file as pixels 0xFFRRGGBB.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> words;

  explicit Pixels(const std::filesystem::path& path) {
    cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
    width = cairo_image_surface_get_width(surface);
    height = cairo_image_surface_get_height(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    const unsigned char* data = cairo_image_surface_get_data(surface);
    for (int y = 0; data != nullptr && y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        std::uint32_t word = 0;
        std::copy_n(data + std::size_t(y) * stride + 4 * std::size_t(x), 4,
                    reinterpret_cast<unsigned char*>(&word));
        words.push_back(word | 0xFF000000U);
      }
    }
    cairo_surface_destroy(surface);
  }
  [[nodiscard]] std::uint32_t at(int x, int y) const { return words.at(std::size_t(y) * width + x); }
  [[nodiscard]] std::uint32_t at(Point2 p) const { return at(static_cast<int>(p.x), static_cast<int>(p.y)); }
  [[nodiscard]] std::size_t count(const std::function<bool(std::uint32_t)>& wanted) const {
    return static_cast<std::size_t>(std::count_if(words.begin(), words.end(), wanted));
  }
  [[nodiscard]] std::size_t count(std::uint32_t word) const {
    return count([&](std::uint32_t w) { return w == word; });
  }
  /// The smallest box around all pixels of a colour, as left, top, right, bottom.
  [[nodiscard]] std::array<int, 4> box_of(std::uint32_t word) const {
    std::array<int, 4> box{width, height, -1, -1};
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (at(x, y) != word) continue;
        box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
      }
    }
    return box;
  }
};

/// The largest difference of red, green or blue, in 1/255.
inline int difference(std::uint32_t a, std::uint32_t b) {
  int most = 0;
  for (const int shift : {0, 8, 16}) {
    most =
        std::max(most, std::abs(static_cast<int>(a >> shift & 0xFF) - static_cast<int>(b >> shift & 0xFF)));
  }
  return most;
}

/// The unit square, n by n squares of two triangles.
inline TriangleMesh unit_square(std::size_t n) {
  shelf::Grid grid(n, n);
  for (Point2& p : grid.points) p = {p.x / static_cast<double>(n), p.y / static_cast<double>(n)};
  return shelf::build(grid.points, grid.triangles);
}

/// The unit square without its middle ninth: 6 by 6 squares without the four in the middle.
inline TriangleMesh square_with_hole() {
  shelf::Grid grid(6, 6);
  for (Point2& p : grid.points) p = {p.x / 6, p.y / 6};
  std::vector<bool> keep;
  for (std::size_t t = 0; t < grid.triangles.size(); ++t) {
    const std::size_t i = t / 2 % 6, j = t / 2 / 6;
    keep.push_back(i < 2 || i > 3 || j < 2 || j > 3);
  }
  return shelf::build_kept(grid.points, grid.triangles, keep);
}

inline std::vector<double> values_on(const TriangleMesh& mesh, const std::function<double(Point2)>& f) {
  std::vector<double> values;
  for (const Point2 p : mesh.points) values.push_back(f(p));
  return values;
}

}  // namespace leonhard::draw::test
