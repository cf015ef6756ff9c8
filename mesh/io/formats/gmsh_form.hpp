// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::io {

enum class GmshVersion { v2_2, v4_1 };

/// The form in which a .msh file is written.
struct GmshForm {
  GmshVersion version = GmshVersion::v4_1;
  bool binary = false;  ///< in this machine's byte order; else text
};

}  // namespace leonhard::io
