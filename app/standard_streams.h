// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What if the standard streams are closed, or broken?

#include <string_view>

namespace vandplan::app {

/// Opens those of the three standard descriptors that are closed on /dev/null: else the next file
/// that is opened would get their number, and what is printed would land in it.
void open_standard_streams() noexcept;

/// Writes to standard error as far as that is possible: where to complain of it otherwise?
void say(std::string_view text) noexcept;

}  // namespace vandplan::app
