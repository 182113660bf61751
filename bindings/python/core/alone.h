// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does an object that changes keep to one thread at a time?

#include <pybind11/pybind11.h>

#include <string>
#include <utility>

#include "vandplan/input_error.h"

namespace vandplan::python {

/// Lets one thread at a time work with an object. Guarded by Python's lock.
class Alone {
 public:
  /// `name` stands in errors.
  explicit Alone(std::string name) : name_(std::move(name)) {}

  /// Throws InputError if a thread is at work.
  void expect() const {
    if (is_busy_) throw InputError(name_, "is at work in another thread");
  }

  /// Runs `work` without Python's lock. Throws InputError if another thread is at work.
  template <typename Work>
  void run(Work work) {
    const Busy busy(*this);
    const pybind11::gil_scoped_release release;
    work();
  }

  /// Keeps others from the object. Throws InputError if another thread is at work.
  class Busy {
   public:
    explicit Busy(Alone& alone) : alone_(alone) {
      alone.expect();
      alone.is_busy_ = true;
    }
    ~Busy() { alone_.is_busy_ = false; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

   private:
    Alone& alone_;
  };

 private:
  std::string name_;
  bool is_busy_ = false;
};

}  // namespace vandplan::python
