// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace leonhard {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

std::string reason(int error) { return std::generic_category().message(error); }

/// The file behind symbolic links: renaming onto a link would replace the link.
std::filesystem::path behind_links(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path resolved = std::filesystem::weakly_canonical(path, error);
  return error ? path : resolved;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)), resolved_(behind_links(target_)) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(resolved_, error);
  if (status.type() == std::filesystem::file_type::directory) throw OutputError(target_, "it is a folder");
  const bool replaceable = status.type() == std::filesystem::file_type::regular ||
                           status.type() == std::filesystem::file_type::not_found;
  if (replaceable || error) {
    open_temporary();
  } else {
    descriptor_ = ::open(resolved_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) throw OutputError(target_, reason(errno));
  }
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      resolved_(std::move(other.resolved_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::move(other.buffer_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() { close_and_remove(); }

void AtomicFile::open_temporary() {
  constexpr int attempts = 1000;  // leftovers of killed processes that had our number
  for (int n = 0; n < attempts && descriptor_ < 0; ++n) {
    temporary_ = resolved_;
    temporary_ += ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(n);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) {
      const int error = errno;
      temporary_.clear();
      throw OutputError(target_, reason(error));
    }
  }
  if (descriptor_ < 0) {
    temporary_.clear();
    throw OutputError(target_, "its folder is full of temporary files of earlier runs (*.tmp-*)");
  }
  struct stat existing {};
  if (::stat(resolved_.c_str(), &existing) == 0)
    static_cast<void>(::fchmod(descriptor_, existing.st_mode & 07777));
}

void AtomicFile::write(std::string_view bytes) {
  if (buffer_.empty()) buffer_.reserve(buffer_size);
  while (!bytes.empty()) {
    const std::size_t part = std::min(bytes.size(), buffer_size - buffer_.size());
    buffer_.append(bytes.substr(0, part));
    bytes.remove_prefix(part);
    if (buffer_.size() == buffer_size) flush_buffer();
  }
}

void AtomicFile::flush_buffer() {
  std::string_view left = buffer_;
  while (!left.empty()) {
    const ::ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw OutputError(target_, reason(errno));
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void AtomicFile::commit() {
  flush_buffer();
  if (::close(std::exchange(descriptor_, -1)) != 0) {  // file systems over a network report a full disc here
    const int error = errno;
    close_and_remove();
    throw OutputError(target_, reason(error));
  }
  if (temporary_.empty()) return;
  std::error_code error;
  std::filesystem::rename(temporary_, resolved_, error);
  if (error) {
    close_and_remove();
    throw OutputError(target_, error.message());
  }
  temporary_.clear();
}

void AtomicFile::close_and_remove() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

void io::write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace leonhard
