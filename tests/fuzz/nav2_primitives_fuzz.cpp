// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as primitives of Nav2.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = fuzz::folder().put("p.json", fuzz::text_of(data, size));
  fuzz::may_refuse([&] { (void)read_primitives(file); });
  return 0;
}
