// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do several threads change one value?

#include <chrono>
#include <mutex>
#include <utility>

namespace vandplan::base {

/// A value that one thread at a time may touch; whoever shares it may change it.
template <typename Value>
class Guarded {
 public:
  template <typename... Arguments>
  explicit Guarded(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

  /// What `use(value)` returns; whoever else asks waits for it.
  template <typename Use>
  auto with(Use use) const {
    const std::lock_guard lock(mutex_);
    return use(value_);
  }

  /// Calls `use(value)` as soon as nobody else does; does not, and returns false, once `give_up()`
  /// is true, which is asked about every millisecond.
  template <typename Use, typename GiveUp>
  [[nodiscard]] bool with(Use use, GiveUp give_up) const {
    std::unique_lock lock(mutex_, std::defer_lock);
    // Until a time of the system's clock: ThreadSanitizer knows no other way to wait for a mutex.
    using std::chrono::system_clock, std::chrono::milliseconds;
    while (!lock.try_lock_until(system_clock::now() + milliseconds(1))) {
      if (give_up()) return false;
    }
    use(value_);
    return true;
  }

 private:
  mutable std::timed_mutex mutex_;
  mutable Value value_;
};

}  // namespace vandplan::base
