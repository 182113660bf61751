// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace vandplan {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, threads, [&](std::size_t i) { ++calls.at(i); });
      EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](const auto& n) { return n == 1; }))
          << count << " indices, " << threads << " threads";
    }
  }
}

TEST(ParallelFor, RunsInOrderInTheCallersThreadWhenThereIsOne) {
  for (const int threads : {std::numeric_limits<int>::min(), 0, 1}) {
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<std::size_t> seen;
    parallel_for(100, threads, [&](std::size_t i) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      seen.push_back(i);
    });
    std::vector<std::size_t> expected(100);
    std::iota(expected.begin(), expected.end(), 0U);
    EXPECT_EQ(seen, expected) << threads << " threads";
  }
}

TEST(ParallelFor, ThrowsTheFirstExceptionAgain) {
  for (const int threads : {1, 4}) {
    std::atomic<int> calls = 0;
    const auto work = [&](std::size_t i) {
      ++calls;
      if (i == 3) throw std::runtime_error("the fourth");
    };
    try {
      parallel_for(100000, threads, work);
      ADD_FAILURE() << "nothing thrown with " << threads << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "the fourth");
    }
    EXPECT_GE(calls, 4);
    if (threads == 1) {
      EXPECT_EQ(calls, 4);
    }
  }
}

TEST(ParallelFor, WorksWithinItself) {
  std::atomic<int> calls = 0;
  parallel_for(4, 2, [&](std::size_t) { parallel_for(5, 3, [&](std::size_t) { ++calls; }); });
  EXPECT_EQ(calls, 20);
}

#ifdef VANDPLAN_THREADS

// Lets calls wait until enough of them run at the same time, or until it is plain that they do not.
class Meeting {
 public:
  // Whether `wanted` calls were in here together.
  bool join(int wanted) {
    std::unique_lock lock(mutex_);
    ++present_;
    changed_.notify_all();
    return changed_.wait_for(lock, std::chrono::seconds(20), [&] { return present_ >= wanted; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int present_ = 0;
};

TEST(ParallelFor, RunsAsManyAtATimeAsThereAreThreads) {
  Meeting meeting;
  parallel_for(3, 3, [&](std::size_t) { EXPECT_TRUE(meeting.join(3)); });
}

TEST(ParallelFor, StartsNoMoreThreadsThanItMay) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallel_for(100, 3, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_LE(threads.size(), 3U);
}

// One call throws while another is still at work: that one is waited for.
TEST(ParallelFor, ReturnsWhenAllCallsHaveReturned) {
  Meeting meeting;
  std::atomic<bool> is_slow_done = false;
  const auto work = [&](std::size_t i) {
    EXPECT_TRUE(meeting.join(2));
    if (i == 0) throw std::runtime_error("early");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    is_slow_done = true;
  };
  EXPECT_THROW(parallel_for(2, 2, work), std::runtime_error);
  EXPECT_TRUE(is_slow_done);
}

TEST(ParallelFor, BeginsNoCallAfterOneHasThrown) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 0) throw std::runtime_error("early");
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  };
  EXPECT_THROW(parallel_for(50000, 2, work), std::runtime_error);
  EXPECT_LT(calls, 50000);
}

#else

TEST(ParallelFor, StartsNoThreadWhenBuiltWithoutThem) {
  const std::thread::id caller = std::this_thread::get_id();
  parallel_for(100, 8, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

#endif

}  // namespace
}  // namespace vandplan
