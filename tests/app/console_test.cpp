// SPDX-License-Identifier: MIT
#include "leonhard/app/console.hpp"

#include <doctest/doctest.h>
#include <signal.h>

#include <chrono>
#include <thread>

TEST_CASE("regress_the_first_signal_asks_to_stop_and_the_end_of_the_work_survives_it") {
  {
    const leonhard::app::StopOnSignal signals;
    CHECK_FALSE(signals.token().stop_requested());
    raise(SIGINT);
    for (int i = 0; i < 500 && !signals.token().stop_requested(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(signals.token().stop_requested());
    std::this_thread::sleep_for(
        std::chrono::milliseconds(20));  // the watcher has ended, and its pipe once was closed
  }
  CHECK_FALSE(leonhard::app::StopOnSignal().token().stop_requested());
}
