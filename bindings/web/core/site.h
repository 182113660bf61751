// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do tables of a site become values of JavaScript, and back?
//
// In JavaScript a table is the bytes of its file, a Uint8Array, which can be sent to other threads.

#include <memory>
#include <vector>

#include "bindings/web/core/values.h"
#include "vandplan/site_table.h"

namespace vandplan::web {

/// Key of the table among the options of a plan, and in errors.
inline constexpr const char* site_key = "site";

/// Reads tables, and keeps the last one.
class SiteReader {
 public:
  /// Table from the bytes of its file; the same array as before is not read again. Throws
  /// InputError naming "site".
  [[nodiscard]] std::shared_ptr<const SiteTable> read(const val& bytes);

 private:
  val bytes_ = val::undefined();  // of the last table
  std::shared_ptr<const SiteTable> table_ = {};
};

/// What is wanted of a table.
struct SiteWish {
  std::vector<Pose> goals;
  SiteTableOptions options;
};

/// Wish from {goals, headings, cell}. Without `goals` the table has the problem's goal, or the free
/// poses of its set. `progress` is a function, or undefined; it is called by reference.
[[nodiscard]] SiteWish site_wish_from(const val& query, const Problem& problem,
                                      const PlanOptions& options, const val& progress);

/// Copy of a table's bytes.
[[nodiscard]] val bytes_of(const SiteTable& table);

/// Object {goals, bounds, cell, headings}.
[[nodiscard]] val object_of(const SiteTable& table);

/// Cost from each pose of {x, y, heading} to a goal [m], infinite without a way. If the headings
/// are missing, each cost is the least of all headings.
[[nodiscard]] val costs_of(const SiteTable& table, const val& poses, double goal);

}  // namespace vandplan::web
