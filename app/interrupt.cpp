// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "interrupt.h"

#include <atomic>
#include <csignal>

namespace vandplan::app {
namespace {

// Asking for a stop changes atomic integers without a lock, as a signal handler may, as long as
// nobody has registered a callback.
std::stop_source stop_wanted;
static_assert(std::atomic<unsigned>::is_always_lock_free);

extern "C" void request_stop(int) {
  stop_wanted.request_stop();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

std::stop_token stop_on_signal() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  return stop_wanted.get_token();
}

}  // namespace vandplan::app
