// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

/// Regions as numbers of 32 bits, for formats that know no others; as many as there are, or none.
///
/// least   smallest number that the format can carry
/// throws  InputError naming the first cell whose region is no such whole number
template <class CellId>
[[nodiscard]] std::vector<Marker> whole_regions(const PerId<CellId, double>& regions, Marker least) {
  std::vector<Marker> whole;
  whole.reserve(regions.size());
  for (const CellId cell : regions.ids()) {
    const double region = regions[cell];
    const bool fits =
        region >= least && region <= std::numeric_limits<Marker>::max() && region == std::floor(region);
    if (!fits)
      throw InputError("cell " + std::to_string(cell.index()),
                       "its region is " + mesh::words(region) + ", which is no whole number from " +
                           std::to_string(least) + " to " +
                           std::to_string(std::numeric_limits<Marker>::max()),
                       "write .vtu or .ele, which carry any number, or number the regions");
    whole.push_back(static_cast<Marker>(region));
  }
  return whole;
}

}  // namespace leonhard::io
