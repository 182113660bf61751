// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Ctrl-C end a run?
//
// Python's own signal handler notes the signal, and Python reacts when the run is over. The handler
// here calls Python's handler, and also ends the run.

#include <stop_token>

namespace vandplan::python {

/// While an object lives in Python's main thread, SIGINT also asks `stop()` to stop. In other
/// threads, which get no signals from Python, it does nothing.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Token that SIGINT asks to stop; one that nobody asks in other threads. Nobody may register a
  /// callback with it.
  [[nodiscard]] std::stop_token stop() const noexcept;

  /// Whether SIGINT came while this object lived.
  [[nodiscard]] bool was_interrupted() const noexcept;

 private:
  bool installed_ = false;
};

/// Lets Python's handler react to signals. Throws what it raises, KeyboardInterrupt.
void raise_signals();

}  // namespace vandplan::python
