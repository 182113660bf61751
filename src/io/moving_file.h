// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are moving obstacles read and written? (docs/formats.md)

#include <string>
#include <vector>

#include "io/document.h"
#include "vandplan/motion.h"

namespace vandplan::io {

/// Moving obstacles of the list under `moving:`. Throws InputError naming the wrong node.
[[nodiscard]] std::vector<MovingObstacle> moving_from(const Document& file, const Node& node);

/// The key `moving:` with its list, as lines of a scenario; empty if there are no obstacles.
[[nodiscard]] std::string moving_to_yaml(const std::vector<MovingObstacle>& moving);

}  // namespace vandplan::io
