// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Ctrl-C end a run?
//
// Python's own handler notes the signal and looks at it when Python goes on, which is after the
// run. Ours, which calls that one, ends the run besides.

#include <atomic>

namespace vandplan::python {

/// As long as one of these lives in Python's main thread, SIGINT sets `stop()` besides what it does
/// anyway. In other threads, which Python hands no signals, it does nothing.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Becomes true at SIGINT; null in other threads.
  [[nodiscard]] const std::atomic<bool>* stop() const noexcept;

  /// Whether there was a SIGINT that this one has seen.
  [[nodiscard]] bool was_interrupted() const noexcept;

 private:
  bool installed_ = false;
};

/// Lets Python's handler act on signals that came: throws what it raises, KeyboardInterrupt.
void raise_signals();

}  // namespace vandplan::python
