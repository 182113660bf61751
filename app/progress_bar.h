// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far has the work come, and how long will it take?

#include <string>

#include "vandplan/evaluation.h"

namespace vandplan::app {

using evaluation::Progress;

/// Shows progress on standard error: a bar that is redrawn on a terminal, a line every 15 s
/// elsewhere.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress);

 private:
  bool terminal_;
  bool drawn_ = false;
  bool finished_ = false;  // whether the end was shown
  double next_ = 0.0;      // elapsed time of the next output [s]
};

/// A duration as text, such as "2 min 05 s".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace vandplan::app
