// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a drive get cheaper without leaving its surroundings?
//
// Method: docs/algorithms/trailers.md.

#include <functional>
#include <span>
#include <vector>

#include "planners/commands/closer.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::commands {

/// Improves one drive by trials: a first sweep, then random ones. A trial is kept only if it is
/// free, cheaper and has no more crumbs.
class DriveShortener {
 public:
  /// Cost of a drive by another measure than a rule.
  using Measure = std::function<double(std::span<const Segment>)>;

  /// The task and the rule outlive the shortener. The commands are a free drive from the start of
  /// the task to its goal.
  DriveShortener(const Task& task, const search::CostRule& rule, std::span<const Command> commands,
                 std::uint64_t seed, Measure measure = {});

  /// One trial. True when the drive got cheaper.
  bool step();

  /// Leaves crumbs out or joins them with the command before, where other commands make up for
  /// that. All changes together cost at most 1e-4 (relative).
  void drop_crumbs();

  [[nodiscard]] double cost() const { return cost_; }
  [[nodiscard]] std::int64_t trials() const { return trials_; }
  [[nodiscard]] const std::vector<Command>& commands() const { return commands_; }
  /// The segments of the drive, which ends at the goal.
  [[nodiscard]] std::vector<Segment> segments() const {
    return merged(wheels_.driven(commands_, ends_.before));
  }
  /// Whether many trials in a row brought almost nothing.
  [[nodiscard]] bool is_stalled() const;
  [[nodiscard]] std::int64_t checks() const { return checks_; }

 private:
  /// Commands that a trial replaces.
  struct Window {
    std::size_t first, last;  // the commands [first, last)
  };
  /// States, gears and costs along a chain of commands.
  struct Driving {
    std::vector<State> states;           // states before each command, and at the end
    std::vector<search::Driven> driven;  // gears and curvatures before each command, and at the end
    std::vector<double> prices;          // cost of each command without clearance
    std::vector<double> near;            // clearance cost of each command
  };

  [[nodiscard]] bool sweeps() const;
  bool sweep();
  bool try_anything();
  [[nodiscard]] Window any_window();
  [[nodiscard]] double any_size();
  void shake(const Window& window);
  void leave_out(const Window& window);
  void split(const Window& window);
  [[nodiscard]] double near_cost(const State& from, std::span<const Segment> segments,
                                 double cutoff) const;
  [[nodiscard]] bool closes(const Window& window);
  bool try_trial(const Window& window, double limit);
  void price_trial(const Window& window);
  [[nodiscard]] double left_for_near(const Window& window, double limit) const;
  [[nodiscard]] bool looks_at_near(const Window& window, double left);
  bool replace(const Window& window, double limit);
  bool settle(std::vector<Command> whole, std::vector<double> near, double limit);
  [[nodiscard]] std::span<const Command> in(const Window& window) const {
    return std::span(commands_).subspan(window.first, window.last - window.first);
  }
  [[nodiscard]] int more_crumbs(const Window& window) const;
  [[nodiscard]] bool drop(std::size_t i, double limit);
  void drive(std::vector<double> near);

  const Task& task_;
  const search::CostRule& rule_;
  Measure measure_;
  Wheels wheels_;
  search::DrivenBeside ends_;
  Closer closer_;
  double crumb_;
  std::vector<Command> commands_;
  Driving driving_;
  double cost_ = 0.0;
  std::vector<Command> trial_;            // commands in the place of a window
  Driving tried_;                         // states, gears and costs along the trial
  std::vector<Segment> segments_;         // segments of the trial
  std::vector<std::size_t> segments_at_;  // number of segments of each command of the trial
  /// Whether the command behind the trial drives the same segments as before.
  bool goes_on_ = true;
  /// Cost of the command behind the trial.
  double next_price_ = 0.0;
  std::size_t swept_ = 0;    // index of the next command that a sweep leaves out
  std::size_t in_vain_ = 0;  // commands left out in vain since the last gain of the sweep
  Rng rng_;
  double size_ = 0.1;  // relative size of what a trial changes
  std::int64_t trials_ = 0;
  int idle_ = 0;                // trials since the last progress
  double progress_cost_ = 0.0;  // cost at the last progress
  std::int64_t checks_ = 0;
};

}  // namespace vandplan::commands
