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
