// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// What an SU2 file states. zone: from 1, of a file of several. throws InputError as read_su2
template <int Dim>
[[nodiscard]] MeshSoup<Dim> parse_su2_soup(std::string_view text, const std::string& source,
                                           std::optional<std::size_t> zone = std::nullopt);

}  // namespace leonhard::io
