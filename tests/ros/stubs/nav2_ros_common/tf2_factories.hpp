// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Nav2: the names that our plugins use.

#include <memory>

namespace nav2 {
struct TransformBuffer {
  using SharedPtr = std::shared_ptr<TransformBuffer>;
};
}  // namespace nav2
