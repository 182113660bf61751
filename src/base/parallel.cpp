// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/parallel.h"

#include <mutex>
#include <vector>

#ifdef VANDPLAN_THREADS

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace vandplan {
namespace {

// State that the threads of one call share.
class Sharing {
 public:
  Sharing(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work) {}

  // Takes one index after the other until none is left. Throws nothing.
  void take() {
    try {
      for (std::size_t i = next_++; i < count_; i = next_++) work_(i);
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  [[nodiscard]] std::exception_ptr failure() const { return failure_; }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;  // guarded by the mutex until all threads are joined
};

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  Sharing sharing(count, work);
  {
    const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(threads, 1)), count);
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back([&] { sharing.take(); });
    sharing.take();
  }
  if (sharing.failure()) std::rethrow_exception(sharing.failure());
}

}  // namespace vandplan

#else

namespace vandplan {

void parallel_for(std::size_t count, int /*threads*/,
                  const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace vandplan

#endif

namespace vandplan {

void parallel_in_order(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                       const std::function<void(std::size_t)>& then) {
  std::mutex mutex;
  std::vector<bool> waits(count);  // work is done; `then` waits for indices before it
  std::size_t next = 0;
  parallel_for(count, threads, [&](std::size_t i) {
    work(i);
    const std::lock_guard lock(mutex);
    waits[i] = true;
    for (; next < count && waits[next]; ++next) {
      waits[next] = false;  // if the call throws, no further `then` begins
      then(next);
    }
  });
}

}  // namespace vandplan
