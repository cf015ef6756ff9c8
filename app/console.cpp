// SPDX-License-Identifier: MIT
#include "leonhard/app/console.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

namespace leonhard::app {

Console::Console(bool quiet) : talks_(!quiet && isatty(STDERR_FILENO) == 1) {}

void Console::clear_transient() {
  if (transient_shown_) fmt::print(stderr, "\r\x1b[K");
  transient_shown_ = false;
}

void Console::stage(std::string_view name, std::string_view what, double seconds) {
  if (!talks_) return;
  clear_transient();
  fmt::print(stderr, "{:<11}{:<72}{:>8.2f} s\n", name, what, seconds);
}

void Console::transient(const std::string& line) {
  if (!talks_) return;
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
  transient_shown_ = true;
}

void Console::warning(const std::string& text) {
  clear_transient();
  fmt::print(stderr, "leonhard: warning: {}\n", text);
}

std::string grouped(unsigned long long count) {
  const std::string digits = std::to_string(count);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

namespace {

// A signal handler may only write to a descriptor, so it writes one byte into a pipe that the watcher reads.
std::atomic<int> signal_pipe{-1};

extern "C" void on_signal(int) {
  const int saved = errno;
  const char byte = 's';
  if (const int fd = signal_pipe.load(); fd >= 0) [[maybe_unused]]
    const auto written = write(fd, &byte, 1);
  errno = saved;
}

void install(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

StopOnSignal::StopOnSignal() {
  if (pipe(pipe_.data()) != 0) return;
  signal_pipe = pipe_[1];
  watcher_ = std::jthread([this] {
    char byte = 0;
    while (read(pipe_[0], &byte, 1) < 0 && errno == EINTR) {
    }
    if (byte == 's') source_.request_stop();
  });
  // SA_RESETHAND: a second Ctrl-C meets the default action and ends the process at once.
  for (const int signal : {SIGINT, SIGTERM})
    install(signal, on_signal, static_cast<int>(SA_RESETHAND) | SA_RESTART);
}

StopOnSignal::~StopOnSignal() {
  for (const int signal : {SIGINT, SIGTERM}) install(signal, SIG_DFL, 0);
  if (const int fd = signal_pipe.exchange(-1); fd >= 0) {
    const char byte = 'q';
    [[maybe_unused]] const auto written = write(fd, &byte, 1);
    if (watcher_.joinable()) watcher_.join();
    for (const int end : pipe_)
      close(end);  // not before: a write to a pipe without a reader ends the process
  }
}

}  // namespace leonhard::app
