// SPDX-License-Identifier: MIT
#include "leonhard/app/meshes/read_request.hpp"

#include <vector>

namespace leonhard::app {

io::ReadOptions ReadRequest::options() const {
  io::ReadOptions options;
  options.split = split;
  if (weld >= 0) options.weld = weld;
  if (zone > 0) options.zone = zone;
  return options;
}

void add_read_options(Command& command, ReadRequest& request) {
  const std::vector<Option> options{
      {"--split", "Cut quadrilaterals into triangles, other cells of space into tetrahedra", &request.split},
      {.names = "--weld",
       .help = "Join vertices that are no farther apart than this; 0: those of equal coordinates",
       .target = &request.weld,
       .rule = OptionRule::not_negative},
      {.names = "--zone",
       .help = "Which zone of an .su2 file of several, from 1",
       .target = &request.zone,
       .range = OptionRange{1, 1e6}}};
  command.options.insert(command.options.end(), options.begin(), options.end());
}

}  // namespace leonhard::app
