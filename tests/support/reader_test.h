// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a reader say of a file that it refuses?

#include <gtest/gtest.h>

#include <string>

#include "support/temporary_folder.h"
#include "vandplan/input_error.h"

namespace vandplan {

/// The text with another part in place of `part`, which is in it.
inline std::string exchanged(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

class ReaderTest : public testing::Test {
 protected:
  /// The message of the InputError that `read` throws, without the name of the folder.
  template <typename Read>
  std::string message_of(Read read) {
    try {
      (void)read();
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::size_t at = text.find(folder_.path());
      return at == std::string::npos ? text : text.erase(at, folder_.path().size() + 1);
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

}  // namespace vandplan
