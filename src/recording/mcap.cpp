// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/mcap.h"

#include <zlib.h>

#include <algorithm>

#include "base/bytes.h"

namespace vandplan::recording {
namespace {

using base::append;

// First byte of a record.
enum class Kind : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

constexpr std::string_view magic = "\x89MCAP0\r\n";
// Size at which a chunk ends [bytes]. Readers hold a few chunks in memory.
constexpr std::size_t full_chunk = std::size_t{1} << 20;
constexpr std::uint32_t no_compression = 0;  // Length of the name of the compression.

std::uint32_t crc_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_text(std::string& bytes, std::string_view text) {
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

/// Appends the begin of a record whose content has `size` bytes.
void append_begin(std::string& bytes, Kind kind, std::size_t size) {
  append(bytes, static_cast<std::uint8_t>(kind));
  append(bytes, std::uint64_t{size});
}

std::string record_of(Kind kind, std::string_view content) {
  std::string bytes;
  append_begin(bytes, kind, content.size());
  return bytes.append(content);
}

}  // namespace

void McapWriter::Times::add(std::uint64_t time) {
  first = messages == 0 ? time : std::min(first, time);
  last = std::max(last, time);
  ++messages;
}

McapWriter::McapWriter(ByteSink sink, std::string_view library) : sink_(std::move(sink)) {
  std::string content;
  append_text(content, "");  // Profile: none of the known ones.
  append_text(content, library);
  hand_out(std::string(magic) + record_of(Kind::header, content));
}

std::uint16_t McapWriter::add_channel(const ChannelInfo& info) {
  auto schema = std::find(schemas_.begin(), schemas_.end(), info.schema_name);
  const auto schema_number = static_cast<std::uint16_t>(schema - schemas_.begin() + 1);
  if (schema == schemas_.end()) {
    schemas_.emplace_back(info.schema_name);
    std::string content;
    append(content, schema_number);
    append_text(content, info.schema_name);
    append_text(content, "jsonschema");
    append_text(content, info.schema);
    const std::string record = record_of(Kind::schema, content);
    records_ += record;
    schema_records_ += record;
  }
  const auto number = static_cast<std::uint16_t>(channels_.size());
  channels_.emplace_back();
  std::string content;
  append(content, number);
  append(content, schema_number);
  append_text(content, info.topic);
  append_text(content, "json");
  append_text(content, "");  // No metadata.
  const std::string record = record_of(Kind::channel, content);
  records_ += record;
  channel_records_ += record;
  note_in_chunk(number);
  return number;
}

void McapWriter::note_in_chunk(std::uint16_t channel) {
  if (std::exchange(channels_[channel].is_in_chunk, true)) return;
  in_chunk_.push_back(channel);
}

void McapWriter::add_message(std::uint16_t channel, std::uint64_t time, std::string_view data) {
  note_in_chunk(channel);
  Channel& its = channels_[channel];
  its.index.emplace_back(time, records_.size());
  append_begin(records_, Kind::message, 22 + data.size());
  append(records_, channel);
  append(records_, its.messages++);
  append(records_, time);  // Time of the recording.
  append(records_, time);  // Time at which the message was sent.
  records_ += data;
  chunk_times_.add(time);
  times_.add(time);
  if (records_.size() > full_chunk) end_chunk();
}

std::string McapWriter::write_message_indexes() {
  std::string all;
  std::string places;
  for (const std::uint16_t number : in_chunk_) {
    Channel& channel = channels_[number];
    append(places, number);
    append(places, position_ + all.size());
    std::string content;
    append(content, number);
    append(content, static_cast<std::uint32_t>(16 * channel.index.size()));
    for (const auto& [time, place] : channel.index) {
      append(content, time);
      append(content, place);
    }
    all += record_of(Kind::message_index, content);
    channel.index.clear();
    channel.is_in_chunk = false;
  }
  hand_out(all);
  return places;
}

void McapWriter::end_chunk() {
  if (chunk_times_.messages == 0) return;
  std::string head;
  append(head, chunk_times_.first);
  append(head, chunk_times_.last);
  append(head, std::uint64_t{records_.size()});
  append(head, crc_of(records_));
  append(head, no_compression);
  append(head, std::uint64_t{records_.size()});
  std::string begin;
  append_begin(begin, Kind::chunk, head.size() + records_.size());
  const std::uint64_t chunk_place = position_;
  hand_out(begin + head);
  hand_out(records_);
  const std::uint64_t index_place = position_;
  const std::string places = write_message_indexes();

  std::string content;
  append(content, chunk_times_.first);
  append(content, chunk_times_.last);
  append(content, chunk_place);
  append(content, index_place - chunk_place);
  append_text(content, places);
  append(content, position_ - index_place);
  append(content, no_compression);
  append(content, std::uint64_t{records_.size()});  // Size of the stored records.
  append(content, std::uint64_t{records_.size()});  // Size without compression.
  chunk_index_records_ += record_of(Kind::chunk_index, content);
  ++chunks_;
  records_.clear();
  in_chunk_.clear();
  chunk_times_ = {};
}

std::string McapWriter::statistics() const {
  std::string counts;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    append(counts, static_cast<std::uint16_t>(i));
    append(counts, std::uint64_t{channels_[i].messages});
  }
  std::string content;
  append(content, times_.messages);
  append(content, static_cast<std::uint16_t>(schemas_.size()));
  append(content, static_cast<std::uint32_t>(channels_.size()));
  append(content, std::uint32_t{0});  // Attachments.
  append(content, std::uint32_t{0});  // Records of metadata.
  append(content, chunks_);
  append(content, times_.first);
  append(content, times_.last);
  append_text(content, counts);
  return record_of(Kind::statistics, content);
}

void McapWriter::end() {
  end_chunk();
  std::string data_end;
  append(data_end, checksum_);
  hand_out(record_of(Kind::data_end, data_end));

  const std::uint64_t begin = position_;
  std::string summary;
  std::string offsets;
  const auto add_group = [&](Kind kind, const std::string& records) {
    if (records.empty()) return;
    std::string content;
    append(content, static_cast<std::uint8_t>(kind));
    append(content, begin + summary.size());
    append(content, std::uint64_t{records.size()});
    offsets += record_of(Kind::summary_offset, content);
    summary += records;
  };
  add_group(Kind::schema, schema_records_);
  add_group(Kind::channel, channel_records_);
  add_group(Kind::statistics, statistics());
  add_group(Kind::chunk_index, chunk_index_records_);
  const std::uint64_t offsets_begin = begin + summary.size();
  summary += offsets;
  append_begin(summary, Kind::footer, 20);
  append(summary, begin);
  append(summary, offsets_begin);
  append(summary, crc_of(summary));
  hand_out(summary.append(magic));
}

void McapWriter::hand_out(std::string_view bytes) {
  checksum_ = crc_of(bytes, checksum_);
  position_ += bytes.size();
  sink_(bytes);
}

}  // namespace vandplan::recording
