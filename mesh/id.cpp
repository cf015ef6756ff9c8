// SPDX-License-Identifier: MIT
#include "leonhard/mesh/id.hpp"

#include <ostream>

namespace leonhard::detail {

std::ostream& write_id(std::ostream& out, IdRaw raw) { return out << raw; }
std::ostream& write_no_id(std::ostream& out) { return out << "none"; }

}  // namespace leonhard::detail
