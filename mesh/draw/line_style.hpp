// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::draw {

enum class LineStyle { solid, dashed, dotted, dash_dotted, none };
enum class MarkerStyle { none, circle, square, triangle, diamond, cross };

}  // namespace leonhard::draw
