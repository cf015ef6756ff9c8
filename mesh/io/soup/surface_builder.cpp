// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/surface_builder.hpp"

#include <limits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::io {

void SurfaceBuilder::end_polygon(std::size_t line, std::optional<Marker> marker,
                                 std::optional<std::size_t> facet) {
  surface_.offsets.push_back(corners_.size());
  lines_.push_back(line);
  if (marker) surface_.markers.push_back(*marker);
  if (facet) surface_.facets.push_back(*facet);
}

SurfaceFile SurfaceBuilder::finish() && {
  check_points();
  check_corners();
  surface_.corners.reserve(corners_.size());
  for (const std::int64_t corner : corners_)
    surface_.corners.push_back(VertexId::from(static_cast<std::size_t>(corner)));
  return std::move(surface_);
}

void SurfaceBuilder::check_points() const {
  if (surface_.set.points.empty()) throw InputError(source_, "the file holds no points", "give at least one");
  if (surface_.set.points.size() >= std::numeric_limits<IdRaw>::max())
    throw InputError(source_, "the file holds more points than ids can number");
  for (std::size_t i = 0; i < surface_.set.points.size(); ++i)
    if (!is_finite(surface_.set.points[i]))
      throw InputError(source_,
                       "vertex " + std::to_string(first_number_ + static_cast<std::int64_t>(i)) +
                           " has a coordinate that is not finite",
                       "NaN and infinities are bad input; find out what wrote them");
}

void SurfaceBuilder::check_corners() const {
  const auto count = static_cast<std::int64_t>(surface_.set.points.size());
  for (std::size_t i = 0; i + 1 < surface_.offsets.size(); ++i)
    for (std::size_t k = surface_.offsets[i]; k < surface_.offsets[i + 1]; ++k)
      if (corners_[k] < 0 || corners_[k] >= count)
        throw InputError(lines_[i] == 0 ? source_ : at_line(source_, lines_[i]),
                         "polygon " + std::to_string(i) + " names vertex " +
                             std::to_string(corners_[k] + first_number_) +
                             ", but the file has only vertices " + std::to_string(first_number_) + " to " +
                             std::to_string(first_number_ + count - 1),
                         "correct the polygon or the number of points");
}

}  // namespace leonhard::io
