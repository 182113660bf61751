// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do several threads share work?

#include <cstddef>
#include <functional>

namespace vandplan {

/// Calls `work(i)` once for every i below `count` and returns when all calls have returned. At most
/// `threads` calls run at the same time, the caller's thread among them; the others are started
/// here and joined before the return. Calls begin in the order of i. With one thread, one index or
/// a library built without threads every call runs in the caller's thread. After a call has
/// thrown, no further one begins, and the first exception is thrown again here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// Calls `work(i)` like `parallel_for`, and `then(i)` once for each i when `work(i)` has returned.
/// Calls of `then` run one at a time, in the order of i. After a call of either has thrown, no
/// further `then` begins.
void parallel_in_order(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                       const std::function<void(std::size_t)>& then);

}  // namespace vandplan
