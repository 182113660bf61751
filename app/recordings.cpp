// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recordings.h"

#include "endings.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::app {
namespace {

constexpr const char* record_flag = "--record";

}  // namespace

void add_record(CLI::App& command, std::optional<std::string>& file, const std::string& about) {
  command.add_option(record_flag, file, about)->type_name("FILE");
}

void expect_recording(const std::string& file) {
  if (file == "-") throw InputError(record_flag, "is -, expected a file");
  expect_ending(file, {"a recording is MCAP", {".mcap"}});
  expect_writable(file);
}

}  // namespace vandplan::app
