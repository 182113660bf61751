// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// The bytes of MCAP files. That others read them: read_back.
#include "recording/mcap.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "support/mcap_reader.h"

namespace vandplan::recording {
namespace {

std::uint32_t crc_of_bytes(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// A file with two channels of one schema, and messages that fill `chunks` chunks and a little
/// more.
std::string file_of(int chunks) {
  std::string file;
  McapWriter writer([&](std::string_view piece) { file += piece; }, "a test");
  const std::uint16_t small = writer.add_channel({"/small", "Number", R"({"type":"object"})"});
  writer.add_message(small, 7, "{}");
  const std::uint16_t large = writer.add_channel({"/large", "Number", R"({"type":"object"})"});
  for (int i = 0; i < chunks; ++i) {
    writer.add_message(large, 5, std::string(1 << 20, ' '));
    writer.add_message(small, 9 + static_cast<std::uint64_t>(i), "{}");
  }
  writer.end();
  return file;
}

std::vector<int> kinds_of(const std::vector<McapRecord>& records) {
  std::vector<int> kinds;
  for (const McapRecord& record : records) kinds.push_back(record.kind);
  return kinds;
}

TEST(Mcap, AFileHasHeaderChunksWithIndexesSummaryAndFooter) {
  const std::string file = file_of(1);
  // Header; chunk and an index for each channel, twice; end of data; two channels of one schema,
  // statistics, two indexes of chunks; where these four groups are; footer.
  EXPECT_EQ(kinds_of(records_of_file(file)),
            (std::vector{1, 6, 7, 7, 6, 7, 15, 3, 4, 4, 11, 8, 8, 14, 14, 14, 14, 2}));
  McapCursor header(records_of_file(file).front().content);
  EXPECT_EQ(header.text(), "");
  EXPECT_EQ(header.text(), "a test");
}

TEST(Mcap, MessagesAreReadBackInOrder) {
  const std::vector<McapMessage> messages = mcap_messages(file_of(2));
  ASSERT_EQ(messages.size(), 5U);
  EXPECT_EQ(messages[0].topic, "/small");
  EXPECT_EQ(messages[0].schema, "Number");
  EXPECT_EQ(messages[0].time, 7U);
  EXPECT_EQ(messages[0].data, "{}");
  EXPECT_EQ(messages[3].topic, "/large");
  EXPECT_EQ(messages[3].sequence, 1U);
  EXPECT_EQ(messages[3].data.size(), 1U << 20U);
  EXPECT_EQ(messages[4].time, 10U);
  EXPECT_EQ(messages[4].sequence, 2U);
}

TEST(Mcap, ChecksumsAreThoseOfTheBytes) {
  const std::string file = file_of(1);
  const std::size_t magic = mcap_magic.size();
  const std::vector<McapRecord> records = records_of_file(file);
  for (const McapRecord& record : records) {
    McapCursor in(record.content);
    if (record.kind == 6) {
      (void)in.take(16);
      EXPECT_EQ(in.number<std::uint64_t>(), record.content.size() - 40);
      const auto checksum = in.number<std::uint32_t>();
      (void)in.take(12);
      EXPECT_EQ(checksum, crc_of_bytes(in.rest()));
    } else if (record.kind == 15) {
      EXPECT_EQ(in.number<std::uint32_t>(),
                crc_of_bytes(std::string_view(file).substr(0, magic + record.begin)));
    } else if (record.kind == 2) {
      const auto begin = in.number<std::uint64_t>();
      (void)in.number<std::uint64_t>();
      const std::size_t end = file.size() - magic - 4;
      EXPECT_EQ(in.number<std::uint32_t>(),
                crc_of_bytes(std::string_view(file).substr(begin, end - begin)));
    }
  }
}

TEST(Mcap, IndexesSayWhereMessagesAndChunksAre) {
  const std::string file = file_of(2);
  const std::size_t magic = mcap_magic.size();
  const std::vector<McapRecord> records = records_of_file(file);
  int found = 0;
  for (const McapRecord& record : records) {
    if (record.kind != 8) continue;
    McapCursor index(record.content);
    const auto first = index.number<std::uint64_t>();
    const auto last = index.number<std::uint64_t>();
    EXPECT_LE(first, last);
    const std::uint64_t place = index.number<std::uint64_t>();
    const std::uint64_t size = index.number<std::uint64_t>();
    const auto chunk = mcap_records(std::string_view(file).substr(place, size));
    ASSERT_EQ(kinds_of(chunk), std::vector{6});
    const std::string_view in_chunk = chunk.front().content.substr(40);
    for (McapCursor places(index.text()); !places.is_at_end();) {
      const auto channel = places.number<std::uint16_t>();
      const auto message_index = places.number<std::uint64_t>();
      const std::string_view rest =
          std::string_view(file).substr(message_index, file.size() - magic - message_index);
      McapCursor at(rest);
      ASSERT_EQ(at.number<std::uint8_t>(), 7);
      (void)at.number<std::uint64_t>();
      EXPECT_EQ(at.number<std::uint16_t>(), channel);
      for (McapCursor entries(at.text()); !entries.is_at_end(); ++found) {
        const auto time = entries.number<std::uint64_t>();
        McapCursor message(in_chunk.substr(entries.number<std::uint64_t>()));
        ASSERT_EQ(message.number<std::uint8_t>(), 5);
        (void)message.number<std::uint64_t>();
        EXPECT_EQ(message.number<std::uint16_t>(), channel);
        (void)message.number<std::uint32_t>();
        EXPECT_EQ(message.number<std::uint64_t>(), time);
        EXPECT_TRUE(first <= time && time <= last);
      }
    }
  }
  EXPECT_EQ(found, 5);
}

TEST(Mcap, TheSummaryCountsMessagesAndSaysWhereItsGroupsAre) {
  const std::string file = file_of(2);
  const std::vector<McapRecord> records = records_of_file(file);
  for (const McapRecord& record : records) {
    McapCursor in(record.content);
    if (record.kind == 14) {
      const auto kind = in.number<std::uint8_t>();
      const auto place = in.number<std::uint64_t>();
      const auto group =
          mcap_records(std::string_view(file).substr(place, in.number<std::uint64_t>()));
      ASSERT_FALSE(group.empty());
      for (const McapRecord& member : group) EXPECT_EQ(member.kind, kind);
    }
    if (record.kind != 11) continue;
    EXPECT_EQ(in.number<std::uint64_t>(), 5U);  // messages
    EXPECT_EQ(in.number<std::uint16_t>(), 1U);  // schemas
    EXPECT_EQ(in.number<std::uint32_t>(), 2U);  // channels
    (void)in.take(8);
    EXPECT_EQ(in.number<std::uint32_t>(), 3U);   // chunks
    EXPECT_EQ(in.number<std::uint64_t>(), 5U);   // first time
    EXPECT_EQ(in.number<std::uint64_t>(), 10U);  // last time
    McapCursor counts(in.text());
    EXPECT_EQ(counts.number<std::uint16_t>(), 0U);
    EXPECT_EQ(counts.number<std::uint64_t>(), 3U);
  }
}

TEST(Mcap, AFileWithoutMessagesHasNoChunk) {
  std::string file;
  McapWriter writer([&](std::string_view piece) { file += piece; }, "");
  writer.end();
  EXPECT_EQ(kinds_of(records_of_file(file)), (std::vector{1, 15, 11, 14, 2}));
}

}  // namespace
}  // namespace vandplan::recording
