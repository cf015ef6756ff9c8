// SPDX-License-Identifier: MIT
#pragma once

/// Everything that draws: PNG, SVG and PDF by the file's extension.
#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/curves.hpp"
#include "leonhard/mesh/draw/diagram.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/pattern.hpp"
#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/draw/tet_picture.hpp"
#include "leonhard/mesh/draw/view3.hpp"
