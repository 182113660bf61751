// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Ctrl-C end a run cleanly?

#include <atomic>

namespace vandplan::app {

/// From the first call on, SIGINT and SIGTERM set this to true; a second signal kills.
[[nodiscard]] const std::atomic<bool>* stop_on_signal();

}  // namespace vandplan::app
