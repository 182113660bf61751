// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the speeds and times of a path read and written? (docs/formats.md)

#include <nlohmann/json_fwd.hpp>

#include "io/document.h"
#include "vandplan/motion.h"

namespace vandplan::io {

/// Profile under `speeds:` of a result. Throws InputError naming the wrong node.
[[nodiscard]] SpeedProfile speeds_from(const Document& file, const Node& node);

/// JSON that `speeds_from` reads back exactly.
[[nodiscard]] nlohmann::ordered_json json_of(const SpeedProfile& speeds);

}  // namespace vandplan::io
