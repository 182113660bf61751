// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do routes come from that nobody has shortened yet?

#include <cstdint>

#include "planners/anytime/worker.h"
#include "search/route.h"

namespace vandplan::anytime {

/// A search for routes from the start to the goal.
class Source {
 public:
  virtual ~Source() = default;

  /// Works for a few microseconds. True when a route was found: `route`.
  [[nodiscard]] virtual bool step() = 0;
  /// The route of the last step that found one, with its cost.
  [[nodiscard]] virtual search::Route route() const = 0;
  /// Whether another step may find anything.
  [[nodiscard]] virtual bool has_work() const { return true; }
  /// Number of searches begun, or of passes done.
  [[nodiscard]] virtual std::int64_t stage() const { return 0; }

  /// Ignores routes that do not cost less than `cost` from now on [m].
  virtual void set_cutoff(double /*cost*/) {}
  /// Tells the source of the best route of all workers, which has changed.
  virtual void set_route(const search::Route& /*best*/) {}
  /// Tells the source of a route that another worker gave up.
  virtual void offer(const search::Route& /*route*/) {}

  [[nodiscard]] virtual Counts counts() const { return {}; }
};

}  // namespace vandplan::anytime
