// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What happens to a call that is cancelled?

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "ros/adapter/cancel_watch.h"
#include "ros/yard.h"
#include "support/cases.h"

namespace vandplan::ros {
namespace {

TEST(RosCancel, AWatchAsksUntilItHearsYes) {
  const CancelWatch never(nullptr);
  EXPECT_FALSE(never.token().stop_requested());
  const CancelWatch at_once([] { return true; });
  EXPECT_TRUE(at_once.token().stop_requested());
  std::atomic<int> asked = 0;
  {
    const CancelWatch third([&] { return ++asked == 3; });
    while (!third.token().stop_requested()) std::this_thread::yield();
  }
  EXPECT_EQ(asked, 3) << "nobody asks after a yes";
  {
    const CancelWatch unused([&] { return ++asked < 0; });
  }
  const int then = asked;
  EXPECT_GE(then, 4);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(asked, then) << "nor after the watch has ended";
}

TEST(RosCancel, ACallThatIsCancelledHasNoPath) {
  Planner planner;
  planner.take(walled_room().view());
  Request request = small_request(left, right);
  std::stop_source source;
  source.request_stop();
  request.stop = source.get_token();
  const Answer answer = planner.plan(request);
  EXPECT_EQ(answer.outcome, Outcome::cancelled);
  EXPECT_TRUE(answer.poses.empty());
  EXPECT_EQ(planner.world(), nullptr) << "not even a world is built";
}

// What changed on the costmap after a call was cancelled is in the world that the next call has.
TEST(RosCancel, AWorldThatIsBeingBuiltIsForTheNextCall) {
  const std::int32_t side = is_sanitized ? 1000 : 3000;
  OwnedCostmap yard(side, side, 0.1);  // a world takes far longer than the watch to say yes
  yard.fill({0, 120, side, 1}, nav2_lethal_cost);
  yard.fill({98, 0, 4, 80}, nav2_lethal_cost);
  Planner planner;
  planner.take(yard.view());
  Request request = small_request(left, right);
  std::atomic<int> asked = 0;
  const CancelWatch watch([&] { return ++asked > 5; });
  request.stop = watch.token();
  ASSERT_EQ(planner.plan(request).outcome, Outcome::cancelled);
  EXPECT_FALSE(planner.world()) << "nobody waits for it";
  yard.fill({98, 80, 4, 40}, nav2_lethal_cost);
  planner.take(yard.view());
  EXPECT_EQ(planner.plan(small_request(left, right, 100000)).outcome, Outcome::no_path);
}

// Cancelled while it improves a path that it already has.
TEST(RosCancel, APathIsNotWantedAnyMore) {
  Planner planner;
  planner.take(walled_room().view());
  Request request = small_request(left, right);
  ASSERT_EQ(planner.plan(request).outcome, Outcome::solved);
  request.options.budget = {.time_limit = 1000.0};
  std::atomic<int> asked = 0;
  const CancelWatch watch([&] { return ++asked > 5; });
  request.stop = watch.token();
  EXPECT_EQ(planner.plan(request).outcome, Outcome::cancelled);
  request = small_request(left, right, 0);
  EXPECT_EQ(planner.plan(request).outcome, Outcome::solved) << "the last whole path is kept";
}

// Storms of cancels: 1000 calls, each cancelled after a random time by another thread, while the
// costmap changes between them. Whatever is cancelled, the planner stays in order.
TEST(RosCancel, AStormOfCancelsLeavesThePlannerInOrder) {
  Rng rng(17);
  Planner planner;
  OwnedCostmap room = walled_room();
  room.fill({60, 60, 80, 60}, 100);
  room.fill({98, 0, 4, 80}, nav2_lethal_cost);
  planner.take(room.view());
  Request request = small_request(left, right);
  request.options.budget = {.time_limit = 1000.0};
  for (int i = 0; i < cases(1000); ++i) {
    room.at(5 + i % 50, 100) = static_cast<std::uint8_t>(i % 2 == 0 ? 254 : i % 253);
    planner.take(room.view());
    const std::chrono::duration<double> after(uniform(0, 1e-3, rng));
    std::stop_source source;
    std::jthread canceller([&] {
      std::this_thread::sleep_for(after);
      source.request_stop();
    });
    request.stop = source.get_token();
    request.viapoints.resize(i % 3 == 0 ? 1 : 0, {{5, 9, 1}, true});
    const Answer answer = planner.plan(request);
    ASSERT_EQ(answer.outcome, Outcome::cancelled) << answer.message;
  }
  EXPECT_EQ(planner.plan(small_request(left, right)).outcome, Outcome::solved);
}

}  // namespace
}  // namespace vandplan::ros
