// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do several threads change one value?

#include <chrono>
#include <mutex>
#include <utility>

namespace vandplan::base {

/// A value that one thread at a time may touch. A const reference is enough to change it.
template <typename Value>
class Guarded {
 public:
  template <typename... Arguments>
  explicit Guarded(Arguments&&... arguments) : value_(std::forward<Arguments>(arguments)...) {}

  /// Returns `use(value)`. Other threads that ask for the value wait meanwhile.
  template <typename Use>
  auto with(Use use) const {
    const std::lock_guard lock(mutex_);
    return use(value_);
  }

  /// Calls `use(value)` as soon as no other thread uses the value, and returns true. While it
  /// waits, it calls `give_up()` about every millisecond, and returns false once that is true.
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
