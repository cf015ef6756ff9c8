// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/permutation.hpp"

#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {

void check_permutation(std::size_t count, const PerId<VertexId, VertexId>& new_of_old) {
  const char* remedy = "give every vertex a new number of its own from 0 to the number of vertices - 1";
  if (new_of_old.size() != count) {
    throw InputError(
        "new_of_old",
        std::to_string(new_of_old.size()) + " entries for " + std::to_string(count) + " vertices", remedy);
  }
  PerId<VertexId, MaybeId<VertexId>> old_of_new(count);
  for (const VertexId old : new_of_old.ids()) {
    const VertexId id = new_of_old[old];
    const auto entry = [&] {
      return "vertex " + std::to_string(old.raw) + " is given the number " + std::to_string(id.raw);
    };
    if (!old_of_new.contains(id)) {
      throw InputError("new_of_old", entry() + ", but there are " + std::to_string(count) + " vertices",
                       remedy);
    }
    if (old_of_new[id]) {
      throw InputError("new_of_old",
                       entry() + ", which vertex " + std::to_string((*old_of_new[id]).raw) + " has already",
                       remedy);
    }
    old_of_new[id] = old;
  }
}

}  // namespace leonhard::mesh
