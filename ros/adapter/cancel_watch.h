// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a function that says "cancelled" stop a run?

#include <functional>
#include <stop_token>
#include <thread>

namespace vandplan::ros {

/// Asks a function every 2 ms, in a thread of its own, whether the call is cancelled, for as long
/// as the watch lives. `is_cancelled` must not throw.
class CancelWatch {
 public:
  /// Without a function, which is allowed, nothing is ever cancelled.
  explicit CancelWatch(std::function<bool()> is_cancelled);

  /// Is asked to stop once the function has said yes. A call that is cancelled already is asked at
  /// once.
  [[nodiscard]] std::stop_token token() const noexcept { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread thread_;  // ends first
};

}  // namespace vandplan::ros
