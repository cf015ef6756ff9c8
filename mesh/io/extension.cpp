// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/extension.hpp"

#include <algorithm>
#include <cctype>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/did_you_mean.hpp"

namespace leonhard::io {

std::string small_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool carries_fields(const std::filesystem::path& path) {
  return small_extension(path) == ".vtu" || small_extension(path) == ".msh";
}

std::string known_extension(const std::filesystem::path& path, const std::vector<std::string>& known,
                            const std::string& what) {
  std::string extension = small_extension(path);
  if (std::find(known.begin(), known.end(), extension) != known.end()) return extension;
  std::string list;
  for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
  const std::string suggestion = did_you_mean(extension, known);
  throw InputError(path.string(),
                   (extension.empty() ? std::string("a ") + what + " file's name needs an extension"
                                      : "\"" + extension + "\" is no extension of a " + what + " file"),
                   (suggestion.empty() ? "" : suggestion + " ") + std::string("known are ") + list);
}

}  // namespace leonhard::io
