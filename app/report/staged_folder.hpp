// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace leonhard::app {

/// An output folder that receives all its files or none.
///
/// Files are written into a hidden folder inside it; commit() moves them to their places. Without commit the
/// destructor removes what was written and every folder that this object made. Making it tells early, before hours of
/// work, whether the folder can be written.
class StagedFolder {
 public:
  /// throws  OutputError: the folder cannot be made or written, or its name belongs to a file
  explicit StagedFolder(std::filesystem::path folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& stage() const { return stage_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Move every file to its place, replacing older ones. throws OutputError
  void commit();

 private:
  std::filesystem::path folder_, stage_;
  std::vector<std::filesystem::path> made_;  // folders that were not there, outermost first
};

}  // namespace leonhard::app
