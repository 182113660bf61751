// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What was made of a thing, and is kept as long as the thing itself?
//
// So an immutable value serves parts of the library that it knows nothing of: each keeps what it
// has computed, once for all who share the value.

#include <memory>
#include <mutex>
#include <typeindex>
#include <utility>
#include <vector>

namespace vandplan::base {

/// A list of immutable values of any type. May be used from several threads at once; who asks for
/// what is being made waits for it.
class Derived {
 public:
  /// The kept value of a type for which `fits(value)` holds; if there is none, the one that
  /// `make()` returns.
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
