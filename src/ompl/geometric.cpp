// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/ompl.h"

#include <ompl/geometric/planners/informedtrees/bitstar/ImplicitGraph.h>
#include <ompl/geometric/planners/informedtrees/bitstar/Vertex.h>

#include <memory>

namespace vandplan::ompl {
namespace {

namespace og = ::ompl::geometric;

const ReedsSheppStateSpace* our_space(const ::ompl::base::SpaceInformation& si) {
  return dynamic_cast<const ReedsSheppStateSpace*>(si.getStateSpace().get());
}

// Access to the samples of BIT*. Its function that sets another nearest-neighbour structure cannot
// be called, as its definition is in a source file of OMPL. Explicit instantiations may name
// private members, so this one does.
template <auto Graph, auto Samples>
struct Reached {
  friend auto& samples_of(og::BITstar& planner) { return (*(planner.*Graph)).*Samples; }
};
auto& samples_of(og::BITstar& planner);
template struct Reached<&og::BITstar::graphPtr_, &og::BITstar::ImplicitGraph::samples_>;

template <typename T>
void find_by_length(std::shared_ptr<::ompl::NearestNeighbors<T>>& nodes) {
  if (!nodes) nodes = std::make_shared<NearestSetByLength<T>>();
}

}  // namespace

void PRM::setup() {
  const ReedsSheppStateSpace* const space = our_space(*si_);
  if (!nn_ && space != nullptr) {
    const auto state_of = [this](const Vertex& vertex) -> const ::ompl::base::State* {
      return stateProperty_[vertex];
    };
    nn_ = std::make_shared<NearestByLength<Vertex>>(space->turning_radius(), state_of);
    nn_->setDistanceFunction(
        [this](const Vertex& a, const Vertex& b) { return distanceFunction(a, b); });
  }
  og::PRM::setup();
}

void BITstar::setup() {
  if (our_space(*si_) != nullptr) find_by_length(samples_of(*this));
  og::BITstar::setup();
}

}  // namespace vandplan::ompl
