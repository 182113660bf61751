// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What if the standard streams are closed, or broken?

#include <string_view>

namespace vandplan::app {

/// Opens /dev/null for each standard descriptor that is closed. Otherwise the next file that is
/// opened would get the number of the descriptor, and printed text would land in this file.
void open_standard_streams() noexcept;

/// Writes to standard error. Failures are ignored, because there is no place to report them.
void say(std::string_view text) noexcept;

}  // namespace vandplan::app
