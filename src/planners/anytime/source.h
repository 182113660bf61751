// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do routes come from that nobody has shortened yet?

#include <cstddef>
#include <cstdint>

#include "search/route.h"

namespace vandplan::anytime {

/// A search for routes from the start to the goal.
class Source {
 public:
  virtual ~Source() = default;

  /// A few microseconds of work. True when a route was found: `route`.
  [[nodiscard]] virtual bool step() = 0;
  /// The route of the last step that found one, with its cost.
  [[nodiscard]] virtual search::Route route() const = 0;
  /// Whether another step may find anything.
  [[nodiscard]] virtual bool has_work() const { return true; }

  /// Routes that cost no less than `cost` are of no interest [m].
  virtual void set_cutoff(double /*cost*/) {}
  /// The best route of all workers, which has changed.
  virtual void set_route(const search::Route& /*best*/) {}
  /// A route that another worker gave up.
  virtual void offer(const search::Route& /*route*/) {}

  [[nodiscard]] virtual std::int64_t solves() const = 0;
  [[nodiscard]] virtual std::int64_t checks() const = 0;
  /// Nodes of the search that is under way.
  [[nodiscard]] virtual std::size_t size() const { return 0; }
};

}  // namespace vandplan::anytime
