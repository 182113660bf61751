// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does an immutable value keep what was computed from it?
//
// Parts of the library that the value does not know keep their results beside it. Each result is
// computed once for all who share the value, and lives as long as the value.

#include <memory>
#include <mutex>
#include <typeindex>
#include <utility>
#include <vector>

namespace vandplan::base {

/// A list of immutable values of any type. May be used from several threads at once: a thread waits
/// while another one makes a value.
class Derived {
 public:
  /// The kept value of a type for which `fits(value)` holds. If there is none, keeps and returns
  /// the value of `make()`.
  template <typename Fits, typename Make>
  [[nodiscard]] std::shared_ptr<const void> find_or_make(std::type_index type, Fits fits,
                                                         Make make) {
    const std::lock_guard lock(mutex_);
    for (const auto& [kept_type, value] : values_) {
      if (kept_type == type && fits(value.get())) return value;
    }
    return values_.emplace_back(type, make()).second;
  }

 private:
  std::mutex mutex_;
  std::vector<std::pair<std::type_index, std::shared_ptr<const void>>> values_;
};

}  // namespace vandplan::base
