// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much worse is a drive whose strokes before and after gear changes are too short?

#include <span>

#include "vandplan/path.h"

namespace vandplan::commands {

/// What strokes shorter than `least` add to the cost of a drive [m or s]: more than any detour.
[[nodiscard]] double price_of_lack(std::span<const Segment> segments, double least);

}  // namespace vandplan::commands
