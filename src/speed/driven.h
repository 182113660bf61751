// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far has a vehicle driven at a time?

#include "vandplan/motion.h"

namespace vandplan::speed {

/// Driven distance at time `t` [m]; `t` is clamped to the drive.
[[nodiscard]] double driven_at(const SpeedProfile& profile, double t) noexcept;

}  // namespace vandplan::speed
