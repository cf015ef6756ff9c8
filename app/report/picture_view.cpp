// SPDX-License-Identifier: MIT
#include "leonhard/app/report/picture_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

std::optional<double> number_of(std::string_view words) {
  double value = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
  if (error != std::errc{} || end != words.data() + words.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

[[noreturn]] void refuse_cut(const std::string& words) {
  throw InputError(
      "--cut", "'" + words + "' is no plane",
      "give none, an axis (x), its position (x=0.5), the side to remove (x<0.5), or nx,ny,nz,d for the "
      "plane nx x + ny y + nz z = d");
}

draw::CutPlane plane_across(const std::string& words, const draw::Box3& box, const draw::View3& view) {
  const auto axis = static_cast<draw::Axis3>(words[0] - 'x');
  const auto middle = [](double low, double high) { return low / 2 + high / 2; };
  const std::array<double, 3> middles{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y),
                                      middle(box.low.z, box.high.z)};
  if (words.size() == 1) return draw::cut_across(axis, middles[static_cast<std::size_t>(axis)], view);
  const auto position = number_of(std::string_view(words).substr(2));
  if (!position || (words[1] != '=' && words[1] != '<' && words[1] != '>')) refuse_cut(words);
  draw::CutPlane plane = draw::cut_across(axis, *position, view);
  if (words[1] == '=') return plane;
  const double side = words[1] == '<' ? -1 : 1;
  plane.normal = {side * std::abs(plane.normal.x), side * std::abs(plane.normal.y),
                  side * std::abs(plane.normal.z)};
  return plane;
}

draw::CutPlane plane_of_numbers(const std::string& words) {
  std::array<double, 4> numbers{};
  std::string_view rest = words;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t end = i < 3 ? rest.find(',') : rest.size();
    const auto value = end == std::string_view::npos ? std::nullopt : number_of(rest.substr(0, end));
    if (!value) refuse_cut(words);
    numbers[i] = *value;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  const auto& [x, y, z, d] = numbers;
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (largest == 0) refuse_cut(words);
  // The foot of the origin on the plane, from a normal of about length 1, whose square cannot overflow.
  const Vec3 n{x / largest, y / largest, z / largest};
  return {Point3{} + (d / largest / dot(n, n)) * n, n};
}

}  // namespace

draw::View plane_view(const std::vector<double>& v) {
  if (v.empty()) return {};
  if (v.size() != 4) {
    throw InputError("--view", fmt::format("{} numbers for a picture of the plane", v.size()),
                     "give xmin,ymin,xmax,ymax");
  }
  if (!(v[0] < v[2] && v[1] < v[3])) {
    throw InputError("--view", fmt::format("{:g},{:g},{:g},{:g} is no rectangle", v[0], v[1], v[2], v[3]),
                     "give xmin,ymin,xmax,ymax");
  }
  return {draw::Box{{v[0], v[1]}, {v[2], v[3]}}};
}

draw::View3 space_view(const std::vector<double>& v) {
  if (v.empty()) return {};
  if (v.size() != 2) {
    throw InputError("--view", fmt::format("{} numbers for a picture of space", v.size()),
                     "give azimuth,elevation in degrees");
  }
  return {.azimuth_deg = v[0], .elevation_deg = v[1]};
}

void parse_cut(const std::string& words, const draw::Box3& box, draw::TetPictureOptions& options) {
  if (words.empty()) return;
  if (words == "none") {
    options.cut = draw::CutStyle::none;
  } else if (words[0] >= 'x' && words[0] <= 'z') {
    options.cut_plane = plane_across(words, box, options.view);
  } else {
    options.cut_plane = plane_of_numbers(words);
  }
}

}  // namespace leonhard::app
