// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do programs that plan with OMPL use this library? docs/ompl.md

#include <ompl/base/SpaceInformation.h>
#include <ompl/datastructures/NearestNeighbors.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Exception.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "vandplan/ompl_spaces.h"
#include "vandplan/tables.h"

namespace vandplan::ompl {

// ---- How do OMPL's planners find the nearest nodes by exact Reeds-Shepp length? ----
//
//   planner->setNearestNeighbors<vandplan::ompl::NearestByLength>();
//
// This works for planners whose nodes lead to their states: RRT, RRTConnect, RRTstar and most
// others. The planners below do it by themselves.

/// Node types of planners that lead to a state, wherever the planner keeps it.
template <typename T>
concept HasState = requires(const T& node) {
  node->state;
}
|| requires(const T& node) { node->state(); }
|| requires(const T& node) { node->getState(); }
|| requires(const T& node) { node->state_; };

/// The state of a planner's node.
template <HasState T>
[[nodiscard]] const ::ompl::base::State* state_of(const T& node) {
  if constexpr (requires { node->getState(); }) {
    return node->getState();
  } else if constexpr (requires { node->state(); }) {
    return node->state();
  } else if constexpr (requires { node->state; }) {
    return node->state;
  } else {
    return node->state_;
  }
}

/// Nodes of an OMPL planner, found exactly by Reeds-Shepp length; ties go to the older node.
/// Queries may run in many threads at once.
template <typename T>
class NearestByLength : public ::ompl::NearestNeighbors<T> {
 public:
  using StateOf = std::function<const ::ompl::base::State*(const T&)>;

  /// Learns the turning radius from the distance function that the planner sets, which must be that
  /// of our Reeds-Shepp space. Otherwise the first node throws ompl::Exception.
  NearestByLength() requires HasState<T> : state_of_(ompl::state_of<T>) {}

  /// Nodes of any kind for a turning radius > 0 [m]; `state_of` returns the state of a node. The
  /// distance function is not used. Throws InputError naming "radius" for another radius.
  NearestByLength(double turning_radius, StateOf state_of)
      : radius_(turning_radius),
        state_of_(std::move(state_of)),
        nodes_(std::in_place, turning_radius) {}

  [[nodiscard]] bool reportsSortedResults() const override { return is_sorted_; }

  void clear() override {
    data_.clear();
    if (nodes_) nodes_.emplace(radius_);
  }

  using ::ompl::NearestNeighbors<T>::add;
  void add(const T& data) override {
    if (!nodes_) {
      radius_ = learned_radius(data);
      nodes_.emplace(radius_);
    }
    nodes_->add(pose(data));
    data_.emplace_back(data);
  }

  /// Removes the youngest equal node whose state has not changed since it was added; false without
  /// one.
  bool remove(const T& data) override {
    if (size() == 0) return false;
    const std::vector<NearNode> there = nodes_->nearest(pose(data), {.within = 0.0});
    const auto found = std::find_if(there.rbegin(), there.rend(),
                                    [&](const NearNode& near) { return at(near.node) == data; });
    if (found == there.rend()) return false;
    nodes_->remove(found->node);
    data_[static_cast<std::size_t>(found->node)].reset();
    if (data_.size() > 64 && data_.size() > 2 * size()) close_up();
    return true;
  }

  T nearest(const T& data) const override {
    if (size() == 0) {
      throw ::ompl::Exception("No elements found in nearest neighbors data structure");
    }
    return at(nodes_->nearest(pose(data))->node);
  }

  void nearestK(const T& data, std::size_t k, std::vector<T>& found) const override {
    find(data, {.count = k}, found);
  }

  void nearestR(const T& data, double radius, std::vector<T>& found) const override {
    find(data, {.within = radius}, found);
  }

  [[nodiscard]] std::size_t size() const override { return nodes_ ? nodes_->size() : 0; }

  void list(std::vector<T>& data) const override {
    data.clear();
    for (const std::optional<T>& one : data_) {
      if (one) data.push_back(*one);
    }
  }

 protected:
  /// Lets `nearestK` and `nearestR` return nodes in any order from now on.
  void leave_unsorted() { is_sorted_ = false; }

 private:
  [[nodiscard]] Pose pose(const T& data) const { return pose_of(state_of_(data)); }
  [[nodiscard]] const T& at(std::int32_t node) const {
    return *data_[static_cast<std::size_t>(node)];
  }

  double learned_radius(const T& data) const {
    const auto* const space = space_behind([&] { (void)this->distFun_(data, data); });
    if (space == nullptr) {
      throw ::ompl::Exception("NearestByLength", "needs a vandplan::ompl::ReedsSheppStateSpace");
    }
    return space->turning_radius();
  }

  void find(const T& data, const NearWanted& wanted, std::vector<T>& found) const {
    found.clear();
    if (size() == 0) return;
    if (!is_sorted_) {
      for (const std::int32_t node : nodes_->nearest_in_any_order(pose(data), wanted)) {
        found.push_back(at(node));
      }
      return;
    }
    for (const NearNode& near : nodes_->nearest(pose(data), wanted)) found.push_back(at(near.node));
  }

  /// Drops the numbers of removed nodes.
  void close_up() {
    std::erase(data_, std::nullopt);
    nodes_.emplace(radius_);
    for (const std::optional<T>& one : data_) nodes_->add(pose(*one));
  }

  double radius_ = 0.0;  // turning radius [m]
  bool is_sorted_ = true;
  StateOf state_of_;
  std::optional<NearestNodes> nodes_ = {};
  std::vector<std::optional<T>> data_ = {};  // nodes by their number; none once removed
};

/// Finds the nodes that `NearestByLength` finds, in any order. It is faster, and enough for
/// planners that look at all of the found nodes, such as RRT*.
template <typename T>
class NearestSetByLength : public NearestByLength<T> {
 public:
  NearestSetByLength() requires HasState<T> { this->leave_unsorted(); }
};

// ---- Which of OMPL's planners find their nearest nodes by exact length, without being told? ----

/// A planner of OMPL that uses `Nearest` over our Reeds-Shepp space. Over any other space it is
/// unchanged.
template <typename Base, template <typename> class Nearest = NearestByLength>
class ByLength : public Base {
 public:
  using Base::Base;

  void setup() override {
    const bool is_ours =
        dynamic_cast<const ReedsSheppStateSpace*>(this->si_->getStateSpace().get()) != nullptr;
    if (!is_ours || by_length_) {
      Base::setup();
      return;
    }
    by_length_ = true;
    // This function calls `setup` again.
    this->template setNearestNeighbors<Nearest>();
  }

 private:
  bool by_length_ = false;
};

/// OMPL's PRM with nearest nodes by exact length over our Reeds-Shepp space. It hides the states of
/// its nodes, so `ByLength` does not fit.
class PRM : public ::ompl::geometric::PRM {
 public:
  using ::ompl::geometric::PRM::PRM;
  void setup() override;
};

/// OMPL's BIT* with nearest nodes by exact length over our Reeds-Shepp space. It takes no other
/// structure from outside, so `ByLength` does not fit.
class BITstar : public ::ompl::geometric::BITstar {
 public:
  using ::ompl::geometric::BITstar::BITstar;
  void setup() override;
};

}  // namespace vandplan::ompl

// With `namespace og = vandplan::ompl::geometric;` in place of `namespace og = ompl::geometric;`
// these planners of a program are ours, and every other name is OMPL's.
namespace vandplan::ompl::geometric {
using namespace ::ompl::geometric;
using ompl::BITstar;
using ompl::PRM;
using InformedRRTstar = ByLength<::ompl::geometric::InformedRRTstar, NearestSetByLength>;
using RRT = ByLength<::ompl::geometric::RRT>;
using RRTConnect = ByLength<::ompl::geometric::RRTConnect>;
using RRTstar = ByLength<::ompl::geometric::RRTstar, NearestSetByLength>;
}  // namespace vandplan::ompl::geometric
