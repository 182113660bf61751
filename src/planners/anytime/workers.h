// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers make routes cheaper?
//
// Tasks and rules outlive the workers.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "planners/anytime/source.h"
#include "planners/anytime/worker.h"
#include "search/route.h"

namespace vandplan::anytime {

/// Takes routes from a source one by one, and shortens each as long as it may become the best.
/// `make` is called when the worker gets its first iterations or its first offer. Other workers may
/// make it needless before.
[[nodiscard]] std::unique_ptr<Worker> seeker(const Task& task, const search::CostRule& rule,
                                             std::uint64_t seed,
                                             std::function<std::unique_ptr<Source>()> make);

/// Shortens the best route, whoever found it.
[[nodiscard]] std::unique_ptr<Worker> refiner(const Task& task, const search::CostRule& rule,
                                              std::uint64_t seed);

/// Keeps the cheapest route by a measure of the whole drive, and makes it cheaper by random trials.
/// `rule`: prices like the measure, by which routes are found and steered. With a
/// `measure_of_drive` routes are bent, too.
[[nodiscard]] std::unique_ptr<Worker> cheapest_drive(
    const Task& task, const search::CostRule& rule, std::uint64_t seed,
    std::function<double(const search::Route&)> measure,
    const std::function<double(std::span<const Segment>)>& measure_of_drive = {});

}  // namespace vandplan::anytime
