// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much worse is a drive whose strokes before and after gear changes are too short?

#include <span>

#include "vandplan/path.h"

namespace vandplan::commands {

/// Addition to the cost of a drive for strokes shorter than `least` [m]: more than any detour costs
/// [m or s].
[[nodiscard]] double price_of_lack(std::span<const Segment> segments, double least);

}  // namespace vandplan::commands
