// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is what moves read and written? (docs/formats.md)

#include <string>
#include <vector>

#include "io/document.h"
#include "vandplan/moving.h"

namespace vandplan::io {

/// The list below `moving:`. Throws InputError naming the node that is wrong.
[[nodiscard]] std::vector<MovingObstacle> moving_from(const Document& file, const Node& node);

/// The key with its list, as lines of a scenario; empty if nothing moves.
[[nodiscard]] std::string moving_to_yaml(const std::vector<MovingObstacle>& moving);

}  // namespace vandplan::io
