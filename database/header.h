// SPDX-License-Identifier: MIT
// The header of a database file (docs/format.md), written and read.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "graspdb/database/database.h"

namespace graspdb {

// Every header starts with these bytes, the version, kHashKey and the header's own hash: a reader
// knows the file and can check all of the header before it parses anything.
constexpr std::string_view kSignature = R"({"__metadata__":{"format":"graspdb","format_version":")";
// Of a database without embeddings, and of one that has them.
constexpr std::string_view kPlainVersion = "1", kEmbeddingVersion = "2";
constexpr std::string_view kHashKey = R"(","header_hash":")";
constexpr std::size_t kHashPosition = kSignature.size() + kPlainVersion.size() + kHashKey.size();
constexpr std::size_t kHashDigits = 32;
constexpr std::size_t kPrefixBytes = 8;  // the length of the header
constexpr std::size_t kAlignment = 64;

struct Column {
  std::string_view name;
  std::string_view dtype;  // as safetensors calls it
  std::size_t item_bytes;
  std::size_t width;      // items a row; 0 for one item, whose shape is then [N] and not [N, 1]
  std::string_view unit;  // for readers of the file

  constexpr std::size_t row_bytes() const { return item_bytes * (width == 0 ? 1 : width); }
};

// In the order of the file: wide items first, so that each column is aligned for its type.
enum ColumnIndex : std::size_t {
  kLabel,
  kBox,
  kView,
  kGrasp,
  kHog,
  kStep,
  kHand,
  kVariant,
  kEmbedding,
  kMostColumns
};

// The columns of one database: all but the last, or all.
class Columns {
 public:
  explicit Columns(std::size_t embedding_bytes);

  std::size_t size() const { return all_[kEmbedding].width > 0 ? kMostColumns : kEmbedding; }
  const Column& operator[](std::size_t column) const { return all_[column]; }
  // Where a column of so many rows starts in the data. The sum of all columns for size().
  std::size_t offset(std::size_t column, std::size_t rows) const;
  // The entry of a column in the header, as JSON.
  std::string json(std::size_t column, std::size_t rows) const;

 private:
  std::array<Column, kMostColumns> all_;
};
using ColumnHashes = std::vector<std::string>;  // one a column

Columns columns_of(const DatabaseInfo& info);
std::string_view version_of(const DatabaseInfo& info);

struct Header {
  DatabaseInfo info;
  std::size_t rows = 0;
  ColumnHashes column_hashes;
};

// Of all columns: the hash of their hashes in the order of the file.
std::string content_hash(const ColumnHashes& hashes);

// Throws Error when the parts of `info` contradict each other or do not fit their columns.
void check_info(const DatabaseInfo& info, const std::string& file);

// The length prefix and the header, padded so that the data behind it is aligned to 64 bytes.
std::string header_bytes(const Header& header, const std::string& file);

// Reads and checks the header against the bytes of the whole file: its checksum, the columns, the
// file's size, the info. Throws Error.
Header read_header(std::span<const std::byte> bytes, const std::string& file);

// The data behind the header. Only for bytes that read_header accepted.
std::span<const std::byte> data_bytes(std::span<const std::byte> bytes);

}  // namespace graspdb
