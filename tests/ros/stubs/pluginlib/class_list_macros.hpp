// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for pluginlib: a class is of its base, and can be made.

#include <memory>
#include <type_traits>

#define PLUGINLIB_EXPORT_CLASS(Class, Base)                                   \
  static_assert(std::is_base_of_v<Base, Class>, "a plugin has another base"); \
  static_assert(std::is_default_constructible_v<Class>, "a plugin cannot be made");
