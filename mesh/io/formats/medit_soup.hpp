// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/mesh/io/formats/medit_data.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// What a file of Medit states. throws  InputError if it is of the other dimension
template <int Dim>
[[nodiscard]] MeshSoup<Dim> medit_soup(MeditData&& data, const std::string& source);

}  // namespace leonhard::io
