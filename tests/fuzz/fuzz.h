// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does every fuzz target do with its bytes?
//
// A target is a function of bytes that must return: with a value, or with an InputError of one
// line. Everything else is a fault: another exception, a signal, a sanitizer's word, a promise that
// does not hold.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/temporary_folder.h"
#include "vandplan/input_error.h"

namespace vandplan::fuzz {

/// Ends the process, as a fault does, unless the promise holds.
inline void expect(bool holds, const std::string& promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise.c_str());
  std::abort();
}

/// Calls what may refuse its input, in one line.
template <typename Call>
void may_refuse(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    const std::string line = error.what();
    expect(line.find('\n') == std::string::npos, "an error is one line: " + line);
  }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Where files lie that readers are given; on a disk that is none, if TMPDIR says so.
inline const TemporaryFolder& folder() {
  static const TemporaryFolder folder;
  return folder;
}

}  // namespace vandplan::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
