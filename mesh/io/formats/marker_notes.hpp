// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "leonhard/mesh/pslg.hpp"

namespace leonhard::io {

/// Marker numbers and names as leading comments of a text file, e.g. "# marker 2 farfield": how formats
/// without a place for one of the two carry both.
///
/// throws InputError if a name is empty, holds a control character, or begins or ends with a blank
///
/// word  what they are about: "marker", or "region"
[[nodiscard]] std::string format_marker_notes(const std::map<Marker, std::string>& names, char comment,
                                              std::string_view word = "marker");

/// The notes among the comment lines before the first line of data; other comments are passed over. If a
/// number or a name comes twice the notes are not ours and none is returned.
[[nodiscard]] std::map<Marker, std::string> read_marker_notes(std::string_view text, char comment,
                                                              std::string_view word = "marker");

}  // namespace leonhard::io
