// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/support/id_set.hpp"

#include <utility>

namespace leonhard::delaunay {

void IdSet::clear() {
  slots_.assign(first_slots, none);
  size_ = 0;
}

std::size_t IdSet::slot_of(IdRaw id) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = ((id * 0x9e3779b1U) >> 7) & mask;
  while (slots_[at] != none && slots_[at] != id) at = (at + 1) & mask;
  return at;
}

bool IdSet::insert(IdRaw id) {
  const std::size_t at = slot_of(id);
  if (slots_[at] == id) return false;
  slots_[at] = id;
  if (2 * ++size_ > slots_.size()) grow();
  return true;
}

void IdSet::grow() {
  std::vector<IdRaw> old = std::exchange(slots_, std::vector<IdRaw>(4 * slots_.size(), none));
  size_ = 0;
  for (const IdRaw id : old)
    if (id != none) insert(id);
}

}  // namespace leonhard::delaunay
