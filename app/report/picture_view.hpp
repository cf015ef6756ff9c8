// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/draw/tet_picture.hpp"
#include "leonhard/mesh/draw/view3.hpp"

/// The options of pictures, --view and --cut, in words and numbers.
namespace leonhard::app {

/// numbers  xmin, ymin, xmax, ymax; or none, for all there is
/// throws   InputError if they are not four or no rectangle
[[nodiscard]] draw::View plane_view(const std::vector<double>& numbers);

/// numbers  azimuth and elevation of the viewer in degrees; or none, for draw::View3's own
/// throws   InputError if they are not two
[[nodiscard]] draw::View3 space_view(const std::vector<double>& numbers);

/// Style and plane of a cut in words: "" through the middle; "none"; "x" through the middle across x; "x=0.5"; "x<0.5" and
/// "x>0.5", which name the side removed; "1,0,1,0.3" the plane x + z = 0.3, the side where x + z is larger removed.
///
/// throws InputError for other words
void parse_cut(const std::string& words, const draw::Box3& box, draw::TetPictureOptions& options);

}  // namespace leonhard::app
