// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/mesh/draw/space/tet_scene.hpp"

namespace leonhard::draw {

/// The facets that are seen anywhere, in an order in which each may be painted over those before it.
///
/// A z-buffer says at each sample which facet is in front; this one comes after the others there. Cycles, and what
/// falls between the samples, are broken by distance. Facets smaller than a sample may count as hidden.
/// facets  placed on the page
/// area    of the page, on which they lie
/// Cost O(samples + n log n), n the facets.
[[nodiscard]] std::vector<std::uint32_t> painters_order(std::span<const Facet> facets, const Rect& area);

}  // namespace leonhard::draw
