// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which of OMPL's planners find their nearest nodes by exact length, without being told?

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include "vandplan/ompl_nearest.h"

namespace vandplan::ompl {

/// A planner of OMPL that uses `Nearest` where the space is our Reeds-Shepp space, and is
/// as it was over any other space.
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
    this->template setNearestNeighbors<Nearest>();  // which calls `setup`
  }

 private:
  bool by_length_ = false;
};

/// OMPL's PRM, which keeps the states of its nodes to itself, likewise.
class PRM : public ::ompl::geometric::PRM {
 public:
  using ::ompl::geometric::PRM::PRM;
  void setup() override;
};

/// OMPL's BIT*, which takes no other structure from outside, likewise.
class BITstar : public ::ompl::geometric::BITstar {
 public:
  using ::ompl::geometric::BITstar::BITstar;
  void setup() override;
};

}  // namespace vandplan::ompl

// With `namespace og = vandplan::ompl::geometric;` in place of `namespace og = ompl::geometric;`
// these planners of a program are ours and everything else of that name is OMPL's.
namespace vandplan::ompl::geometric {
using namespace ::ompl::geometric;
using ompl::BITstar;
using ompl::PRM;
using InformedRRTstar = ByLength<::ompl::geometric::InformedRRTstar, NearestSetByLength>;
using RRT = ByLength<::ompl::geometric::RRT>;
using RRTConnect = ByLength<::ompl::geometric::RRTConnect>;
using RRTstar = ByLength<::ompl::geometric::RRTstar, NearestSetByLength>;
}  // namespace vandplan::ompl::geometric
