// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/formats/gmsh_form.hpp"

namespace leonhard::io {

/// The file that parse_gmsh_data turns back into the same data (but for the lines). Groups are not negative and names
/// can stand in the file.
[[nodiscard]] std::string format_gmsh_data(const GmshData& data, const GmshForm& form);

}  // namespace leonhard::io
