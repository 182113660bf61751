// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/input_error.h"
#include "vandplan/replanner.h"

namespace vandplan {

std::string_view name_of(TickOutcome outcome) noexcept {
  switch (outcome) {
    case TickOutcome::kept:
      return "kept";
    case TickOutcome::new_times:
      return "new_times";
    case TickOutcome::new_way:
      return "new_way";
    case TickOutcome::stop:
      return "stop";
    case TickOutcome::none:
      break;
  }
  return "none";
}

Action action_at(const ReplanAnswer& answer, const Vehicle& vehicle, double t) {
  if (!answer.drive) throw InputError("answer", "holds no drive, expected that of a tick");
  const Motion motion =
      motion_at(answer.drive->path, vehicle, answer.drive->speeds, t - answer.begin);
  return {t, motion.steering_angle, motion.v, motion.a};
}

}  // namespace vandplan
