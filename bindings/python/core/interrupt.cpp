// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/python/core/interrupt.h"

#include <pybind11/pybind11.h>
#include <signal.h>

#include <atomic>

namespace vandplan::python {
namespace {

// Asking for a stop changes atomic integers without a lock, as a signal handler may, as long as
// nobody has registered a callback.
std::stop_source stop_wanted{std::nostopstate};
static_assert(std::atomic<unsigned>::is_always_lock_free);
struct sigaction previous = {};
int depth = 0;  // Nested objects, since planners in Python may plan themselves.

extern "C" void note_interrupt(int signal) {
  stop_wanted.request_stop();
  previous.sa_handler(signal);
}

bool is_main_thread() {
  namespace py = pybind11;
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// Whether SIGINT has a plain handler function that can be called.
bool has_handler(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler != SIG_DFL &&
         action.sa_handler != SIG_IGN;
}

}  // namespace

Interruptible::Interruptible() {
  if (!is_main_thread()) return;
  installed_ = true;
  if (depth++ > 0) return;
  stop_wanted = std::stop_source();
  sigaction(SIGINT, nullptr, &previous);
  if (!has_handler(previous)) return;
  struct sigaction ours = previous;
  ours.sa_handler = note_interrupt;
  sigaction(SIGINT, &ours, nullptr);
}

Interruptible::~Interruptible() {
  if (!installed_ || --depth > 0) return;
  if (has_handler(previous)) sigaction(SIGINT, &previous, nullptr);
}

std::stop_token Interruptible::stop() const noexcept {
  return installed_ ? stop_wanted.get_token() : std::stop_token();
}

bool Interruptible::was_interrupted() const noexcept {
  return installed_ && stop_wanted.stop_requested();
}

void raise_signals() {
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

}  // namespace vandplan::python
