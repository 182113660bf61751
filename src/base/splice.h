// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a part of a sequence replaced?

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace vandplan::base {

/// Puts `fresh` in the place of the elements [first, last). `fresh` is no part of `values`.
template <class T>
void splice(std::vector<T>& values, std::size_t first, std::size_t last,
            std::span<const std::type_identity_t<T>> fresh) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(last);
  const std::size_t common = std::min(fresh.size(), last - first);
  const auto at = std::copy_n(fresh.begin(), common, begin);
  values.erase(at, end);
  values.insert(at, fresh.begin() + static_cast<std::ptrdiff_t>(common), fresh.end());
}

}  // namespace vandplan::base
