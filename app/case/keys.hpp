// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace leonhard::app {

/// One key of the case file with the value in force, as `describe` prints it.
struct KeyInForce {
  std::string key;    ///< "solver.order"; bodies and boundaries carry their name: "body.main.file"
  std::string value;  ///< as TOML
  bool by_default = false;
  std::string where{};  ///< "case.toml:12"; of the section or the file where it is by default
  std::size_t elements = 0;  ///< of a vector; 0 of other keys
};

/// One key a case file may have: what docs/case-file.md must tell about.
struct KnownKey {
  std::string key;       ///< "solver.order", "body.file", "boundary.NAME.kind"
  std::string type;      ///< "number", "integer", "text", "true or false", "2 numbers", "one of: ..."
  std::string fallback;  ///< default as TOML, "required" or "none"
};

}  // namespace leonhard::app
