// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/input_error.h"

#include <algorithm>

namespace vandplan {
namespace {

/// The text with control characters replaced: whatever a file name or a quoted value holds, a
/// message stays one line.
std::string one_line(std::string text) {
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < ' ' || byte == 127;
  };
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return text;
}

}  // namespace

InputError::InputError(const std::string& where, const std::string& problem)
    : std::runtime_error(one_line(where + ": " + problem)),
      where_(one_line(where)),
      problem_(one_line(problem)) {}

}  // namespace vandplan
