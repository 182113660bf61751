// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Tries many nasty worlds, as many as somebody has time for.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "nasty/trial.h"

namespace {

using vandplan::nasty::Trial;

constexpr const char* usage =
    "usage: nasty_worlds [--patient | --rigs | --goals | --zones | --movers] FROM COUNT [JOBS]\n"
    "       nasty_worlds --save SEED FOLDER\n\n"
    "Tries the worlds FROM to FROM + COUNT - 1, JOBS at a time (1), and prints a line for each "
    "broken\n"
    "promise with the number that repeats it; exit status 1 if there is one. --rigs: "
    "with a\n"
    "trailer; --goals: to sets of goals; --zones: with zones and masks; --movers: with moving "
    "obstacles;\n"
    "--patient: with 25 times the iterations. --save writes a world as a scenario file.\n";

/// What all trials brought.
struct Total {
  std::uint64_t worlds = 0, refused = 0, paths = 0, faults = 0;
  std::uint64_t slowest = 0;
  double slowest_time = 0;  // [s]
};

using Try = Trial (*)(std::uint64_t seed);

void add(Total& total, std::uint64_t seed, const Trial& trial, double time) {
  ++total.worlds;
  total.refused += trial.refused;
  total.paths += static_cast<std::uint64_t>(trial.paths);
  total.faults += trial.faults.size();
  if (time > total.slowest_time) {
    total.slowest_time = time;
    total.slowest = seed;
  }
  for (const std::string& fault : trial.faults) {
    std::printf("%s    (world %llu)\n", fault.c_str(), static_cast<unsigned long long>(seed));
  }
  std::fflush(stdout);
}

Total try_all(Try one, std::uint64_t from, std::uint64_t count, unsigned jobs) {
  Total total;
  std::mutex mutex;
  std::atomic<std::uint64_t> next = 0;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < count; i = next++) {
      const auto begin = std::chrono::steady_clock::now();
      const Trial trial = one(from + i);
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
      const std::lock_guard lock(mutex);
      add(total, from + i, trial, time.count());
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < jobs; ++i) threads.emplace_back(work);
  threads.clear();
  return total;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "--save") {
    const std::uint64_t seed = std::strtoull(words[1].c_str(), nullptr, 10);
    std::puts(vandplan::nasty::save_world(seed, words[2]).c_str());
    return 0;
  }
  Try one = vandplan::nasty::try_world;
  constexpr std::pair<const char*, Try> kinds[] = {
      {"--rigs", vandplan::nasty::try_world_of_a_rig},
      {"--goals", vandplan::nasty::try_world_of_goals},
      {"--zones", vandplan::nasty::try_world_of_zones},
      {"--movers", vandplan::nasty::try_world_of_movers},
      {"--patient", vandplan::nasty::try_world_patiently}};
  for (const auto& [flag, try_kind] : kinds) {
    if (words.empty() || words[0] != flag) continue;
    one = try_kind;
    words.erase(words.begin());
    break;
  }
  if (words.size() < 2 || words.size() > 3) {
    std::fputs(usage, stderr);
    return 2;
  }
  const auto number = [&](std::size_t i) { return std::strtoull(words[i].c_str(), nullptr, 10); };
  const auto jobs = words.size() > 2 ? std::max(1U, static_cast<unsigned>(number(2))) : 1U;
  const Total total = try_all(one, number(0), number(1), jobs);
  std::printf(
      "%llu worlds, %llu of them refused; %llu paths; %llu faults; slowest: %llu, %.3f s\n",
      static_cast<unsigned long long>(total.worlds), static_cast<unsigned long long>(total.refused),
      static_cast<unsigned long long>(total.paths), static_cast<unsigned long long>(total.faults),
      static_cast<unsigned long long>(total.slowest), total.slowest_time);
  return total.faults == 0 ? 0 : 1;
}
