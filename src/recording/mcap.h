// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do messages become the bytes of an MCAP file?
//
// Messages stand in chunks without compression. Each chunk has a checksum and is followed by an
// index of its messages. A summary at the end says where everything is. Specification:
// https://mcap.dev/spec

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vandplan::recording {

/// Receives the bytes of a file piece by piece.
using ByteSink = std::function<void(std::string_view piece)>;

/// A channel: messages of one kind under one name.
struct ChannelInfo {
  std::string_view topic;        ///< name of the channel, such as "/log"
  std::string_view schema_name;  ///< name of the schema; equal names stand for equal schemas
  std::string_view schema;       ///< the schema of its messages (JSON Schema)
};

/// Writes a file message by message.
class McapWriter {
 public:
  /// Begins a file. `library` names the program that writes it.
  McapWriter(ByteSink sink, std::string_view library);

  /// Adds a channel of JSON messages and returns its number.
  [[nodiscard]] std::uint16_t add_channel(const ChannelInfo& info);
  /// Adds a message, valid at `time` [ns].
  void add_message(std::uint16_t channel, std::uint64_t time, std::string_view data);
  /// Ends the file. Must follow the last message.
  void end();

 private:
  /// Earliest and latest time of messages [ns].
  struct Times {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    std::uint64_t messages = 0;  ///< number of messages
    void add(std::uint64_t time);
  };
  struct Channel {
    std::uint32_t messages = 0;  ///< number of messages in the file
    /// Time [ns] of each message of the open chunk, and where it is in the chunk.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index = {};
    bool is_in_chunk = false;  ///< whether `in_chunk_` has the channel
  };

  void note_in_chunk(std::uint16_t channel);
  void end_chunk();
  /// Writes the index of the open chunk. Returns, for the index of chunks, where it is for each
  /// channel.
  std::string write_message_indexes();
  [[nodiscard]] std::string statistics() const;
  void hand_out(std::string_view bytes);

  ByteSink sink_;
  std::uint64_t position_ = 0;           ///< number of bytes handed out
  std::uint32_t checksum_ = 0;           ///< CRC-32 of all bytes handed out
  std::vector<std::string> schemas_;     ///< names; the first one has the number 1
  std::vector<Channel> channels_;        ///< channels by their number
  std::string records_;                  ///< records of the open chunk
  std::vector<std::uint16_t> in_chunk_;  ///< channels of the open chunk, by first appearance
  Times chunk_times_;                    ///< times of the open chunk
  Times times_;                          ///< times of the file
  std::uint32_t chunks_ = 0;             ///< number of chunks
  std::string schema_records_ = {};      ///< records of the summary, by kind
  std::string channel_records_ = {};
  std::string chunk_index_records_ = {};
};

}  // namespace vandplan::recording
