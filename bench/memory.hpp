// SPDX-License-Identifier: MIT
#pragma once

#include <malloc.h>

#include <cstddef>
#include <fstream>
#include <string>

/// How much memory some work needs, as Linux counts it.
namespace leonhard::benching {

/// A line of /proc/self/status, in bytes; 0 where there is none.
inline std::size_t status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == name + ":" && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

/// The most memory resident during the work, beyond what was resident before it.
template <class Work>
std::size_t peak_bytes_of(const Work& work) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // sets the high-water mark back
  const std::size_t before = status_bytes("VmRSS");
  work();
  const std::size_t peak = status_bytes("VmHWM");
  return peak > before ? peak - before : 0;
}

}  // namespace leonhard::benching
