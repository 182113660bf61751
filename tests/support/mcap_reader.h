// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What stands in an MCAP file? A simple reader, by the specification (https://mcap.dev/spec).

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"

namespace vandplan {

/// A record, and where it is in the bytes that it was read from.
struct McapRecord {
  std::uint8_t kind = 0;
  std::string_view content;
  std::size_t begin = 0;
  std::size_t size = 0;  // with kind and length
};

/// Reads numbers and texts one after the other.
class McapCursor {
 public:
  explicit McapCursor(std::string_view bytes) : bytes_(bytes) {}
  template <class Number>
  Number number() {
    const std::string_view part = take(sizeof(Number));
    return base::read_at<Number>(part, 0);
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view take(std::size_t size) {
    if (size > bytes_.size() - at_) throw std::runtime_error("the file ends too soon");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  std::string_view rest() { return take(bytes_.size() - at_); }
  [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

inline constexpr std::string_view mcap_magic = "\x89MCAP0\r\n";

inline std::vector<McapRecord> mcap_records(std::string_view bytes) {
  std::vector<McapRecord> records;
  for (McapCursor cursor(bytes); !cursor.is_at_end();) {
    McapRecord& record = records.emplace_back();
    record.begin = cursor.at();
    record.kind = cursor.number<std::uint8_t>();
    record.content = cursor.take(cursor.number<std::uint64_t>());
    record.size = cursor.at() - record.begin;
  }
  return records;
}

/// The records of a file between its magic bytes; `begin` counts from the first record on.
inline std::vector<McapRecord> records_of_file(std::string_view file) {
  const std::size_t magic = mcap_magic.size();
  if (!file.starts_with(mcap_magic) || !file.ends_with(mcap_magic)) {
    throw std::runtime_error("the magic bytes are missing");
  }
  return mcap_records(file.substr(magic, file.size() - 2 * magic));
}

struct McapMessage {
  std::string topic;
  std::string schema;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;  // [ns]
  std::string data = {};
};

/// All messages in the chunks of a file, in their order.
inline std::vector<McapMessage> mcap_messages(std::string_view file) {
  std::map<std::uint16_t, std::string> schemas;
  std::map<std::uint16_t, McapMessage> channels;
  std::vector<McapMessage> messages;
  for (const McapRecord& chunk : records_of_file(file)) {
    if (chunk.kind != 0x06) continue;
    McapCursor cursor(chunk.content);
    (void)cursor.take(28);  // times, size, checksum
    (void)cursor.text();
    (void)cursor.number<std::uint64_t>();
    for (const McapRecord& record : mcap_records(cursor.rest())) {
      McapCursor in(record.content);
      const auto id = in.number<std::uint16_t>();
      if (record.kind == 0x03) schemas[id] = in.text();
      if (record.kind == 0x04) {
        const std::string& schema = schemas.at(in.number<std::uint16_t>());
        channels[id] = {.topic = std::string(in.text()), .schema = schema};
      }
      if (record.kind != 0x05) continue;
      McapMessage& message = messages.emplace_back(channels.at(id));
      message.sequence = in.number<std::uint32_t>();
      message.time = in.number<std::uint64_t>();
      (void)in.number<std::uint64_t>();
      message.data = in.rest();
    }
  }
  return messages;
}

}  // namespace vandplan
