// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/space/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

constexpr double radians = std::numbers::pi / 180;

void check_angle(const char* what, double degrees, double low, double high) {
  if (degrees >= low && degrees <= high) return;
  throw InputError("view", std::string(what) + " of " + mesh::words(degrees) + " degrees is out of range",
                   "give " + mesh::words(low) + " to " + mesh::words(high));
}

}  // namespace

void check_view(const View3& view) {
  check_angle("an azimuth", view.azimuth_deg, -360, 360);
  check_angle("an elevation", view.elevation_deg, -90, 90);
  check_angle("a field of view", view.field_of_view_deg, 0, 60);
}

Vec3 towards_viewer(const View3& view) {
  const double azimuth = view.azimuth_deg * radians, elevation = view.elevation_deg * radians;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

namespace {

Vec3 rightwards(const View3& view) {
  const double azimuth = view.azimuth_deg * radians;
  return {-std::sin(azimuth), std::cos(azimuth), 0};
}

}  // namespace

Point3 seen_from(const View3& view, const Point3& p) {
  const Vec3 towards = towards_viewer(view), right = rightwards(view), v = p - Point3{};
  return {dot(right, v), dot(cross(towards, right), v), dot(towards, v)};
}

Box3 box_of(const TetMesh& mesh) {
  if (mesh.corners.empty()) throw InputError("mesh", "it has no tetrahedron", "there is nothing to draw");
  const Point3 first = mesh.points[mesh.corners.flat().front()[0]];
  Box3 box{first, first};
  for (const auto& tet : mesh.corners) {
    for (const VertexId v : tet) {
      const Point3& p = mesh.points[v];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
  }
  return box;
}

CutPlane cut_across(Axis3 axis, double position, const View3& view) {
  const Vec3 towards = towards_viewer(view);
  const auto side = [](double component) { return component < 0 ? -1.0 : 1.0; };
  switch (axis) {
    case Axis3::x:
      return {{position, 0, 0}, {side(towards.x), 0, 0}};
    case Axis3::y:
      return {{0, position, 0}, {0, side(towards.y), 0}};
    case Axis3::z:
      break;
  }
  return {{0, 0, position}, {0, 0, side(towards.z)}};
}

CutPlane cut_through_middle(const Box3& box, const View3& view) {
  const Vec3 t = towards_viewer(view);
  const double x = std::abs(t.x), y = std::abs(t.y), z = std::abs(t.z);
  const auto middle = [](double low, double high) { return low / 2 + high / 2; };
  if (x >= y && x >= z) return cut_across(Axis3::x, middle(box.low.x, box.high.x), view);
  if (y >= z) return cut_across(Axis3::y, middle(box.low.y, box.high.y), view);
  return cut_across(Axis3::z, middle(box.low.z, box.high.z), view);
}

Camera::Camera(const Box3& box, const View3& view) {
  const auto middle = [](double low, double high) { return low / 2 + high / 2; };  // does not overflow
  centre_ = {middle(box.low.x, box.high.x), middle(box.low.y, box.high.y), middle(box.low.z, box.high.z)};
  const Vec3 half{box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2,
                  box.high.z / 2 - box.low.z / 2};
  unit_ = std::max({half.x, half.y, half.z});
  if (unit_ == 0) unit_ = 1;

  towards_ = towards_viewer(view);
  right_ = rightwards(view);
  up_ = cross(towards_, right_);
  // The sphere about the box just fills the field of view.
  const double radius = norm(Vec3{half.x / unit_, half.y / unit_, half.z / unit_});
  if (view.field_of_view_deg > 0) distance_ = radius / std::sin(view.field_of_view_deg * radians / 2);
}

Vec3 Camera::turn(const Vec3& v) const { return {dot(right_, v), dot(up_, v), dot(towards_, v)}; }

Vec3 Camera::turn(const Point3& p) const {
  const Vec3 d = p - centre_;
  return turn(Vec3{d.x / unit_, d.y / unit_, d.z / unit_});
}

Camera::Seen Camera::see(const Vec3& turned) const {
  if (distance_ == 0) return {turned.x, turned.y, turned.z};
  const double nearness = distance_ / (distance_ - turned.z);
  return {turned.x * nearness, turned.y * nearness, nearness};
}

}  // namespace leonhard::draw
