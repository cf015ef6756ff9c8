// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "leonhard/app/command_line/command.hpp"
#include "leonhard/mesh/io/read_options.hpp"

namespace leonhard::app {

/// How a mesh is read, in the words of the command line.
struct ReadRequest {
  bool split = false;
  double weld = -1;        ///< negative: vertices stay as they are
  std::uint32_t zone = 0;  ///< 0: the only one

  [[nodiscard]] io::ReadOptions options() const;
};

/// Adds --split, --weld and --zone to a subcommand.
void add_read_options(Command& command, ReadRequest& request);

}  // namespace leonhard::app
