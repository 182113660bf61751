// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Ctrl-C end a run cleanly?

#include <atomic>

namespace vandplan::app {

/// Flag that SIGINT and SIGTERM set to true from the first call on. A second signal ends the
/// program.
[[nodiscard]] const std::atomic<bool>* stop_on_signal();

}  // namespace vandplan::app
