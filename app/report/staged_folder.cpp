// SPDX-License-Identifier: MIT
#include "leonhard/app/report/staged_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "leonhard/mesh/io/atomic_file.hpp"

namespace leonhard::app {
namespace fs = std::filesystem;

StagedFolder::StagedFolder(fs::path folder) : folder_(std::move(folder)) {
  for (fs::path part = fs::absolute(folder_).lexically_normal(); !part.empty() && !fs::exists(part);
       part = part.parent_path()) {
    if (part.has_filename()) made_.insert(made_.begin(), part);
  }
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!error) {
    stage_ = folder_ / (".unfinished-" + std::to_string(getpid()));
    fs::create_directory(stage_, error);
  }
  if (!error) return;
  std::error_code ignored;
  for (auto part = made_.rbegin(); part != made_.rend(); ++part) fs::remove(*part, ignored);
  throw OutputError(folder_, error.message() + "; choose another folder with -o or output.folder");
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(stage_, ignored);
  // Only empty folders go: after commit they hold the results.
  for (auto part = made_.rbegin(); part != made_.rend(); ++part) fs::remove(*part, ignored);
}

void StagedFolder::commit() {
  try {
    for (const auto& entry : fs::directory_iterator(stage_))
      fs::rename(entry.path(), folder_ / entry.path().filename());
  } catch (const fs::filesystem_error& error) {
    throw OutputError(folder_, error.code().message());
  }
}

}  // namespace leonhard::app
