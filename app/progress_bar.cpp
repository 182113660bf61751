// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "standard_streams.h"

namespace vandplan::app {
namespace {

constexpr int bar_width = 30;
constexpr double redraw_interval = 0.1;  // time between bars on a terminal [s]
constexpr double line_interval = 15.0;   // time between lines elsewhere [s]

std::string progress_text(const Progress& progress) {
  const int finished = progress.kept + progress.done;
  // Rounded down, so that 100 % means all runs.
  const int percent = static_cast<int>(100LL * finished / progress.total);
  return fmt::format("{:3} %  {} of {} runs, {} left", percent, finished, progress.total,
                     progress.done > 0 ? duration_text(progress.left()) : "?");
}

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) say("\n");
}

void ProgressBar::show(const Progress& progress) {
  if (finished_) return;
  finished_ = progress.kept + progress.done == progress.total;
  if (progress.elapsed < next_ && !finished_) return;
  next_ = progress.elapsed + (terminal_ ? redraw_interval : line_interval);
  if (!terminal_) {
    say(progress_text(progress) + "\n");
    return;
  }
  const int filled = bar_width * (progress.kept + progress.done) / progress.total;
  say(fmt::format("\r[{:#<{}}{:.<{}}] {}\033[K", "", filled, "", bar_width - filled,
                  progress_text(progress)));
  drawn_ = true;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace vandplan::app
