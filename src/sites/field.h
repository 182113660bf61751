// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does it cost to drive to one goal from everywhere, and what changes when obstacles come and
// go?
//
// Method, and why a repaired field equals one that is made anew: docs/algorithms/site_tables.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "search/clearance_raster.h"
#include "sites/data.h"
#include "sites/ground_changes.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::sites {

/// Costs of driving to one goal, for all states of a grid: a label for each, made of arcs and lines
/// that are driven backwards from the goal. The label of a state is the cheapest of the free steps
/// that lead from labels of other states into its cell. So labels follow from the ground alone, not
/// from the order in which they were found.
class SiteField {
 public:
  /// A field without labels. The box is that of the grid, in the frame of the task's world. The
  /// goal is that of the task.
  SiteField(const SiteGrid& grid, const Bounds& box, const Task& task, const PlanOptions& options);

  /// Takes over the ground of a task with the same vehicle, goal and prices. Nothing but `changed`
  /// differs from the ground before. `spread` has to follow, and may have been cut short before.
  void renew(const Task& task, std::span<const GroundChange> changed);

  /// Finds all labels. False if it ended early because `is_over` said so; a later call goes on.
  [[nodiscard]] bool spread(const std::function<bool()>& is_over);

  /// Writes the numbers of the layer anew where labels have changed since the last call. `numbers`
  /// and `layer` are those of that call, or empty but for the layer's goal.
  void write(std::string& numbers, SiteLayer& layer);

 private:
  /// Number of a state: (pair * 2) + 1 if its step is driven in reverse as the field spreads.
  using Id = std::uint32_t;
  static constexpr Id none = 0xFFFFFFFF;
  static constexpr float infinite = std::numeric_limits<float>::infinity();

  /// How a state is reached, and with which pose.
  struct Label {
    float x, y;            // Pose that the state keeps, in the world's frame.
    float near;            // Cost that small clearance adds to a metre here.
    Id parent;             // State from which the step leads here; `none` at the goal.
    std::int16_t heading;  // Steps of a turn from the goal's heading.
    std::int8_t arc;       // Number of the arc of the step, left above 0; 0 straight.
    std::int8_t gear;      // Gear of the step, as the field spreads; 0 at the goal.
    bool is_sure;          // Whether the step needs no exact check.
    bool is_checked;       // Whether an exact check has found the step free.
  };
  enum class Status : std::uint8_t { open, settled, orphan };
  struct State {
    float cost = infinite;  // Cost of the label; infinite without one.
    Status status = Status::open;
  };
  /// Motion from one heading by an arc or a line.
  struct Step {
    float x, y;
    float length, cost;
    float sure;                           // Clearance above which it needs no exact check.
    std::int16_t left, right, low, high;  // Cells where it may begin, from the one where it ends.
    std::int16_t heading;                 // Heading at the end.
    std::int8_t arc, gear;
  };
  /// A label that a step offers to a state.
  struct Offer {
    Id state;
    float cost;
    Label label;
  };
  static constexpr int arcs = 2 * arcs_of_site + 1;

  void set_ground(const Task& task);
  void find_priced_cells(double longest, double reach);
  void make_steps();
  void reset();
  void root();
  [[nodiscard]] const Step& step_of(int heading, int gear, int arc) const noexcept;
  [[nodiscard]] std::span<const Step> steps_from(int heading) const noexcept;
  [[nodiscard]] LocalPose pose(const Label& label) const noexcept;
  [[nodiscard]] std::int64_t cell_of(float x, float y) const noexcept;
  [[nodiscard]] Id state_of(std::int64_t cell, int heading, int gear) const noexcept;
  [[nodiscard]] float near_at(float clearance) const noexcept;

  // Offers.
  [[nodiscard]] float cost_of(const Label& from, float cost, const Step& step) const noexcept;
  [[nodiscard]] bool is_worth(Id state, float cost) const noexcept;
  [[nodiscard]] bool is_beaten(Id state, float cost, Id twin) const noexcept;
  [[nodiscard]] bool is_better(const Offer& offer) const noexcept;
  [[nodiscard]] float surcharge(const Label& from, const Label& to) const;
  [[nodiscard]] bool look_at(Offer& offer) const;
  [[nodiscard]] bool is_free(const Label& label) const;
  /// Whether a pose with enough clearance is free.
  [[nodiscard]] bool is_trusted() const { return raster_->is_trusted() && !raster_->has_rules(); }
  void pull(Id state);
  void pull_from(Id from, const Step& step, Id state);
  void take(const Offer& offer);

  // Dijkstra's algorithm, by buckets that no step stays in.
  [[nodiscard]] std::size_t bucket_of(float cost) const noexcept;
  void push(Id state, float cost);
  void confirm(Id state);
  [[nodiscard]] bool is_ripe(Id state) const noexcept;
  void settle(Id state);
  void expand(Id state);

  // Changes.
  void withdraw(Id state);
  void clear(Id state);
  void find_children(Id state, float cost);
  void orphan(Id state, float cost);
  [[nodiscard]] bool still_holds(Id state, const Bounds& changed);
  [[nodiscard]] double swing(double length) const;
  [[nodiscard]] bool has_label_near(Id state, const Bounds& box, double distance) const;
  [[nodiscard]] bool is_near(const Label& label, const Bounds& box, double ahead,
                             double aside) const;
  template <typename Visit>
  void for_states_near(const Bounds& box, double distance, Visit visit) const;
  void mark(Id state) noexcept { changed_words_[state / 2 / pairs_of_word] = 1; }
  [[nodiscard]] SiteRecord record(Id state) const;

  SiteGrid grid_;
  Bounds box_;
  Task task_;
  PlanOptions options_;
  search::CostRule rule_;
  std::unique_ptr<search::ClearanceRaster> raster_;
  std::vector<bool> priced_;  // of each cell: whether a step from there may meet ground at a price
  double turn_;               // between two headings [rad]
  double largest_;            // largest clearance that matters [m]
  float x_min_, y_min_, x_end_, y_end_, cells_of_metre_, buckets_of_metre_, most_;
  float gear_change_, turning_, clearance_weight_, clearances_of_metre_;
  std::vector<Step> steps_;
  std::vector<float> cos_, sin_;
  std::vector<double> headings_;

  Id root_ = none;  // state of the goal
  std::vector<State> states_;
  std::unique_ptr<Label[]> labels_;       // NOLINT(modernize-avoid-c-arrays): left uninitialised
  std::vector<std::vector<Id>> buckets_;  // states to look at, by cost
  std::size_t front_ = 0;
  std::vector<Id> withdrawn_;                // buffer
  std::vector<std::uint8_t> changed_words_;  // 64 pairs each, since they were written
};

}  // namespace vandplan::sites
