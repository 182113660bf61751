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
  /// The kept T for which `fits` holds; if there is none, the one that `make()` returns.
  template <typename T, typename Fits, typename Make>
  [[nodiscard]] std::shared_ptr<const T> find_or_make(Fits fits, Make make) const {
    const std::lock_guard lock(mutex_);
    for (const auto& [type, value] : values_) {
      if (type != typeid(T)) continue;
      auto found = std::static_pointer_cast<const T>(value);
      if (fits(*found)) return found;
    }
    std::shared_ptr<const T> made = make();
    values_.emplace_back(typeid(T), made);
    return made;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::vector<std::pair<std::type_index, std::shared_ptr<const void>>> values_;
};

}  // namespace vandplan::base
