// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Ctrl-C end a run cleanly?

#include <stop_token>

namespace vandplan::app {

/// Token that SIGINT and SIGTERM ask to stop from the first call on. A second signal ends the
/// program. Nobody may register a callback with the token.
[[nodiscard]] std::stop_token stop_on_signal();

}  // namespace vandplan::app
