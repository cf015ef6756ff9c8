// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace leonhard {

/// A file could not be written: disc full, folder missing or not writable. what() names the file and the
/// reason.
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error("cannot write " + path.string() + ": " + reason), path_(path) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A file that appears whole or not at all.
///
/// Bytes go to PATH.tmp-<process>-<n> in the same folder; commit() renames that file to PATH. Without commit
/// the destructor removes it and PATH stays as it was. A symbolic link is followed, an existing file's
/// permissions are kept. A target that is a device or a pipe (/dev/null, /dev/stdout) is written to directly:
/// there is nothing to rename. Every failure, at the latest the one of commit(), throws OutputError.
class AtomicFile {
 public:
  /// throws OutputError if the folder is missing or not writable, or the target is a folder
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  /// Append bytes. throws OutputError (disc full, ...)
  void write(std::string_view bytes);

  /// Everything on the disc and the target replaced. Call once, last.
  /// throws OutputError; the temporary file is then removed and the target untouched
  void commit();

 private:
  void open_temporary();
  void flush_buffer();
  void close_and_remove() noexcept;

  std::filesystem::path target_;     ///< as the caller named it, for messages
  std::filesystem::path resolved_;   ///< behind symbolic links
  std::filesystem::path temporary_;  ///< empty when writing directly to a device
  std::string buffer_;
  int descriptor_ = -1;
};

namespace io {

/// One whole file in one call. throws OutputError
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace io
}  // namespace leonhard
