// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>

#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

constexpr std::size_t plenty = 1 << 20;

using Names = std::vector<std::string>;

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(File, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  std::string content("a\0\n\xFF", 4);
  content += std::string(300'000, 'x');
  write_file(folder.file("f"), content);
  EXPECT_EQ(read_file(folder.file("f"), plenty), content);
  write_file(folder.file("f"), "");
  EXPECT_EQ(read_file(folder.file("f"), plenty), "");
  EXPECT_EQ(folder.names(), Names{"f"});
}

TEST(File, WritingKeepsModeAndSymbolicLink) {
  const TemporaryFolder folder;
  write_file(folder.file("f"), "old");
  ASSERT_EQ(::chmod(folder.file("f").c_str(), 0640), 0);
  std::filesystem::create_symlink("f", folder.file("link"));
  write_file(folder.file("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(read_file(folder.file("f"), plenty), "new");
  struct stat status {};
  ASSERT_EQ(::stat(folder.file("f").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(File, ALinkToNothingSaysWhereToMakeTheFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("d"));
  std::filesystem::create_symlink("second", folder.file("first"));
  std::filesystem::create_symlink("d/f", folder.file("second"));
  write_file(folder.file("first"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("first")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("second")));
  EXPECT_EQ(read_file(folder.file("d/f"), plenty), "new");
}

TEST(File, ALinkThatLeadsNowhereIsLeftAlone) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("none/f", folder.file("astray"));
  std::filesystem::create_symlink("circle", folder.file("circle"));
  const auto message = [&](const std::string& file) {
    return message_of([&] { write_file(file, "new"); });
  };
  EXPECT_EQ(message(folder.file("astray")),
            folder.file("astray") + ": cannot write: No such file or directory");
  EXPECT_EQ(message(folder.file("circle")),
            folder.file("circle") + ": cannot write: Too many levels of symbolic links");
  EXPECT_EQ(folder.names().size(), 2U);
}

TEST(File, ANewFileHasTheUsersMode) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_file(folder.file("f"), "new");
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat(folder.file("f").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(File, ADiskThatFillsUpLeavesTheOldFileAndNoOther) {
  const TemporaryFolder folder;
  write_file(folder.file("f"), "old");
  struct rlimit limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = 1000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message =
      message_of([&] { write_file(folder.file("f"), std::string(5000, 'x')); });
  limit.rlim_cur = before;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, folder.file("f") + ": cannot write: File too large");
  EXPECT_EQ(read_file(folder.file("f"), plenty), "old");
  EXPECT_EQ(folder.names(), Names{"f"});
}

TEST(File, APieceByPieceFileAppearsWhenItIsWhole) {
  const TemporaryFolder folder;
  write_file(folder.file("f"), "old");
  {
    FileWriter writer(folder.file("f"));
    writer.write("a");
    writer.write("bc");
    EXPECT_EQ(read_file(folder.file("f"), plenty), "old");
    writer.commit();
    EXPECT_EQ(read_file(folder.file("f"), plenty), "abc");
  }
  EXPECT_EQ(read_file(folder.file("f"), plenty), "abc");
  EXPECT_EQ(folder.names(), Names{"f"});
}

TEST(File, APieceByPieceFileThatIsGivenUpLeavesNothing) {
  const TemporaryFolder folder;
  write_file(folder.file("f"), "old");
  {
    FileWriter writer(folder.file("f"));
    writer.write("new");
  }
  EXPECT_EQ(read_file(folder.file("f"), plenty), "old");
  EXPECT_EQ(folder.names(), Names{"f"});
}

TEST(File, WritingSaysWhyItCannot) {
  const TemporaryFolder folder;
  write_file(folder.file("f"), "old");
  const auto message = [&](const std::string& file) {
    return message_of([&] { write_file(file, "new"); });
  };
  EXPECT_EQ(message(folder.file("none/f")),
            folder.file("none/f") + ": cannot write: No such file or directory");
  EXPECT_EQ(message(folder.file("f/f")), folder.file("f/f") + ": cannot write: Not a directory");
  EXPECT_EQ(message(folder.path()), folder.path() + ": cannot write: Is a directory");
  EXPECT_EQ(message("/dev/full"), "/dev/full: cannot write: No space left on device");
  EXPECT_EQ(message(""), ": cannot write: No such file or directory");
}

TEST(File, AFolderOrFileWithoutPermissionIsLeftAlone) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  write_file(folder.file("f"), "old");
  ASSERT_EQ(::chmod(folder.file("f").c_str(), 0444), 0);
  EXPECT_EQ(message_of([&] { write_file(folder.file("f"), "new"); }),
            folder.file("f") + ": cannot write: Permission denied");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  EXPECT_EQ(message_of([&] { write_file(folder.file("g"), "new"); }),
            folder.file("g") + ": cannot write: Permission denied");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
}

TEST(File, DevicesAndStandardOutputAreWrittenThrough) {
  EXPECT_NO_THROW(write_file("/dev/null", "gone"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  testing::internal::CaptureStdout();
  write_file("-", "to the terminal\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "to the terminal\n");
}

TEST(File, ReadingSaysWhyItCannot) {
  const TemporaryFolder folder;
  write_file(folder.file("f"), std::string(1001, 'x'));
  const auto message = [&](const std::string& file) {
    return message_of([&] { (void)read_file(file, 1000); });
  };
  EXPECT_EQ(message(folder.file("none")),
            folder.file("none") + ": cannot open: No such file or directory");
  EXPECT_EQ(message(folder.path()), folder.path() + ": cannot read: Is a directory");
  EXPECT_EQ(message(folder.file("f")),
            folder.file("f") + ": is too large, expected at most 1000 bytes");
}

TEST(File, NobodyWaitsForPipesAndDevices) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string rest = ", expected a regular file; - is standard input";
  const auto message = [&](const std::string& file) {
    return message_of([&] { (void)read_file(file, 1000); });
  };
  EXPECT_EQ(message(pipe), pipe + ": is a pipe" + rest);
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: is a device" + rest);
  EXPECT_EQ(message("/dev/tty"), "/dev/tty: is a device" + rest);
  EXPECT_EQ(message_of([&] { (void)read_table_file(pipe); }), pipe + ": is a pipe" + rest);
}

TEST(File, APipeThatIsOpenIsReadUnderItsNumber) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "abc", 3), 3);
  ::close(ends[1]);
  EXPECT_EQ(read_file("/dev/fd/" + std::to_string(ends[0]), plenty), "abc");
  ::close(ends[0]);
}

TEST(File, ScenariosNameTheFileThatCannotBeRead) {
  EXPECT_EQ(message_of([] { (void)read_scenario("none.yaml"); }),
            "none.yaml: cannot open: No such file or directory");
  EXPECT_EQ(message_of([] { (void)read_results("none.json", {}); }),
            "none.json: cannot open: No such file or directory");
  EXPECT_EQ(message_of([] { (void)read_tpcap("none.csv"); }),
            "none.csv: cannot open: No such file or directory");
}

}  // namespace
}  // namespace vandplan
