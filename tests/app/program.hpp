// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace leonhard::test {

/// What one run of the program left.
struct Ran {
  int exit_code{};
  std::string out, err;
};

/// Run `leonhard ARGUMENTS` through the shell, in a folder.
///
/// program  another build of it, by its path
[[nodiscard]] Ran run(const std::string& arguments, const std::filesystem::path& folder,
                      const std::string& program = {});

/// A fresh folder under the system's temporary one, removed with everything in it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Write a file, folders included, and return its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string text_of(const std::filesystem::path& file);

/// The whole numbers with which a file begins.
[[nodiscard]] std::vector<int> numbers_of(const std::filesystem::path& file);

}  // namespace leonhard::test
