// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/table_bytes.h"

#include "base/hash.h"
#include "vandplan/input_error.h"

namespace vandplan::tables::table_bytes {
namespace {

constexpr std::string_view magic = "vp-table";
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t swapped_byte_order = 0x04030201;
constexpr std::uint32_t version = 1;
constexpr std::size_t content_at = 16;
constexpr std::size_t units_at = 32;
constexpr std::size_t parameters_at = 48;
constexpr std::size_t count_at = 80;
constexpr std::size_t checksum_at = 88;
constexpr std::size_t text_size = 16;

std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result.push_back(c >= ' ' && c <= '~' ? c : '?');
  return result + "'";
}

void check_version(std::string_view bytes, const std::string& file) {
  const auto refuse = [&file](const std::string& problem) { throw InputError(file, problem); };
  if (bytes.empty()) refuse("is empty, expected a table file");
  if (!bytes.starts_with(magic)) refuse("not a table file: does not start with 'vp-table'");
  if (bytes.size() < head_size) {
    refuse("truncated: " + std::to_string(bytes.size()) + " bytes, the header alone has " +
           std::to_string(head_size));
  }
  const auto order = read_at<std::uint32_t>(bytes, 8);
  if (order == swapped_byte_order) refuse("big-endian, only little-endian files are read");
  if (order != byte_order) refuse("altered: the byte order mark is not one");
  if (const auto found = read_at<std::uint32_t>(bytes, 12); found != version) {
    refuse("version " + std::to_string(found) + " of the format, this program reads version " +
           std::to_string(version));
  }
}

const Kind& kind_of(std::string_view bytes, const std::string& file) {
  const std::string_view content = bytes.substr(content_at, text_size);
  if (content != lengths.content && content != bounds.content) {
    throw InputError(file, "holds " + quoted(content) + ", expected " + quoted(lengths.content) +
                               " or " + quoted(bounds.content));
  }
  const Kind& kind = content == lengths.content ? lengths : bounds;
  const std::string_view units = bytes.substr(units_at, text_size);
  if (units != kind.units) {
    throw InputError(file, "units are " + quoted(units) + ", expected " + quoted(kind.units));
  }
  return kind;
}

}  // namespace

std::string start_of(const Head& head) {
  std::string bytes(magic);
  append(bytes, byte_order);
  append(bytes, version);
  bytes.append(head.kind->content).append(head.kind->units);
  for (const std::uint64_t parameter : head.parameters) append(bytes, parameter);
  append(bytes, head.count);
  append(bytes, std::uint64_t{0});
  return bytes;
}

void seal(std::string& bytes) {
  std::string sum;
  append(sum, checksum(bytes));
  bytes.replace(checksum_at, sum.size(), sum);
}

Head head_of(std::string_view bytes, const std::string& file) {
  check_version(bytes, file);
  Head head{.kind = &kind_of(bytes, file),
            .count = read_at<std::uint64_t>(bytes, count_at),
            .checksum = read_at<std::uint64_t>(bytes, checksum_at)};
  for (std::size_t i = 0; i < head.parameters.size(); ++i) {
    head.parameters[i] = read_at<std::uint64_t>(bytes, parameters_at + 8 * i);
  }
  if (head.count > most_entries) {
    throw InputError(file, "says that it holds " + std::to_string(head.count) +
                               " entries, expected at most " + std::to_string(most_entries));
  }
  return head;
}

Head checked_head(std::string_view bytes, const std::string& file) {
  const Head head = head_of(bytes, file);
  const std::uint64_t size = head_size + head.kind->entry_size * head.count;
  if (bytes.size() != size) {
    throw InputError(file, (bytes.size() < size ? "truncated: " : "longer than it says: ") +
                               std::to_string(bytes.size()) + " bytes, expected " +
                               std::to_string(head_size) + " + " +
                               std::to_string(head.kind->entry_size) + " * " +
                               std::to_string(head.count));
  }
  if (head.checksum != checksum(bytes)) {
    throw InputError(file, "altered: the checksum does not fit the content");
  }
  return head;
}

std::uint64_t checksum(std::string_view bytes) noexcept {
  const std::uint64_t head = base::hash_of(bytes.substr(0, checksum_at));
  return bytes.size() <= head_size ? head : base::hash_of(bytes.substr(head_size), head);
}

}  // namespace vandplan::tables::table_bytes
