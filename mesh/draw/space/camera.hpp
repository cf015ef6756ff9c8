// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/draw/view3.hpp"

namespace leonhard::draw {

/// throws InputError for angles that are not finite or out of range
void check_view(const View3& view);

/// The unit vector towards the viewer.
[[nodiscard]] Vec3 towards_viewer(const View3& view);

/// From space to a picture plane. Lengths are halves of the box's longest side, so that meshes of any size are alike.
/// Not meant for callers of the room.
class Camera {
 public:
  Camera(const Box3& box, const View3& view);

  /// A point in the camera's own axes: x to the right, y up, z towards the viewer; the box's centre is the origin.
  [[nodiscard]] Vec3 turn(const Point3& p) const;
  /// A direction likewise, its length kept.
  [[nodiscard]] Vec3 turn(const Vec3& v) const;

  /// Where a turned point is seen.
  struct Seen {
    double x{}, y{};
    double
        nearness{};  ///< larger is nearer to the viewer; linear on the picture of a plane, as a z-buffer wants it
  };
  [[nodiscard]] Seen see(const Vec3& turned) const;

  [[nodiscard]] bool is_perspective() const { return distance_ > 0; }

 private:
  Point3 centre_;
  double unit_;  ///< world lengths in one of the camera's
  Vec3 right_, up_, towards_;
  double distance_ = 0;  ///< from the box's centre to the eye; 0: parallel projection
};

}  // namespace leonhard::draw
