// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/cancel_watch.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace vandplan::ros {
namespace {

constexpr auto pause = std::chrono::milliseconds(2);

void watch(const std::stop_token& is_over, const std::function<bool()>& is_cancelled,
           std::stop_source& source) {
  std::mutex mutex;
  std::condition_variable_any alarm;
  std::unique_lock lock(mutex);
  while (!is_over.stop_requested()) {
    if (is_cancelled()) {
      source.request_stop();
      return;
    }
    alarm.wait_for(lock, is_over, pause, [] { return false; });
  }
}

}  // namespace

CancelWatch::CancelWatch(std::function<bool()> is_cancelled) {
  if (!is_cancelled) return;
  if (is_cancelled()) {
    source_.request_stop();
    return;
  }
  // The thread holds the source's state, not the watch: a watch may be moved.
  thread_ =
      std::jthread([source = source_, asked = std::move(is_cancelled)](
                       const std::stop_token& is_over) mutable { watch(is_over, asked, source); });
}

}  // namespace vandplan::ros
