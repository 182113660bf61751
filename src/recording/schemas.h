// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is in the messages of a recording?
//
// Schemas whose names begin with "foxglove." describe those parts of Foxglove's messages that we
// fill. The others are ours.

#include <string>

namespace vandplan::recording {

/// A kind of message.
struct Schema {
  std::string name;
  std::string text;  ///< the schema (JSON Schema)
};

/// All kinds of messages.
struct Schemas {
  Schema scene;
  Schema grid;
  Schema poses;
  Schema transform;
  Schema log;
  Schema motion;       ///< motion of the vehicle and its deviation from the plan, for plots
  Schema improvement;  ///< an improvement of the best path, for plots
};

[[nodiscard]] const Schemas& schemas();

}  // namespace vandplan::recording
